"""Drives the real window under a virtual display and checks the pictures that it shows and saves.

usage: ui_test.py PROGRAM [TEST …]        exits 77 where Xvfb, xdotool or ImageMagick is missing
"""
import json
import operator
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import x11

WIDTH, HEIGHT = 1280, 720
# Points in the picture at scale 1; controls are found by label.
PICTURE = (0, 21, 944, 674)  # x, y, width, height
PANEL_PIXEL = (950, 690)
PROGRESS_PIXEL = (8, 695)
RASTERISED_BUTTON = (960, 37)  # blue while the rasterised view is shown
PANEL = (1100, 500)  # in the side panel, where the wheel scrolls it
ASIDE = (100, 600)  # in the picture, where nothing is
LIGHT = (472, 217)  # of the Cornell box, seen by its camera
TIMEOUT = 90.0  # seconds until a wait counts as failed; the machine may be busy


class Failure(Exception):
    pass


class Pixels:
    """An RGB picture with 8 bits per channel."""

    def __init__(self, ppm):
        fields, at = [], 0
        while len(fields) < 4:
            end = at
            while ppm[end] not in b" \n\t":
                end += 1
            fields.append(ppm[at:end])
            at = end + 1
        self.width, self.height, self.data = int(fields[1]), int(fields[2]), ppm[at:]

    def at(self, x, y):
        start = 3 * (y * self.width + x)
        return tuple(self.data[start:start + 3])

    def crop(self, x, y, width, height):
        rows = [self.data[3 * (row * self.width + x):3 * (row * self.width + x + width)] for row in range(y, y + height)]
        part = Pixels.__new__(Pixels)
        part.width, part.height, part.data = width, height, b"".join(rows)
        return part

    def mean(self):
        count = self.width * self.height
        return tuple(sum(self.data[channel::3]) / count for channel in range(3))

    def brightness(self):
        return sum(self.data) / len(self.data)

    def differing(self, other):
        """Number of pixels that differ."""
        return 0 if self.data == other.data else sum(map(operator.ne, self.pixels(), other.pixels()))

    def pixels(self):
        return zip(self.data[::3], self.data[1::3], self.data[2::3])

    def count(self, wanted):
        return sum(count for color, count in Counter(self.pixels()).items() if wanted(*color))


def convert_to_ppm(*arguments):
    return subprocess.run([*arguments, "-depth", "8", "ppm:-"], check=True, stdout=subprocess.PIPE).stdout


def wait_for(what, condition, timeout=TIMEOUT):
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        result = condition()
        if result:
            return result
        time.sleep(0.05)
    raise Failure(f"timed out after {timeout:.0f} s waiting for: {what}")


def expect(condition, message):
    if not condition:
        raise Failure(message)


class Viewer:
    """A running window: sends input to it and reads its picture and its controls."""

    def __init__(self, program, folder, *arguments):
        self.folder, self.map = folder, folder / "controls.tsv"
        environment = dict(os.environ, XDG_CONFIG_HOME=str(folder / "config"), XDG_CACHE_HOME=str(folder / "cache"),
                           RAYSCOPE_UI_MAP=str(self.map), LIBGL_ALWAYS_SOFTWARE="1")
        self.log = open(folder / "viewer.log", "w+")
        size = [] if "--size" in arguments else ["--size", f"{WIDTH}x{HEIGHT}"]
        self.process = subprocess.Popen([program, "view", *size, *arguments], cwd=folder,
                                        env=environment, stderr=self.log)
        self.screen = x11.Client()
        self.window = wait_for("the window", self._find_window).split()[0]
        wait_for("the first frame", lambda: self.capture().brightness() > 5)

    def _find_window(self):
        expect(self.process.poll() is None,
               "the program ended before it opened a window: " + (self.folder / "viewer.log").read_text())
        return subprocess.run(["xdotool", "search", "--name", "Rayscope"], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True).stdout

    def do(self, *arguments):
        expect(self.process.poll() is None, f"the program ended with {self.process.returncode}")
        subprocess.run(["xdotool", *map(str, arguments)], check=True)
        self.wait_for_frame()

    def wait_for_frame(self):
        """Waits until earlier input is in a frame: the reply to the second ping comes after the frame that follows the
        first."""
        for _ in range(2):
            wait_for("a reply of the window",
                     lambda: self.process.poll() is not None or self.screen.ping(int(self.window), 1.0))

    def key(self, keys):
        self.do("key", keys)

    def controls(self):
        """The visible controls and texts as pairs of path and rectangle, as the program has drawn them last."""
        return [(line.split("\t", 4)[4], tuple(map(int, line.split("\t", 4)[:4])))
                for line in self.map.read_text().splitlines()]

    def rect(self, label):
        """The rectangle of a control. Its label is the end of its path "Tab/Section/Label##identifier"; the identifier may
        be left out. Waits until it is there, and scrolls the side panel if it does not appear."""
        def ends(path):
            return path == label or path.endswith("/" + label)

        def found():
            paths = self.controls()
            for matches in ([(path, at) for path, at in paths if path == label],
                            [(path, at) for path, at in paths if ends(path) and "##" in label],
                            [(path, at) for path, at in paths if "##" in path and ends(path.split("##")[0])],
                            [(path, at) for path, at in paths if ends(path) and not path.startswith("Menu/")]):
                if matches:
                    return matches[0][1]
            return None
        try:
            return wait_for(f"the control '{label}'", found, 5)
        except Failure:
            return self.scroll_to(found) or wait_for(f"the control '{label}'", found)

    def scroll_to(self, found):
        """Turns the wheel in the side panel, down and then up, until found() returns something, and returns that."""
        down, up = 5, 4
        for button in [down] * 20 + [up] * 40:
            self.point(*PANEL)
            self.do("click", button)
            self.wait_for_frame()
            if found():
                self.do("click", button)  # what was cut off, too
                self.wait_for_frame()
                return found()
        return None

    def within(self, label, across, down=0.5):
        """A point in a control, by fractions of its width and height."""
        x, y, width, height = self.rect(label)
        return int(x + across * width), int(y + down * height)

    def below(self, path):
        """What is drawn in a section: the ends of the paths that start like this one."""
        return [found[len(path):] for found, _ in self.controls() if found.startswith(path)]

    def says(self, part):
        return any(part in path for path, _ in self.controls())

    def point(self, *place):
        """Moves the mouse to a point, or to the control of a label."""
        place = place[0] if len(place) == 1 else place
        self.do("mousemove", *(self.within(place, 0.5) if isinstance(place, str) else place))

    def choose(self, row, choice):
        """Opens the combo of a row and clicks a choice."""
        self.click(row)
        self.click(row.split("/")[-1] + "/" + choice)

    def click(self, *place):
        self.point(*place)
        self.do("mousedown", 1)
        self.do("mouseup", 1)

    def drag(self, start, end, steps=8):
        self.point(*start)
        self.do("mousedown", 1)
        for step in range(1, steps + 1):
            x, y = (a + (b - a) * step // steps for a, b in zip(start, end))
            self.do("mousemove", x, y)
        self.do("mouseup", 1)

    def wheel(self, place, notches):
        """Turns the wheel forward at a place."""
        self.point(*place)
        self.do("click", "--repeat", notches, "--delay", 30, 4)

    def capture(self):
        return Pixels(self.screen.capture())

    def picture(self):
        return self.capture().crop(*PICTURE)

    def title(self):
        return subprocess.run(["xdotool", "getwindowname", self.window], stdout=subprocess.PIPE, text=True).stdout

    def settled_picture(self):
        """The picture once it has stopped changing, and nothing is being traced if it is the traced one."""
        def settled():
            before = self.capture()
            time.sleep(0.2)
            self.wait_for_frame()
            after = self.capture()
            # The bar over the status line is there as long as something is traced.
            quiet = after.at(*PROGRESS_PIXEL) == after.at(PROGRESS_PIXEL[0], PROGRESS_PIXEL[1] + 6)
            red, _, blue = after.at(*RASTERISED_BUTTON)
            return (quiet or blue > red + 60) and before.crop(*PICTURE).data == after.crop(*PICTURE).data and after.crop(*PICTURE)
        return wait_for("a picture that no longer changes", settled)

    def save(self, keys):
        """The picture that these keys write."""
        known = set(self.folder.glob("rayscope-*.png"))
        self.key(keys)
        wait_for(f"a file after {keys}", lambda: set(self.folder.glob("rayscope-*.png")) - known)
        [path] = set(self.folder.glob("rayscope-*.png")) - known
        return Pixels(convert_to_ppm("convert", str(path)))

    def settled_window(self):
        """The whole window, once the picture no longer changes."""
        self.settled_picture()
        return self.capture()

    def type_into(self, place, text):
        """Types into a slider or a field to drag."""
        self.do("keydown", "ctrl")
        self.click(place)
        self.do("keyup", "ctrl")
        self.do("type", "--delay", "40", "--", text)
        self.key("Return")

    def scroll_to_end(self, place):
        self.point(*place)
        before = None
        while before is None or self.capture().differing(before) > 0:
            before = self.capture()
            self.do("click", "--repeat", 10, "--delay", 30, 5)
            self.wait_for_frame()

    def saved_property(self, name, keys="ctrl+s"):
        """A property in the metadata of the picture that these keys write; empty if it has none of that name."""
        known = set(self.folder.glob("rayscope-*.png"))
        self.key(keys)
        wait_for("a file", lambda: set(self.folder.glob("rayscope-*.png")) - known)
        [path] = set(self.folder.glob("rayscope-*.png")) - known
        return subprocess.run(["identify", "-format", f"%[rayscope:{name}]", str(path)], stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True).stdout

    def size(self):
        output = subprocess.run(["xdotool", "getwindowgeometry", "--shell", self.window], stdout=subprocess.PIPE,
                                text=True).stdout
        values = dict(line.split("=") for line in output.split())
        return int(values["WIDTH"]), int(values["HEIGHT"])

    def open_by_name(self, name):
        self.key("ctrl+o")
        self.wait_for_frame()
        self.key("ctrl+a")
        self.do("type", "--delay", "40", name)
        self.key("Return")

    def open_scene(self, name):
        """Opens a built-in scene and waits until it is there."""
        self.open_by_name(name)
        wait_for("the other scene", lambda: name in self.title())

    def record_rays(self, pixel):
        """Records the rays of a pixel and orbits the camera: seen from its origin, a camera ray is a point."""
        self.click("Rays")
        self.point(*ASIDE)
        before = self.settled_picture()
        self.point(*pixel)
        self.key("r")
        wait_for("the rays", lambda: self.picture().differing(before) > 10)
        self.drag(ASIDE, (ASIDE[0] + 160, ASIDE[1] - 40))
        return self.settled_picture()

    def quit(self):
        subprocess.run(["xdotool", "key", "ctrl+q"], check=True)
        wait_for("the end of the program", lambda: self.process.poll() is not None)
        expect(self.process.returncode == 0, f"the program ended with {self.process.returncode}")


def test_views(viewer):
    raster = viewer.settled_picture()
    red, green, blue = raster.crop(290, 240, 60, 60).mean()
    expect(red > 2 * green and red > 2 * blue, f"the rasterised view shows the red wall ({red:.0f} {green:.0f} {blue:.0f})")
    viewer.point(*ASIDE)
    viewer.key("Tab")
    wait_for("another picture", lambda: viewer.picture().data != raster.data)
    traced = viewer.settled_picture()
    red, green, blue = traced.crop(300, 220, 40, 40).mean()
    expect(red > 2 * green and red > 2 * blue, "the ray-traced view shows the red wall at the same place")
    return raster, traced


def test_toggle_and_undo(viewer):
    viewer.click("Ray-traced")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    shadowed = viewer.save("ctrl+s")
    expect((shadowed.width, shadowed.height) == PICTURE[2:], "the saved image has the size of the picture")
    viewer.click("Settings")
    viewer.click("Hard shadows")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    bright = viewer.save("ctrl+s")
    expect(bright.brightness() > shadowed.brightness() + 1.0, "without shadows the picture is brighter")
    viewer.key("ctrl+z")
    viewer.settled_picture()
    expect(viewer.save("ctrl+s").data == shadowed.data, "undo brings back the same pixels")
    viewer.key("ctrl+y")
    viewer.settled_picture()
    expect(viewer.save("ctrl+s").data == bright.data, "redo brings back the other pixels")


def is_ray_yellow(red, green, blue):
    return red > 200 and green > 190 and 40 < blue < 130


def test_debug_ray(viewer):
    viewer.click("Ray-traced")
    yellow = viewer.record_rays((360, 300)).count(is_ray_yellow)
    expect(yellow > 100, f"the camera ray is visible in the ray-traced view ({yellow} pixels)")
    without = viewer.save("ctrl+s").count(is_ray_yellow)
    expect(without == 0, "the saved image has no overlay")
    shot = viewer.save("shift+ctrl+s")
    expect((shot.width, shot.height) == (WIDTH, HEIGHT), "the screenshot has the size of the window")
    expect(shot.count(is_ray_yellow) > 100, "the screenshot has the overlay")
    viewer.key("Tab")
    viewer.point(*ASIDE)
    raster = viewer.settled_picture()
    expect(raster.count(is_ray_yellow) > 50, "the camera ray is visible in the rasterised view")
    viewer.key("c")
    wait_for("the rays to go", lambda: viewer.picture().count(is_ray_yellow) == 0)


def is_box_white(red, green, blue):
    return min(red, green, blue) > 190 and max(red, green, blue) - min(red, green, blue) < 25


def is_reference_red(red, green, blue):
    return red > 170 and 40 < green < 110 and blue < 80


def is_leaf_yellow(red, green, blue):
    return red > 200 and green > 180 and blue < 100


def is_visited_green(red, green, blue):
    return green > 150 and red < 80 and 90 < blue < 180


def test_traversal(viewer):
    """The traversal of a camera ray, step by step; exported ray trees; the legend as a filter."""
    viewer.open_scene("builtin:monkey")
    bare = viewer.record_rays((390, 480))
    expect(bare.count(is_ray_yellow) > 100, "the camera ray is visible")
    viewer.key("t")
    traversed = viewer.settled_picture()
    expect(traversed.count(is_visited_green) > bare.count(is_visited_green) + 1000, "the visited boxes are green")
    expect(traversed.count(is_leaf_yellow) > bare.count(is_leaf_yellow) + 30, "the triangle that is hit is outlined")
    seen = set()
    for _ in range(6):
        viewer.key("Right")
        seen.add(viewer.settled_picture().data)
    expect(len(seen) >= 4, "each step looks different")
    viewer.key("Left")
    expect(viewer.settled_picture().data in seen, "a step back shows the same as before")
    viewer.key("t")
    viewer.key("ctrl+j")
    wait_for("the exported rays", lambda: list(viewer.folder.glob("*.obj")) and list(viewer.folder.glob("*.json")))
    tree = json.loads(next(viewer.folder.glob("*.json")).read_text())
    lines = next(viewer.folder.glob("*.obj")).read_text().count("\nl ")
    expect(lines == len(tree["nodes"]) + len(tree["shadow_rays"]), "the OBJ has a line for each ray")
    viewer.click("Recorded rays")
    viewer.click("Legend (click to show or hide)/camera ray")
    viewer.point(*ASIDE)
    expect(viewer.settled_picture().count(is_ray_yellow) == 0, "a click on the legend hides the camera rays")
    viewer.click("Legend (click to show or hide)/camera ray")
    viewer.click("Recorded rays")
    viewer.click("Recorded rays/camera 0")
    viewer.point(*ASIDE)
    expect(viewer.settled_picture().differing(bare) > 100, "the ray that is selected in the table has a halo")
    viewer.key("h")
    viewer.point(*ASIDE)
    expect(viewer.settled_picture().count(is_ray_yellow) == 0, "a hidden ray is not drawn")


def is_square_purple(red, green, blue):
    return 150 < red < 230 and 70 < green < 135 and blue > 180


def test_surfaces(viewer):
    """Texels, the glossy square, the lens and its focus, and samples of the pixel."""
    viewer.open_scene("builtin:quad-textured")
    viewer.record_rays((440, 330))
    wait_for("texels in the panel", lambda: viewer.capture().crop(*viewer.rect("Texels")).count(
        lambda r, g, b: r > 200 and g < 120 and b < 120) > 200)
    # A click on the last bar of the strip chooses the last sample, whose camera ray is another one.
    first = viewer.capture().crop(*viewer.rect("Sample positions"))
    viewer.click(viewer.within("Sample strip", 0.97))
    viewer.point(*ASIDE)
    wait_for("another sample", lambda: viewer.capture().crop(*viewer.rect("Sample positions")).differing(first) > 10)
    viewer.key("c")
    viewer.open_scene("builtin:cornell-glossy")
    glossy = viewer.record_rays((440, 330))
    expect(glossy.count(is_square_purple) > 60, "the square of the glossy reflection is purple")
    viewer.key("c")
    viewer.open_scene("builtin:spheres-dof")
    lens = viewer.record_rays((420, 330))
    expect(lens.count(is_visited_green) > 300, "the plane of focus is green")
    viewer.key("p")
    viewer.key("c")
    viewer.key("Home")
    viewer.settled_picture()
    viewer.point(450, 60)
    viewer.key("r")
    wait_for("the reason why the background is black", lambda: any("black" in text for text in viewer.below("Rays/Diagnosis/")))
    viewer.key("c")
    # A live ray follows the cursor without any key.
    bare = viewer.settled_picture()
    viewer.key("l")
    viewer.point(500, 360)
    wait_for("live rays", lambda: viewer.picture().differing(bare) > 30)
    one = viewer.settled_picture()
    viewer.point(300, 400)
    wait_for("live rays elsewhere", lambda: viewer.picture().differing(one) > 30)
    viewer.key("Escape")
    viewer.key("Escape")
    wait_for("no ray any more", lambda: viewer.picture().differing(bare) == 0)


def is_vertex_normal(red, green, blue):
    return 110 < red < 160 and green > 200 and 170 < blue < 220


def test_normals_and_panes(viewer):
    """Vertex normals by a click on the legend; segments in the colours of the surfaces they hit."""
    viewer.open_scene("builtin:monkey")
    viewer.record_rays((440, 330))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    viewer.point(*ASIDE)
    bare = viewer.settled_picture().count(is_vertex_normal)
    viewer.click("vertex normals")
    viewer.point(*ASIDE)
    wait_for("normals of vertices", lambda: viewer.settled_picture().count(is_vertex_normal) > bare + 30)
    viewer.click("vertex normals")
    viewer.key("c")
    viewer.open_scene("builtin:cornell-transparent")
    by_kind = viewer.record_rays((420, 430))
    expect(by_kind.count(is_ray_yellow) > 100, "the camera ray is yellow")
    viewer.choose("Filters/Colour", "surface")
    viewer.point(*ASIDE)
    wait_for("the colours of surfaces", lambda: viewer.settled_picture().count(is_ray_yellow) < 20)
    viewer.choose("Filters/Colour", "kind")
    viewer.point(*ASIDE)
    wait_for("the colours of kinds", lambda: viewer.settled_picture().data == by_kind.data)


def test_bvh_boxes(viewer):
    """Boxes of levels, one leaf and its primitives, the boxes of the reference tree, and a tree of one level."""
    viewer.open_scene("builtin:monkey")
    viewer.click("BVH")
    viewer.point(*ASIDE)
    bare = viewer.settled_picture()
    viewer.key("b")
    root = wait_for("the root's box", lambda: viewer.settled_picture().count(is_box_white) - bare.count(is_box_white))
    for _ in range(3):
        viewer.key("Next")
    deeper = viewer.settled_picture()
    expect(deeper.count(is_box_white) - bare.count(is_box_white) > root + 500, "a deeper level has more boxes")
    viewer.point(460, 400)
    viewer.key("g")
    viewer.point(*ASIDE)
    wait_for("the leaf under the cursor", lambda: viewer.settled_picture().crop(430, 340, 80, 80).count(is_leaf_yellow) > 50)
    before = viewer.settled_picture()
    viewer.key("period")
    expect(viewer.settled_picture().differing(before) > 50, "the next leaf is another one")
    viewer.key("comma")
    expect(viewer.settled_picture().data == before.data, "the one before is the first again")
    viewer.key("period")
    viewer.click("Compare with another BVH")
    viewer.point(*ASIDE)
    wait_for("the boxes of the median split", lambda: viewer.settled_picture().count(is_reference_red) > 500)
    # Leaves of another size change the cost of the reference tree.
    viewer.click("BVH/Build")  # closes the section, so that the whole table is visible
    comparison = "BVH/Comparison with another BVH/"
    table = wait_for("the costs of the reference tree", lambda: "visits per ray" in viewer.below(comparison) and viewer.below(comparison))
    viewer.type_into("Comparison with another BVH/Leaf size", "64")
    viewer.point(*ASIDE)
    wait_for("other costs", lambda: "visits per ray" in viewer.below(comparison) and viewer.below(comparison) != table)
    viewer.click("BVH/Build")
    viewer.click("Compare with another BVH")
    # A tree of one level: its leaves hold half of the triangles each.
    few = viewer.settled_picture().count(is_leaf_yellow)
    viewer.type_into("Max level", "1")
    viewer.point(*ASIDE)
    wait_for("the coarse tree", lambda: viewer.settled_picture().count(is_leaf_yellow) > 10 * few)
    viewer.key("ctrl+z")
    wait_for("the fine tree", lambda: viewer.settled_picture().count(is_leaf_yellow) < 10 * few)


def test_light_handle(viewer):
    """The light of the Cornell box is selected and dragged down by its vertical arrow."""
    before = viewer.settled_picture()
    viewer.click(*LIGHT)
    viewer.point(*ASIDE)
    selected = viewer.settled_picture()
    expect(selected.differing(before) > 100, "a selected light has arrows")
    viewer.drag((LIGHT[0], LIGHT[1] - 50), (LIGHT[0], LIGHT[1] + 60))
    viewer.point(*ASIDE)
    moved = viewer.settled_picture()
    expect(moved.differing(selected) > 20000, "the scene is lit from the light's new place")
    viewer.key("ctrl+z")
    expect(viewer.settled_picture().data == selected.data, "undo puts the light back")
    viewer.click(100, 600)
    expect(viewer.settled_picture().data == before.data, "a click beside the light deselects it")


def is_map_yellow(red, green, blue):
    return red > 200 and green > 200 and blue < 140


def test_heat_map(viewer):
    """The cost of pixels in place of the picture; a drag in the histogram narrows the range."""
    viewer.open_scene("builtin:monkey")
    viewer.click("Map")
    viewer.point(*ASIDE)
    viewer.key("m")
    wait_for("the map", lambda: viewer.settled_picture().count(is_map_yellow) > 300)
    few = viewer.settled_picture().count(is_map_yellow)
    viewer.drag(viewer.within("Histogram", 0.53), viewer.within("Histogram", 0.15))
    viewer.point(*ASIDE)
    wait_for("more pixels beyond the range", lambda: viewer.settled_picture().count(is_map_yellow) > 2 * few)
    viewer.key("m")
    wait_for("the traced picture", lambda: viewer.settled_picture().count(is_map_yellow) < few)


def is_failure_purple(red, green, blue):
    return red > 150 and green < 130 and blue > 170


def test_lab(viewer):
    """The robustness test runs in the background; failed rays of the float triangle test are drawn."""
    viewer.open_scene("builtin:monkey")
    viewer.click("Scene")
    viewer.click("Numerical robustness")
    viewer.click("Test numerical robustness")
    viewer.point(*ASIDE)
    wait_for("rays that went wrong", lambda: viewer.picture().count(is_failure_purple) > 500)
    viewer.click("Draw failed rays")
    viewer.point(*ASIDE)
    wait_for("the scene without them", lambda: viewer.picture().count(is_failure_purple) < 50)


def test_typing_is_not_a_shortcut(viewer):
    """Letters in a text field open no panel, switch no view and record no rays."""
    viewer.open_scene("builtin:spheres")
    viewer.point(*ASIDE)
    shown = viewer.settled_picture()
    expect(viewer.capture().at(*PANEL_PIXEL) != (0, 0, 0), "the side panel is still there")
    expect(shown.count(is_ray_yellow) == 0, "no rays were recorded")
    viewer.key("n")
    wait_for("a wider picture", lambda: viewer.capture().crop(960, 100, 300, 500).differing(
        viewer.capture().crop(960, 30, 300, 500)) > 0)


def test_wide_traversal(viewer):
    """The same ray in the wide tree that production rays traverse."""
    viewer.open_scene("builtin:monkey")
    viewer.record_rays((390, 480))
    viewer.key("t")
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    viewer.point(*ASIDE)
    binary = viewer.settled_picture()
    viewer.click("Wide")
    viewer.point(*ASIDE)
    wait_for("the boxes of the wide tree", lambda: viewer.settled_picture().differing(binary) > 300)
    viewer.click("Missed")
    seen = set()
    for _ in range(6):
        viewer.key("Right")
        seen.add(viewer.settled_picture().data)
    expect(len(seen) >= 4, f"steps of the wide traversal look different ({len(seen)})")
    viewer.key("Left")
    expect(viewer.settled_picture().data in seen, "a step back shows the same as before")


def is_lit(red, green, blue):
    return red + green + blue > 30


def test_compare(viewer):
    """A kept picture against one with other settings: wipe, flip and difference."""
    viewer.point(*ASIDE)
    viewer.settled_picture()
    viewer.key("Tab")
    viewer.key("o")  # lights and handles are not compared
    a = viewer.settled_picture()
    viewer.key("k")
    viewer.click("Settings")
    viewer.click("Hard shadows")
    viewer.click("A/B")
    viewer.point(*ASIDE)
    left, right, below = (0, 60, 460, 560), (484, 60, 460, 560), (0, 60, 944, 560)
    wait_for("B", lambda: viewer.settled_picture().crop(*right).differing(a.crop(*right)) > 1000)
    wiped = viewer.settled_picture()
    expect(wiped.crop(*left).data == a.crop(*left).data, "A is on the left of the divider")
    viewer.drag((472, 640), (300, 640))
    viewer.point(*ASIDE)
    moved = viewer.settled_picture()
    beside = (320, 60, 140, 560)
    expect(moved.crop(*beside).differing(wiped.crop(*beside)) > 300, "the divider was dragged")
    viewer.key("x")
    expect(viewer.settled_picture().crop(*below).data == a.crop(*below).data, "flipped, A is shown")
    viewer.key("x")
    b = viewer.settled_picture()
    expect(b.crop(*below).differing(a.crop(*below)) > 3000, "flipped again, B is shown")
    expect(b.crop(*right).data == wiped.crop(*right).data, "B is what was on the right of the divider")
    viewer.click("Difference")
    viewer.point(*ASIDE)
    wait_for("the difference", lambda: viewer.settled_picture().crop(*below).data != b.crop(*below).data)
    differing = viewer.settled_picture().crop(*below).count(is_lit)
    truly = a.crop(*below).differing(b.crop(*below))
    expect(abs(differing - truly) < 0.1 * truly, f"where the pictures differ, and only there ({differing}, {truly})")
    metrics = wait_for("metrics", lambda: viewer.says("complete picture B") and viewer.below("A/B/"))
    viewer.click("Restore settings")
    viewer.point(*ASIDE)
    wait_for("no difference", lambda: viewer.settled_picture().crop(*below).count(is_lit) == 0)
    wait_for("other figures", lambda: viewer.says("complete picture B") and viewer.below("A/B/") != metrics)
    viewer.key("v")
    expect(viewer.settled_picture().crop(*below).data == a.crop(*below).data, "V ends the comparison")


def test_stop_criteria(viewer):
    """Preset slider, error target and time limit."""
    viewer.click("Settings")
    viewer.key("Tab")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    expect(viewer.saved_property("setting.spp") == "4", "four samples were requested")
    viewer.click(viewer.within("Quality/Preset##preset", 0.02))
    viewer.point(*ASIDE)
    viewer.settled_picture()
    expect(viewer.saved_property("setting.max_depth") == "2", "the first preset is 'preview'")
    viewer.key("ctrl+z")
    viewer.click("Error target##byError")
    viewer.point(*ASIDE)
    wait_for("the target", lambda: viewer.settled_picture() and int(viewer.saved_property("samples")) >= 8)
    expect(viewer.saved_property("setting.spp") == "65536", "the picture was requested with as many samples as necessary")
    # A target out of reach, and a second of time.
    viewer.click("Time limit##byTime")
    viewer.type_into("Error target##error", "0.0001")
    viewer.type_into("Time limit##seconds", "1")
    viewer.drag((700, 600), (860, 560))
    viewer.point(*ASIDE)
    viewer.settled_picture()
    expect(int(viewer.saved_property("samples")) < 400, "tracing ended")


def test_trade(viewer):
    """The Pareto front, measured in the background, and the position of the current settings."""
    def is_preset_orange(r, g, b):
        return abs(r - 230) < 12 and abs(g - 159) < 12 and b < 25

    def is_front_blue(r, g, b):
        return abs(r - 86) < 12 and abs(g - 180) < 12 and abs(b - 233) < 12

    def is_ring_white(r, g, b):
        return min(r, g, b) > 225

    def charts():
        return [viewer.capture().crop(*viewer.rect("Chart"))] if viewer.says("Chart") else []

    viewer.click("Settings")
    viewer.click("Quality-speed study")
    # In the first budget a busy machine may measure too little for a line.
    for budget in "6", "24":
        viewer.type_into("Time budget", budget)
        viewer.click("Measure quality and speed")
        viewer.point(100, 600)
        chart = wait_for("the chart with presets",
                         lambda: next((shown for shown in charts() if shown.count(is_preset_orange) > 25), None))
        if chart.count(is_front_blue) > 40:
            break
    expect(chart.count(is_front_blue) > 40, "the Pareto front is a line")
    viewer.click(viewer.within("Quality/Preset##preset", 0.02))
    viewer.point(100, 600)
    ring = wait_for("the position of the first preset",
                    lambda: next((shown for shown in charts() if shown.count(is_ring_white) > 15), None))
    expect(ring.differing(chart) > 15, "the ring moved")


def test_isolate_and_copy(viewer):
    """One ray and what belongs to it; the tree in the clipboard."""
    every = viewer.record_rays((440, 340))
    viewer.key("j")
    copied = json.loads(wait_for("the clipboard", x11.clipboard_text))
    viewer.key("ctrl+j")
    newest = wait_for("the exported rays", lambda: sorted(viewer.folder.glob("*.json")))[-1]
    expect(copied == json.loads(newest.read_text()), "the clipboard has the tree of the file")
    viewer.click("Recorded rays/camera 0")
    viewer.point(*ASIDE)
    selected = viewer.settled_picture()
    viewer.key("i")
    isolated = viewer.settled_picture()
    expect(isolated.differing(selected) > 30, "other rays went away")
    viewer.key("i")
    expect(viewer.settled_picture().data == selected.data, "they come back")
    expect(selected.differing(every) > 30, "the selected ray has a halo")
    viewer.key("ctrl+c")


def is_missed_red(red, green, blue):
    return 190 < red < 230 and 40 < green < 90 and blue < 60


def is_occluded_red(red, green, blue):
    return red > 200 and green < 75 and blue < 70


def is_good_green(red, green, blue):
    return 100 < red < 140 and green > 180 and 120 < blue < 160


def is_warning_orange(red, green, blue):
    return red > 220 and 165 < green < 215 and 60 < blue < 120


def test_replay(viewer):
    """Ctrl+click records; the replay is bit-identical, and the rays stay when the camera moves; rays can be picked."""
    viewer.click("Rays")
    viewer.key("Tab")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    viewer.do("keydown", "ctrl")
    viewer.click(350, 399)
    viewer.do("keyup", "ctrl")
    wait_for("the result of the replay", lambda: viewer.says("bit-identical"))
    expect(viewer.says("of this view"), "fresh rays are of this view")
    viewer.drag(ASIDE, (ASIDE[0] + 160, ASIDE[1] - 40))
    wait_for("rays of an earlier view", lambda: viewer.says("of an earlier view"))
    blocked = viewer.settled_picture()
    expect(blocked.count(is_occluded_red) > 60, "the occluded shadow ray is red")
    # A sentence names the ray that it rests on; a click on its button selects that ray.
    viewer.click("Diagnosis/ray 1")
    viewer.point(*ASIDE)
    wait_for("the ray of the sentence", lambda: viewer.settled_picture().differing(blocked) > 30)
    viewer.click(*ASIDE)
    wait_for("nothing selected", lambda: viewer.settled_picture().data == blocked.data)
    # The same by a click on the ray itself, which the table follows.
    table = viewer.capture().crop(950, 360, 310, 110)
    yellow = [i for i, pixel in enumerate(blocked.pixels()) if is_ray_yellow(*pixel)]
    place = yellow[len(yellow) // 2]
    viewer.click(place % blocked.width, PICTURE[1] + place // blocked.width)
    viewer.point(*ASIDE)
    wait_for("a halo", lambda: viewer.settled_picture().differing(blocked) > 100)
    expect(viewer.capture().crop(950, 360, 310, 110).differing(table) > 100, "the row of the ray is marked")


def shown(viewer):
    viewer.point(*ASIDE)
    return viewer.settled_picture()


def test_filters(viewer):
    """Rays by depth, contribution and kind; culled boxes."""
    every = viewer.record_rays((440, 360))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    expect(every.count(is_missed_red) > 60, f"a ray that misses is red ({every.count(is_missed_red)})")
    viewer.type_into("Filters/Max depth", "0")
    expect(shown(viewer).count(is_missed_red) == 0, "without reflections it is not drawn")
    expect(shown(viewer).count(is_ray_yellow) > 100, "but the camera ray is")
    viewer.type_into("Filters/Max depth", "16")
    expect(shown(viewer).data == every.data, "with reflections it is")
    viewer.click("Legend (click to show or hide)/miss")
    expect(shown(viewer).count(is_missed_red) == 0, "the legend hides rays that miss")
    viewer.click("Legend (click to show or hide)/miss")
    viewer.type_into("Min contribution", "1")
    expect(shown(viewer).count(is_ray_yellow) == 0, "what adds less than 1 is hidden")
    viewer.type_into("Min contribution", "0")
    expect(shown(viewer).data == every.data, "and comes back")
    viewer.key("t")
    traversed = shown(viewer)
    viewer.click("Culled")
    expect(traversed.count(is_square_purple) > shown(viewer).count(is_square_purple) + 100, "culled boxes are violet")
    viewer.click("Culled")
    expect(shown(viewer).data == traversed.data, "and come back")


def test_parts_of_scenes(viewer):
    """Shadow rays of one light, outlines of the lens, pinned pixels, glossy rays that would go below the surface."""
    viewer.open_scene("builtin:monkey")
    both = viewer.record_rays((440, 330))
    viewer.click("Recorded rays")
    viewer.click("Diagnosis")
    single = []
    for light in "0", "1":
        viewer.type_into("Filters/Light", light)
        single.append(shown(viewer))
        expect(single[-1].differing(both) > 20, f"only the shadow ray to light {light}")
    expect(single[0].data != single[1].data, "each light has its own")
    viewer.type_into("Filters/Light", "-1")
    expect(shown(viewer).data == both.data, "all lights again")
    viewer.key("c")
    viewer.open_scene("builtin:spheres-dof")
    lens = viewer.record_rays((420, 330))
    viewer.click("Lens and focus")
    # The shading normal is as green as they are.
    expect(shown(viewer).count(is_visited_green) < 0.6 * lens.count(is_visited_green), "lens and focus go away")
    viewer.click("Lens and focus")
    expect(shown(viewer).data == lens.data, "and come back")
    viewer.key("p")
    viewer.scroll_to_end(PANEL)
    wait_for("the statistics of the pixel", lambda: "420, 309" in viewer.below("Rays/Pinned pixels/"))
    viewer.key("c")
    viewer.open_scene("builtin:cornell-glossy")
    rejected = viewer.record_rays((480, 330)).count(is_square_purple)
    viewer.click("glossy, below the surface")
    expect(shown(viewer).count(is_square_purple) < rejected - 30, "rays below the surface are dotted violet")
    viewer.click("glossy, below the surface")
    expect(shown(viewer).count(is_square_purple) == rejected, "and come back")


def is_node_blue(red, green, blue):
    return 60 < red < 110 and 160 < green < 200 and 210 < blue < 245


def nodes(viewer):
    """The labels of the visible nodes of the tree."""
    return [path for path in viewer.below("BVH/Nodes/") if path.startswith(("node ", "leaf "))]


def open_root(viewer):
    """Opens the root of the tree and selects its first child."""
    root = wait_for("the tree", lambda: nodes(viewer))[0]
    x, y, _, height = viewer.rect("Nodes/" + root)
    viewer.click(x + height // 2, y + height // 2)
    child = wait_for("the children", lambda: nodes(viewer)[1:])[0]
    viewer.click(viewer.within("Nodes/" + child, 0.3))


def test_node_tree(viewer):
    """A click on a node of the tree draws it, and the plot of its splits follows."""
    viewer.open_scene("builtin:monkey")
    viewer.click("BVH")
    viewer.point(*ASIDE)
    bare = viewer.settled_picture().count(is_node_blue)
    wait_for("the tree", lambda: nodes(viewer))
    wait_for("the plot of the root", lambda: viewer.says("/root: "))
    open_root(viewer)
    viewer.point(*ASIDE)
    wait_for("the box of the node", lambda: viewer.settled_picture().count(is_node_blue) > bare + 300)
    wait_for("statistics of the node", lambda: viewer.says("/Nodes/Lower"))
    viewer.scroll_to_end(PANEL)
    wait_for("the plot of the node", lambda: viewer.says("/Split costs of the node/node "))


def test_heat_quantities(viewer):
    """Each quantity and each colour map is another picture."""
    viewer.click("Map")
    viewer.key("m")
    viewer.point(*ASIDE)
    seen = []
    for row, choices in ("Quantity", ("triangles", "rays")), ("Colour map", ("blue-gold", "grey")):
        for choice in choices:
            viewer.choose(row, choice)
            viewer.point(*ASIDE)
            another = wait_for("another map", lambda: next(
                (picture for picture in [viewer.settled_picture()]
                 if picture.data not in seen and picture.count(is_lit) > 1000), None))
            seen.append(another.data)


def test_fly(viewer):
    before = viewer.settled_picture()
    viewer.point(470, 340)
    viewer.key("grave")
    viewer.do("keydown", "w")
    wait_for("a flight", lambda: viewer.picture().differing(before) > 20000)
    viewer.do("keyup", "w")
    viewer.key("Escape")
    flown = viewer.settled_picture()
    viewer.key("w")
    expect(viewer.settled_picture().data == flown.data, "the flight has ended")
    viewer.key("Home")
    wait_for("the camera of the scene", lambda: viewer.settled_picture().data == before.data)


def test_drop(viewer):
    scene = viewer.folder / "dropped.obj"
    scene.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    expect(x11.drop_file(int(viewer.window), scene), "the window takes the file")
    wait_for("the dropped scene", lambda: "dropped.obj" in viewer.title())


def test_vertex_colors(viewer):
    """A square whose vertices are green, of a red material, in both views."""
    (viewer.folder / "square.ply").write_text(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "-1 -1 0 0 200 0\n1 -1 0 0 200 0\n1 1 0 0 200 0\n-1 1 0 0 200 0\n4 0 1 2 3\n")
    text = ('version = 1\n[[camera]]\nlook_from = [0, 0, 3]\n[[light]]\ntype = "point"\nposition = [0, 0, 3]\n'
            '[material.red]\nkd = [1, 0, 0]\n[[mesh]]\nfile = "square.ply"\nmaterial = "red"\n')
    for scene, key, channel in ("shown.toml", "vertex_colors = true\n", 1), ("hidden.toml", "", 0):
        (viewer.folder / scene).write_text(text + key)
        viewer.open_scene(scene)
        for _ in "rasterised", "traced":
            color = viewer.settled_picture().crop(450, 310, 40, 40).mean()
            expect(color[channel] > 2 * color[1 - channel], f"the colour of {scene}: {color}")
            viewer.point(*ASIDE)
            viewer.key("Tab")


def test_bloom_stages(viewer):
    def stage(name, is_new):
        """The picture of a stage: bloom is computed in the background, so the picture of before stays for a while."""
        viewer.choose("Bloom stage", name)
        viewer.point(*ASIDE)
        return wait_for(f"the stage {name}", lambda: next(
            (picture for picture in [viewer.settled_picture()] if is_new(picture)), None))

    viewer.click("Settings")
    viewer.key("Tab")
    viewer.scroll_to_end(PANEL)
    viewer.point(*ASIDE)
    everything = viewer.settled_picture().count(is_lit)
    thresholded = stage("thresholded", lambda picture: picture.count(is_lit) < 0.8 * everything)
    filtered = stage("filtered", lambda picture: picture.data != thresholded.data)
    lit = thresholded.count(is_lit), filtered.count(is_lit)
    expect(0 < lit[0] < lit[1], f"the filter spreads what is above the threshold {lit}")
    stage("added", lambda picture: picture.data != filtered.data)
    viewer.click("Bloom debug")
    viewer.point(*ASIDE)
    wait_for("the glow that is added to the picture",
             lambda: viewer.settled_picture().brightness() > filtered.brightness())


def is_sky_blue(red, green, blue):
    return 175 < red < 210 and 195 < green < 228 and 220 < blue < 250


def test_environment_overlay(viewer):
    before = viewer.record_rays((340, 300))
    # The sphere shows the sky there, and so does the line along which it is seen.
    line = before.crop(450, 150, 490, 130).count(is_sky_blue)
    expect(line > 100, f"the reflected direction is drawn in the colour of the sky ({line} pixels)")
    viewer.key("c")
    wait_for("the line to go", lambda: viewer.settled_picture().crop(450, 150, 490, 130).count(is_sky_blue) == 0)


CUBE_MAP = """version = 1
[[camera]]
look_from = [0, 0, 3]
look_at = [0, 0, 0]
fov = 120
[[sphere]]
center = [0, 0, 0]
radius = 0.5
material = "mirror"
[material.mirror]
kd = [0.1, 0.1, 0.1]
ks = [1, 1, 1]
[environment]
cube = { px = "px.png", nx = "nx.png", py = "py.png", ny = "ny.png", pz = "pz.png", nz = "nz.png" }
"""


def test_cube_map(viewer):
    """A ray that misses has the colour of the cube face it hits, and the panel names the face."""
    colors = {"px": (40, 200, 240), "nx": (240, 60, 240), "py": (250, 250, 250), "ny": (90, 90, 90),
              "pz": (240, 160, 40), "nz": (60, 220, 60)}
    for face, color in colors.items():
        subprocess.run(["convert", "-size", "8x8", "xc:rgb({},{},{})".format(*color), viewer.folder / f"{face}.png"],
                       check=True)
    (viewer.folder / "cube-map.toml").write_text(CUBE_MAP)
    viewer.open_by_name("cube-map.toml")
    wait_for("the cube map", lambda: "cube-map" in viewer.title())
    viewer.click("Rays")
    for pixel, face in ((30, 360), "nx"), ((360, 360), "nz"), ((915, 360), "px"):
        viewer.key("Home")
        viewer.point(*ASIDE)
        bare = viewer.settled_window()
        viewer.point(*pixel)
        viewer.key("r")
        wait_for("what was recorded", lambda: viewer.capture().differing(bare) > 3000)
        viewer.drag(ASIDE, (ASIDE[0] + 160, ASIDE[1] - 40))
        rays = viewer.settled_picture()
        drawn = rays.count(lambda *rgb: all(abs(a - b) < 12 for a, b in zip(rgb, colors[face])))
        expect(drawn > 60, f"the ray has the colour of face {face} ({drawn} pixels)")
        viewer.click("Recorded rays")
        viewer.click("Diagnosis")
        viewer.point(*ASIDE)
        wait_for("the face of the map", lambda: viewer.says("environment: face " + face.replace("n", "-").replace("p", "+")))
        viewer.click("Diagnosis")
        viewer.click("Recorded rays")
        viewer.key("c")


def exported_tree(viewer):
    """What is recorded, as the window writes it."""
    known = set(viewer.folder.glob("*.json"))
    viewer.key("ctrl+j")
    wait_for("the exported rays", lambda: set(viewer.folder.glob("*.json")) - known)
    [path] = set(viewer.folder.glob("*.json")) - known
    return wait_for("the whole file", lambda: json.loads(path.read_text()) if path.read_text().endswith("}\n") else None)


def test_light_samples(viewer):
    """The number of recorded shadow rays is that of the slider for the kind of light."""
    for scene, slider, number, rays in (("builtin:cornell-area", "Parallelogram samples", "3", 9),
                                        ("builtin:cube", "Segment samples", "5", 5)):
        viewer.open_scene(scene)
        for expected in 16, rays:
            viewer.record_rays((440, 380))
            tree = exported_tree(viewer)
            found = len([ray for ray in tree["shadow_rays"] if ray["node"] == 0])
            expect(found == expected, f"{scene}: {found} shadow rays, not {expected}")
            viewer.key("c")
            viewer.key("Home")
            viewer.click("Settings")
            viewer.type_into(slider, number)


def test_lens(viewer):
    """Rays through all of the lens, none of them within the sharp zone, whose planes are dashed."""
    def is_faint_yellow(red, green, blue):
        return red > 90 and green > 80 and red - blue > 40

    def spread():
        one = viewer.record_rays((420, 330))
        viewer.click("Draw all samples")
        every = shown(viewer)
        viewer.click("Draw all samples")
        expect(shown(viewer).data == one.data, "a single sample again")
        viewer.key("c")
        viewer.key("Home")
        # Of many rays each is transparent. Before the dark sky there is nothing else that is yellow.
        sky = (760, 170, 180, 60)
        return one.count(is_visited_green), every.crop(*sky).count(is_faint_yellow) / one.crop(*sky).count(is_faint_yellow)

    planes, sharp = spread()
    viewer.click("Settings")
    viewer.scroll_to_end(PANEL)
    viewer.type_into("Sharp zone", "0")
    fewer_planes, blurred = spread()
    expect(planes > 1.3 * fewer_planes, f"the planes of the sharp zone ({planes}, {fewer_planes} pixels)")
    expect(blurred > 2.0 * sharp, f"rays from all of the lens ({blurred:.1f} and {sharp:.1f} times the pixels of one)")


def test_pins(viewer):
    """Pinned pixels are listed, and a click removes one."""
    viewer.open_scene("builtin:cornell")
    for x in 300, 500:
        viewer.key("Home")
        viewer.record_rays((x, 480))
        viewer.key("p")
        viewer.key("c")
    viewer.point(*ASIDE)

    def pins():
        return [text for text in viewer.below("Rays/Pinned pixels/") if text.endswith(", 459")]

    expect(pins() == ["300, 459", "500, 459"], f"both pixels are listed: {pins()}")
    viewer.click("300, 459")
    wait_for("one pin less", lambda: pins() == ["500, 459"])
    viewer.click("500, 459")
    wait_for("no pin", lambda: pins() == [])


def test_byte_budget(viewer):
    """All samples of a pixel, as many as the memory holds."""
    one = viewer.record_rays((440, 480))
    viewer.click("Draw all samples")
    viewer.point(*ASIDE)
    wait_for("all samples", lambda: viewer.settled_picture().differing(one) > 300)
    every = viewer.settled_picture()
    viewer.type_into("Memory limit", "1")
    viewer.point(*ASIDE)
    wait_for("fewer rays", lambda: viewer.settled_picture().differing(every) > 30)


def test_moving(viewer):
    """While the camera moves: all of ten thousand rays are drawn, and the lower resolution is reported."""
    viewer.record_rays((440, 480))
    viewer.click("Draw all samples")
    viewer.point(*ASIDE)
    viewer.settled_picture()
    expect(viewer.saved_property("drawn", "shift+ctrl+s") == "", "a still picture is drawn in full")
    viewer.do("mousedown", 1)
    viewer.do("mousemove", ASIDE[0] + 60, ASIDE[1])
    said = viewer.saved_property("drawn", "shift+ctrl+s")
    expect(said == "1/2 of the resolution", f"all lines are drawn: {said!r}")
    moving = viewer.picture()
    viewer.key("o")
    bare = viewer.picture()
    viewer.key("o")
    expect(moving.differing(bare) > 3000, "the lines are visible")
    viewer.do("mouseup", 1)
    expect(viewer.settled_picture().differing(moving) > 1000, "at rest everything is drawn")
    expect(viewer.saved_property("drawn", "shift+ctrl+s") == "", "and nothing is reported")


def test_layout(viewer):
    """Width and side of the panel, its tab and the UI scale are the same at the next start; a command resets them."""
    def seen():
        return viewer.rect("Rasterised"), viewer.rect("Panel edge")

    first = seen()
    x = first[1][0]
    viewer.drag((x + 2, 300), (x - 98, 300))
    wait_for("a wider panel", lambda: viewer.rect("Panel edge")[0] < x - 80)
    viewer.click("BVH")
    viewer.key("shift+n")
    wait_for("the panel on the left", lambda: viewer.rect("Rasterised")[0] < 100)
    heights = [viewer.rect("Rasterised")[3]]
    for _ in range(3):
        viewer.key("ctrl+plus")
        wait_for("larger controls", lambda: viewer.rect("Rasterised")[3] > heights[-1])
        heights.append(viewer.rect("Rasterised")[3])
    changed = seen()
    viewer.quit()
    viewer.__init__(os.path.abspath(sys.argv[1]), viewer.folder, "builtin:cube")
    wait_for("the layout of before", lambda: seen() == changed)
    viewer.rect("BVH/Boxes")
    viewer.key("ctrl+shift+n")
    wait_for("the layout of the first start", lambda: seen() == first)


def test_full_screen(viewer):
    small = viewer.size()
    expect(small == (800, 600), f"the window has the requested size, not {small}")
    viewer.key("F11")
    wait_for("the whole screen", lambda: viewer.size() == (WIDTH, HEIGHT))
    wait_for("panels at the new edge", lambda: viewer.capture().at(*PANEL_PIXEL) != (0, 0, 0))
    viewer.key("F11")
    wait_for("the window of before", lambda: viewer.size() == small)


def test_cancel_loading(viewer):
    viewer.settled_picture()
    viewer.open_by_name("builtin:ten-million")
    viewer.rect("Loading/Cancel")
    wait_for("the step", lambda: viewer.says("generating a terrain"))
    viewer.key("Escape")
    wait_for("the end of the load", lambda: viewer.says("Cancelled: builtin:ten-million was not loaded"))
    expect("builtin:cornell" in viewer.title(), "the scene before stays")
    viewer.open_by_name("builtin:ten-million")
    viewer.rect("Loading/Cancel")
    viewer.open_scene("builtin:cube")  # replaces what is being loaded
    viewer.open_by_name("builtin:ten-million")
    viewer.rect("Loading/Cancel")  # and the program ends while it is being loaded


def test_missing_file(viewer):
    viewer.open_scene("builtin:spheres")
    viewer.settled_picture()
    before = viewer.picture()
    viewer.open_by_name("does-not-exist.toml")
    wait_for("the message", lambda: viewer.picture().differing(before) > 1000)
    viewer.key("Escape")
    expect("builtin:spheres" in viewer.title(), "the scene before stays")
    wait_for("the message to go", lambda: viewer.picture().differing(before) < 1000)


def test_pixel_commands(viewer):
    """Commands for a pixel, chosen in a menu, wait for a click on one; a removal of rays can be undone."""
    viewer.open_scene("builtin:cornell")
    viewer.click("Rays")
    viewer.point(*ASIDE)
    bare = viewer.settled_picture()
    viewer.click("Menu/Rays")
    viewer.click("Menu/Rays/Record rays")
    wait_for("the request for a click", lambda: viewer.says("Record rays: click a pixel"))
    viewer.click(360, 300)
    wait_for("the recorded pixel", lambda: viewer.says("Pixel 360, 279:"))
    viewer.drag(ASIDE, (ASIDE[0] + 160, ASIDE[1] - 40))
    rays = viewer.settled_picture().count(is_ray_yellow)
    expect(rays > 50, f"the rays of the pixel that was clicked ({rays} pixels)")
    viewer.key("c")
    wait_for("no rays", lambda: viewer.settled_picture().count(is_ray_yellow) == 0)
    viewer.key("ctrl+z")
    wait_for("the rays again", lambda: viewer.settled_picture().count(is_ray_yellow) == rays)
    viewer.key("c")
    viewer.click("Record rays of a pixel...")
    viewer.rect("Rays/Recorded rays")
    viewer.key("Escape")
    wait_for("no request", lambda: not viewer.says("Record rays: click a pixel"))
    viewer.key("Home")
    wait_for("the camera of the file", lambda: viewer.settled_picture().differing(bare) == 0)
    viewer.point(360, 300)
    viewer.do("click", 3)
    viewer.click("Pixel menu/Center on pixel")
    viewer.point(*ASIDE)
    wait_for("another view", lambda: viewer.settled_picture().differing(bare) > 1000)
    centered = viewer.settled_picture()
    viewer.key("Home")
    wait_for("the camera of the file", lambda: viewer.settled_picture().differing(bare) == 0)
    viewer.point(360, 300)
    viewer.do("click", "--repeat", 2, "--delay", 30, 1)
    viewer.point(*ASIDE)
    wait_for("the same view by a double click", lambda: viewer.settled_picture().differing(centered) == 0)


def test_keys_window(viewer):
    before = viewer.settled_picture()
    viewer.key("F1")
    wait_for("the list of keys", lambda: viewer.picture().differing(before) > 20000)
    viewer.key("Escape")
    wait_for("the list to close", lambda: viewer.picture().differing(before) == 0)


def test_render_to_file(viewer):
    viewer.key("F12")
    viewer.rect("Render to file/Render")
    viewer.key("Return")
    wait_for("the rendered file", (viewer.folder / "render.png").exists)
    rendered = Pixels(convert_to_ppm("convert", str(viewer.folder / "render.png")))
    expect((rendered.width, rendered.height) == PICTURE[2:], "the rendered file has the size of the picture")
    expect(rendered.brightness() > 5, "the rendered file shows something")
    viewer.key("Escape")
    wait_for("the dialog to close", lambda: not any(path.startswith("Render to file/") for path, _ in viewer.controls()))


def test_without_display(program):
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    run = subprocess.run([program, "view"], env=environment, stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
    expect(run.returncode == 2, f"without a display the exit code is 2, not {run.returncode}")
    expect("display" in run.stderr and run.stderr.count("\n") == 1, f"one message about the display: {run.stderr!r}")


# What windows are opened with, and what is tested in windows of their own.
TESTS = [
    (["--set", "spp=4"],
     [test_views, test_toggle_and_undo, test_debug_ray, test_light_handle, test_traversal, test_surfaces, test_normals_and_panes, test_bvh_boxes,
      test_heat_map, test_lab, test_typing_is_not_a_shortcut, test_cancel_loading, test_missing_file, test_pixel_commands, test_keys_window, test_render_to_file,
      test_wide_traversal]),
    (["--set", "spp=4"], [test_compare, test_stop_criteria, test_trade, test_isolate_and_copy, test_fly, test_drop,
                          test_vertex_colors]),
    (["builtin:spheres-dof", "--set", "spp=16", "--set", "sharp_zone=0.5"], [test_lens]),
    (["--set", "spp=4"], [test_cube_map, test_light_samples, test_pins]),
    (["--set", "spp=4"], [test_replay, test_heat_quantities, test_node_tree, test_filters, test_parts_of_scenes]),
    (["builtin:environment", "--set", "reflection_map=true"], [test_environment_overlay]),
    (["builtin:cornell-area", "--set", "spp=1024"], [test_moving, test_byte_budget]),
    (["builtin:spheres", "--set", "spp=1", "--set", "bloom=true", "--set", "bloom_debug=true", "--set",
      "bloom_threshold=0.3", "--set", "bloom_size=8", "--set", "bloom_sigma=4"],
     [test_bloom_stages]),
    (["--size", "800x600", "builtin:cube"], [test_full_screen]),
    (["builtin:cube"], [test_layout]),
]


def run_test(program, folder, arguments, test):
    folder.mkdir()
    began = time.monotonic()
    viewer = Viewer(program, folder, *arguments)
    try:
        test(viewer)
        viewer.quit()
        print(f"ok  {test.__name__}  {time.monotonic() - began:.1f} s", flush=True)
    except Exception:
        kept = Path(tempfile.gettempdir()) / "rayscope_ui_test_failed.png"
        subprocess.run(["import", "-window", "root", str(kept)], check=False)
        print(f"the screen at that moment: {kept}", file=sys.stderr)
        raise
    finally:
        viewer.process.kill()
        viewer.process.wait()


def run_all(program, folder):
    test_without_display(program)
    for arguments, tests in TESTS:
        for test in tests:
            if not sys.argv[2:] or test.__name__ in sys.argv[2:]:
                run_test(program, folder / test.__name__, arguments, test)


def start_display():
    """Starts a virtual display and sets DISPLAY. Servers that start at the same moment may take the same number, and one
    of them then ends: hence the check and the repeats."""
    for _ in range(5):
        read, write = os.pipe()
        display = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24",
                                    "-nolisten", "tcp"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            os.environ["DISPLAY"] = ":" + pipe.readline().strip()
        check = subprocess.run(["xdotool", "getdisplaygeometry"], capture_output=True, check=False)
        if check.returncode == 0 and check.stdout.split() == [str(WIDTH).encode(), str(HEIGHT).encode()]:
            return display
        display.kill()
        display.wait()
    sys.exit("FAILED: no virtual display responds")


def main():
    program = os.path.abspath(sys.argv[1])
    missing = [tool for tool in ("Xvfb", "xdotool", "import", "convert", "identify") if shutil.which(tool) is None]
    if missing:
        print("skipped: not installed:", ", ".join(missing))
        return 77
    display = start_display()
    with tempfile.TemporaryDirectory() as folder:
        try:
            run_all(program, Path(folder))
        except Failure as failure:
            print("FAILED:", failure, file=sys.stderr)
            return 1
        finally:
            display.terminate()
            display.wait()
    return 0


if __name__ == "__main__":
    sys.exit(main())
