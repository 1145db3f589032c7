#!/usr/bin/env python3
"""Checks what `render --target-error` promises: how often the error stays below the target, and how good forecasts are.

check_targets.py [--seeds N] [--scenes A,B] [--size WxH] [--program PATH] [--options "…"] prints a Markdown table. Each
seed of a scene is rendered to a target and compared with a reference that is ten times more accurate. The promise is
kept if the number of failures is within the 99 % binomial limit of what the confidence allows.
"""
import argparse, json, math, os, subprocess, tempfile

SCENES = "cornell,cornell-area,cornell-glossy,cornell-transparent,teapot,spheres,spheres-dof,environment,cube-textured"
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def most_failures(runs, risk):
    """The largest count that a fair promise exceeds with less than 1 %."""
    total = 0.0
    for k in range(runs + 1):
        total += math.comb(runs, k) * risk**k * (1 - risk) ** (runs - k)
        if total >= 0.99:
            return k
    return runs


def render(args, scene, target, seed, file, extra=()):
    command = [args.program, "render", "builtin:" + scene, "--size", args.size, "--target-error", repr(target),
               "--seed", str(seed), "-o", file, "--progress", "json", *args.options.split(), *extra]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(f"{' '.join(command)}: {done.stderr}")
    lines = done.stderr.splitlines()
    return [json.loads(line) for line in lines if line.startswith("{")]


def error_of(args, image, reference):
    output = subprocess.run([args.program, "compare", image, reference, "--json"], capture_output=True, text=True)
    return json.loads(output.stdout)["rmse"]


def forecast_error(looks):
    """Relative error of the forecast of all work at half of the way, or None if there was no look before. In samples,
    to which time is proportional where nothing else disturbs the machine."""
    total = looks[-1]["samples"]
    early = [look for look in looks if look["error_upper"] > 0 and look["samples"] <= 0.6 * total]
    if not early:
        return None
    nearest = min(early, key=lambda look: abs(look["samples"] - 0.5 * total))
    return nearest["samples"] * (1 + nearest["remaining_s"] / nearest["elapsed_s"]) / total - 1


def check(args, scene, folder):
    reference = os.path.join(folder, scene + ".pfm")
    # A few samples tell how noisy the scene is; the target should take some five times as many.
    pilot = render(args, scene, 1e-9, 90001, reference, ("--spp", "16"))
    target = (pilot[-1]["error"] or 1e-3) / 3
    render(args, scene, target / 10, 90002, reference)
    failures, ratios, forecasts, samples = 0, [], [], []
    for seed in range(args.seeds):
        image = os.path.join(folder, "image.pfm")
        looks = render(args, scene, target, seed, image)
        error = error_of(args, image, reference)
        failures += error > target
        ratios.append(error / target)
        samples.append(looks[-1]["samples"])
        wrong = forecast_error(looks)
        if wrong is not None:
            forecasts.append(abs(wrong) <= 0.25)
    limit = most_failures(args.seeds, 1 - args.confidence)
    good = f"{100 * sum(forecasts) / len(forecasts):.0f} % of {len(forecasts)}" if forecasts else "–"
    print(f"| {scene} | {target:.3g} | {sum(samples) / len(samples):.0f} | {args.seeds - failures} of {args.seeds} "
          f"| {'yes' if failures <= limit else '**no**'} | {sum(ratios) / len(ratios):.2f} | {good} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--scenes", default=SCENES)
    parser.add_argument("--size", default="48x48")
    parser.add_argument("--confidence", type=float, default=0.95)
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/rayscope"))
    parser.add_argument("--options", default="")
    args = parser.parse_args()
    args.options += f" --confidence {args.confidence}"
    print("| scene | target RMSE | samples | error below target | promise kept | error / target | forecasts within 25 % |\n"
          "|---|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for scene in args.scenes.split(","):
            check(args, scene, folder)


if __name__ == "__main__":
    main()
