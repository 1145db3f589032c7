"""The commands of the program with small inputs, and the checks of what they leave behind."""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

OLD = b"old content\n"


class Failures:
    """Collects failed checks; each names the command line."""

    def __init__(self):
        self.count = 0

    def add(self, command, text):
        self.count += 1
        print(f"FAILED: {text}\n  {command}", flush=True)

    def end(self, summary):
        print(f"{summary}, {self.count} failures", flush=True)
        sys.exit(1 if self.count else 0)


class Command:
    """`arguments` contain the names of `outputs`; `folder` is a folder of reports that the command fills."""

    def __init__(self, name, arguments, outputs=(), folder=None, codes=(0,)):
        self.name, self.arguments, self.outputs = name, arguments, list(outputs)
        self.folder, self.codes = folder, codes


SMALL = ["builtin:cornell", "--size", "40x30"]
COMMANDS = [
    Command("render", ["render", *SMALL, "--spp", "64", "-o", "a.png", "-o", "a.exr", "-o", "a.pfm", "-o", "a.hdr", "-o",
                       "a.ppm", "--aov", "depth,nodes", "--stats", "s.json"],
            ["a.png", "a.exr", "a.pfm", "a.hdr", "a.ppm", "a.depth.exr", "a.nodes.exr", "s.json"]),
    Command("render with a texture and bloom", ["render", "scene.toml", "--size", "64x64", "--spp", "16", "--set",
                                                "bloom=true", "-o", "b.png"], ["b.png"]),
    Command("render to an error", ["render", *SMALL, "--target-error", "0.02", "-o", "t.png", "-o", "t.pfm"],
            ["t.png", "t.pfm"]),
    Command("render for a time", ["render", *SMALL, "--spp", "100000", "--time-limit", "0.3", "-o", "l.png"], ["l.png"],
            codes=(3,)),
    Command("probe", ["probe", *SMALL, "--pixel", "20,15", "--explain", "--traversal", "--json", "p.json"], ["p.json"]),
    Command("cast", ["cast", "builtin:teapot", "--rays", "many.rays", "-o", "c.hits"], ["c.hits"]),
    Command("info", ["info", "scene.toml", "--json"]),
    Command("bench", ["bench", "builtin:cornell", "--size", "16", "--rounds", "5", "--json", "r.json"], ["r.json"]),
    Command("trade", ["trade", "builtin:triangle", "--size", "16x16", "--budget", "0.5", "-o", "trade"],
            ["trade/trade.json", "trade/trade.csv", "trade/trade.html"], folder="trade", codes=(0, 3)),
    Command("lab", ["lab", "builtin:triangle", "--quick", "--rays", "100", "-o", "lab"],
            ["lab/lab.json", "lab/lab.csv", "lab/lab.html"], folder="lab", codes=(0, 4)),
    Command("compare", ["compare", "x.png", "y.png", "-o", "d.png", "--map", "m.csv"], ["d.png", "m.csv"]),
    Command("settings", ["settings", "--json"]),
]

INPUTS = ["scene.toml", "texture.png", "many.rays", "x.png", "y.png"]


def png(width, height, pixel):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Workplace:
    """A folder with the inputs of the commands; caches are in it, too."""

    def __init__(self, program):
        self.program = program
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="rayscope-faults-"))
        self.environment = {**os.environ, "XDG_CACHE_HOME": str(self.path / "cache"),
                            "XDG_CONFIG_HOME": str(self.path / "config")}
        (self.path / "texture.png").write_bytes(png(64, 64, lambda x, y: (4 * x, 4 * y, 128)))
        (self.path / "x.png").write_bytes(png(32, 32, lambda x, y: (8 * x, 8 * y, 50)))
        (self.path / "y.png").write_bytes(png(32, 32, lambda x, y: (8 * y, 8 * x, 50)))
        (self.path / "many.rays").write_bytes(struct.pack("<8f", 0, 0, 5, 0, 0, -1, 0, 100) * 100000)
        (self.path / "scene.toml").write_text(
            'version = 1\n[[camera]]\nlook_from = [0, 0, 3]\nlook_at = [0, 0, 0]\n'
            '[material.m]\nkd = [1, 1, 1]\nkd_texture = "texture.png"\n'
            '[[mesh]]\ngenerate = { shape = "uv_sphere" }\nmaterial = "m"\n'
            '[[light]]\ntype = "point"\nposition = [2, 2, 2]\ncolor = [1, 1, 1]\n')

    def remove(self):
        shutil.rmtree(self.path, ignore_errors=True)

    def prepare(self, command, keep_old):
        """Removes outputs, or puts old files in their place."""
        for name in ["cache", "config", "trade", "lab"]:
            shutil.rmtree(self.path / name, ignore_errors=True)
        for entry in self.path.iterdir():
            if entry.name not in INPUTS:
                entry.unlink()
        if command.folder:
            (self.path / command.folder).mkdir()
        if keep_old:
            for name in command.outputs:
                (self.path / name).write_bytes(OLD)

    def start(self, command, extra=None, **options):
        """`extra`: environment variables."""
        return subprocess.Popen([self.program, *command.arguments], cwd=self.path, env={**self.environment, **(extra or {})},
                                **options)

    def run(self, command, extra=None):
        """The exit status, the standard output and the messages."""
        process = self.start(command, extra, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = process.communicate()
        return process.returncode, out.decode(errors="replace"), err.decode(errors="replace")

    def problem_of(self, name):
        """Why an output is neither absent, nor old, nor whole; None if it is one of them."""
        path = self.path / name
        if not path.exists():
            return None
        content = path.read_bytes()
        try:
            return None if content == OLD else self.damage_of(name, content)
        except Exception as error:  # of a parser
            return f"{name} is damaged: {error}"

    def damage_of(self, name, content):
        suffix = name.rsplit(".", 1)[1]
        if suffix == "json":
            json.loads(content)
        elif suffix == "html":
            return None if content.rstrip().endswith(b"</html>") else f"{name} ends too early"
        elif suffix == "csv":
            return None if content.endswith(b"\n") else f"{name} ends too early"
        elif suffix == "hits":
            return None if len(content) == 16 * 100000 else f"{name} has {len(content)} bytes"
        else:  # an image: the reader of the program refuses damaged ones
            read = subprocess.run([self.program, "compare", name, name], cwd=self.path, capture_output=True)
            if read.returncode not in (0, 5):
                return f"{name} is damaged: {read.stderr.decode(errors='replace')}"
        return None

    def is_new(self, name):
        path = self.path / name
        return path.exists() and path.read_bytes() != OLD

    def problems(self, command):
        """What a command left that it must not leave."""
        found = [problem for name in command.outputs if (problem := self.problem_of(name))]
        known = {*INPUTS, *command.outputs, "cache", "config", "trade", "lab", "out", "err"}
        for path in self.path.rglob("*"):
            name = str(path.relative_to(self.path))
            if path.name.startswith(".rayscope-"):
                found.append(f"the temporary file {name} is left")
            elif name.split("/")[0] in ("cache", "config"):
                mode = path.stat().st_mode & 0o777
                if mode & 0o077:
                    found.append(f"{name} has the permissions {mode:o}")
            elif name not in known and not name.startswith("lab/"):
                found.append(f"{name} is left")
        return found


def shown(command, extra=""):
    return " ".join(["rayscope", *command.arguments, extra]).strip()


CRASHES = ("terminate called", "Sanitizer", "Assertion", "rayscope crashed")


def crash_in(messages):
    return next((word for word in CRASHES if word in messages), None)
