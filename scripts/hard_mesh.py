#!/usr/bin/env python3
"""hard_mesh.py [TRIANGLES]: writes a mesh that is difficult for BVHs as OBJ to standard output: long thin triangles along the
diagonals of a cube, whose boxes are nearly empty, clusters ten thousand times smaller than the mesh, and a few triangles of the
size of the mesh. Default 100,000 triangles; the output is a function of the number."""
import math
import random
import sys


def direction(rng):
    z, phi = rng.uniform(-1, 1), rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return [r * math.cos(phi), r * math.sin(phi), z]


def along(point, way, length):
    return [p + length * w for p, w in zip(point, way)]


def needle(rng):
    """Along one of the four diagonals, up to 0.03 rad off; a thousand times as long as wide."""
    way = along([rng.choice((-1, 1)) / math.sqrt(3) for _ in range(3)], direction(rng), 0.03)
    length = rng.uniform(0.3, 1.0)
    foot = [rng.uniform(-1, 1) for _ in range(3)]
    return foot, along(foot, way, length), along(foot, direction(rng), 1e-3 * length)


def scrap(rng, center, size):
    foot = along(center, direction(rng), 30 * size * rng.random())
    return foot, along(foot, direction(rng), size), along(foot, direction(rng), size)


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    rng = random.Random(1)
    centers = [[rng.uniform(-1, 1) for _ in range(3)] for _ in range(100)]
    kinds = (lambda: needle(rng), lambda: scrap(rng, rng.choice(centers), 2e-4), lambda: scrap(rng, [0, 0, 0], 0.03))
    giants = [scrap(rng, [0, 0, 0], 1.5) for _ in range(12)]
    triangles = giants + [rng.choices(kinds, (60, 30, 10))[0]() for _ in range(count - len(giants))]
    for triangle in triangles:
        for corner in triangle:
            print("v {:.9g} {:.9g} {:.9g}".format(*corner))
    for i in range(len(triangles)):
        print(f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}")


if __name__ == "__main__":
    main()
