"""Outputs, surroundings and command lines: what cannot be written, what is missing on the machine, what nobody can have meant."""
# SPDX-License-Identifier: MIT
import os
from pathlib import Path

from references import HOLES, cut_dot, dot
from row import BOX, FACE, LIGHT, Row, scene

SCENE = {"s.json": scene()}
SMALL_BALL = scene(objects=f'"objects": [{BOX}, {{"shape": "sphere", "radius": 1e-9, "segments": 96, "translate": [0, 2, 0]}}]')
BOX_OVER_FLOOR = scene(objects=f'"objects": [{BOX}, {{"shape": "quad", "size": [9, 9], "translate": [0, -2, 0]}}]')
DECK = '{"title": "T", "scene": "s.json", "slides": [{"name": "a", "title": "A", "slots": [{"technique": "unshadowed"}], "caption": "c", "alt": "x"}]}'


def lesson(name):
    return (Path(__file__).resolve().parents[2] / "assets" / "lessons" / f"{name}.json").read_text(encoding="utf-8")


def capture_to(output, *more):
    return ["capture", "s.json", "-o", output, "--size", "32x24", *more]


def refused(title, words, status, *says, files=None, **further):
    return Row(title, {**SCENE, **(files or {})}, words, status, list(says), **further)


def drawn(title, writes, words, *says, files=None, **further):
    return Row(title, {**SCENE, **(files or {})}, words, 0, list(says), writes, **further)


def link_to(target):
    return lambda path: path.symlink_to(target)


OUTPUTS = [
    refused("a folder for a picture", capture_to("d.png"), 4, "d.png", files={"d.png/inner": ""}),
    refused("a folder that is not there", capture_to("gone/x.png"), 4, "gone"),
    refused("a file for a folder", capture_to("s.json/x.png"), 4, "s.json"),
    refused("a name of 300 letters", capture_to("n" * 300 + ".png"), 4, "too long"),
    refused("a pipe that nobody reads", capture_to("p.png"), 4, "p.png", "nobody reads the pipe", files={"p.png": os.mkfifo}),
    refused("a device that is full", capture_to("full.png"), 4, "full.png", files={"full.png": link_to("/dev/full")}),
    refused("a folder of the kernel's", capture_to("/proc/x.png"), 4, "/proc/x.png"),
    refused("the scene for its picture", ["capture", "l.png", "-o", "l.png"], 2, "l.png", files={"l.png": link_to("s.json")}),
    refused("a picture of no size", ["capture", "s.json", "-o", "x.png", "--size", "0x0"], 2, "'0x0'"),
    refused("a picture beyond the limit", ["capture", "s.json", "-o", "x.png", "--size", "20000x20"], 6, "16384"),
    refused("a map of a size that no card has", capture_to("x.png", "-t", "shadow-map", "--set", "shadow-map.resolution=100000"), 2, "100000"),
    refused("samples of none", capture_to("x.png", "-t", "ray-traced", "--set", "ray-traced.samples=-1"), 2, "-1"),
    refused("nothing at all to do", ["capture"], 2, "SCENE"),
    refused("an option nobody knows", capture_to("x.png", "--siez", "8x8"), 2, '"--size"'),
    refused("an option of 100,000 letters", capture_to("x.png", "--" + "o" * 100000), 2, "--help"),
    refused("a value of 100,000 letters", ["capture", "s.json", "-o", "x.png", "--size", "8" * 100000], 2, "--size"),
    refused("an option without its value", ["capture", "s.json", "-o", "x.png", "--size"], 2, "--size"),
    refused("bytes that are no UTF-8", capture_to("x.png", "-t", "\udcff\udcfe"), 2, "\\xff"),
    refused("an escape sequence in an option", capture_to("x.png", "--\x1b[31m"), 2, "\\x1b"),
    refused("an unknown built-in scene", ["capture", "still-lief", "-o", "x.png"], 3, "still-life"),
    refused("a file called -x without --", ["capture", "-x", "-o", "x.png"], 2, "-x"),
    drawn("a file called -x behind --", ["x.png"], ["capture", "-o", "x.png", "--size", "32x24", "--", "-x.json"], files={"-x.json": scene()}),
    drawn("an output that exists", ["x.png"], capture_to("x.png"), files={"x.png": "an old picture"}),
    drawn("an output through a link", ["target.png"], capture_to("x.png"), files={"x.png": link_to("target.png"), "target.png": "an old picture"}),
    drawn("no home", ["x.png"], capture_to("x.png"), environment={"HOME": ""}),
    drawn("a home that is not there", ["x.png"], capture_to("x.png"), environment={"HOME": "/nowhere", "XDG_CONFIG_HOME": "/nowhere"}),
    drawn("a locale that is not there", ["x.png"], capture_to("x.png"), environment={"LC_ALL": "xx_YY.UTF-8", "LANG": "xx_YY.UTF-8"}),
    drawn("no temporary folder", ["x.png"], capture_to("x.png"), environment={"TMPDIR": "/nowhere"}),
    refused("a card of OpenGL 2.1", capture_to("x.png", "--backend", "osmesa"), 5, "2.1",
            environment={"MESA_GL_VERSION_OVERRIDE": "2.1", "MESA_GLSL_VERSION_OVERRIDE": "120"}),
    refused("a card of OpenGL 3.2", capture_to("x.png", "--backend", "egl"), 5, "3.2",
            environment={"MESA_GL_VERSION_OVERRIDE": "3.2", "MESA_GLSL_VERSION_OVERRIDE": "150"}),
    refused("a driver that OSMesa does not have", capture_to("x.png", "--backend", "osmesa"), 5, "GALLIUM_DRIVER", "unset",
            environment={"GALLIUM_DRIVER": "zink"}),
    refused("shaders of another time alone", capture_to("x.png", "--backend", "osmesa"), 5, "MESA_GLSL_VERSION_OVERRIDE", "unset",
            environment={"MESA_GLSL_VERSION_OVERRIDE": "120"}),
    *[refused(f"a setting of Mesa's developers: {name}={value}", capture_to("x.png", *backend), 5, name, "unset", environment={name: value})
      for name, value, *backend in (("GALLIUM_NOOP", "1"), ("LP_PERF", "no_depth"), ("ST_DEBUG", "wf"), ("LP_NATIVE_VECTOR_WIDTH", "7"),
                                    ("MESA_EXTENSION_OVERRIDE", "-GL_ARB_texture_float"), ("DRAW_USE_LLVM", "0", "--backend", "osmesa"))],
    drawn("a width of vectors that Mesa has code for", ["x.png"], capture_to("x.png"), environment={"LP_NATIVE_VECTOR_WIDTH": "128"}),
    refused("a window without a display", capture_to("x.png", "--backend", "window"), 5, "display"),
    refused("a display that is not there", capture_to("x.png", "--backend", "window"), 5, "display", environment={"DISPLAY": ":8888"}),
    refused("shaders that are broken", capture_to("x.png", "-t", "unshadowed"), 3, "shade_light.frag", files={"shaders/light.glsl": "float ;\n"},
            environment={"SHADOWLAB_SHADERS": "shaders"}),
    refused("a pipe for a shader", capture_to("x.png", "-t", "unshadowed"), 3, "light.glsl", files={"shaders/light.glsl": os.mkfifo},
            environment={"SHADOWLAB_SHADERS": "shaders"}),
    drawn("a folder of shaders that is not there", ["x.png"], capture_to("x.png"), environment={"SHADOWLAB_SHADERS": "nowhere"}),
    refused("a scene that is also the picture's folder", capture_to("s.json/"), 2, "s.json"),
    refused("a slide that the deck does not have", ["demo", "--deck", "shadows", "--slide", "volums"], 2, "--slide", '"volumes"'),
    refused("a lesson beside a scene that is not there", ["demo", "gone.json", "--lesson", "acne"], 3, "gone.json"),
    Row("an image of the scene for its picture", {"s.json": HOLES, "a.png": dot()}, capture_to("a.png"), 2, ["a.png", "another name"]),
    Row("a scene for the numbers of a report", {"report.json": scene()},
        ["report", "report.json", "--quick", "--size", "64x48", "-t", "unshadowed", "-o", "."], 4, ["report.json", "overwritten"]),
    refused("the picture for its numbers, through a link", capture_to("x.png", "--stats", "n.json"), 2, "--stats", files={"x.png": link_to("n.json")}),
    refused("a deck for one of its slides, through a link", ["slides", "d.json", "-o", ".", "--size", "640x360"], 2, "d-01-a.png", "that is read",
            files={"d.json": DECK, "d-01-a.png": link_to("d.json")}),
    refused("a lesson for its picture, through a link", ["lesson", "l.json", "-o", "l.png", "--size", "320x180"], 2, "l.png", "that is read",
            files={"l.json": lesson("acne"), "l.png": link_to("l.json")}),
    refused("materials for their picture, through a link", ["capture", "m.obj", "-o", "m.png", "--size", "32x24"], 2, "m.png", "that is read",
            files={"m.obj": "mtllib m.mtl\n" + FACE + "f 1 2 3\n", "m.mtl": "newmtl m\n", "m.png": link_to("m.mtl")}),
    refused("a mask that cannot be read, for its picture", ["capture", "m.obj", "-o", "a.png", "--size", "32x24"], 2, "a.png", "that is read",
            files={"m.obj": "mtllib m.mtl\n" + FACE + "usemtl m\nf 1 2 3\n", "m.mtl": "newmtl m\nmap_d a.png\n", "a.png": cut_dot()}),
    Row("a mask for a later picture", {"s.json": HOLES.replace("a.png", "f_3.png"), "f_3.png": dot()},
        ["capture", "s.json", "-o", "f_#.png", "--frames", "3", "--size", "32x24"], 2, ["f_3.png", "that is read"]),
    refused("a plug-in whose name means something else to the loader", capture_to("x.png", "--plugin", "$ORIGIN.so"), 3, "rename",
            files={"$ORIGIN.so": "no library"}),
    refused("half a surrogate pair in a name", ["capture", "\udced\udca0\udc80.obj", "-o", "x.png"], 3, "\\xed\\xa0\\x80"),
    refused("measuring without a light", ["measure", "d.json", "--size", "64x48"], 3, "d.json: has no light", files={"d.json": scene(lights="")}),
    refused("a plug-in for a picture, through a link", capture_to("x.png", "--plugin", "p.so"), 3, "p.so", "no shared library",
            files={"p.so": "no library", "x.png": link_to("p.so")}),
    refused("a plug-in that cannot be read to its end", capture_to("x.png", "--plugin", "/proc/self/mem"), 3, "/proc/self/mem"),
    refused("a later picture for the numbers, through a link", capture_to("x_#.png", "--frames", "3", "--stats", "n.json"), 2, "--stats", "x_2.png",
            files={"n.json": link_to("x_2.png")}),
    drawn("a picture through two links to where nothing is", ["c.png"], capture_to("a.png"), files={"a.png": link_to("b.png"), "b.png": link_to("c.png")}),
    refused("a limit nobody knows", capture_to("x.png", "--limit", "trianlges=3"), 2, '"triangles"'),
    refused("a limit without its value", capture_to("x.png", "--limit", "triangles"), 2, "--limit triangles=20000000"),
    refused("a limit of nothing", capture_to("x.png", "--limit", "triangles=0"), 2, "from 1 to 1000000000"),
    refused("a limit beyond what can be", capture_to("x.png", "--limit", "json-depth=100000"), 2, "from 1 to 1000"),
    refused("more pictures than the limit", capture_to("x_##.png", "--frames", "12", "--limit", "frames=11"), 6, "11", "--limit frames"),
    refused("a lower limit of pictures' sides", ["measure", "s.json", "--size", "64x48", "--limit", "measured-side=50"], 6, "50", "--limit measured-side"),
    refused("a limit in words", capture_to("x.png", "--limit", "triangles=many"), 2, '"many"'),
    refused("a limit that is lower", capture_to("x.png", "--limit", "triangles=11"), 6, "s.json:1:", "12 triangles", "--limit triangles"),
    refused("a lower limit of levels", capture_to("x.png", "--limit=json-depth=3"), 6, "s.json:1:", "--limit json-depth"),
    refused("a lower limit of a file", capture_to("x.png", "--limit", "scene-file=50"), 6, "s.json:", "--limit"),
    refused("a picture beyond memory", ["capture", "s.json", "-o", "x.png", "--size", "900x900", "--limit", "memory=170000000"], 6, "--size 900x900", "MB of memory", "--limit memory"),
    refused("a measurement beyond memory", ["measure", "s.json", "--limit", "memory=170000000", "--size", "400x400"], 6, "--size 400x400", "--limit memory"),
    refused("a scene beyond memory", ["inspect", "s.json", "--limit", "memory=160001000"], 6, "s.json:1:", "12 triangles", "--limit memory"),
    refused("patches beyond memory", capture_to("x.png", "-t", "radiosity", "--limit", "memory=161000000"), 6, '"s" makes', "patches", "--limit memory", files={"s.json": BOX_OVER_FLOOR}),
    refused("no memory at all", capture_to("x.png", "--limit", "memory=0"), 2, "from 1 to 1000000000000000"),
    drawn("radiosity of a ball that nobody can see", ["x.png"], capture_to("x.png", "-t", "radiosity"), files={"s.json": SMALL_BALL}),
    drawn("a limit that is higher", ["x.png"], capture_to("x.png", "--limit", "lights=100"),
          files={"s.json": scene(lights='"lights": [' + ", ".join([LIGHT] * 70) + "]")}),
    refused("a report into a file", ["report", "s.json", "-t", "unshadowed", "--quick", "--size", "32x24", "-o", "s.json"], 4, "s.json"),
    refused("slides into a file", ["slides", "-o", "s.json"], 4, "s.json"),
    refused("a scene packed into a folder that is there", ["pack", "s.json", "-o", "here"], 4, "here", files={"here/inner": ""}),
    refused("a scene exported into a folder that is there", ["export", "s.json", "-o", "here", "--to", "gltf"], 4, "here", files={"here/inner": ""}),
    refused("exercises in a folder that is there", ["exercise", "-o", "here"], 4, "here", files={"here/inner": ""}),
    refused("a key of exercises where there is no folder", ["exercise", "-o", "sheet", "--key", "gone/key.html"], 4, "gone"),
    refused("a folder for the key of exercises", ["exercise", "-o", "sheet", "--key", "key.html"], 4, "key.html", files={"key.html/inner": ""}),
    refused("a judged picture into a file", ["judge", "seen.png", "s.json", "-o", "s.json"], 4, "s.json", files={"seen.png": dot()}),
    refused("a picture to be judged, for its errors, through a link", ["judge", "seen.png", "s.json", "-o", "."], 2, "errors.png", "that is read",
            files={"seen.png": dot(), "errors.png": link_to("seen.png")}),
    refused("a score sheet for its plug-in, through a link", ["grade", "--plugin", "p.so", "--sheet", "html:x.html"], 3, "p.so", "no shared library",
            files={"p.so": "no library", "x.html": link_to("p.so")}),
    refused("a new technique in a folder that is there", ["new-technique", "here"], 4, "here", files={"here/inner": ""}),
]
