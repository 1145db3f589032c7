#!/usr/bin/env bash
# scripts/make_numerics.sh [RAYS]: runs `rayscope lab` on generated shapes and on shipped scenes with RAYS rays at shared edges
# per test point (default 2000), and writes the counts into the marked part of docs/numerics.md. They are reproducible.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/build/release/rayscope
rays=${1:-2000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
scenes=(shapes cornell monkey teapot quad-textured custom)
for scene in "${scenes[@]}"; do
    echo "== $scene"
    arguments=(builtin:"$scene")
    [[ $scene != shapes ]] || arguments=()
    "$program" lab "${arguments[@]}" --rays "$rays" --json -q >"$folder/$scene.json" || (($? == 4))
done

python3 - "$root/docs/numerics.md" "$folder" "${scenes[@]}" <<'END_OF_SCRIPT'
import json, sys

page, folder, scenes = sys.argv[1], sys.argv[2], sys.argv[3:]
reports = {scene: json.load(open(f"{folder}/{scene}.json")) for scene in scenes}
methods = {"rayscope": "Rayscope", "float": "Möller–Trumbore, float",
           "epsilon": "… with 1e-6", "double": "Möller–Trumbore, double"}


def fraction(part, whole): return f"{part:,} of {whole:,}".replace(",", " ") if part else f"0 of {whole:,}".replace(",", " ")
def ratio(x): return "–" if x is None else f"{x:.3f}" if x < 100 else f"{x:.1e}"


lines = ["All test points (scales 2^-40 … 2^40, offsets 0 … 10^7 sizes), "
         f"{reports[scenes[0]]['rays_per_cell']} rays at shared edges per test point:", "",
         "| scene | method | leaks | double hits | false hits | lost surfaces | t error / bound | weight error / bound | failing test points |",
         "|---|---|---|---|---|---|---|---|---|"]
for scene, report in reports.items():
    for method, label in methods.items():
        c, r = report["totals"][method], report["ranges"][method]
        lines.append(f"| {scene} | {label} | {fraction(c['leaks'], c['aimed'])} | {fraction(c['double_hits'], c['aimed'])} "
                     f"| {fraction(c['false_hits'], c['spawned'])} | {fraction(c['lost_surfaces'], c['second_surfaces'])} "
                     f"| {ratio(c['t_error_over_bound'])} | {ratio(c['weight_error_over_bound'])} "
                     f"| {r['failing_cells']} of {len(report['cells'])} |")
lines += ["", "Leaks of the shapes at scale 2^0, by offset in sizes:", "",
          "| offset | rays | " + " | ".join(methods.values()) + " | degenerate triangles |",
          "|---|---|---|---|---|---|---|"]
for cell in reports["shapes"]["cells"]:
    if cell["scale_exponent"] != 0: continue
    m = cell["methods"]
    lines.append(f"| {cell['offset_sizes']:g} | {m['rayscope']['aimed']} | "
                 + " | ".join(str(m[name]["leaks"]) for name in methods) + f" | {cell['collapsed_triangles']} |")

text = open(page).read()
start, end = "<!-- measured -->\n", "<!-- end of measured -->\n"
before, rest = text.split(start)
_, after = rest.split(end)
open(page, "w").write(before + start + "\n".join(lines) + "\n" + end + after)
END_OF_SCRIPT
