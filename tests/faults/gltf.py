"""glTF files: bad ones, and ones with more than is shown."""
# SPDX-License-Identifier: MIT
import base64
import copy
import json
import struct

from row import Row, captured, drawn_scene, refused_scene, scene

POSITIONS = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
INDICES = struct.pack("<3H", 0, 1, 2)


def data(content):
    return "data:application/octet-stream;base64," + base64.b64encode(content).decode()


def triangle(content=POSITIONS + INDICES):
    """A whole file: one triangle, its buffer within."""
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": len(content), "uri": data(content)}],
    }


def changed(path, value, file=None):
    """With another value at a path such as accessors.0.count; None takes it out."""
    file = copy.deepcopy(file or triangle())
    *parents, last = [int(part) if part.isdigit() else part for part in path.split(".")]
    place = file
    for part in parents:
        place = place[part]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return file


def glb(file, content=POSITIONS + INDICES):
    file = copy.deepcopy(file)
    file["buffers"] = [{"byteLength": len(content)}]
    text = json.dumps(file).encode()
    text += b" " * (-len(text) % 4)
    content += bytes(-len(content) % 4)
    return (b"glTF" + struct.pack("<II", 2, 20 + len(text) + 8 + len(content)) + struct.pack("<I", len(text)) + b"JSON" + text
            + struct.pack("<I", len(content)) + b"BIN\0" + content)


def refused(title, file, *says, status=3, name="m.gltf", files=None):
    content = json.dumps(file) if isinstance(file, dict) else file
    return Row(title, {name: content, **(files or {})}, captured(name), status, [name, *says])


def drawn(title, file, *says, name="m.gltf", files=None):
    content = json.dumps(file) if isinstance(file, dict) else file
    return Row(title, {name: content, **(files or {})}, captured(name), 0, list(says), ["x.png"])


WHOLE = glb(triangle())
NODE_OF_SCENE = '"objects": [{"mesh": "m.gltf", "node": "nod 0"}]'

GLTF = [
    drawn("a whole glTF file", triangle()),
    drawn("a whole .glb", WHOLE, name="m.glb"),
    drawn("a .glb that is called .gltf", WHOLE),
    drawn("a glTF file whose ending is in capitals", triangle(), name="M.GLTF"),
    drawn("a buffer beside the glTF file, with a blank in its name", changed("buffers.0.uri", "a%20b.bin"), files={"a b.bin": POSITIONS + INDICES}),
    refused("an empty glTF file", b"", "m.gltf:1:1"),
    refused("an OBJ file called .gltf", b"v 0 0 0\n", "m.gltf:1:1"),
    refused("random bytes called .glb", bytes(range(256)) * 4, name="m.glb"),
    refused("a .glb that was cut off", WHOLE[:-8], "byte 8", "cut off", name="m.glb"),
    refused("a .glb of 10 bytes", WHOLE[:10], "header", name="m.glb"),
    refused("a .glb of version 1", WHOLE[:4] + struct.pack("<I", 1) + WHOLE[8:], "version 1", name="m.glb"),
    refused("a chunk longer than its .glb", WHOLE[:12] + struct.pack("<I", 0xfffffff0) + WHOLE[16:], "byte 12", name="m.glb"),
    refused("a .glb whose first chunk is not JSON", WHOLE[:16] + b"BIN\0" + WHOLE[20:], "byte 16", name="m.glb"),
    refused("glTF 1.0", changed("asset.version", "1.0"), "1.0"),
    refused("a glTF file without a version", changed("asset", None), "asset"),
    refused("JSON that is no glTF", {"camera": {}}, "asset"),
    refused("a required extension that is not there", changed("extensionsRequired", ["KHR_draco_mesh_compression"]), "KHR_draco_mesh_compression"),
    refused("glTF nested 200 levels deep", json.dumps(triangle())[:-1] + ', "extras": ' + "[" * 200 + "]" * 200 + "}", "64 levels", status=6),
    refused("an accessor that is not there", changed("meshes.0.primitives.0.indices", 9), "meshes[0].primitives[0].indices", "9"),
    refused("an accessor beyond its view", changed("accessors.0.count", 4), "accessors[0]", "bufferViews[0]"),
    refused("a count of 10^15", changed("accessors.0.count", 10**15), "accessors[0]"),
    refused("a count in a string", changed("accessors.0.count", "3"), "accessors[0].count", "string"),
    refused("a component type that there is not", changed("accessors.0.componentType", 5124), "accessors[0].componentType", "5124"),
    refused("an offset that overflows", changed("bufferViews.1.byteOffset", 2**64 - 1), "bufferViews[1].byteOffset"),
    refused("a view beyond its buffer", changed("bufferViews.0.byteLength", 99), "bufferViews[0]", "99"),
    refused("an index beyond the vertices", triangle(POSITIONS + struct.pack("<3H", 0, 1, 7)), "index 7", "accessors[1]"),
    refused("a position that is no number", triangle(struct.pack("<9f", 0, 0, 0, float("nan"), 0, 0, 0, 1, 0) + INDICES), "position nan"),
    refused("a position at infinity", triangle(struct.pack("<9f", 0, 0, 0, float("inf"), 0, 0, 0, 1, 0) + INDICES), "position inf"),
    refused("rubbish in base64", changed("buffers.0.uri", "data:application/octet-stream;base64,???"), "buffers[0]", "base64"),
    refused("a buffer that is missing", changed("buffers.0.uri", "none.bin"), "buffers[0]", "none.bin"),
    refused("a buffer that is too short", changed("buffers.0.uri", "a.bin"), "buffers[0]", "42", "7", files={"a.bin": b"1234567"}),
    refused("a buffer on the network", changed("buffers.0.uri", "https://example.org/a.bin"), "buffers[0]", "address"),
    refused("a buffer outside of the folder", changed("buffers.0.uri", "../../../../../../etc/passwd"), "buffers[0]", "--allow"),
    refused("a node that is its own parent", changed("nodes.0.children", [0]), "nodes[0]", "tree"),
    refused("a rotation of length 0", changed("nodes.0.rotation", [0, 0, 0, 0]), "nodes[0]", "[0, 0, 0, 1]"),
    refused("a matrix of nine numbers", changed("nodes.0.matrix", [1] * 9), "nodes[0].matrix", "16"),
    refused("a node beyond all numbers", changed("nodes.0.translation", [1e300, 0, 0]), "nodes[0]", "1e+15"),
    refused("a node without extent, alone", changed("nodes.0.scale", [1, 0, 1]), "nodes[0]", "flattened"),
    refused("points alone", changed("meshes.0.primitives.0.mode", 0), "points"),
    drawn("animations and skins", changed("animations", [{}], changed("skins", [{}])), "animations"),
    drawn("an unknown key", changed("nodes.0.postion", [1, 2, 3]), "nodes[0]", "postion"),
    drawn("an image that is missing", changed("materials", [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
                                               changed("meshes.0.primitives.0.material", 0,
                                                       changed("textures", [{"source": 0}], changed("images", [{"uri": "none.png"}])))),
          "images[0]", "none.png"),
    drawn_scene("a glTF file in a scene", scene(objects='"objects": [{"mesh": "m.gltf"}]'), files={"m.gltf": json.dumps(triangle())}),
    refused_scene("a node that the glTF file has not", scene(objects=NODE_OF_SCENE), "did you mean", files={
        "m.gltf": json.dumps({**triangle(), "nodes": [{"mesh": 0}, {"mesh": 0}], "scenes": [{"nodes": [0, 1]}]})}),
    Row("a view that the scene has not", {"m.gltf": json.dumps(triangle())}, captured("m.gltf", "--view", "above"), 2, ["--view", "above"]),
    Row("more triangles than the limit", {"m.gltf": json.dumps({**triangle(), "nodes": [{"mesh": 0}, {"mesh": 0}], "scenes": [{"nodes": [0, 1]}]})},
        captured("m.gltf", "--limit", "triangles=1"), 6, ["m.gltf", "2 triangles"]),
]
