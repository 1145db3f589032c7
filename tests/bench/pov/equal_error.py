#!/usr/bin/env python3
"""Time to equal error beside POV-Ray 3.7, on pictures whose models differ in detail: glossy reflections, depth of field.

    tests/bench/pov/equal_error.py [--program build/release/rayscope] [--rounds 3] [--size 200] [--scene glossy|lens]
                                   [--keep FOLDER]

Both programs render the scene with more and more samples, in turns, on all cores. The error is the RMSE of linear values,
clipped to 0 … 1, against a picture of the same program with far more samples, since the two do not converge to the same
one: POV-Ray has no rough mirrors, so fine noise on the normals takes their place, and it samples the lens in patterns of
its own. `apart` says how far the converged pictures are from each other. Rayscope's time at the error of each of
POV-Ray's pictures is interpolated between its own on logarithmic axes. Prints tables in Markdown.
"""
import argparse
import math
import os
import random
import statistics
import tempfile
from pathlib import Path

import race


def glossy():
    """The Cornell box with a rough mirror, under a point light, so that only reflections and edges are noisy."""
    scene = race.cornell()
    # The standard deviation of Rayscope's square, 1 / (3 ns) at a distance of 0.3, for the roughest of its mirrors.
    rough = min(m["ns"] for m in scene["materials"].values() if any(m["ks"]))
    common = ("glossy=true", "glossy_samples=2")
    scene.update({
        "name": "Glossy Cornell box",
        "light": {"position": (0.0, 0.5, 0.2)},
        "roughness": round(2.0 / (3.0 * rough * 0.3), 3),
        "rayscope": {f"{spp} spp": (f"spp={spp}", *common) for spp in (1, 4, 16, 64, 256)},
        "rayscope_reference": ("spp=4096", *common),
        # Subpixels per side; each meets four textures.
        "povray": {"1 sample": 1, "3 x 3": 3, "5 x 5": 5, "7 x 7": 7}, "povray_reference": 33,
    })
    return scene


def lens():
    """Three balls at different depths over a floor, through an open lens that is sharp at the second."""
    vertices, triangles = [], []
    for name, center, radius in (("near", (-0.75, -0.15, -1.2), 0.35), ("middle", (0.0, -0.15, 0.0), 0.35),
                                 ("far", (0.9, -0.15, 1.4), 0.35)):
        add_ball(vertices, triangles, name, center, radius)
    scene = race.on_mirror("Three balls through a lens", vertices, triangles, -0.5)
    distance = math.dist(race.CAMERA["from"], race.CAMERA["at"])
    scene["materials"] = {name: {"kd": kd, "ks": (0.0,) * 3, "ns": 30.0} for name, kd in
                          (("near", (0.7, 0.2, 0.15)), ("middle", (0.6, 0.55, 0.2)), ("far", (0.2, 0.4, 0.7)),
                           ("floor", (0.5, 0.5, 0.5)))}
    scene.update({
        "lens": (0.1, distance),
        "rayscope": {f"{spp} spp": (f"spp={spp}",) for spp in (1, 4, 16, 64, 256)},
        "rayscope_reference": ("spp=2048",),
        "povray": {f"{n} blur samples": n for n in (7, 19, 37, 128)}, "povray_reference": 1024,
    })
    return scene


def add_ball(vertices, triangles, name, center, radius, rings=48, columns=96):
    first = len(vertices)
    for j in range(rings + 1):
        for i in range(columns):
            theta, phi = math.pi * j / rings, 2.0 * math.pi * i / columns
            direction = (math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi))
            vertices.append(tuple(c + radius * d for c, d in zip(center, direction)))
    for j in range(rings):
        for i in range(columns):
            a, b = first + j * columns + i, first + j * columns + (i + 1) % columns
            triangles += [(name, a, b, b + columns), (name, a, b + columns, a + columns)]


def render_povray(scene, level, folder, size):
    """Level: samples of the lens where there is one, otherwise subpixels per side."""
    through_lens = "lens" in scene
    race.write_povray(scene, folder, blur_samples=level if through_lens else 0, copies=4)
    # Its regular grids end at 9 per side; what subdivides itself goes on to 33.
    grid = ("+AM1", "+A0.0", f"+R{level}") if level <= 9 else ("+AM2", "+A0.0", "+R5")
    antialiasing = ("-A",) if through_lens or level == 1 else grid
    total, traced = race.run_povray(folder, size, folder / "pov.ppm", antialiasing)
    return total, traced, race.read_ppm16(folder / "pov.ppm")


def render_rayscope(options, settings, folder):
    total, traced = race.run_rayscope(options.program, folder, options.size, settings, folder / "rayscope.pfm")
    return total, traced, race.read_pfm(folder / "rayscope.pfm")


def measure(scene, options, folder):
    """{(program, variant): (median tracing seconds, RMSE)}, and how far the converged pictures are apart."""
    race.write_rayscope(scene, folder)
    truths = {"POV-Ray": render_povray(scene, scene["povray_reference"], folder, options.size)[2],
              "Rayscope": render_rayscope(options, scene["rayscope_reference"], folder)[2]}
    order = [("POV-Ray", v) for v in scene["povray"]] + [("Rayscope", v) for v in scene["rayscope"]]
    seconds, errors = {run: [] for run in order}, {}
    random.seed(1)
    for _ in range(options.rounds):
        random.shuffle(order)
        for program, variant in order:
            if program == "POV-Ray":
                _, traced, picture = render_povray(scene, scene["povray"][variant], folder, options.size)
            else:
                _, traced, picture = render_rayscope(options, scene["rayscope"][variant], folder)
            seconds[program, variant].append(traced)
            errors[program, variant] = race.rmse(picture, truths[program])
    medians = {run: (statistics.median(times), errors[run]) for run, times in seconds.items()}
    return medians, race.rmse(truths["POV-Ray"], truths["Rayscope"])


def seconds_at(error, runs):
    """Between (seconds, RMSE) of neighbours on logarithmic axes; None beyond them."""
    runs = sorted(runs)
    for (s, e), (s2, e2) in zip(runs, runs[1:]):
        if e >= error >= e2 and e > e2:
            return s * (s2 / s) ** (math.log(e / error) / math.log(e / e2))
    return None


def report(scene, options, folder):
    medians, apart = measure(scene, options, folder)
    ours = [figures for (program, _), figures in medians.items() if program == "Rayscope"]
    print(f"\n{scene['name']}, {options.size} x {options.size}, {os.cpu_count()} threads, medians of {options.rounds} "
          f"interleaved runs; converged pictures {apart:.4f} apart\n")
    print("| program | tracing, s | RMSE to its own | Rayscope at that error, s | times faster |\n|---|---|---|---|---|")
    for (program, variant), (seconds, error) in medians.items():
        same = seconds_at(error, ours) if program == "POV-Ray" else None
        ratio = f"{same:.3f} | {seconds / same:.1f}" if same else "– | –"
        print(f"| {program}, {variant} | {seconds:.3f} | {error:.5f} | {ratio} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(race.ROOT / "build/release/rayscope"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--size", type=int, default=200)
    parser.add_argument("--keep", type=Path, help="folder for scenes and pictures; absent: a temporary one")
    parser.add_argument("--scene", choices=("glossy", "lens"), help="absent: both")
    options = parser.parse_args()
    scenes = {"glossy": glossy, "lens": lens}
    for make in [scenes[options.scene]] if options.scene else scenes.values():
        with tempfile.TemporaryDirectory() as temporary:
            folder = options.keep / make.__name__ if options.keep else Path(temporary)
            folder.mkdir(parents=True, exist_ok=True)
            report(make(), options, folder)


if __name__ == "__main__":
    main()
