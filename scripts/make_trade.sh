#!/usr/bin/env bash
# scripts/make_trade.sh [SECONDS [SCENE…]]: runs `rayscope trade` on the shipped scenes, or on the named ones, SECONDS each
# (default 120), and writes docs/trade: a page per scene and a table of all. $TRADE_OPTIONS has further options of
# `rayscope trade`. Uses the program in build/release.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/build/release/rayscope
seconds=${1:-120}
shift || true
scenes=("$@")
if ((${#scenes[@]} == 0)); then
    mapfile -t scenes < <("$program" info --list --json | python3 -c '
import json, sys
print("\n".join(scene["name"].removeprefix("builtin:") for scene in json.load(sys.stdin)))')
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$root/docs/trade"
measured=()
for scene in "${scenes[@]}"; do
    echo "== $scene"
    # shellcheck disable=SC2086
    "$program" trade "builtin:$scene" --budget "$seconds" -o "$folder/$scene" ${TRADE_OPTIONS:-} || (($? == 3)) ||
        { echo "left out: $scene"; continue; }
    cp "$folder/$scene/trade.html" "$root/docs/trade/$scene.html"
    measured+=("$scene")
done

python3 - "$folder" "${measured[@]}" >"$root/docs/trade/README.md" <<'END'
import json, sys

folder, scenes = sys.argv[1], sys.argv[2:]
reports = {scene: json.load(open(f"{folder}/{scene}/trade.json")) for scene in scenes}
first = next(iter(reports.values()))

def number(value): return f"{value:.3g}"
def interval(i): return f"{number(i['value'])} [{number(i['lower'])}, {number(i['upper'])}]" if i["value"] else "–"

print("# Speed against accuracy on the shipped scenes\n\nWritten by `scripts/make_trade.sh`: "
      f"{first['width']} × {first['height']} pixels, {first['threads']} thread(s), {first['budget_seconds']:g} s per scene. "
      "The pages are complete reports; open them in a browser. Slope: error ~ samples^slope. Noise: timing noise of the machine. "
      "preview, balanced, final: excess time of the preset over the Pareto front at the same error; – not measured within the "
      "budget; ? not significant.\n")
noises = sorted(report["smallest_time_difference"] or 0 for report in reports.values())
if noises[len(noises) // 2] > 0.25:
    print("The machine was busy: with timing noise above 25 % errors, slopes and biases are valid, times only roughly.\n")
print("| scene | candidates | RMSE of the reference | slope | noise | preview | balanced | final |\n"
      "|---|---|---|---|---|---|---|---|")
for scene, report in reports.items():
    worse = {p["name"] for p in report["points"] if p.get("dominated_by")}
    excess = {d["preset"]: f"{100 * d['excess_time']:.0f} %" + ("" if d["excess_time"] < 0.005 or d["point"] in worse else "?")
              for d in report["dial"]}
    noise = report["smallest_time_difference"]
    print(f"| [{scene}]({scene}.html) | {len(report['points'])} | {number(report['reference']['rmse'] or 0)} "
          f"| {interval(report['convergence_slope'])} | {100 * noise:.0f} % | "
          + " | ".join(excess.get(name, "–") for name in ("preview", "balanced", "final")) + " |")
print("\n| scene | budget | settings | seconds | RMSE |\n|---|---|---|---|---|")
for scene, report in reports.items():
    for advice in report["advice"]:
        point = next(p for p in report["points"] if p["name"] == advice["point"])
        print(f"| {scene} | {number(advice['seconds'])} s | {point['name']} | {interval(point['seconds'])} "
              f"| {interval(point['rmse'])} |")
END
