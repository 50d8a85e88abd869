"""Scenes: syntax, keys, types and domains."""
# SPDX-License-Identifier: MIT
import os

from row import BOX, LIGHT, Row, captured, drawn_scene, refused_scene, scene


def camera(**keys):
    values = {"position": "[3, 2, 5]", "target": "[0, 0.5, 0]", **keys}
    return '"camera": {' + ", ".join(f'"{key}": {value}' for key, value in values.items()) + "}"


def light(text):
    return f'"lights": [{text}]'


def objects(text):
    return f'"objects": [{text}]'


SCENES = [
    *[drawn_scene(f"an exposure that pictures cannot hold, {exposure}", scene(more=f'\n"exposure": {exposure}'), "s.json:2:13: ", "half floats")
      for exposure in ("1e-8", "1e6")],
    refused_scene("an empty scene", "", "s.json:1:1"),
    refused_scene("a scene of blanks", "  \n\t ", "s.json:"),
    refused_scene("a list for a scene", "[]", "s.json:1:"),
    refused_scene("a number for a scene", "42", "s.json:1:"),
    refused_scene("a comma too many", scene().replace("\"lights\"", "\n,\"lights\""), "s.json:2:"),
    refused_scene("a comma too few", scene().replace(", \"lights\"", "\n\"lights\""), "s.json:2:"),
    refused_scene("a comma at the end", scene()[:-1] + ",\n}", "s.json:2:"),
    refused_scene("a scene that breaks off", scene()[:-20]),
    refused_scene("two scenes in one file", scene() + "\n" + scene(), "s.json:2:"),
    refused_scene("a comment that never ends", "/* the scene\n" + scene()),
    refused_scene("a key twice", scene(more='"ambient": [0, 0, 0],\n"ambient": [1, 1, 1]'), "s.json:2:", "ambient"),
    refused_scene("an unknown key", scene(camera="\n" + camera(postion="[1, 2, 3]")), "s.json:2:", 'did you mean "position"'),
    refused_scene("a key in capitals", scene(camera="\n" + camera(Target="[1, 2, 3]")), "s.json:2:"),
    refused_scene("an empty key", scene(more='\n"": 1'), "s.json:2:"),
    refused_scene("a version", scene(more='\n"version": 3'), "s.json:2:", "version"),
    refused_scene("a key of 100,000 letters", scene(more='\n"' + "k" * 100000 + '": 1'), "s.json:2:"),
    refused_scene("a key with an escape sequence in it", scene(more='\n"\\u001b[31m": 1'), "s.json:2:"),
    refused_scene("a number in quotes", scene(camera="\n" + camera(fovYDegrees='"45"')), "s.json:2:", "fovYDegrees"),
    refused_scene("null for a number", scene(camera="\n" + camera(near="null")), "s.json:2:", "near"),
    refused_scene("a number for a list", scene(more='\n"ambient": 1'), "s.json:2:", "ambient"),
    refused_scene("a list for a number", scene(camera="\n" + camera(near="[1]")), "s.json:2:", "near"),
    refused_scene("an object for a list", scene(objects='\n"objects": {}'), "s.json:2:", "objects"),
    refused_scene("two numbers for a place", scene(camera="\n" + camera(position="[1, 2]")), "s.json:2:", "position"),
    refused_scene("four numbers for a place", scene(camera="\n" + camera(position="[1, 2, 3, 4]")), "s.json:2:", "position"),
    refused_scene("no camera", scene(camera=""), "camera"),
    refused_scene("a camera without a place", scene(camera='\n"camera": {"target": [0, 0, 0]}'), "s.json:2:", "position"),
    refused_scene("NaN", scene(camera="\n" + camera(near="NaN")), "s.json:2:"),
    refused_scene("infinity", scene(camera="\n" + camera(near="Infinity")), "s.json:2:"),
    refused_scene("a number beyond doubles", scene(camera="\n" + camera(near="1e400")), "s.json:2:"),
    refused_scene("a number of 10,000 digits", scene(camera="\n" + camera(near="1" * 10000)), "s.json:2:"),
    refused_scene("a hexadecimal number", scene(camera="\n" + camera(near="0x1")), "s.json:2:"),
    refused_scene("a number with a plus", scene(camera="\n" + camera(near="+1")), "s.json:2:"),
    refused_scene("a number with a comma", scene(camera="\n" + camera(near="0,1")), "s.json:2:"),
    refused_scene("a field of view of nothing", scene(camera="\n" + camera(fovYDegrees="0")), "s.json:2:", "fovYDegrees"),
    refused_scene("a field of view of half the world", scene(camera="\n" + camera(fovYDegrees="180")), "s.json:2:", "fovYDegrees"),
    refused_scene("a field of view beyond it", scene(camera="\n" + camera(fovYDegrees="-45")), "s.json:2:", "fovYDegrees"),
    refused_scene("a near plane at the eye", scene(camera="\n" + camera(near="0")), "s.json:2:", "near"),
    refused_scene("a near plane behind the eye", scene(camera="\n" + camera(near="-1")), "s.json:2:", "near"),
    refused_scene("a far plane before the near one", scene(camera="\n" + camera(near="2", far="1")), "s.json:2:", "far"),
    refused_scene("a camera that looks at itself", scene(camera="\n" + camera(target="[3, 2, 5]")), "s.json:2:", "target"),
    refused_scene("a camera that looks along up", scene(camera="\n" + camera(target="[3, 9, 5]")), "s.json:2:", "up"),
    refused_scene("an up of nothing", scene(camera="\n" + camera(up="[0, 0, 0]")), "s.json:2:", "up"),
    refused_scene("a camera beyond everything", scene(camera="\n" + camera(position="[1e16, 0, 0]")), "s.json:2:", "position"),
    refused_scene("a light of no kind", scene(lights=light('\n{"position": [0, 3, 0]}')), "s.json:2:", "type"),
    refused_scene("a light of an unknown kind", scene(lights=light('\n{"type": "pont", "position": [0, 3, 0]}')), "s.json:2:", "point"),
    refused_scene("a light without a place", scene(lights=light('\n{"type": "point"}')), "s.json:2:", "position"),
    refused_scene("a light that takes light away", scene(lights=light('\n{"type": "point", "position": [0, 3, 0], "intensity": -1}')), "s.json:2:",
           "intensity"),
    refused_scene("a sun without a direction", scene(lights=light('\n{"type": "directional", "direction": [0, 0, 0]}')), "s.json:2:", "direction"),
    refused_scene("a sphere light of no size", scene(lights=light('\n{"type": "sphere", "position": [0, 3, 0], "radius": 0}')), "s.json:2:", "radius"),
    refused_scene("a spot of no cone", scene(lights=light('\n{"type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "coneDegrees": 0}')),
           "s.json:2:", "coneDegrees"),
    refused_scene("two lights of one name", scene(lights=light(LIGHT.replace("{", '{"name": "a", ') + ",\n" + LIGHT.replace("{", '{"name": "a", '))),
           "s.json:2:", '"a"'),
    Row("more lights than the limit", {"s.json": scene(lights=light(",".join([LIGHT] * 65)))}, captured("s.json"), 6, ["s.json:", "64"]),
    Row("a million objects", {"s.json": lambda path: path.write_text(scene(objects=objects(",".join([BOX] * 1000000))))}, captured("s.json"), 6,
        ["s.json:"]),
    refused_scene("an object of nothing", scene(objects=objects('\n{"name": "a"}')), "s.json:2:", "shape"),
    refused_scene("an object that is two", scene(objects=objects('\n{"shape": "box", "size": [1, 1, 1], "mesh": "m.obj"}')), "s.json:2:"),
    refused_scene("an unknown shape", scene(objects=objects('\n{"shape": "bxo", "size": [1, 1, 1]}')), "s.json:2:", "box"),
    refused_scene("a box of negative size", scene(objects=objects('\n{"shape": "box", "size": [1, -1, 1]}')), "s.json:2:", "size"),
    refused_scene("a box of no size", scene(objects=objects('\n{"shape": "box", "size": [1, 0, 1]}')), "s.json:2:", "size"),
    refused_scene("a sphere of a billion triangles", scene(objects=objects('\n{"shape": "sphere", "radius": 1, "segments": 1000000}')), "s.json:2:",
           "segments"),
    refused_scene("a scale of nothing", scene(objects=objects('\n{"shape": "box", "size": [1, 1, 1], "scale": [1, 0, 1]}')), "s.json:2:", "scale"),
    refused_scene("a material that is not there", scene(objects=objects('\n{"shape": "box", "size": [1, 1, 1], "material": "gold"}')), "s.json:2:", "gold"),
    Row("brackets in brackets", {"s.json": "[" * 200000}, captured("s.json"), 6, ["s.json:1:", "64"]),
    Row("brackets in brackets in an unknown key", {"s.json": scene(more='"a": ' + "[" * 200000 + "]" * 200000)}, captured("s.json"), 6, ["64"]),
    Row("a scene beyond the limit", {"s.json": lambda path: (path.touch(), os.truncate(path, 65 << 20))}, captured("s.json"), 6, ["67108864"]),
    refused_scene("bytes that are no UTF-8", scene(more='"name": "').encode() + b"\xff\xfe" + b'"}', "s.json:1:"),
    refused_scene("half a surrogate pair", scene(more='\n"name": "\\ud800"'), "s.json:2:"),
    refused_scene("a zero byte", scene().encode()[:-1] + b"\0}", "s.json:1:"),
    refused_scene("UTF-16 that breaks off in a character", scene().encode("utf-16") + b"}", "s.json:", "UTF-16"),
    refused_scene("UTF-32", scene().encode("utf-32"), "s.json:1:", "UTF-32"),
    refused_scene("a curly quote", scene(more='\n\u201cname": "a"'), "s.json:2:1:", "U+201C"),
    refused_scene("a minus sign of a word processor", scene(more='\n"exposure": \u22121'), "s.json:2:13:", "U+2212"),
    refused_scene("a no-break space", scene(more='\n\u00a0"exposure": 1'), "s.json:2:1:", "U+00A0"),
    refused_scene("a PNG called .json", b"\x89PNG\r\n\x1a\n" + bytes(300), "binary data"),
    drawn_scene("comments", "// a scene\n" + scene().replace("{", "{ /* here */", 1)),
    drawn_scene("a byte order mark", "\ufeff" + scene()),
    drawn_scene("UTF-16", scene().encode("utf-16")),
    drawn_scene("UTF-16 of the other order, without its mark", scene().encode("utf-16-be")),
    drawn_scene("line ends of Windows", scene().replace(", ", ",\r\n")),
    drawn_scene("a light at the camera", scene(lights=light('{"type": "point", "position": [3, 2, 5]}'))),
    drawn_scene("no light", scene(lights=""), "no lights"),
    drawn_scene("no objects", scene(objects=""), "no objects"),
    drawn_scene("names in all scripts", scene(objects=objects('{"name": "\u5f71 \U0001f311 \\u00e9", "shape": "box", "size": [1, 1, 1]}'))),
]
