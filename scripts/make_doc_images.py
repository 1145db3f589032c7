#!/usr/bin/env python3
"""Makes the pictures of docs/debugging.md: drives the window under a virtual display and takes screenshots.

usage: scripts/make_doc_images.py PROGRAM [rays|surface|lens|…]        needs what tests/viewer/ui_test.py needs
"""
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images" / "debugging"
sys.path.insert(0, str(ROOT / "tests" / "viewer"))
import ui_test as ui  # noqa: E402  (its folder is known only now)

PICTURE, PANEL = (0, 19, 944, 678), (944, 19, 336, 678)


def take(viewer, name, part=(0, 0, ui.WIDTH, ui.HEIGHT), scale=0.75):
    """Takes a screenshot, or a part of it, at three quarters of its size."""
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    pixels = viewer.capture().crop(*part)
    write(b"P6 %d %d 255\n" % (pixels.width, pixels.height) + pixels.data, name, scale)


def write(ppm, name, scale):
    subprocess.run(["convert", "ppm:-", "-resize", f"{100 * scale:g}%", "-dither", "None", "-colors", "128", "-define",
                    "png:compression-level=9", f"png8:{IMAGES / name}.png"], input=ppm, check=True)
    print(IMAGES / f"{name}.png", flush=True)


def rays(viewer):
    viewer.record_rays((440, 340))
    take(viewer, "rays")


def shadows(viewer):
    viewer.record_rays((530, 500))
    take(viewer, "shadows", PICTURE)


def show_boxes(viewer, level, leaf):
    """The boxes of a level and the leaf under a pixel."""
    viewer.click("BVH")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    viewer.key("b")
    for _ in range(level):
        viewer.key("Next")
    viewer.point(*leaf)
    viewer.key("g")


def levels(viewer):
    show_boxes(viewer, 4, (430, 380))
    take(viewer, "levels")


def normals(viewer):
    viewer.record_rays((440, 330))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    viewer.click("vertex normals")
    viewer.wheel((500, 330), 5)
    take(viewer, "normals")


def surface(viewer):
    viewer.record_rays((440, 330))
    viewer.click("Recorded rays")
    take(viewer, "texels")


def environment(viewer):
    viewer.record_rays((340, 300))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    take(viewer, "environment")


def bloom(viewer):
    viewer.click("Settings")
    viewer.key("Tab")
    viewer.scroll_to_end(ui.PANEL)
    stages = []
    for stage in ui.BLOOM_STAGES:
        viewer.choose("Bloom stage", stage)
        viewer.point(*ui.ASIDE)
        viewer.settled_picture()
        stages.append(viewer.capture().crop(150, 150, 640, 420))
    rows = [stage.data[3 * 640 * y:3 * 640 * (y + 1)] for y in range(420) for stage in stages]
    write(b"P6 1920 420 255\n" + b"".join(rows), "bloom", 0.6)


def glossy(viewer):
    viewer.record_rays((440, 330))
    take(viewer, "glossy", PICTURE)


def transparency(viewer):
    viewer.record_rays((420, 430))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    viewer.choose("Filters/Colour", "surface")
    take(viewer, "transparency")


def lens(viewer):
    viewer.record_rays((420, 330))
    take(viewer, "lens")


def noise(viewer):
    viewer.key("Tab")
    viewer.record_rays((560, 500))
    take(viewer, "samples")


def replay(viewer):
    viewer.key("Tab")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    viewer.click("Rays")
    viewer.point(440, 480)
    viewer.key("r")
    take(viewer, "replay", PANEL)


def table(viewer):
    viewer.record_rays((440, 340))
    x, y = viewer.within("Recorded rays/camera 0", 0.5)
    viewer.click(x, y + 40)
    take(viewer, "table")


def diagnosis(viewer):
    viewer.record_rays((387, 375))
    take(viewer, "diagnosis")


def traversal(viewer):
    viewer.record_rays((390, 480))
    viewer.key("t")
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    viewer.click("Wide")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    for _ in range(2):
        viewer.key("shift+Right")
    take(viewer, "traversal-wide")
    viewer.click("Binary")
    for _ in range(12):
        viewer.key("Right")
    take(viewer, "traversal-binary")


def hierarchy(viewer):
    show_boxes(viewer, 3, (460, 400))
    viewer.click("Compare with another BVH")
    take(viewer, "builds")


def nodes(viewer):
    viewer.click("BVH")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    ui.open_root(viewer)
    take(viewer, "nodes")


def heat(viewer):
    viewer.click("Map")
    viewer.point(*ui.ASIDE)
    viewer.key("m")
    ui.wait_for("the map", lambda: viewer.settled_picture().count(ui.is_map_yellow) > 300)
    take(viewer, "heat-map")


def pins(viewer):
    viewer.key("Tab")
    viewer.click("Rays")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    for place in (560, 500), (440, 480), (330, 300):
        viewer.point(*place)
        viewer.key("r")
        viewer.key("p")
    viewer.click("Recorded rays")
    viewer.scroll_to_end(ui.PANEL)
    take(viewer, "pins", PANEL)


def comparison(viewer):
    viewer.key("Tab")
    viewer.point(*ui.ASIDE)
    viewer.settled_picture()
    viewer.key("k")
    viewer.click("Settings")
    viewer.click("Hard shadows")
    viewer.click("A/B")
    take(viewer, "comparison")


def probe(program):
    """The output of rayscope probe as a terminal shows it."""
    command = "rayscope probe builtin:cornell --pixel 300,420 --explain"
    output = subprocess.run([program, *command.split()[1:]], check=True, stdout=subprocess.PIPE, text=True).stdout
    lines = [f"$ {command}", *(line for part in output.splitlines() for line in textwrap.wrap(part, 100, subsequent_indent="      "))]
    ppm = subprocess.run(["convert", "-background", "#15171a", "-fill", "#e6e8eb", "-font", "DejaVu-Sans-Mono", "-pointsize",
                          "13", "-bordercolor", "#15171a", "-border", "10", "label:" + "\n".join(lines), "-depth", "8", "ppm:-"],
                         check=True, stdout=subprocess.PIPE).stdout
    write(ppm, "probe", 1)


PICTURES = [
    (["builtin:cornell"], rays),
    (["builtin:cornell-area", "--set", "parallelogram_samples=4"], shadows),
    (["builtin:monkey"], levels),
    (["builtin:monkey"], normals),
    (["builtin:environment", "--set", "reflection_map=true"], environment),
    (["builtin:spheres", "--set", "bloom=true", "--set", "bloom_debug=true", "--set", "bloom_threshold=0.3", "--set",
      "bloom_size=8", "--set", "bloom_sigma=4"], bloom),
    (["builtin:cornell-glossy"], glossy),
    (["builtin:cornell-transparent"], transparency),
    (["builtin:cornell-area"], replay),
    (["builtin:cornell"], table),
    (["builtin:cornell"], diagnosis),
    (["builtin:monkey"], nodes),
    (["builtin:cornell-area", "--set", "parallelogram_samples=1"], pins),
    (["builtin:quad-textured"], surface),
    (["builtin:spheres-dof"], lens),
    (["builtin:cornell-area", "--set", "parallelogram_samples=1"], noise),
    (["builtin:monkey"], traversal),
    (["builtin:monkey"], hierarchy),
    (["builtin:monkey"], heat),
    (["builtin:cornell"], comparison),
]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = str(Path(sys.argv[1]).resolve())
    IMAGES.mkdir(parents=True, exist_ok=True)
    display = ui.start_display()
    try:
        if not sys.argv[2:] or "probe" in sys.argv[2:]:
            probe(program)
        for arguments, draw in PICTURES:
            if sys.argv[2:] and draw.__name__ not in sys.argv[2:]:
                continue
            with tempfile.TemporaryDirectory() as folder:
                viewer = ui.Viewer(program, Path(folder), "--set", "spp=16", *arguments)
                try:
                    draw(viewer)
                finally:
                    viewer.process.kill()
                    viewer.process.wait()
    finally:
        display.terminate()
        display.wait()


if __name__ == "__main__":
    main()
