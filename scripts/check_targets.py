#!/usr/bin/env python3
"""Checks `render --target-error`: how often the error is below the target, and how accurate the forecasts are.

check_targets.py [--seeds N] [--first-seed N] [--scenes A,B] [--size WxH] [--program PATH] [--options "…"] [--cache FOLDER] [--jobs N]
prints a Markdown table. A scene may be followed by settings: environment:reflection_map=true. Each seed is rendered to
a target, about a third of the error of 16 samples per pixel, and compared with a reference ten times as accurate, which
--cache keeps. The confidence level holds if the number of failures is within the 99 % binomial limit. Forecasts are the last
ones before half of the total, of samples and of seconds.
"""
import argparse, json, math, os, subprocess, tempfile
from concurrent.futures import ThreadPoolExecutor

SCENES = ("cornell,cornell-area,cornell-glossy,cornell-transparent,cube-textured,monkey,spheres,spheres-dof,teapot,custom,"
          "environment,environment:reflection_map=true")
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def most_failures(runs, risk):
    """The number of failures that is exceeded with a probability below 1 %."""
    total = 0.0
    for k in range(runs + 1):
        total += math.comb(runs, k) * risk**k * (1 - risk) ** (runs - k)
        if total >= 0.99:
            return k
    return runs


def render(args, scene, target, seed, file, extra=()):
    name, *settings = scene.split(":")
    command = [args.program, "render", "builtin:" + name, "--size", args.size, "--target-error", repr(target),
               "--seed", str(seed), "-o", file, "--progress", "json", "--threads", "1", *args.options.split(), *extra]
    for setting in settings:
        command += ["--set", setting]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(f"{' '.join(command)}: {done.stderr}")
    lines = done.stderr.splitlines()
    return [json.loads(line) for line in lines if line.startswith("{")]


def error_of(args, image, reference):
    output = subprocess.run([args.program, "compare", image, reference, "--json"], capture_output=True, text=True)
    return json.loads(output.stdout)["rmse"]


def forecast_errors(events):
    """Relative errors of the forecasts of all samples and of all seconds at half of them; None without a forecast."""
    errors = []
    for spent, total in (("samples", lambda event: event["expected_samples"]),
                         ("elapsed_s", lambda event: event["elapsed_s"] + event["remaining_s"])):
        early = [event for event in events if event["expected_samples"] > 0 and event[spent] <= 0.5 * events[-1][spent]]
        errors.append(total(early[-1]) / events[-1][spent] - 1 if early else None)
    return errors


def reference_for(args, scene, folder):
    """A target for the scene, and a picture ten times as accurate."""
    stem = os.path.join(folder, scene.replace(":", "-") + "-" + args.size)
    if not os.path.exists(stem + ".json"):
        pilot = render(args, scene, 1e-9, 90001, stem + ".pfm", ("--spp", "16"))
        target = (pilot[-1]["error"] or 1e-3) / 3
        render(args, scene, target / 10, 90002, stem + ".pfm")
        with open(stem + ".json", "w") as file:
            json.dump(target, file)
    with open(stem + ".json") as file:
        return json.load(file), stem + ".pfm"


def run(args, scene, target, reference, seed):
    with tempfile.TemporaryDirectory() as folder:
        image = os.path.join(folder, "image.pfm")
        events = render(args, scene, target, seed, image)
        return events[-1]["samples"], error_of(args, image, reference), forecast_errors(events)


def fraction_right(errors):
    known = [abs(e) <= 0.25 for e in errors if e is not None]
    return f"{100 * sum(known) / len(known):.0f} % of {len(known)}" if known else "–"


def check(args, scene, folder):
    target, reference = reference_for(args, scene, folder)
    with ThreadPoolExecutor(args.jobs) as pool:
        runs = list(pool.map(lambda seed: run(args, scene, target, reference, seed), range(args.first_seed, args.first_seed + args.seeds)))
    samples, errors, forecasts = zip(*runs)
    failures = sum(error > target for error in errors)
    limit = most_failures(args.seeds, 1 - args.confidence)
    print(f"| {scene} | {target:.3g} | {sum(samples) / len(samples):.0f} | {args.seeds - failures} of {args.seeds} "
          f"| {'yes' if failures <= limit else '**no**'} | {sum(errors) / len(errors) / target:.2f} "
          f"| {fraction_right([f[0] for f in forecasts])} | {fraction_right([f[1] for f in forecasts])} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--scenes", default=SCENES)
    parser.add_argument("--size", default="32x32")
    parser.add_argument("--confidence", type=float, default=0.95)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/rayscope"))
    parser.add_argument("--options", default="")
    parser.add_argument("--cache", help="folder for references; absent: a temporary one")
    parser.add_argument("--jobs", type=int, default=1, help="seeds at once; forecasts of seconds suffer from more than one")
    args = parser.parse_args()
    args.options += f" --confidence {args.confidence}"
    print("| scene | target RMSE | samples | error below target | confidence holds | error / target "
          "| forecasts of samples within 25 % | of seconds |\n|---|---|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        if args.cache:
            os.makedirs(args.cache, exist_ok=True)
        for scene in args.scenes.split(","):
            check(args, scene, args.cache or folder)


if __name__ == "__main__":
    main()
