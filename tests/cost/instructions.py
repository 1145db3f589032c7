#!/usr/bin/env python3
"""Counts instructions, which do not depend on the load of the machine.

usage: instructions.py rays COUNT_RAYS [--record]        per ray, against tests/cost/rays.json
       instructions.py samples COUNT_SAMPLES [--record]  per sample, against tests/cost/samples.json
       instructions.py unused RAYSCOPE                   what settings cost that the scene has no use for
Exits with 77 if valgrind is missing or nothing is recorded for this compiler.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 0.03  # relative to the recorded value, in both directions: a gain has to be recorded as well
LARGEST_COST = 0.01
INSTRUCTION_SETS = "scalar", "sse2", "avx2"  # valgrind does not support AVX-512
SAMPLED_SCENES = "builtin:cornell", "builtin:cornell-area", "builtin:monkey", "builtin:cornell-transparent"

# Settings without effect on the scene of the last test: a mesh of one opaque material, two point lights, a pinhole camera.
UNUSED = (
    "segment_samples=400", "parallelogram_samples=20", "transparent_shadows=true", "transparency=false",
    "texture_mapping=false", "texture_filter=mipmap", "environment=false", "reflection_map=true", "depth_of_field=false",
    "motion_blur=false", "soft_shadows=false",
)


def skip(reason):
    print(reason)
    sys.exit(77)


def compiler():
    version = subprocess.run(["c++", "--version"], capture_output=True, text=True, check=True).stdout
    return version.splitlines()[0].split(" (")[0] + " " + re.search(r"(\d+)\.\d+", version).group(1)


def callgrind(folder, command, *options):
    return subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", *options, *command],
                          capture_output=True, text=True, cwd=folder)


def counted_calls(command, *functions):
    """What a program prints, and the instructions of each call of the functions in order; None if it fails."""
    with tempfile.TemporaryDirectory() as folder:
        run = callgrind(folder, command, "--collect-atstart=no", "--toggle-collect=counted*",
                        *(f"--dump-after={function}" for function in functions))
        if run.returncode != 0:
            print(run.stderr)
            return None
        parts = sorted(Path(folder).glob("out.*"), key=lambda path: int(path.suffix[1:]))
        totals = [int(re.search(r"^totals: (\d+)", part.read_text(), re.M).group(1)) for part in parts]
    return run.stdout.splitlines(), totals


def instructions_per_ray(program, instruction_set):
    """By kind of ray and query; None if this machine lacks the instruction set."""
    found = counted_calls([program, instruction_set], "countedSingle", "countedBatched")
    if not found:
        return None
    lines, totals = [line.split() for line in found[0]], found[1]
    # The first of three calls per kind warms up.
    counted = [total for i, total in enumerate(totals) if i % 3]
    return {f"{instruction_set} {kind} {query}": round(total / int(rays))
            for (kind, query, rays), total in zip(lines, counted, strict=True)}


def check_record(name, program, values, record):
    """Compares values with those recorded for this compiler, or records them."""
    print("\n".join(f"{key}: {value}" for key, value in values.items()))
    path = Path(__file__).with_name(f"{name}.json")
    recorded = json.loads(path.read_text()) if path.exists() else {}
    if record:
        recorded[compiler()] = values
        path.write_text(json.dumps(recorded, indent=2) + "\n")
        return 0
    if compiler() not in recorded:
        skip(f"nothing is recorded for {compiler()}")
    failed = 0
    for key, value in values.items():
        before = recorded[compiler()].get(key, 0)
        if abs(value - before) > TOLERANCE * before:
            print(f"{key}: {value} instructions, {before} are recorded; if the change is intended, run "
                  f"tests/cost/instructions.py {name} {program} --record")
            failed = 1
    return failed


def check_rays(program, record):
    values = {}
    for instruction_set in INSTRUCTION_SETS:
        found = instructions_per_ray(program, instruction_set)
        if not found:
            print(f"no {instruction_set} on this machine")
        values |= found or {}
    return check_record("rays", program, values, record)


def check_samples(program, record):
    found = counted_calls([program, *SAMPLED_SCENES], "countedSingle", "countedBatched", "countedFrame")
    if not found:
        sys.exit(f"{program} failed")
    lines, totals = [line.split() for line in found[0]], found[1]
    values = {}
    for i, (scene, samples) in enumerate(lines):
        # The first three of six calls per scene warm up.
        for query, total in zip(("single", "batched", "frame"), totals[6 * i + 3:6 * i + 6], strict=True):
            values[f"{scene} {query}"] = round(total / int(samples))
    return check_record("samples", program, values, record)


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

    plain, failed = instructions(), 0
    for setting in UNUSED:
        cost = instructions(setting) / plain - 1.0
        print(f"{setting}: {100 * cost:+.3f} %")
        if abs(cost) > LARGEST_COST:
            failed = 1
    return failed


def main():
    if not shutil.which("valgrind"):
        skip("valgrind is not installed")
    # The commands run in folders of their own.
    arguments = [str(Path(argument).resolve()) if Path(argument).exists() else argument for argument in sys.argv[1:]]
    match arguments:
        case ["rays", program, *options] if options in ([], ["--record"]):
            sys.exit(check_rays(program, bool(options)))
        case ["samples", program, *options] if options in ([], ["--record"]):
            sys.exit(check_samples(program, bool(options)))
        case ["unused", program]:
            sys.exit(check_unused(program))
    sys.exit(__doc__)


main()
