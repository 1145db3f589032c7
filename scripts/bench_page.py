#!/usr/bin/env python3
"""bench_page.py FROM DOCS SIZE: writes the page DOCS/bench.md, its charts DOCS/images/bench-*.svg and the ratios in
DOCS/performance.md from the output of `rayscope bench --json` in the folder FROM: race-*.json, builder-*.json, growth-*.json and picture-*.json, and of
tests/bench/frame: frame-*.json (see scripts/make_bench.sh)."""
import json
import math
import pathlib
import sys

KINDS = {"primary": "primary", "shadow": "shadow", "bounce": "bounce", "ao": "ambient occlusion"}
# Okabe and Ito's palette, distinguishable with colour vision deficiencies.
COLORS = {"single / Embree": "#0072b2", "single / robust": "#56b4e9", "batched / Embree": "#d55e00", "batched / best": "#e69f00"}


def ratio(interval):
    return f"{interval['median']:.2f} ({interval['low']:.2f} … {interval['high']:.2f})"


def name(row):
    return pathlib.PurePath(row["scene"].removeprefix("builtin:")).stem


def scene(row):
    return f"{name(row)} ({row['triangles']:,})"


def threads_text(threads):
    return f"{threads} thread{'s' if threads > 1 else ''}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(cells) + " |" for cells in rows]) + "\n"


def builds(rows):
    return "## Builds\n\n" + table(
        ["mesh", "threads", "Rayscope, ms", "Embree, ms", "times as fast", "bytes per triangle", "Embree's", "levels",
         "triangles per leaf"],
        [[scene(r), str(r["threads"]), f"{r['build_ms']:.1f}", f"{r['embree_build_ms']:.1f}", ratio(r["build_ratio"]),
          f"{r['bytes_per_triangle']:.0f}", f"{r['embree_bytes_per_triangle']:.0f}", str(r["levels"]),
          f"{r['triangles_per_leaf']:.1f}"] for r in rows])


def ratios(timing):
    return {"single / Embree": timing["ratio_interval"], "single / robust": timing["ratio_to_robust"],
            "batched / Embree": timing["batched_to_embree_single"], "batched / best": timing["batched_to_embree_best"]}


def rays(rows, threads):
    body = []
    for r in rows:
        for kind, label in KINDS.items():
            t = r["rays"][kind]
            best = max(t["embree_mrays_per_s"], t["embree_packet16_mrays_per_s"], t["embree_stream_mrays_per_s"])
            body.append([scene(r), label] + [f"{x:.2f}" for x in (t["mrays_per_s"], t["batched_mrays_per_s"],
                        t["embree_mrays_per_s"], t["embree_robust_mrays_per_s"], best)] + [ratio(x) for x in ratios(t).values()])
    return f"## Rays, {threads_text(threads)}\n\n" + table(
        ["mesh", "rays", "single", "batched", "Embree", "Embree robust", "Embree's best", *COLORS], body)


def all_ratios(race):
    """Tables of all ratios to Embree: for each kind of ray a row per mesh, a column per ratio and number of threads."""
    threads = sorted({row["threads"] for row in race})
    meshes = {scene(row): {} for row in race}
    for row in race:
        meshes[scene(row)][row["threads"]] = row
    heads = [f"{label}, {threads_text(n)}" for label in COLORS for n in threads]
    return "\n".join(f"### {label.capitalize()} rays\n\n" + table(["mesh", *heads], [
        [mesh] + [ratio(ratios(by_threads[n]["rays"][kind])[column]) for column in COLORS for n in threads]
        for mesh, by_threads in meshes.items()]) for kind, label in KINDS.items())


def replace_section(page, text, what=""):
    """Replaces the part of a page between the two comments that name this script and `what`."""
    begin, end = f"<!-- {what}written by scripts/bench_page.py -->\n", f"<!-- {what}up to here -->\n"
    before, rest = page.read_text().split(begin)
    page.write_text(before + begin + "\n" + text + "\n" + end + rest.split(end)[1])


def pictures(rows):
    return table(["scene", "threads", "rays", "picture, Mray/s", "its rays alone, Mray/s", "share of search"],
                 [[name(r), str(r["threads"]), f"{r['picture']['rays']:,}", f"{r['picture']['picture_mrays_per_s']:.2f}",
                   f"{r['picture']['queries_mrays_per_s']:.2f}", ratio(r["picture"]["share_interval"])] for r in rows])


def frames(rows):
    return table(["scene", "threads", "rays", "Rayscope, ms", "Embree program, ms", "times as fast", "mean difference"],
                 [[name(r), str(r["threads"]), f"{r['rays']:,}", f"{1e3 * r['seconds']:.1f}", f"{1e3 * r['embree_seconds']:.1f}",
                   ratio(r["ratio"]), f"{r['mean_difference']:.0e}"] for r in rows])


def counters(rows):
    body = [[scene(r), label] + [f"{r['rays'][kind]['per_ray'][key]:.2f}" for key in ("nodes", "leaves", "primitives",
                                                                                     "exact_tests")]
            for r in rows for kind, label in KINDS.items()]
    return """## Traversal steps per ray

Counted in the wide layout: nodes of eight children visited, leaves visited, triangles in those leaves, and of them those that
the float filter passed to the exact test.

""" + table(["mesh", "rays", "nodes", "leaves", "triangles", "exact tests"], body)


def builders(rows):
    body = [[scene(r), r["builder"], f"{r['build_ms']:.1f}", f"{r['sah_cost']:.2f}", f"{r['counted_cost']:.2f}", str(r["levels"]),
             f"{r['binary_nodes']:,}", f"{r['wide_nodes']:,}", f"{r['triangles_per_leaf']:.1f}", f"{r['bytes_per_triangle']:.0f}"]
            + [f"{r['rays'][kind]['per_ray']['nodes'] + r['rays'][kind]['per_ray']['leaves']:.2f}" for kind in KINDS]
            for r in rows]
    return """## The builders

The SAH cost is the expected cost of a random line through the scene: inner nodes visited and triangles tested in the binary tree.
*Random lines* is the measured cost of 10,000 random lines. Both are of the binary tree built for inspection; levels and nodes are of the
one from which the wide layout is collapsed. The last columns are nodes and leaves of the wide layout visited per ray.

""" + table(["mesh", "builder", "build, ms", "SAH cost", "random lines", "levels", "nodes", "wide nodes", "triangles per leaf",
             "bytes per triangle", *KINDS.values()], body)


def growth(rows):
    def per(row, ms):
        return f"{ms * 1e6 / (row['triangles'] * math.log2(row['triangles'])):.2f}"
    body = [[f"{r['triangles']:,}", f"{r['build_ms']:.1f}", f"{r['embree_build_ms']:.1f}", ratio(r["build_ratio"]),
             per(r, r["build_ms"]), per(r, r["embree_build_ms"]), f"{r['bytes_per_triangle']:.0f}"] for r in rows]
    return f"""## Build time over mesh size

Terrain, all threads ({rows[0]['threads']}). For time proportional to n log n, nanoseconds per n log₂ n are constant.

![Build time over triangles](images/bench-builds.svg)

""" + table(["triangles", "Rayscope, ms", "Embree, ms", "times as fast", "ns per n log₂ n", "Embree's", "bytes per triangle"], body)


class Chart:
    """An SVG file with a plot area; x and y are in pixels relative to its top left corner."""

    def __init__(self, width, height, left=64, top=40, right=16, bottom=56):
        self.width, self.height, self.left, self.top = width, height, left, top
        self.total = (width + left + right, height + top + bottom)
        self.parts = []

    def text(self, x, y, content, anchor="middle"):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{content}</text>')

    def line(self, x1, y1, x2, y2, color="#999", width=1.0, dash=""):
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}" '
                          f'stroke-width="{width}"{dashed}/>')

    def dot(self, x, y, color, radius=3.5):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{color}"/>')

    def write(self, path):
        w, h = self.total
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" '
                        'font-family="sans-serif" font-size="12" fill="#222">\n<rect width="100%" height="100%" fill="#fff"/>\n'
                        f'<g transform="translate({self.left} {self.top})">\n' + "\n".join(self.parts) + "\n</g>\n</svg>\n")


def legend(chart, entries):
    x = 0
    for label, color in entries:
        chart.dot(x + 4, 14 - chart.top, color)
        chart.text(x + 14, 18 - chart.top, label, "start")
        x += 30 + 7 * len(label)


def ray_chart(rows, path):
    """Ratios with confidence intervals, a panel for each kind of ray."""
    panel, step, low, high = 220, 24, 0.25, 2.0
    position = lambda value: panel * math.log(min(max(value, low), high) / low) / math.log(high / low)
    chart = Chart(4 * (panel + 24), step * len(rows), left=170, top=64, bottom=36)
    legend(chart, [(label, color) for label, color in COLORS.items()])
    for i, row in enumerate(rows):
        chart.text(-10, step * (i + 0.5) + 4, scene(row), "end")
    for column, (kind, label) in enumerate(KINDS.items()):
        origin = column * (panel + 24)
        chart.text(origin + panel / 2, -4, label)
        for tick in (0.25, 0.5, 1.0, 2.0):
            chart.line(origin + position(tick), 0, origin + position(tick), chart.height, "#222" if tick == 1.0 else "#ddd")
            chart.text(origin + position(tick), chart.height + 16, f"{tick:g}")
        for i, row in enumerate(rows):
            for k, (name_of, interval) in enumerate(ratios(row["rays"][kind]).items()):
                y, color = step * i + 4.5 + 5 * k, COLORS[name_of]
                chart.line(origin + position(interval["low"]), y, origin + position(interval["high"]), y, color, 1.2)
                chart.dot(origin + position(interval["median"]), y, color, 2.4)
    chart.text(2 * (panel + 24), chart.height + 32, "speed relative to Embree, one thread; right is faster")
    chart.write(path)


def build_chart(rows, path):
    """Build times over triangles on logarithmic axes."""
    chart = Chart(560, 300, right=44)
    xs = [math.log10(r["triangles"]) for r in rows]
    times = [t for r in rows for t in (r["build_ms"], r["embree_build_ms"])]
    bottom, top = math.floor(math.log10(min(times))), math.ceil(math.log10(max(times)))
    x = lambda value: chart.width * (value - xs[0]) / (xs[-1] - xs[0])
    y = lambda ms: chart.height * (top - math.log10(ms)) / (top - bottom)
    for exponent in range(bottom, top + 1):
        chart.line(0, y(10.0**exponent), chart.width, y(10.0**exponent), "#ddd")
        chart.text(-8, y(10.0**exponent) + 4, f"{10.0**exponent:g} ms", "end")
    for exponent in range(round(xs[0]), round(xs[-1]) + 1):
        chart.text(x(exponent), chart.height + 18, f"{10**exponent:,}")
    chart.text(chart.width / 2, chart.height + 40, "triangles")
    legend(chart, [("Rayscope", "#0072b2"), ("Embree", "#d55e00"), ("n log n through the largest", "#999999")])
    law = [(v, rows[-1]["build_ms"] * 10**(v - xs[-1]) * v / xs[-1]) for v in xs]
    for (x1, t1), (x2, t2) in zip(law, law[1:]):
        chart.line(x(x1), y(t1), x(x2), y(t2), "#999999", 1.0, "5 4")
    for key, color in (("build_ms", "#0072b2"), ("embree_build_ms", "#d55e00")):
        points = [(x(v), y(r[key])) for v, r in zip(xs, rows)]
        for (x1, y1), (x2, y2) in zip(points, points[1:]):
            chart.line(x1, y1, x2, y2, color, 2.0)
        for px, py in points:
            chart.dot(px, py, color)
    chart.write(path)


def main():
    folder, docs, size = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    read = lambda pattern: [row for file in sorted(folder.glob(pattern)) for row in json.loads(file.read_text())]
    race, grown = read("race-*.json"), sorted(read("growth-*.json"), key=lambda row: row["triangles"])
    threads = sorted({row["threads"] for row in race})
    one = [row for row in race if row["threads"] == threads[0]]
    pages = [f"""# Build times and ray throughput compared with Embree

Written by `scripts/make_bench.sh` from `rayscope bench`. Million rays per second, medians of seven rounds of
interleaved measurements, on an image of {size} × {size} pixels; ratios are medians of the ratios of each round, with 95 % confidence
intervals between order statistics (approximate for fewer than six rounds). Embree 3 at medium quality: *Embree* is its default
mode, one ray at a time, *robust* its robust flag, *best* the fastest of single rays, packets of 16 and streams in each round.
Kernels: {", ".join(sorted({row["isa"] for row in race}))}. Rays that hit in one and miss in the other of Rayscope and Embree's robust mode:
{sum(row["mismatches"] for row in race)}.

*room* is the dragon of 871,414 triangles between 36 large ones; *hard* is long thin diagonal triangles, clusters ten thousand times
smaller than the scene and a few triangles of its size ([hard_mesh.py](../scripts/hard_mesh.py)); it is not closed, so results
may differ by rounding at its boundary; *hills* is terrain.

![Ratios to Embree](images/bench-rays.svg)
""", builds(race), *[rays([row for row in race if row["threads"] == n], n) for n in threads], counters(one),
             builders(sorted(read("builder-*.json"), key=lambda row: name(row))), growth(grown)]
    (docs / "bench.md").write_text("\n".join(pages))
    replace_section(docs / "performance.md", all_ratios(race))
    replace_section(docs / "performance.md", pictures(read("picture-*.json")), "pictures ")
    replace_section(docs / "performance.md", frames(read("frame-*.json")), "frames ")
    ray_chart(one, docs / "images" / "bench-rays.svg")
    build_chart(grown, docs / "images" / "bench-builds.svg")


if __name__ == "__main__":
    main()
