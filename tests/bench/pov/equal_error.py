#!/usr/bin/env python3
"""Time to equal error compared with POV-Ray 3.7: an antialiased dragon, a rough mirror, and a lens.

    tests/bench/pov/equal_error.py [--program build/release/rayscope] [--rounds 3] [--size N] [--scene glossy|lens|dragon]
                                   [--keep FOLDER]

Both programs render the scene at increasing sample counts, interleaved, on all cores. The error is the RMSE of linear values,
clipped to 0 … 1. The dragon's is against a picture by Rayscope with far more samples, to which both converge. Elsewhere it is
against such a picture of the same program, since the two do not converge to the same one: POV-Ray has no rough mirrors, so
noise on the normals is used instead, and it samples the lens in other patterns. `apart` is the RMSE between the converged
pictures. Rayscope's time at the error of each of POV-Ray's pictures is interpolated between its
own on logarithmic axes. Prints tables in Markdown. With --keep, converged pictures and finished runs are kept in the folder,
and an interrupted comparison is resumed.
"""
import argparse
import json
import math
import os
import random
import shutil
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
        "name": "Glossy Cornell box", "size": 80,
        "light": {"position": (0.0, 0.5, 0.2)},
        "roughness": round(2.0 / (3.0 * rough * 0.3), 3),
        "rayscope": {f"{spp} spp": (f"spp={spp}", *common) for spp in (1, 4, 16, 64, 256)},
        "rayscope_reference": ("spp=4096", *common),
        # Subpixels per side; each samples four textures.
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
        "lens": (0.1, distance), "size": 100,
        "rayscope": {f"{spp} spp": (f"spp={spp}",) for spp in (1, 4, 16, 64, 256)},
        "rayscope_reference": ("spp=2048",),
        "povray": {f"{n} blur samples": n for n in (7, 19, 37, 128)}, "povray_reference": 1024,
    })
    return scene


def dragon():
    """The antialiased dragon over a mirroring floor, with the same model in both programs."""
    scene = race.dragon()
    scene.update({
        "size": 300,
        "rayscope": {f"{spp} spp": (f"spp={spp}",) for spp in (1, 2, 4, 8, 16, 32)},
        "rayscope_reference": ("spp=1024",),
        # Adaptive antialiasing with usual thresholds, and subpixels everywhere.
        "povray": {"1 sample": 1, "+A0.3 +R3": ("+AM1", "+A0.3", "+R3"), "+A0.1 +R3": ("+AM1", "+A0.1", "+R3"),
                   "+AM2 +A0.1 +R3": ("+AM2", "+A0.1", "+R3"), "3 x 3": 3, "5 x 5": 5},
        "povray_reference": None,
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


def antialiasing_of(level, through_lens):
    """Options for a level: samples of the lens where there is one, subpixels per side, or the options themselves."""
    if isinstance(level, tuple):
        return level
    if through_lens or level == 1:
        return ("-A",)
    # Regular grids are limited to 9 per side, recursive ones to 33.
    return ("+AM1", "+A0.0", f"+R{level}") if level <= 9 else ("+AM2", "+A0.0", "+R5")


def render_povray(scene, level, folder, options):
    through_lens = "lens" in scene
    race.write_povray(scene, folder, blur_samples=level if through_lens else 0, copies=4)
    picture = folder / "pov.ppm"
    _, traced = race.run_povray(folder, options.size, picture, antialiasing_of(level, through_lens))
    return traced, picture


def render_rayscope(scene, settings, folder, options):
    picture = folder / "rayscope.pfm"
    _, traced = race.run_rayscope(options.program, folder, options.size, settings, picture)
    return traced, picture


RENDER = {"POV-Ray": render_povray, "Rayscope": render_rayscope}
KEY = {"POV-Ray": "povray", "Rayscope": "rayscope"}


def read(picture):
    return race.read_ppm16(picture) if picture.suffix == ".ppm" else race.read_pfm(picture)


def reference_of(program, scene, folder, options):
    """The converged picture of the program, from the folder if it exists; None where the other's is used."""
    level = scene[KEY[program] + "_reference"]
    if level is None:
        return None
    kept = folder / f"reference-{program}-{options.size}{'.ppm' if program == 'POV-Ray' else '.pfm'}"
    if not kept.exists():
        shutil.move(RENDER[program](scene, level, folder, options)[1], kept)
    return read(kept)


def measure(scene, options, folder):
    """{(program, variant): (median tracing seconds, RMSE)}, and the RMSE between the converged pictures."""
    race.write_rayscope(scene, folder)
    references = {program: reference_of(program, scene, folder, options) for program in RENDER}
    apart = None if references["POV-Ray"] is None else race.rmse(*references.values())
    references["POV-Ray"] = references["POV-Ray"] or references["Rayscope"]
    record = folder / f"runs-{options.size}.json"
    done = json.loads(record.read_text()) if record.exists() else []
    order = [(program, variant) for program in RENDER for variant in scene[KEY[program]]]
    random.seed(1)
    for completed in range(1, options.rounds + 1):
        random.shuffle(order)
        for program, variant in order:
            if sum(run[:2] == [program, variant] for run in done) >= completed:
                continue
            level = scene[KEY[program]][variant]
            traced, picture = RENDER[program](scene, level, folder, options)
            done.append([program, variant, traced, race.rmse(read(picture), references[program])])
            record.write_text(json.dumps(done))
    figures = {}
    for program in RENDER:
        for variant in scene[KEY[program]]:
            runs = [run[2:] for run in done if run[:2] == [program, variant]]
            figures[program, variant] = tuple(statistics.median(column) for column in zip(*runs))
    return figures, apart


def seconds_at(error, runs):
    """Interpolates between (seconds, RMSE) of neighbours on logarithmic axes; None outside of their range."""
    runs = sorted(runs)
    for (s, e), (s2, e2) in zip(runs, runs[1:]):
        if e >= error >= e2 and e > e2:
            return s * (s2 / s) ** (math.log(e / error) / math.log(e / e2))
    return None


def report(scene, options, folder):
    options.size = options.requested_size or scene["size"]
    medians, apart = measure(scene, options, folder)
    ours = [figures for (program, _), figures in medians.items() if program == "Rayscope"]
    print(f"\n{scene['name']}, {options.size} x {options.size}, {os.cpu_count()} threads, medians of {options.rounds} "
          f"interleaved runs{'' if apart is None else f'; converged pictures {apart:.4f} apart'}\n")
    print("| program | tracing, s | RMSE | Rayscope at that error, s | times faster |\n|---|---|---|---|---|")
    for (program, variant), (seconds, error) in medians.items():
        same = seconds_at(error, ours) if program == "POV-Ray" else None
        ratio = f"{same:.3f} | {seconds / same:.1f}" if same else "– | –"
        print(f"| {program}, {variant} | {seconds:.3f} | {error:.5f} | {ratio} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(race.ROOT / "build/release/rayscope"))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--size", dest="requested_size", type=int, help="absent: 80 to 300, so that each comparison takes minutes")
    parser.add_argument("--keep", type=Path, help="folder for scenes and pictures; absent: a temporary one")
    parser.add_argument("--scene", choices=("glossy", "lens", "dragon"), help="absent: the first two")
    options = parser.parse_args()
    scenes = {"glossy": glossy, "lens": lens, "dragon": dragon}
    for make in [scenes[options.scene]] if options.scene else [glossy, lens]:
        with tempfile.TemporaryDirectory() as temporary:
            folder = options.keep / make.__name__ if options.keep else Path(temporary)
            folder.mkdir(parents=True, exist_ok=True)
            report(make(), options, folder)


if __name__ == "__main__":
    main()
