#!/usr/bin/env python3
"""bench_page.py FILE.json…: the page docs/bench.md from what `rayscope bench --json` wrote."""
import json
import pathlib
import sys

KINDS = {"primary": "primary", "shadow": "shadow", "bounce": "bounce", "ao": "ambient occlusion"}


def ratio(interval):
    return f"{interval['median']:.2f} ({interval['low']:.2f} … {interval['high']:.2f})"


def scene(row):
    return f"{pathlib.PurePath(row['scene'].removeprefix('builtin:')).stem} ({row['triangles']:,})"


def table(head, rows):
    print("| " + " | ".join(head) + " |")
    print("|" + "---|" * len(head))
    for cells in rows:
        print("| " + " | ".join(cells) + " |")
    print()


def builds(rows):
    print("## Builds\n")
    table(["mesh", "threads", "Rayscope, ms", "Embree, ms", "times as fast", "bytes per triangle", "Embree's", "SAH cost"],
          [[scene(r), str(r["threads"]), f"{r['build_ms']:.1f}", f"{r['embree_build_ms']:.1f}", ratio(r["build_ratio"]),
            f"{r['bytes_per_triangle']:.0f}", f"{r['embree_bytes_per_triangle']:.0f}", f"{r['sah_cost']:.1f}"]
           for r in rows])


def rays(rows, threads):
    print(f"## Rays, {threads} thread{'s' if threads > 1 else ''}\n")
    body = []
    for r in rows:
        for kind, name in KINDS.items():
            t = r["rays"][kind]
            best = max(t["embree_mrays_per_s"], t["embree_packet16_mrays_per_s"], t["embree_stream_mrays_per_s"])
            body.append([scene(r), name, f"{t['mrays_per_s']:.2f}", f"{t['batched_mrays_per_s']:.2f}",
                         f"{t['embree_mrays_per_s']:.2f}", f"{t['embree_robust_mrays_per_s']:.2f}", f"{best:.2f}",
                         ratio(t["ratio_interval"]), ratio(t["ratio_to_robust"]), ratio(t["batched_to_embree_single"]),
                         ratio(t["batched_to_embree_best"])])
    table(["mesh", "rays", "single", "batched", "Embree", "Embree robust", "Embree's best", "single / Embree",
           "single / robust", "batched / Embree", "batched / best"], body)


def main():
    rows = [row for name in sys.argv[1:] for row in json.loads(pathlib.Path(name).read_text())]
    print("# Builds and rays beside Embree\n")
    print(f"""Written by `scripts/make_bench.sh` from `rayscope bench`. Million rays per second, medians of seven rounds in which all
contestants take turns; ratios are medians of the ratios of each round, with the order statistics that enclose the true
median with 95 % confidence (for fewer rounds than that takes, an estimate). Embree 3 at medium quality: *Embree* is its default mode, one ray at a
time, *robust* its robust flag, *best* the fastest of single rays, packets of 16 and streams in each round. Kernels:
{", ".join(sorted({row["isa"] for row in rows}))}. Rays whose hit or miss differs from Embree's robust mode: {sum(row["mismatches"] for row in rows)}.
""")
    builds(rows)
    for threads in sorted({row["threads"] for row in rows}):
        rays([row for row in rows if row["threads"] == threads], threads)


if __name__ == "__main__":
    main()
