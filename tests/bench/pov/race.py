#!/usr/bin/env python3
"""Renders the same pictures with Rayscope and with POV-Ray 3.7 and compares time and error.

    tests/bench/pov/race.py [--program build/release/rayscope] [--rounds 7] [--size 800] [--scene NAME]
                           [--keep FOLDER]

Both programs get the same triangles, materials, lights and camera, and run interleaved on all cores. The error is the RMSE of linear values, clipped to 0 … 1 as POV-Ray's files are, against a
converged picture by Rayscope; `offset` is the mean of POV-Ray's picture minus the reference, to check that
both render the same picture. Prints a table in Markdown.
"""
import argparse
import array
import json
import math
import os
import random
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
CAMERA = {"from": (-0.964181, 1.026060, -2.649067), "at": (0.0, 0.0, 0.0), "fov": 50.0}


def read_materials(path):
    materials, current = {}, None
    for line in path.read_text().splitlines():
        fields = line.split()
        if not fields:
            continue
        if fields[0] == "newmtl":
            current = materials.setdefault(fields[1], {"kd": (0.8,) * 3, "ks": (0.0,) * 3, "ns": 1.0})
        elif fields[0] in ("Kd", "Ks"):
            current[fields[0].lower()] = tuple(float(w) for w in fields[1:4])
        elif fields[0] == "Ns":
            current["ns"] = float(fields[1])
    return materials


def cornell():
    """The Cornell box under a white light of 10 by 10 samples."""
    scale, move = 0.0019155, (-0.5298, -0.4075, -0.5474)
    vertices, triangles, material = [], [], None
    for line in (ROOT / "scenes/cornell.obj").read_text().splitlines():
        fields = line.split()
        if fields[:1] == ["v"]:
            vertices.append(tuple(float(w) * scale + m for w, m in zip(fields[1:4], move)))
        elif fields[:1] == ["usemtl"]:
            material = fields[1]
        elif fields[:1] == ["f"]:
            corners = [int(w.split("/")[0]) - 1 for w in fields[1:]]
            for i in range(1, len(corners) - 1):
                triangles.append((material, corners[0], corners[i], corners[i + 1]))
    return {
        "name": "Cornell box, 10 x 10 light samples",
        "vertices": vertices, "normals": None, "triangles": triangles,
        "materials": read_materials(ROOT / "scenes/cornell.mtl"),
        "light": {"corner": (-0.2, 0.5, 0.0), "edges": ((0.4, 0.0, 0.0), (0.0, 0.0, 0.4))},
        "variants": {"1 spp, 10 x 10": ("spp=1", "parallelogram_samples=10"),
                     "4 spp, 5 x 5": ("spp=4", "parallelogram_samples=5"),
                     "4 spp, 2 x 2": ("spp=4", "parallelogram_samples=2")},
        "reference": ("spp=256", "parallelogram_samples=2"),
    }


def scales():
    """A closed shape of 87,362 triangles with a scaly surface over a mirroring floor, under a point light."""
    rings, columns = 209, 209
    vertices, normals, triangles = [], [], []

    def point(i, j):
        theta, phi = math.pi * j / rings, 2.0 * math.pi * (i % columns) / columns
        radius = 0.55 + 0.05 * math.sin(9 * theta) * math.cos(7 * phi) + 0.012 * math.sin(40 * theta) * math.sin(38 * phi)
        return (radius * math.sin(theta) * math.cos(phi), radius * math.cos(theta) + 0.15,
                radius * math.sin(theta) * math.sin(phi))

    for j in range(rings + 1):
        for i in range(columns):
            vertices.append(point(i, j))
    for j in range(rings):
        for i in range(columns):
            a, b = j * columns + i, j * columns + (i + 1) % columns
            c, d = a + columns, b + columns
            triangles += [("shape", a, b, d), ("shape", a, d, c)]
    return on_mirror("87k triangles, point light, mirroring floor", vertices, triangles, -0.5)


def dragon():
    """The Stanford dragon of 87,130 triangles from scripts/fetch_dragon.sh, at the same position."""
    vertices, triangles = [], []
    for line in (ROOT / "scenes/meshes/dragon.obj").read_text().splitlines():
        fields = line.split()
        if fields[:1] == ["v"]:
            vertices.append(tuple(map(float, fields[1:])))
        elif fields[:1] == ["f"]:
            triangles.append(("shape", *(int(w.split("/")[0]) - 1 for w in fields[1:])))
    return on_mirror("Dragon, point light, mirroring floor", vertices, triangles, -0.52)


def on_mirror(name, vertices, triangles, height):
    first = len(vertices)
    vertices = vertices + [(-3.0, height, -3.0), (3.0, height, -3.0), (3.0, height, 3.0), (-3.0, height, 3.0)]
    triangles = triangles + [("floor", first, first + 1, first + 2), ("floor", first, first + 2, first + 3)]
    return {
        "name": name,
        "vertices": vertices, "normals": None, "triangles": triangles,
        "materials": {"shape": {"kd": (0.42, 0.68, 0.5), "ks": (0.0,) * 3, "ns": 30.0},
                      "floor": {"kd": (0.4, 0.4, 0.4), "ks": (0.3, 0.3, 0.3), "ns": 60.0}},
        "light": {"position": (-1.0, 1.6, -1.4)},
        "variants": {"1 spp": ("spp=1",), "2 spp": ("spp=2",), "4 spp": ("spp=4",)},
        "reference": ("spp=256",),
    }


def numbers(values, separator=", "):
    return separator.join(f"{v:.9g}" for v in values)


def lens_of(scene):
    """The lens for Rayscope: its radius is focal_length / (2 f_number)."""
    if "lens" not in scene:
        return ""
    radius, distance = scene["lens"]
    return f"lens = {{ f_number = 1, focal_length = {2 * radius:.9g}, focus_distance = {distance:.9g} }}\n"


def write_rayscope(scene, folder):
    with open(folder / "scene.mtl", "w") as f:
        for name, m in scene["materials"].items():
            f.write(f"newmtl {name}\nKd {numbers(m['kd'], ' ')}\nKs {numbers(m['ks'], ' ')}\nNs {m['ns']}\n")
    with open(folder / "scene.obj", "w") as f:
        f.write("mtllib scene.mtl\n")
        for v in scene["vertices"]:
            f.write(f"v {numbers(v, ' ')}\n")
        material = None
        for name, a, b, c in scene["triangles"]:
            if name != material:
                f.write(f"usemtl {name}\n")
                material = name
            f.write(f"f {a + 1} {b + 1} {c + 1}\n")
    light = scene["light"]
    white = "[1, 1, 1]"
    if "corner" in light:
        edges = ", ".join(f"[{numbers(e)}]" for e in light["edges"])
        light_text = (f'type = "parallelogram"\ncorner = [{numbers(light["corner"])}]\nedges = [{edges}]\n'
                f"colors = [{white}, {white}, {white}, {white}]\n")
    else:
        light_text = f'type = "point"\nposition = [{numbers(light["position"])}]\ncolor = {white}\n'
    (folder / "scene.toml").write_text(
        f'version = 1\n[[camera]]\nlook_from = [{numbers(CAMERA["from"])}]\nlook_at = [{numbers(CAMERA["at"])}]\n'
        f'fov = {CAMERA["fov"]}\n{lens_of(scene)}[[mesh]]\nfile = "scene.obj"\n[[light]]\n{light_text}')


def povray_texture(material, roughness, copies):
    """POV-Ray has only sharp reflections; rough ones are approximated by averaging `copies` textures with noise on the
    normals."""
    ks = numbers(material["ks"])
    shine = (f" phong {material['ks'][0]} phong_size {material['ns']} reflection {{ rgb <{ks}> }}" if any(material["ks"])
             else "")
    plain = f"pigment {{ rgb <{numbers(material['kd'])}> }} finish {{ ambient 0 diffuse 1{shine} }}"
    if not roughness or not any(material["ks"]):
        return f"texture {{ {plain} }}"
    maps = " ".join(f"[1 {plain} normal {{ bumps {roughness} scale 0.0001 translate {31 * k + 7} }}]" for k in range(copies))
    return f"texture {{ average texture_map {{ {maps} }} }}"


def write_povray(scene, folder, blur_samples=0, copies=1):
    light = scene["light"]
    if "corner" in light:
        (u, v), corner = light["edges"], light["corner"]
        middle = tuple(c + 0.5 * (a + b) for c, a, b in zip(corner, u, v))
        # POV-Ray distributes n jittered samples over n / (n - 1) of the axes.
        axes = [tuple(0.9 * a for a in axis) for axis in (u, v)]
        light_text = (f"light_source {{ <{numbers(middle)}> rgb 1 area_light <{numbers(axes[0])}>, <{numbers(axes[1])}>, 10, 10 "
                "jitter area_illumination on }\n")
    else:
        light_text = f"light_source {{ <{numbers(light['position'])}> rgb 1 }}\n"
    blur = ""
    if "lens" in scene:
        # The aperture is a diameter; variance 0 takes all samples everywhere.
        radius, distance = scene["lens"]
        view = tuple(a - b for a, b in zip(CAMERA["at"], CAMERA["from"]))
        length = math.sqrt(sum(v * v for v in view))
        focus = tuple(o + distance * v / length for o, v in zip(CAMERA["from"], view))
        blur = (f"aperture {2 * radius:.9g} focal_point <{numbers(focus)}> blur_samples {blur_samples} "
                "confidence 0.999 variance 0")
    with open(folder / "scene.pov", "w") as f:
        # `right -x` converts from POV-Ray's left-handed coordinates.
        f.write("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 6 }\n"
                f"camera {{ location <{numbers(CAMERA['from'])}> right -x up y angle {CAMERA['fov']} "
                f"look_at <{numbers(CAMERA['at'])}> {blur} }}\n" + light_text)
        names = list(scene["materials"])
        f.write("mesh2 {\nvertex_vectors { %d,\n" % len(scene["vertices"]))
        f.write(",\n".join(f"<{numbers(v)}>" for v in scene["vertices"]) + " }\n")
        f.write("texture_list { %d,\n" % len(names))
        for name in names:
            f.write(povray_texture(scene["materials"][name], scene.get("roughness"), copies) + "\n")
        f.write("}\nface_indices { %d,\n" % len(scene["triangles"]))
        f.write(",\n".join(f"<{a},{b},{c}>,{names.index(name)}" for name, a, b, c in scene["triangles"]))
        f.write(" }\n}\n")


def run_rayscope(program, folder, size, settings, output):
    command = [program, "render", str(folder / "scene.toml"), "-o", str(output), "--size", f"{size}x{size}", "--quiet",
               "--stats", str(folder / "stats.json")]
    for setting in settings:
        command += ["--set", setting]
    start = time.perf_counter()
    subprocess.run(command, check=True)
    total = time.perf_counter() - start
    return total, json.loads((folder / "stats.json").read_text())["render_s"]


def run_povray(folder, size, output, antialiasing=("-A",)):
    command = ["povray", f"+I{folder / 'scene.pov'}", f"+O{output}", f"+W{size}", f"+H{size}", "+FP16", "-D", *antialiasing,
               "File_Gamma=1.0", f"+WT{os.cpu_count()}"]
    start = time.perf_counter()
    result = subprocess.run(command, check=True, capture_output=True, text=True)
    total = time.perf_counter() - start
    traced = re.search(r"Trace Time:.*\(([\d.]+) seconds\)", result.stderr)
    return total, float(traced.group(1)) if traced else float("nan")


def read_pfm(path):
    data = path.read_bytes()
    kind, width, height, scale, rest = re.match(rb"(PF)\s+(\d+)\s+(\d+)\s+(\S+)\n(.*)", data, re.S).groups()
    values = array.array("f")
    values.frombytes(rest)
    if (float(scale) < 0) != (sys.byteorder == "little"):
        values.byteswap()
    width, height = int(width), int(height)
    rows = [values[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    return [min(max(v, 0.0), 1.0) for row in reversed(rows) for v in row]


def read_ppm16(path):
    data = path.read_bytes()
    header = re.match(rb"P6\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+(\d+)\s", data)
    values = array.array("H")
    values.frombytes(data[header.end():])
    if sys.byteorder == "little":
        values.byteswap()
    return [v / float(header.group(3)) for v in values]


def rmse(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))


def race(make, options, folder):
    scene = make()
    write_rayscope(scene, folder)
    write_povray(scene, folder)
    size = options.size
    run_rayscope(options.program, folder, size, scene["reference"], folder / "reference.pfm")
    reference = read_pfm(folder / "reference.pfm")
    times = {"POV-Ray": []}
    for variant in scene["variants"]:
        times[variant] = []
    order = list(times)
    random.seed(1)
    for _ in range(options.rounds):
        random.shuffle(order)
        for variant in order:
            if variant == "POV-Ray":
                times[variant].append(run_povray(folder, size, folder / "pov.ppm"))
            else:
                output = folder / (re.sub(r"\W+", "-", variant) + ".pfm")
                times[variant].append(run_rayscope(options.program, folder, size, scene["variants"][variant], output))
    pov = read_ppm16(folder / "pov.ppm")
    offset = sum(x - y for x, y in zip(pov, reference)) / len(pov)
    median = {variant: [statistics.median(column) for column in zip(*rows)] for variant, rows in times.items()}
    print(f"\n{scene['name']}, {size} x {size}, {os.cpu_count()} threads, medians of {options.rounds} interleaved runs; "
          f"offset {offset:+.1e}\n")
    print("| program | whole run, s | tracing, s | RMSE | times faster, whole run | times faster, tracing |")
    print("|---|---|---|---|---|---|")
    for variant in times:
        picture = pov if variant == "POV-Ray" else read_pfm(folder / (re.sub(r"\W+", "-", variant) + ".pfm"))
        whole, traced = median[variant]
        label = variant if variant == "POV-Ray" else f"Rayscope, {variant}"
        print(f"| {label} | {whole:.3f} | {traced:.3f} | {rmse(picture, reference):.5f} | "
              f"{median['POV-Ray'][0] / whole:.1f} | {median['POV-Ray'][1] / traced:.1f} |")
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=str(ROOT / "build/release/rayscope"))
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--size", type=int, default=800)
    parser.add_argument("--keep", type=Path, help="folder for scenes and pictures; absent: a temporary one")
    parser.add_argument("--scene", choices=("cornell", "scales", "dragon"), help="absent: the first two")
    options = parser.parse_args()
    scenes = {"cornell": cornell, "scales": scales, "dragon": dragon}
    for make in [scenes[options.scene]] if options.scene else [cornell, scales]:
        if options.keep:
            folder = options.keep / make.__name__
            folder.mkdir(parents=True, exist_ok=True)
            race(make, options, folder)
        else:
            with tempfile.TemporaryDirectory() as temporary:
                race(make, options, Path(temporary))


if __name__ == "__main__":
    main()
