#!/usr/bin/env python3
"""Loads the mesh files of a folder with Rayscope and with independent readers, and compares the numbers of triangles and
of materials.

    scripts/check_meshes.py [FOLDER] [--program build/release/rayscope] [--all]

FOLDER is searched for .obj, .ply, .stl, .gltf and .glb files; the default is the folder of the Debian package
assimp-testmodels. The readers are assimp (package assimp-utils) and VTK (package python3-vtk9), those that are
installed. Prints a line per file on which they disagree, with the class of the reason, or per file with --all. The exit
code is 1 if a disagreement has no explanation, 77 if FOLDER or all readers are missing, else 0.

Classes of explanations:
    contradiction   the other readers contradict one another, and Rayscope agrees with one of them
    refused         Rayscope refuses the file and names a feature that it does not have
    noted           Rayscope prints what it leaves out or replaces
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile

SUFFIXES = (".obj", ".ply", ".stl", ".gltf", ".glb")
TEST_MODELS = "/usr/share/assimp/models"
# Messages of Rayscope that name a feature that it does not have or a word that is no number, of which others read a part,
# and those that say why its counts are others.
FEATURES = ("glTF 1", "requires the extension", "is not supported", "expected a number, got")
DIFFERENCES = ("left out", "ignored", "default material", "only scene", "one instance")
SECONDS = 120


class Answer:
    """What a reader says about a file: counts, or a reason why it cannot read it. None: not known."""

    def __init__(self, triangles=None, materials=None, error="", notes=()):
        self.triangles, self.materials, self.error, self.notes = triangles, materials, error, notes

    def text(self):
        if self.error:
            return "refused"
        return f"{self.triangles}" if self.materials is None else f"{self.triangles}/{self.materials}"


def run(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return None


def ask_rayscope(program, path):
    done = run([program, "info", path, "--json"])
    if done is None:
        return Answer(error=f"no answer within {SECONDS} s")
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        return Answer(error=lines[-1] if lines and done.returncode == 2 else f"crash: exit code {done.returncode}")
    info = json.loads(done.stdout)
    return Answer(info["triangles"], info["materials"], notes=[found["message"] for found in info["lint"]])


def count_assimp(scene):
    """Triangles and used materials of all nodes; meshes that several nodes place count several times."""
    meshes = []
    for mesh in scene.get("meshes", []):
        meshes.append((sum(len(face) == 3 for face in mesh["faces"]), mesh.get("materialindex", 0)))
    triangles, materials, nodes = 0, set(), [scene["rootnode"]]
    while nodes:
        node = nodes.pop()
        nodes += node.get("children", [])
        for index in node.get("meshes", []):
            triangles += meshes[index][0]
            if meshes[index][0]:
                materials.add(meshes[index][1])
    return Answer(triangles, len(materials))


def ask_assimp(path):
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "scene.json")
        done = run(["assimp", "export", path, output, "-fassjson", "-tri"])
        if done is None or done.returncode != 0 or not os.path.exists(output):
            return Answer(error="assimp cannot read it")
        with open(output, encoding="utf-8", errors="replace") as file:
            try:
                return count_assimp(json.load(file, strict=False))
            except (ValueError, KeyError):
                return Answer(error="assimp writes no valid scene")


VTK = r"""
import os, sys
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
vtkObject.GlobalWarningDisplayOff()
path = sys.argv[1]
suffix = os.path.splitext(path)[1].lower()
reader = {".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader, ".gltf": vtkGLTFReader,
          ".glb": vtkGLTFReader}[suffix]()
if suffix == ".stl":
    reader.MergingOff()
reader.SetFileName(path)
reader.Update()
def leaves(data):
    if data is None:
        return
    if data.IsA("vtkMultiBlockDataSet"):
        for i in range(data.GetNumberOfBlocks()):
            yield from leaves(data.GetBlock(i))
    else:
        yield data
count = 0
for data in leaves(reader.GetOutputDataObject(0)):
    polys, strips = data.GetPolys(), data.GetStrips()
    count += polys.GetNumberOfConnectivityIds() - 2 * polys.GetNumberOfCells()
    count += strips.GetNumberOfConnectivityIds() - 2 * strips.GetNumberOfCells()
print("triangles", count)
"""


def find_vtk():
    """A Python interpreter that has VTK, or None."""
    for python in (sys.executable, "/usr/bin/python3"):
        done = run([python, "-c", "import vtkmodules.vtkIOGeometry"])
        if done and done.returncode == 0:
            return python
    return None


def ask_vtk(python, path):
    done = run([python, "-c", VTK, path])
    lines = [] if done is None else [line for line in done.stdout.splitlines() if line.startswith("triangles ")]
    # VTK prints its errors and returns empty data.
    if not lines or lines[-1] == "triangles 0":
        return Answer(error="VTK reads no triangles")
    return Answer(int(lines[-1].split()[1]))


def explain(ours, others):
    """The class of the reason of a disagreement, "" if there is none, or "unexplained"."""
    readable = [other for other in others.values() if not other.error and other.triangles]
    if ours.error.startswith("crash") or "no answer" in ours.error:
        return "unexplained"
    if not readable:
        return "" if ours.error else "read here only"
    if any(feature in ours.error for feature in FEATURES):
        return "refused"
    if ours.error:
        return "contradiction" if len(readable) < len(others) else "unexplained"
    counts = {other.triangles for other in readable} or {None}
    materials = {other.materials for other in readable if other.materials is not None} or {ours.materials}
    if counts == {ours.triangles} and materials == {ours.materials}:
        return ""
    if ours.triangles in counts and len(counts) > 1 and materials == {ours.materials}:
        return "contradiction"
    return "noted" if any(word in note for note in ours.notes for word in DIFFERENCES) else "unexplained"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default=TEST_MODELS)
    parser.add_argument("--program", default="build/release/rayscope")
    parser.add_argument("--all", action="store_true", help="print all files")
    options = parser.parse_args()

    readers = {}
    if shutil.which("assimp"):
        readers["assimp"] = ask_assimp
    python = find_vtk()
    if python:
        readers["VTK"] = lambda path: ask_vtk(python, path)
    if not os.path.isdir(options.folder) or not readers:
        missing = options.folder if readers else "assimp (package assimp-utils) and VTK (package python3-vtk9)"
        print(f"skipped: not installed: {missing}")
        return 77

    paths = sorted(os.path.join(folder, name) for folder, _, names in os.walk(options.folder) for name in names
                   if name.lower().endswith(SUFFIXES))
    names = list(readers)
    print(f"{'file':60} {'rayscope':>12} " + " ".join(f"{name:>12}" for name in names) + "  triangles/materials")
    classes = {}
    for path in paths:
        ours = ask_rayscope(options.program, path)
        others = {name: ask(path) for name, ask in readers.items()}
        reason = explain(ours, others)
        classes[reason] = classes.get(reason, 0) + 1
        if not reason and not options.all:
            continue
        print(f"{os.path.relpath(path, options.folder):60} {ours.text():>12} "
              + " ".join(f"{others[name].text():>12}" for name in names) + f"  {reason}")
        for line in [ours.error] if ours.error else ours.notes:
            print(f"    {line}")
    agreed = classes.pop("", 0)
    rest = ", ".join(f"{count} {reason}" for reason, count in sorted(classes.items()))
    print(f"{len(paths)} files: {agreed} agree" + (f", {rest}" if rest else ""))
    return 1 if classes.get("unexplained") else 0


if __name__ == "__main__":
    sys.exit(main())
