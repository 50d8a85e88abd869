"""What a scene, a mesh, a lesson, a deck or a command names: files that are elsewhere, are no files, or hold something else."""
# SPDX-License-Identifier: MIT
import os
import socket
import struct
import zlib

from row import FACE, Row, captured, drawn_mesh, drawn_scene, refused_scene, scene

MESH = FACE + "f 1 2 3\n"
MATERIAL = "newmtl a\nKd 1 0 0\n"


def with_mesh(name):
    return scene(objects=f'\n"objects": [{{"name": "o", "mesh": {name}}}]')


HOLES = scene(objects='"objects": [{"shape": "box", "size": [1, 1, 1], "material": "a"}]', more='\n"materials": {"a": {"alphaMap": "a.png"}}')


def dot():
    """A PNG of one pixel."""
    return picture_of(1)


def cut_dot():
    """The same, damaged."""
    return dot()[:40]


def picture_of(side, height=None, interlaced=0):
    """A PNG that says it has so many pixels on a side, and has one."""
    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    size = struct.pack(">IIBBBBB", side, height or side, 8, 6, 0, 0, interlaced)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(b"IDAT", zlib.compress(bytes(5))) + chunk(b"IEND", b"")


def link_to(target):
    return lambda path: path.symlink_to(target)


def a_socket(path):
    with socket.socket(socket.AF_UNIX) as end:
        end.bind(str(path))


def refused_material(title, named, *says, files=None):
    return Row(title, {"m.obj": f"mtllib {named}\n" + MESH, **(files or {})}, captured("m.obj"), 3, ["m.obj:1:", *says])


def file_of(command, text, *says, title, files=None, status=3):
    return Row(title, {"f.json": text, **(files or {})}, command, status, ["f.json", *says])


LESSON = ["lesson", "f.json", "-o", "x.png"]
DECK = ["slides", "f.json", "-o", "out"]

REFERENCES = [
    refused_scene("a mesh above the scene's folder", with_mesh('"../m.obj"'), "s.json:2:", "--allow"),
    refused_scene("a mesh by an absolute path", with_mesh('"/etc/passwd"'), "s.json:2:", "--allow"),
    refused_scene("a mesh out and in again", with_mesh('"../../../../../../../../etc/hostname"'), "s.json:2:", "--allow"),
    refused_scene("a mesh through a link that leaves the folder", with_mesh('"l.obj"'), "s.json:2:", "--allow", files={"l.obj": link_to("/etc/passwd")}),
    refused_scene("a mesh through a linked folder", with_mesh('"l/hostname"'), "s.json:2:", "--allow", files={"l": link_to("/etc")}),
    refused_scene("a mesh through a link to itself", with_mesh('"l.obj"'), "s.json:2:", files={"l.obj": link_to("l.obj")}),
    refused_scene("a mesh that is not there", with_mesh('"gone.obj"'), "s.json:2:", "gone.obj"),
    refused_scene("a mesh without a name", with_mesh('""'), "s.json:2:"),
    refused_scene("a mesh that is a dot", with_mesh('"."'), "s.json:2:"),
    refused_scene("a mesh that is a folder", with_mesh('"d.obj"'), "folder", files={"d.obj/inner": ""}),
    refused_scene("a mesh that is a pipe", with_mesh('"p.obj"'), "p.obj", files={"p.obj": os.mkfifo}),
    refused_scene("a mesh that is a socket", with_mesh('"p.obj"'), "p.obj", files={"p.obj": a_socket}),
    refused_scene("a mesh that is a device", with_mesh('"z.obj"'), "s.json:2:", files={"z.obj": link_to("/dev/zero")}),
    refused_scene("a mesh that is a terminal", with_mesh('"z.obj"'), "s.json:2:", files={"z.obj": link_to("/dev/tty")}),
    refused_scene("a mesh of the kernel's", with_mesh('"z.obj"'), "s.json:2:", files={"z.obj": link_to("/proc/self/environ")}),
    refused_scene("a mesh that is the scene", with_mesh('"s.json"'), "is not an OBJ file"),
    Row("a mesh of another kind", {"s.json": with_mesh('"m.stl"'), "m.stl": "solid"}, captured("s.json"), 3, ["m.stl:1:", "is not an OBJ file"]),
    refused_scene("a mesh with a zero byte in its name", with_mesh('"m.obj\\u0000.txt"'), "s.json:2:", files={"m.obj": MESH}),
    refused_scene("a mesh with a name of 5,000 letters", with_mesh('"' + "n" * 5000 + '.obj"'), "s.json:2:"),
    refused_scene("a mesh with a line break in its name", with_mesh('"a\\nb\\u001b[31m.obj"'), "s.json:2:"),
    Row("a mesh that is broken", {"s.json": with_mesh('"m.obj"'), "m.obj": FACE + "f 1 2 9\n"}, captured("s.json"), 3,
        ["m.obj:4:", "9"]),
    drawn_scene("a mesh by a path of Windows", with_mesh('"C:\\\\models\\\\Below\\\\m.obj"'), "s.json:2:", "below/m.obj", files={"below/m.obj": MESH}),
    refused_scene("a mesh above the folder, by a path of Windows", with_mesh('"..\\\\..\\\\etc\\\\passwd"'), "s.json:2:"),
    drawn_scene("a mesh in a folder below", with_mesh('"below/m.obj"'), files={"below/m.obj": MESH}),
    drawn_scene("a mesh through a link within the folder", with_mesh('"l.obj"'), files={"l.obj": link_to("m.obj"), "m.obj": MESH}),
    drawn_scene("a mesh with blanks, colons and letters in its name", with_mesh('"a b:c;d \u5f71.obj"'), files={"a b:c;d \u5f71.obj": MESH}),
    refused_scene("a mesh that is a link to itself", with_mesh('"l.obj"'), "s.json:2:", "symbolic links", files={"l.obj": link_to("l.obj")}),
    refused_scene("a mesh whose name turns the text round", with_mesh('"a\u202eb\u009b31m.obj"'), "s.json:2:", "a\\xe2\\x80\\xaeb\\xc2\\x9b31m.obj"),
    refused_scene("an alpha map that is no picture", HOLES, "s.json:2:", "neither PNG nor JPEG", files={"a.png": "no picture"}),
    refused_scene("an alpha map that breaks off", HOLES, "s.json:2:", "not a readable PNG", files={"a.png": picture_of(4)[:60]}),
    refused_scene("an alpha map beyond the limit", HOLES, "s.json:2:", "65535", "--limit image-side", status=6, files={"a.png": picture_of(65535)}),
    refused_scene("an alpha map of two thousand million pixels in a row", HOLES, "s.json:2:", "2147483647 x 4", "--limit image-side", status=6, files={"a.png": picture_of(2**31 - 1, 4)}),
    refused_scene("an alpha map of as many, interlaced", HOLES, "s.json:2:", "2147483647 x 4", "--limit image-side", status=6, files={"a.png": picture_of(2**31 - 1, 4, interlaced=1)}),
    Row("an alpha map beyond memory", {"s.json": HOLES, "a.png": picture_of(16384)}, captured("s.json", "--limit", "memory=1000000000"), 6,
        ["s.json:2:", "16384 x 16384 pixels", "MB of memory", "--limit memory"]),
    refused_material("materials above the mesh's folder", "../m.mtl", "--allow"),
    refused_material("materials above the mesh's folder, in capitals", "../ETC/PASSWD", "--allow"),
    refused_material("materials by an absolute path", "/etc/passwd", "--allow"),
    refused_material("materials through a link that leaves", "l.mtl", "--allow", files={"l.mtl": link_to("/etc/passwd")}),
    Row("materials that are a pipe", {"m.obj": "mtllib p.mtl\n" + MESH, "p.mtl": os.mkfifo}, captured("m.obj"), 3, ["p.mtl", "not a regular file"]),
    refused_material("materials that are a device", "z.mtl", files={"z.mtl": link_to("/dev/zero")}),
    refused_material("materials that are a folder", "d.mtl", "folder", files={"d.mtl/inner": ""}),
    drawn_mesh("materials with a colon in their folder", "mtllib a:b/c d.mtl\nusemtl a\n" + MESH, files={"a:b/c d.mtl": MATERIAL}),
    drawn_mesh("two material files", "mtllib a.mtl b.mtl\nusemtl a\n" + MESH, files={"a.mtl": MATERIAL, "b.mtl": MATERIAL.replace("newmtl a", "newmtl b")}),
    file_of(LESSON, "", "f.json:1:1", title="an empty lesson"),
    file_of(LESSON, "[1]", "f.json:1:", title="a lesson that is a list"),
    file_of(LESSON, '{\n"lesson": 1}', "f.json:2:", title="a lesson with an unknown key"),
    file_of(LESSON, "[" * 100000, title="a lesson of brackets", status=6),
    file_of(DECK, "", "f.json:1:1", title="an empty deck"),
    file_of(DECK, '{"deck": "a"', "f.json:1:", title="a deck that breaks off"),
    file_of(DECK, '{\n"slidse": []}', "f.json:2:", title="a deck with an unknown key"),
    file_of(DECK, "[" * 100000, title="a deck of brackets", status=6),
    file_of(DECK, '{"title": "t", "slides": [' + ",".join(f'{{"name": "s{i}"}}' for i in range(20000)) + "]}", "300 slides", title="a deck of 20,000 slides"),
    file_of(DECK, '{"title": "t", "slides": [\n{"name": "a", "title": "t", "scene": "gone.json", "slots": [{"technique": "shadow-map"}]}]}', "f.json:2:", '"gone.json"', "No such file",
            title="a slide of a scene that is not there"),
    file_of(DECK, '{"title": "t", "slides": [\n{"name": "a", "title": "t", "scene": "p.json", "slots": [{"technique": "shadow-map"}]}]}', "f.json:2:", '"p.json"', "regular file",
            title="a slide of a scene that is a pipe", files={"p.json": os.mkfifo}),
    Row("a lesson that is a pipe", {"f.json": os.mkfifo}, LESSON, 3, ["f.json"]),
    Row("a deck that is a folder", {"f.json/inner": ""}, DECK, 3, ["f.json"]),
    Row("a plug-in that is not there", {}, ["list", "techniques", "--plugin", "./gone.so"], 3, ["gone.so"]),
    Row("a plug-in that is a text", {"p.so": "no library"}, ["list", "techniques", "--plugin", "./p.so"], 3, ["p.so"]),
    Row("a plug-in that is a folder", {"p.so/inner": ""}, ["list", "techniques", "--plugin", "./p.so"], 3, ["p.so"]),
    Row("a plug-in that is a pipe", {"p.so": os.mkfifo}, ["list", "techniques", "--plugin", "./p.so"], 3, ["p.so"]),
    Row("a plug-in that breaks off", {"p.so": b"\x7fELF\2\1\1" + bytes(40)}, ["list", "techniques", "--plugin", "./p.so"], 3, ["p.so"]),
    Row("a library that is no plug-in", {"p.so": link_to("/lib/x86_64-linux-gnu/libm.so.6")}, ["list", "techniques", "--plugin", "./p.so"], 3,
        ["p.so"]),
    Row("a path of frames with an unknown key", {"s.json": scene(), "p.json": '[{"frame": 1,\n"camrea": 1}]'},
        captured("s.json", "--path", "p.json", "--frames", "1"), 3, ["p.json:2:", "camera"]),
]
