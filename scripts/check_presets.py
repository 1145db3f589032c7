#!/usr/bin/env python3
"""Excess rays of the presets over the Pareto front of each shipped scene. Rays, unlike times, do not depend on the machine.

check_presets.py [--scenes A,B] [--presets A,B] [--size WxH] [--seeds N] [--program PATH] [--cache FOLDER]
prints a Markdown table. Each scene is rendered with every combination of samples per light and reflection and of depth
with an effect in it, at increasing samples per pixel. A combination ends when its error is below that of all presets, when it
takes 1.5 times the rays of the most expensive preset, or when it took more than twice the rays of the front at two successive
sample counts. Errors are RMSE of linear values against a picture with 16 times the samples of `reference`; the mean square over
seeds. The front is interpolated on logarithmic axes. Scenes may be files.
"""
import argparse, itertools, json, math, os, subprocess, tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LARGE = ("million", "ten-million")
NO_BUILTIN = ("scenes/spheres-moving.toml",)
# Settings with an effect for each requirement of a scene (`rayscope info --json`), values by increasing cost.
CHOICES = {"segment lights": ("segment_samples", (1, 2, 4, 8)), "parallelogram lights": ("parallelogram_samples", (1, 2)),
           "reflections": ("max_depth", (1, 2, 3, 4, 6, 16))}
MOST_SAMPLES = 4096


def output_of(args, *command):
    return subprocess.run([args.program, *command], capture_output=True, text=True, check=True).stdout


def choices_of(args, scene):
    info = json.loads(output_of(args, "info", scene, "--json"))
    grid = dict(CHOICES[need["name"]] for need in info["requirements"] if need["needed"] and need["name"] in CHOICES)
    if json.loads(render(args, scene, (), 0)[2])["glossy"] == "true":
        grid["glossy_samples"] = (1, 2, 4)
    return grid


def render(args, scene, options, seed, picture=None):
    """Rays, picture file and settings (as JSON) of one picture."""
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        output_of(args, "render", scene, "--size", args.size, "--seed", str(seed), "-q", "--threads", "1", "--stats", stats,
                  "-o", picture or os.path.join(folder, "picture.pfm"), *options)
        with open(stats) as file:
            figures = json.load(file)
        return figures["rays"], picture, json.dumps(figures["settings"])


def measure(args, scene, options, reference):
    """(rays, RMSE) of one choice."""
    squares = []
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.pfm")
        for seed in range(1, args.seeds + 1):
            rays, _, _ = render(args, scene, options, seed, picture)
            squares.append(json.loads(output_of(args, "compare", picture, reference, "--json"))["rmse"] ** 2)
    return rays, math.sqrt(sum(squares) / len(squares))


def front_of(points):
    front = []
    for rays, error, name in sorted(points):
        if not front or error < front[-1][1]:
            front.append((rays, error, name))
    return front


def excess_over(front, rays, error):
    """Rays beyond those of the front at the same error, relative to them; and the first of its points with no larger error."""
    for k, (r, e, name) in enumerate(front):
        if e > error:
            continue
        if k > 0:
            last_r, last_e, _ = front[k - 1]
            r = last_r * (r / last_r) ** (math.log(error / last_e) / math.log(e / last_e))
        return max(0.0, rays / r - 1), name
    return 0.0, ""


def reference_for(args, scene):
    path = os.path.join(args.cache, os.path.basename(scene).replace(":", "-") + f"-{args.size}.pfm")
    if not os.path.exists(path):
        render(args, scene, ("--preset", "reference", "--spp", "16384"), 90001, path)
    return path


class Series:
    """One combination at increasing samples per pixel."""

    def __init__(self, combination):
        self.names = [f"{key} {value}" for key, value in combination]
        self.options = [argument for key, value in combination for argument in ("--set", f"{key}={value}")]
        self.points, self.steps_off_front = [], 0

    def extend(self, args, scene, spp, reference):
        point = measure(args, scene, (*self.options, "--spp", str(spp)), reference)
        self.points.append((*point, ", ".join([f"spp {spp}", *self.names])))

    def goes_on(self, front, most_rays, least_error):
        rays, error, _ = self.points[-1]
        self.steps_off_front = self.steps_off_front + 1 if excess_over(front, rays, error)[0] > 1 else 0
        return self.steps_off_front < 2 and error > least_error and rays < most_rays


def points_about(args, scene, reference, presets):
    """Points of all combinations, around the errors of the presets."""
    grid = choices_of(args, scene)
    running = [Series(tuple(zip(grid, values))) for values in itertools.product(*grid.values())]
    most_rays, least_error = 1.5 * max(p[0] for p in presets), min(p[1] for p in presets)
    points, spp = [], 1
    with ThreadPoolExecutor(args.jobs) as pool:
        while running and spp <= MOST_SAMPLES:
            list(pool.map(lambda series: series.extend(args, scene, spp, reference), running))
            points += [series.points[-1] for series in running]
            front = front_of(points)
            running = [series for series in running if series.goes_on(front, most_rays, least_error)]
            spp *= 2
    return points


def check(args, scene):
    reference = reference_for(args, scene)
    presets = [(*measure(args, scene, ("--preset", name), reference), "preset " + name) for name in args.presets.split(",")]
    points = points_about(args, scene, reference, presets)
    front = front_of(points + presets)
    cells = []
    for rays, error, _ in presets:
        excess, better = excess_over(front, rays, error)
        cells.append(f"{100 * excess:.0f} %" + (f" ({better})" if excess > args.name_above else ""))
    print(f"| {os.path.basename(scene).removeprefix('builtin:')} | {len(points)} | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", help="absent: all but the large ones")
    parser.add_argument("--size", default="40x40")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--presets", default="preview,balanced,final")
    parser.add_argument("--name-above", type=float, default=0.1, help="excess above which the better settings are named")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/rayscope"))
    parser.add_argument("--cache", help="folder for references; absent: a temporary one")
    parser.add_argument("--jobs", type=int, default=2, help="pictures at once")
    args = parser.parse_args()
    scenes = [f"builtin:{scene}" if not scene.endswith(".toml") else scene for scene in args.scenes.split(",")] \
        if args.scenes else [scene["name"] for scene in json.loads(output_of(args, "info", "--list", "--json"))
                             if scene["name"].removeprefix("builtin:") not in LARGE] \
        + [os.path.join(ROOT, file) for file in NO_BUILTIN]
    names = args.presets.split(",")
    print("| scene | choices | " + " | ".join(names) + " |\n|---|---" + "|---" * len(names) + "|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        args.cache = args.cache or folder
        os.makedirs(args.cache, exist_ok=True)
        for scene in scenes:
            check(args, scene)


if __name__ == "__main__":
    main()
