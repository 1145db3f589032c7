#!/usr/bin/env python3
"""Makes the pictures of docs/debugging.md: drives the window under a virtual display and takes screenshots.

usage: scripts/make_doc_images.py PROGRAM [rays|surface|lens|…]        needs what tests/viewer/ui_test.py needs
"""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images" / "debugging"
sys.path.insert(0, str(ROOT / "tests" / "viewer"))
import ui_test as ui  # noqa: E402  (its folder is known only now)

ASIDE = (100, 600)  # a place in the picture where nothing is


def take(viewer, name):
    viewer.point(*ASIDE)
    viewer.settled_picture()
    pixels = viewer.capture()
    screen = b"P6 %d %d 255\n" % (pixels.width, pixels.height) + pixels.data
    subprocess.run(["convert", "ppm:-", "-resize", "960x540", "-dither", "None", "-colors", "160", "-define",
                    "png:compression-level=9", f"png8:{IMAGES / name}.png"], input=screen, check=True)
    print(IMAGES / f"{name}.png", flush=True)


def record(viewer, pixel):
    """Records the rays of a pixel and looks at them from the side."""
    viewer.click(*ui.TAB_RAYS)
    viewer.point(*ASIDE)
    viewer.settled_picture()
    viewer.point(*pixel)
    viewer.key("r")
    viewer.drag((700, 600), (860, 560))


def rays(viewer):
    record(viewer, (440, 340))
    take(viewer, "rays")


def surface(viewer):
    record(viewer, (440, 330))
    viewer.click(*ui.RECORDED)
    take(viewer, "texels")


def lens(viewer):
    record(viewer, (420, 330))
    take(viewer, "lens")


def noise(viewer):
    viewer.key("Tab")
    record(viewer, (560, 500))
    take(viewer, "samples")


def search(viewer):
    record(viewer, (390, 480))
    viewer.key("t")
    viewer.click(*ui.RECORDED)
    viewer.click(*ui.WHY)
    viewer.click(*ui.TREE_WIDE)
    viewer.point(*ASIDE)
    viewer.settled_picture()
    for _ in range(2):
        viewer.key("shift+Right")
    take(viewer, "search-wide")
    viewer.click(*ui.TREE_BINARY)
    for _ in range(12):
        viewer.key("Right")
    take(viewer, "search-binary")


def hierarchy(viewer):
    viewer.click(*ui.TAB_BVH)
    viewer.point(*ASIDE)
    viewer.settled_picture()
    viewer.key("b")
    for _ in range(3):
        viewer.key("Next")
    viewer.point(460, 400)
    viewer.key("g")
    viewer.click(*ui.BVH_SAVINGS)
    take(viewer, "builds")


def heat(viewer):
    viewer.click(*ui.TAB_MAP)
    viewer.point(*ASIDE)
    viewer.key("m")
    ui.wait_for("the map", lambda: viewer.settled_picture().count(ui.is_map_yellow) > 300)
    take(viewer, "heat-map")


def comparison(viewer):
    viewer.key("Tab")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    viewer.key("k")
    viewer.click(*ui.TAB_SETTINGS)
    viewer.click(*ui.HARD_SHADOWS)
    viewer.click(*ui.TAB_COMPARE)
    take(viewer, "comparison")


PICTURES = [
    (["builtin:cornell"], rays),
    (["builtin:quad-textured"], surface),
    (["builtin:spheres-dof"], lens),
    (["builtin:cornell-area", "--set", "parallelogram_samples=1"], noise),
    (["builtin:monkey"], search),
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
