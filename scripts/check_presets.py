#!/usr/bin/env python3
"""How far the presets are from the front of each shipped scene, in rays, which are the same on every machine.

check_presets.py [--scenes A,B] [--size WxH] [--seeds N] [--most RAYS] [--program PATH] [--cache FOLDER]
prints a Markdown table. Each scene is rendered with every combination of samples per pixel, samples per light, lens and
reflection, depth and texture filter that can matter in it, as long as a picture takes no more than --most rays. Errors are
RMSE of linear values against a picture with far more samples; the mean square over seeds. The front is what no other
combination beats in both; between its points it is interpolated on logarithmic axes. Scenes may be files, too.
"""
import argparse, itertools, json, math, os, subprocess, tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LARGE = ("dragon", "million", "ten-million")
PRESETS = ("preview", "balanced", "final")
# What each requirement of a scene (`rayscope info --json`) lets one choose, cheap values first.
CHOICES = {"segment lights": ("segment_samples", (1, 2, 4, 8)), "parallelogram lights": ("parallelogram_samples", (1, 2)),
           "reflections": ("max_depth", (1, 2, 3, 4, 5))}


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


def behind(front, rays, error):
    """How many more rays than the front needs for the error; and the first of its points with no larger error."""
    for k, (r, e, name) in enumerate(front):
        if e > error:
            continue
        if k > 0:
            last_r, last_e, _ = front[k - 1]
            r = last_r * (r / last_r) ** (math.log(error / last_e) / math.log(e / last_e))
        return rays / r - 1, name
    return 0.0, ""


def reference_for(args, scene):
    path = os.path.join(args.cache, os.path.basename(scene).replace(":", "-") + f"-{args.size}.pfm")
    if not os.path.exists(path):
        render(args, scene, ("--preset", "reference", "--spp", "16384"), 90001, path)
    return path


def check(args, scene):
    reference, grid = reference_for(args, scene), choices_of(args, scene)
    combinations = [tuple(zip(grid, values)) for values in itertools.product(*grid.values())]

    def series(combination):
        """One combination with more and more samples per pixel."""
        points = []
        for spp in (2**k for k in range(9)):
            options = [word for key, value in combination for word in ("--set", f"{key}={value}")]
            rays, error = measure(args, scene, (*options, "--spp", str(spp)), reference)
            points.append((rays, error, ", ".join([f"spp {spp}"] + [f"{key} {value}" for key, value in combination])))
            if 2 * rays > args.most:
                break
        return points

    with ThreadPoolExecutor(args.jobs) as pool:
        points = [point for part in pool.map(series, combinations) for point in part]
    presets = [(*measure(args, scene, ("--preset", name), reference), "preset " + name) for name in PRESETS]
    front = front_of(points + presets)
    cells = []
    for rays, error, _ in presets:
        excess, better = behind(front, rays, error)
        cells.append(f"{100 * excess:.0f} %" + (f" ({better})" if excess > args.told else ""))
    print(f"| {os.path.basename(scene)} | {len(points)} | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", help="absent: all but the large ones")
    parser.add_argument("--size", default="40x40")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--most", type=float, default=2e6, help="rays of a picture at most")
    parser.add_argument("--told", type=float, default=0.1, help="beyond so much the better choice is named")
    parser.add_argument("--program", default=os.path.join(ROOT, "build/release/rayscope"))
    parser.add_argument("--cache", help="folder for references; absent: a temporary one")
    parser.add_argument("--jobs", type=int, default=2, help="pictures at once")
    args = parser.parse_args()
    scenes = [f"builtin:{scene}" if not scene.endswith(".toml") else scene for scene in args.scenes.split(",")] \
        if args.scenes else [scene["name"] for scene in json.loads(output_of(args, "info", "--list", "--json"))
                             if scene["name"].removeprefix("builtin:") not in LARGE]
    print("| scene | choices | preview | balanced | final |\n|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        args.cache = args.cache or folder
        os.makedirs(args.cache, exist_ok=True)
        for scene in scenes:
            check(args, scene)


if __name__ == "__main__":
    main()
