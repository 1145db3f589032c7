#!/usr/bin/env python3
"""Counts instructions, which are the same on a busy machine and a quiet one.

usage: instructions.py rays COUNT_RAYS [--record]   what a ray costs, against tests/cost/rays.json
       instructions.py samples COUNT_SAMPLES        what it costs that the tracer can be watched
       instructions.py unused RAYSCOPE              what features cost that a scene has no use for
Exits with 77 where valgrind is missing or nothing was recorded for this compiler.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

RECORD = Path(__file__).with_name("rays.json")
TOLERANCE = 0.03  # of the recorded figure, in either direction: a gain has to be recorded as well
LARGEST_COST = 0.01
LARGEST_HOOK = 0.001
INSTRUCTION_SETS = "scalar", "sse2", "avx2"  # valgrind knows no AVX-512

WATCHED_SCENES = "builtin:cornell", "builtin:cornell-area", "builtin:monkey", "builtin:cornell-transparent"

# What the scene of the last test has no use for: it is a mesh of one opaque material, two point lights, a pinhole.
UNUSED = (
    "segment_samples=400", "parallelogram_samples=20", "transparent_shadows=true", "transparency=false",
    "texture_mapping=false", "texture_filter=mipmap", "environment=false", "reflection_map=true", "depth_of_field=false",
    "motion_blur=false", "soft_shadows=false",
)


def skip(words):
    print(words)
    sys.exit(77)


def compiler():
    version = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True).stdout
    return version.splitlines()[0].split(" (")[0] + " " + re.search(r"(\d+)\.\d+", version).group(1)


def callgrind(folder, command, *options):
    return subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", *options, *command],
                          capture_output=True, text=True, cwd=folder)


def between_gates(command, *gates):
    """What a program prints, and the instructions of each call of its gates in order; None if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        run = callgrind(folder, command, "--collect-atstart=no", "--toggle-collect=counted*",
                        *(f"--dump-after={gate}" for gate in gates))
        if run.returncode != 0:
            return None
        parts = sorted(Path(folder).glob("out.*"), key=lambda path: int(path.suffix[1:]))
        totals = [int(re.search(r"^totals: (\d+)", part.read_text(), re.M).group(1)) for part in parts]
    return run.stdout.splitlines(), totals


def rays_of(program, instruction_set):
    """Instructions per ray by kind and query; None where the instruction set is missing."""
    found = between_gates([program, instruction_set], "countedSingle", "countedBatched")
    if not found:
        return None
    lines, totals = [line.split() for line in found[0]], found[1]
    # The first gate of each kind is the one that warms up.
    counted = [total for i, total in enumerate(totals) if i % 3]
    return {f"{instruction_set} {kind} {query}": round(total / int(rays))
            for (kind, query, rays), total in zip(lines, counted, strict=True)}


def check_rays(program, record):
    figures = {}
    for instruction_set in INSTRUCTION_SETS:
        found = rays_of(program, instruction_set)
        print("\n".join(f"{key}: {value}" for key, value in found.items()) if found else f"no {instruction_set} here")
        figures |= found or {}
    recorded = json.loads(RECORD.read_text()) if RECORD.exists() else {}
    if record:
        recorded[compiler()] = figures
        RECORD.write_text(json.dumps(recorded, indent=2) + "\n")
        return 0
    if compiler() not in recorded:
        skip(f"nothing is recorded for {compiler()}")
    wrong = 0
    for key, value in figures.items():
        before = recorded[compiler()][key]
        if abs(value - before) > TOLERANCE * before:
            print(f"{key}: {value} instructions per ray, {before} are recorded; if that is intended: "
                  f"tests/cost/instructions.py rays {program} --record")
            wrong = 1
    return wrong


def check_samples(program):
    found = between_gates([program, *WATCHED_SCENES], "countedSilent", "countedUnwatched")
    if not found:
        sys.exit("the two tracers differ, or do not run")
    lines, totals = found
    wrong = 0
    for i, scene in enumerate(lines):
        # The first pair of each scene warms up.
        silent, unwatched = totals[4 * i + 2:4 * i + 4]
        print(f"{scene}: {silent} instructions with the silent observer, {unwatched} without one")
        if abs(silent / unwatched - 1.0) > LARGEST_HOOK:
            wrong = 1
    return wrong


def check_unused(program):
    def instructions(*settings):
        with tempfile.TemporaryDirectory() as folder:
            command = [program, "render", "builtin:monkey", "--size", "64x64", "--spp", "1", "--threads", "1", "-o", "x.png",
                       "--set", "isa=sse2"]
            for setting in settings:
                command += ["--set", setting]
            run = callgrind(folder, command)
            if run.returncode != 0:
                sys.exit(run.stderr)
            return int(re.search(r"Collected : (\d+)", run.stderr).group(1))

    plain, wrong = instructions(), 0
    for setting in UNUSED:
        cost = instructions(setting) / plain - 1.0
        print(f"{setting}: {100 * cost:+.3f} %")
        if abs(cost) > LARGEST_COST:
            wrong = 1
    return wrong


def main():
    if not shutil.which("valgrind"):
        skip("valgrind is not installed")
    # The commands run in folders of their own.
    arguments = [str(Path(word).resolve()) if Path(word).exists() else word for word in sys.argv[1:]]
    match arguments:
        case ["rays", program, *options] if options in ([], ["--record"]):
            sys.exit(check_rays(program, bool(options)))
        case ["samples", program]:
            sys.exit(check_samples(program))
        case ["unused", program]:
            sys.exit(check_unused(program))
    sys.exit(__doc__)


main()
