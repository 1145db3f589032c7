#!/usr/bin/env python3
"""Writes small valid files of every kind that Rayscope reads: the inputs from which the fuzzers start.

usage: make_seeds.py FOLDER    writes FOLDER/TARGET/NAME

JPEG files and compressed EXR files are written by ImageMagick where it is installed.
"""
import base64
import json
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]


def little(form, *values):
    return struct.pack("<" + form, *values)


def big(form, *values):
    return struct.pack(">" + form, *values)


# Images of 5 x 3 pixels.
WIDTH, HEIGHT = 5, 3


def samples(count, largest=255):
    return [(37 * i + 11) % (largest + 1) for i in range(count)]


def packed(values, bits):
    """Rows of values with so many bits each, padded to bytes."""
    text = "".join(f"{value:0{bits}b}" for value in values)
    text += "0" * (-len(text) % 8)
    return bytes(int(text[i:i + 8], 2) for i in range(0, len(text), 8))


def png_chunk(kind, data):
    return big("I", len(data)) + kind + data + big("I", zlib.crc32(kind + data))


def png(color, depth, chunks=b"", interlaced=False):
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[color]
    passes = [(0, 0, 1, 1)]
    if interlaced:
        passes = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]
    rows = b""
    for x0, y0, dx, dy in passes:
        columns = len(range(x0, WIDTH, dx))
        for y in range(y0, HEIGHT, dy) if columns else ():
            largest = 3 if color == 3 and depth > 1 else 2 ** depth - 1
            rows += bytes([y % 5 if not interlaced else 0]) + packed(samples(columns * channels, largest), depth)
    header = big("IIBBBBB", WIDTH, HEIGHT, depth, color, 0, 0, int(interlaced))
    return (b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", header) + chunks + png_chunk(b"IDAT", zlib.compress(rows)) +
            png_chunk(b"IEND", b""))


def png_files():
    palette = png_chunk(b"PLTE", bytes(samples(12)))
    chromaticities = big("8I", 31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000)
    profile = b"p\0\0" + zlib.compress(bytes(128))
    for color, depths in (0, (1, 2, 4, 8, 16)), (2, (8, 16)), (3, (1, 2, 4, 8)), (4, (8, 16)), (6, (8, 16)):
        for depth in depths:
            chunks = palette if color == 3 else b""
            yield f"color{color}-depth{depth}", png(color, depth, chunks)
    yield "interlaced", png(2, 8, interlaced=True)
    yield "interlaced-palette", png(3, 4, palette, interlaced=True)
    yield "transparent", png(3, 2, palette + png_chunk(b"tRNS", b"\0\x7f\xff"))
    yield "chunks", png(2, 8, b"".join(png_chunk(kind, data) for kind, data in (
        (b"gAMA", big("I", 45455)), (b"cHRM", chromaticities), (b"sRGB", b"\0"), (b"sBIT", b"\5\6\5"),
        (b"pHYs", big("IIB", 1, 2, 1)), (b"tEXt", b"rayscope:seed\x007"), (b"zTXt", b"a\0\0" + zlib.compress(b"b")),
        (b"iTXt", b"c\0\0\0\0\0d"), (b"bKGD", bytes(6)), (b"eXIf", b"II*\0\x08\0\0\0\0\0"))))
    yield "profile", png(2, 8, png_chunk(b"iCCP", profile))
    yield "linear", png(0, 16, png_chunk(b"gAMA", big("I", 100000)))


def bmp_files():
    for bits in 1, 4, 8, 16, 24, 32:
        colors = 2 ** bits if bits <= 8 else 0
        palette = b"".join(bytes([i, 255 - i, i // 2, 0]) for i in range(min(colors, 16)))
        row = packed(samples(WIDTH, min(colors, 16) - 1), bits) if bits <= 8 else bytes(samples(WIDTH * bits // 8))
        rows = (row + bytes(-len(row) % 4)) * HEIGHT
        info = little("IiiHHIIiiII", 40, WIDTH, HEIGHT, 1, bits, 0, len(rows), 0, 0, len(palette) // 4, 0)
        yield f"bits{bits}", b"BM" + little("IHHI", 54 + len(palette) + len(rows), 0, 0, 54 + len(palette)) + info + palette + rows
    palette = b"".join(bytes([i, i, i, 0]) for i in range(16))
    for compression, code in (1, b"\5\1\0\0\2\7\0\3\1\2\3\0\0\0\0\2\1\0\4\5\0\1"), (2, b"\5\x12\0\0\0\5\x12\x34\x50\0\0\0\0\1"):
        bits = 8 if compression == 1 else 4
        info = little("IiiHHIIiiII", 40, WIDTH, HEIGHT, 1, bits, compression, len(code), 0, 0, 16, 0)
        yield f"runs{bits}", b"BM" + little("IHHI", 118 + len(code), 0, 0, 118) + info + palette + code
    masks = little("IIII", 0xf800, 0x07e0, 0x001f, 0)
    rows = (bytes(samples(WIDTH * 2)) + bytes(2)) * HEIGHT
    info = little("IiiHHIIiiII", 56, WIDTH, -HEIGHT, 1, 16, 3, len(rows), 0, 0, 0, 0) + masks
    yield "masks", b"BM" + little("IHHI", 70 + len(rows), 0, 0, 70) + info + rows
    core = little("IHHHH", 12, WIDTH, HEIGHT, 1, 24)
    yield "core", b"BM" + little("IHHI", 26 + 48, 0, 0, 26) + core + bytes(samples(48))


def tga_files():
    palette = bytes(samples(12))
    for kind, bits, mapped in (1, 8, True), (2, 16, False), (2, 24, False), (2, 32, False), (3, 8, False), (3, 16, False):
        count = WIDTH * HEIGHT
        header = little("BBBHHBHHHHBB", 2, int(mapped), kind, 0, 4 if mapped else 0, 24 if mapped else 0, 0, 0, WIDTH,
                        HEIGHT, bits, 0x20)
        head = header + b"id" + (palette if mapped else b"")
        largest = 3 if mapped else 255
        yield f"kind{kind}-bits{bits}", head + bytes(samples(count * bits // 8, largest))
        pixel = bits // 8
        runs = bytes([0x80 | 9]) + bytes(samples(pixel, largest)) + bytes([4]) + bytes(samples(5 * pixel, largest))
        header = header[:2] + bytes([kind + 8]) + header[3:]
        yield f"runs-kind{kind}-bits{bits}", header + head[18:] + runs + bytes(8) + b"TRUEVISION-XFILE.\0"


def hdr_files():
    size = f"-Y {HEIGHT} +X {WIDTH}\n".encode()
    pixels = bytes(samples(WIDTH * HEIGHT * 4))
    yield "flat", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + pixels
    yield "exposure", b"#?RGBE\n# a\nEXPOSURE=2.0\nGAMMA=1\nPRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\nFORMAT=32-bit_rle_rgbe\n\n" + size + pixels
    yield "xyz", b"#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n" + size + pixels
    line = b"\2\2\0\x09" + b"\x89\x40" * 2 + b"\x04\1\2\3\4\x85\7" + b"\x89\x80"
    yield "runs", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 9\n" + line * 2
    yield "old-runs", b"#?RADIANCE\n\n+Y 1 +X 9\n" + b"\x20\x40\x60\x80" + b"\1\1\1\x08"
    yield "turned", b"#?RADIANCE\n\n+X 5 -Y 3\n" + pixels


def pfm_files():
    for kind, channels in (b"PF", 3), (b"Pf", 1), (b"PF4", 4):
        for scale, order in (b"-1.0", "<"), (b"2", ">"):
            pixels = struct.pack(f"{order}{WIDTH * HEIGHT * channels}f", *(i / 7 for i in range(WIDTH * HEIGHT * channels)))
            yield f"{kind.decode()}{order == '<'}", kind + b"\n5 3\n" + scale + b"\n" + pixels


def pnm_files():
    count = WIDTH * HEIGHT
    yield "p1", b"P1\n# a\n5 3\n" + b"1 0 1 1 0\n" * 3
    yield "p1-dense", b"P1 5 3 101101011010110"
    yield "p2", b"P2\n5 3 15\n" + " ".join(map(str, samples(count, 15))).encode()
    yield "p3", b"P3\n5 3\n255\n" + " ".join(map(str, samples(3 * count))).encode()
    yield "p4", b"P4\n5 3\n" + bytes(samples(3))
    yield "p5", b"P5\n5 3\n255\n" + bytes(samples(count))
    yield "p6", b"P6 5 3 255\n" + bytes(samples(3 * count))
    yield "p6-16", b"P6 5 3 65535\n" + bytes(samples(6 * count))
    yield "several", (b"P5\n1 1\n255\na" * 2)
    for kind, depth in (b"BLACKANDWHITE", 1), (b"GRAYSCALE_ALPHA", 2), (b"RGB", 3), (b"RGB_ALPHA", 4):
        largest = 1 if depth == 1 else 255
        yield f"p7-{depth}", (b"P7\nWIDTH 5\nHEIGHT 3\nDEPTH %d\nMAXVAL %d\nTUPLTYPE %s\nENDHDR\n" % (depth, largest, kind) +
                              bytes(samples(count * depth, largest)))


def exr_attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + little("i", len(value)) + value


def exr(names="BGR", pixel_type=1, compression=0, tiled=False, extra=b"", sampling=1):
    size = {0: 4, 1: 2, 2: 4}[pixel_type]
    channels = b"".join(name.encode() + b"\0" + little("iBxxxii", pixel_type, 0, sampling, sampling) for name in names) + b"\0"
    window = little("4i", 0, 0, WIDTH - 1, HEIGHT - 1)
    head = b"\x76\x2f\x31\x01" + little("I", 2 | (0x200 if tiled else 0))
    head += exr_attribute("channels", "chlist", channels) + exr_attribute("compression", "compression", bytes([compression]))
    head += exr_attribute("dataWindow", "box2i", window) + exr_attribute("displayWindow", "box2i", window)
    head += exr_attribute("lineOrder", "lineOrder", b"\0") + exr_attribute("pixelAspectRatio", "float", little("f", 1))
    head += exr_attribute("screenWindowCenter", "v2f", little("2f", 0, 0)) + exr_attribute("screenWindowWidth", "float", little("f", 1))
    if tiled:
        head += exr_attribute("tiles", "tiledesc", little("IIB", 8, 8, 0))
    head += extra + b"\0"
    values = {0: lambda i: little("I", i), 1: lambda i: little("e", i / 8), 2: lambda i: little("f", i / 8)}[pixel_type]
    row = b"".join(values(i) for i in range(WIDTH * len(names)))

    def code(data):
        if compression not in (2, 3):
            return data
        halves = data[::2] + data[1::2]
        delta = bytes([halves[0]]) + bytes((b - a + 128) & 255 for a, b in zip(halves, halves[1:]))
        short = zlib.compress(delta)
        return short if len(short) < len(data) else data
    if tiled:
        blocks = [little("4i", 0, 0, 0, 0) + little("i", len(code(row * HEIGHT))) + code(row * HEIGHT)]
    elif compression == 3:
        blocks = [little("ii", 0, len(code(row * HEIGHT))) + code(row * HEIGHT)]
    else:
        blocks = [little("ii", y, len(code(row))) + code(row) for y in range(HEIGHT)]
    table, at = b"", len(head) + 8 * len(blocks)
    for block in blocks:
        table += little("Q", at)
        at += len(block)
    assert len(row) == WIDTH * len(names) * size
    return head + table + b"".join(blocks)


def exr_files():
    for pixel_type in 0, 1, 2:
        for compression in 0, 2, 3:
            yield f"type{pixel_type}-compression{compression}", exr(pixel_type=pixel_type, compression=compression)
    yield "luminance", exr("Y")
    yield "alpha", exr("ABGR")
    yield "tiles", exr(tiled=True)
    yield "tiles-zip", exr(tiled=True, compression=3)
    yield "attributes", exr(extra=exr_attribute("rayscope:seed", "string", b"7") +
                            exr_attribute("chromaticities", "chromaticities", little("8f", .64, .33, .3, .6, .15, .06, .3127, .329)) +
                            exr_attribute("whiteLuminance", "float", little("f", 2)))


MAGICK = {
    "jpeg": [("grey", "-colorspace Gray"), ("plain", "-sampling-factor 1x1"), ("half", "-sampling-factor 2x2"),
             ("progressive", "-interlace JPEG"), ("cmyk", "-colorspace CMYK"), ("coarse", "-quality 3"),
             ("restart", "-define jpeg:restart-interval=1")],
    "exr": [(name.lower(), f"-compress {name}") for name in ("RLE", "Piz", "Pxr24", "B44", "B44A", "DWAA", "DWAB")],
}


def magick_files(target):
    if not shutil.which("convert"):
        return
    with tempfile.TemporaryDirectory() as folder:
        for name, options in MAGICK[target]:
            path = Path(folder) / f"{name}.{target}"
            done = subprocess.run(["convert", "-size", "9x5", "gradient:red-blue", *options.split(), path], check=False,
                                  capture_output=True)
            if done.returncode == 0 and path.exists():
                yield name, path.read_bytes()


OBJ = b"""mtllib a.mtl
o a
v 0 0 0
v 1 0 0 1 0 0
v 1 1 0 1
v 0 1 0
vt 0 0
vt 1 0 0
vt 1 1
vn 0 0 1
g b
s off
usemtl m
f 1/1/1 2/2/1 3/3/1 \\
 4
f -4 -3 -2
f 1//1 2//1 3//1 # a
"""


def obj_files():
    yield "all", OBJ
    yield "polygon", b"".join(b"v %d %d 0\n" % (i, i * i % 7) for i in range(12)) + b"f 1 2 3 4 5 6 7 8 9 10 11 12\n"
    yield "hole", b"v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nv 3 3 0\nv 6 3 0\nv 6 6 0\nf 1 2 3 4 1 5 7 6 5 1\n"
    yield "utf16", b"\xff\xfe" + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".encode("utf-16-le")
    yield "latin", b"v 0 0 0\rv 1 0 0\rv 0 1 0\rusemtl b\xe9ton\rf 1 2 3"
    yield "oddities", b"v nan 0 0\nv 1 inf 0\nv 0 1e39 -1.#IND\nvp 1\ncstype bezier\nl 1 2\np 1\nf 1 2 3\nend\nwhat 1\n"


def mtl_files():
    yield "all", (b"newmtl m\nKd 0.5 0.5 0.5\nKs 1\nKa 0 0 0\nNs 30\nd 0.5\nTr 0.5\nillum 7\nNi 1.5\n"
                  b"map_Kd -clamp on -s 1 2 3 \"a b.png\"\nbump -bm 2 b.png\n")
    yield "colors", b"newmtl a\nKd 1 0 0\nKs 0 1 0\nnewmtl b\nKd 0.25\nd 1\n"
    yield "maps", b"newmtl a\nmap_Kd a.png\nmap_Kd -o 1 1 1 b\\ c.png # d\nmap_d e.png\ndecal f\nnewmtl \"a b\"\nillum 11\n"
    yield "ends", b"\xef\xbb\xbfnewmtl a\r\nKd 1 1 \\\r\n 1\rTr 0.2\r\n"
    yield "odd", b"Kd 1\nnewmtl\nKd xyz 1 1 1\nnewmtl b\nKd spectral a.rfl\nd -halo 0,5\nNs nan\nTf 1 1\n"


def ply_files():
    head = b"ply\nformat %s 1.0\ncomment TextureFile t.png\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    faces = b"element face 2\nproperty list uchar int vertex_indices\nend_header\n"
    yield "ascii", (head % b"ascii" + b"property uchar red\nproperty uchar green\nproperty uchar blue\n" + faces +
                    b"0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0 7 8 9\n0 1 0 0 0 0\n3 0 1 2\n4 0 1 2 3\n")
    for name, order in (b"binary_little_endian", "<"), (b"binary_big_endian", ">"):
        body = b"".join(struct.pack(order + "3f", i % 2, i // 2, 0) for i in range(4))
        body += struct.pack(order + "B3iB4i", 3, 0, 1, 2, 4, 0, 1, 3, 2)
        yield name.decode(), head % name + faces + body
    yield "strips", (head % b"ascii" + b"property double s\nproperty double t\nproperty float nx\nproperty float ny\nproperty float nz\n"
                     b"element tristrips 1\nproperty list int int vertex_indices\nelement edge 1\nproperty int vertex1\nend_header\n" +
                     b"0 0 0 0 0 0 0 1\n1 0 0 1 0 0 0 1\n1 1 0 1 1 0 0 1\n0 1 0 0 1 0 0 1\n6 0 1 2 -1 1 2\n7\n")
    yield "corners", (head % b"ascii" + b"element face 1\nproperty list uchar int vertex_index\nproperty list uchar float texcoord\n"
                      b"property int texnumber\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 6 0 0 1 0 1 1 0\n")


def stl_files():
    facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
    yield "ascii", f"solid a\n{facet}{facet}endsolid a\nsolid b\n{facet}endsolid b\n".encode()
    triangle = little("12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0x8123)
    yield "binary", b"solid".ljust(80) + little("I", 2) + triangle * 2
    yield "binary-short", b"COLOR=abcd".ljust(80) + little("I", 5) + triangle
    yield "upper", f"SOLID\r\n{facet.upper()}".encode()
    yield "mac", f"solid\r{facet}endsolid".replace("\n", "\r").encode()


def gltf_document(buffer, extra=None):
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [{"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
                  {"camera": 0, "translation": [0, 0, 3], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1], "children": []},
                  {"extensions": {"KHR_lights_punctual": {"light": 0}}}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0, "mode": 4}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "metallicFactor": 0.5, "roughnessFactor": 0.5,
                                                "baseColorTexture": {"index": 0}}, "alphaMode": "MASK"}],
        "textures": [{"source": 0, "sampler": 0}], "samplers": [{"wrapS": 33071}],
        "images": [{"uri": "data:image/x;base64," + base64.b64encode(b"P5\n2 1\n255\nab").decode()}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5121, "normalized": True, "count": 3, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR",
                       "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 2}}}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12, "byteStride": 4},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 6}],
        "buffers": [buffer], "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "color": [1, 1, 1], "intensity": 9}]}},
    }
    return json.dumps(document | (extra or {}), separators=(",", ":")).encode()


def gltf_files():
    data = little("9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + bytes(12) + little("3H", 0, 1, 2)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    yield "embedded", gltf_document({"byteLength": len(data), "uri": uri})
    text = gltf_document({"byteLength": len(data)})
    text += b" " * (-len(text) % 4)
    padded = data + bytes(-len(data) % 4)
    chunks = little("I", len(text)) + b"JSON" + text + little("I", len(padded)) + b"BIN\0" + padded
    yield "binary", b"glTF" + little("II", 2, 12 + len(chunks)) + chunks
    yield "skin", gltf_document({"byteLength": len(data), "uri": uri}, {
        "skins": [{"joints": [1, 2]}], "animations": [{"channels": [], "samplers": []}],
        "meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0}, "mode": 5, "targets": [{"POSITION": 0}]}]}]})
    yield "least", b'{"asset":{"version":"2.0"}}'
    yield "old", b'{"asset":{"version":"1.0"}}'


SCENE = b"""version = 1
title = "a"
[[camera]]
name = "c"
look_from = [0, 1.5, -4]
fov = 40
lens = { f_number = 2.8, focal_length = 0.05, focus_distance = 3 }
[[mesh]]
file = "m.obj"
transform = { scale = 2, rotate = [-90, 0, 0], translate = [0, 1, 0] }
vertex_colors = true
motion = [0.1, 0, 0]
[[mesh]]
generate = { shape = "box", size = [1, 1, 1], inward = true }
material = "b c"
[[sphere]]
center = [0, 0.5, 0]
radius = 0.5
material = "a"
[material.a]
kd = { srgb = [0.5, 0.4, 0.1] }
ks = [0.3, 0.3, 0.2]
shininess = 40
opacity = 0.5
illum = 5
kd_texture = { file = "t.pgm", wrap = "clamp" }
[material."b c"]
kd_texture = { generate = "texels", size = [2, 1], colors = [[0, 0, 0], [1, 1, 1]] }
[[light]]
type = "parallelogram"
corner = [0, 0, 0]
edges = [[1, 0, 0], [0, 1, 0]]
falloff = "inverse_square"
[[light]]
type = "segment"
endpoints = [[0, 0, 0], [1, 0, 0]]
[environment]
equirect = "t.pgm"
[settings]
spp = 4
sampler = "jittered"
"""


def scene_files():
    yield "all", SCENE
    yield "cube", b'version=1\n[environment]\ncube={px="t.pgm",nx="t.pgm",py="t.pgm",ny="t.pgm",pz="t.pgm",nz="t.pgm"}\n'
    for path in sorted((SOURCE / "scenes").glob("*.toml")):
        if path.stat().st_size < 1500 and "million" not in path.name:
            yield path.stem, path.read_bytes()


def settings_files():
    for text in "spp=4", "glossy=true", "exposure=-1.5", "sampler=sobol", "bvh_builder=sah", "isa=avx2", "bloom_sigma=0.5", "a=b":
        yield text.replace("=", "-"), text.encode()


def options_files():
    for i, words in enumerate((
            "render builtin:cornell -o a.png --size 64x64 --spp 4 --seed 7 -t 2 --fov 50 --look-from 1,2,3 --up 0,1,0",
            "render a.toml -oa.exr --set spp=4 -D glossy=true --time-limit 2.5 --aov depth,normal --pixelbounds 0,1,2,3 -q",
            "render a.obj --target-error 0.01 --confidence 0.9 --metric rmse --output=b.png --preset final",
            "probe a.toml --pixel 1,2 --sample 3 --traversal s0 --layout wide --explain --json j.json",
            "compare a.png b.png --fail-above 0.5 --exposure 1 --range 0.5 --pixels-per-degree 67 --tile 16",
            "trade a.toml --budget 5 -o t --no-cache --json", "cast a.toml --rays r --output h --any", "lab --quick --rays 10",
            "bench builtin:teapot --size 64 --rounds 5", "info --list --json", "-- -x.obj", "--help", "a.toml")):
        yield f"line{i}", words.replace(" ", "\n").encode()


def rays_files():
    ray = little("8f", 1.25, 1.25, 5, 0, 0, -1, 0, float("inf"))
    yield "one", ray
    yield "edges", b"".join(little("8f", x, y, -5, 0, 0, 1, 0, 100) for x in (0, 1, 2) for y in (0, 1, 2))
    yield "odd", little("8f", float("nan"), 0, 0, 0, 0, 0, -1, 0) + little("8f", 0, 0, 0, 1e38, 1e-38, 1, 0, float("inf"))
    yield "inside", little("8f", 2, 2, 0.5, 0.1, 0.2, 0.3, 0.25, 1)
    yield "short", ray[:31]
    yield "empty", b""


def films_files():
    def tile(samples, *pixel):  # the sums of red, green, blue and of squared luminance
        return little("i", samples) + little("4d", *pixel) * 12

    rendered, unrendered = tile(2, 1, 2, 3, 9), tile(0, 0, 0, 0, 0)
    yield "tiles", rendered * 2
    yield "empty_tiles", unrendered * 2
    yield "one_film", rendered + unrendered
    yield "no_samples", tile(0, 1, 2, 3, 9) * 2
    yield "impossible", tile(2, 1, 2, 3, 1) * 2
    yield "negative", tile(-1, 1, 2, 3, 9) + unrendered
    yield "not_finite", rendered + tile(2, float("inf"), 2, 3, float("nan"))
    yield "file", b"rayscope films 2 hash 4 3 Rayscope\n" + rendered * 2 + bytes(8)
    yield "short", rendered + unrendered[:100]
    yield "empty", b""


def recent_files():
    yield "list", b"/a/b.toml\nbuiltin:cornell\n\n/c d.obj\n"
    yield "many", b"".join(b"/%d\n" % i for i in range(14))
    yield "open", b"/a"
    yield "latin", b"/b\xe9.obj\r\n\0\n"
    yield "empty", b""


def text_files():
    yield "plain", b"a.toml"
    yield "controls", b"a\nf.toml:1:1: error: \x1b[2J\x07\x7f\r\t\0b"
    yield "unicode", "é…\u202e\u2066\ufeff\U0001f600\x9b".encode()
    yield "latin", b"caf\xe9 \xc3\x28 \xf0\x9f \xed\xa0\x80 \xc0\xaf"
    yield "shell", b"-a 'b' $(c) `d` \\ \"e\" !f"


TARGETS = {
    "png": png_files, "bmp": bmp_files, "tga": tga_files, "hdr": hdr_files, "pfm": pfm_files, "pnm": pnm_files,
    "exr": lambda: (*exr_files(), *magick_files("exr")), "jpeg": lambda: magick_files("jpeg"),
    "obj": obj_files, "mtl": mtl_files, "ply": ply_files, "stl": stl_files, "gltf": gltf_files, "scene": scene_files,
    "settings": settings_files, "options": options_files, "rays": rays_files, "films": films_files,
    "recent": recent_files, "text": text_files,
}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for target, files in TARGETS.items():
        folder = Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in files():
            (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
