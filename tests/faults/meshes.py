"""Meshes: Wavefront OBJ files and their materials."""
# SPDX-License-Identifier: MIT
import os

from row import FACE, Row, captured, drawn_mesh, refused_mesh


def sparse(size):
    def make(path):
        path.touch()
        os.truncate(path, size)
    return make


def with_material(statements):
    return {"m.mtl": "newmtl a\n" + statements}


USES = "mtllib m.mtl\nusemtl a\n" + FACE + "f 1 2 3\n"

MESHES = [
    *[refused_mesh(f"a coordinate beyond all numbers, written {number[:12]}", f"v {number} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj:1", "finite")
      for number in ("0.1e400", ".1e400", "-0.1e999", "1" + 400 * "0" + ".5e-10", "1e99999999999999999999")],
    drawn_mesh("coordinates nearer to zero than all numbers", "v 1e-400 -0.1e-400 0." + 400 * "0" + "1\nv 1 0 0\nv 0 1e-99999999999999999999 1\nf 1 2 3\n"),
    drawn_mesh("a material file that is named ten thousand times", "mtllib" + 10000 * " m.mtl" + "\n" + FACE + "usemtl m7\nf 1 2 3\n",
               files={"m.mtl": "".join(f"newmtl m{i}\n" for i in range(100))}),
    drawn_mesh("a material file that is not there, named twice", "mtllib a.mtl a.mtl\nmtllib ./a.mtl\n" + FACE + "f 1 2 3\n", "missing"),
    Row("more materials than memory", {"m.obj": "mtllib m.mtl\n" + FACE + "f 1 2 3\n", "m.mtl": "".join(f"newmtl m{i}\n" for i in range(40000))},
        ["capture", "m.obj", "-o", "x.png", "--limit", "memory=300000000"], 6, ["m.mtl: for 40000 materials", "--limit memory"]),
    refused_mesh("an index beyond the last vertex", FACE + "f 1 2 9\n", "m.obj:4:", "9", "3"),
    refused_mesh("the largest 32-bit index", FACE + "f 1 2 2147483647\n", "m.obj:4:", "2147483647"),
    refused_mesh("an index that overflows 32 bits", FACE + "f 1 2 99999999999\n", "m.obj:4:"),
    refused_mesh("an index of 400 digits", FACE + "f 1 2 " + "9" * 400 + "\n", "m.obj:4:"),
    refused_mesh("a negative index before the first vertex", FACE + "f -1 -2 -9\n", "m.obj:4:", "-9"),
    refused_mesh("the index 0", FACE + "f 0 1 2\n", "m.obj:4:"),
    refused_mesh("an index of a normal that is not there", FACE + "vn 0 0 1\nf 1//1 2//1 3//7\n", "m.obj:5:", "7"),
    refused_mesh("an index of a texture place that is not there", FACE + "vt 0 0\nf 1/1 2/1 3/5\n", "m.obj:5:", "5"),
    refused_mesh("a face with one slash too many", FACE + "f 1/1/1/1 2 3\n", "m.obj:4:"),
    refused_mesh("an index with letters behind it", FACE + "f 1 2 3x\n", "m.obj:4:"),
    refused_mesh("an index with a fraction", FACE + "f 1 2 3.5\n", "m.obj:4:"),
    drawn_mesh("a face before its vertices", "f 1 2 3\n" + FACE),
    refused_mesh("a vertex that is not a number", "v nan 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:", "finite"),
    refused_mesh("a vertex at infinity", "v 0 inf 0\n" + FACE + "f 1 2 3\n", "m.obj:1:", "finite"),
    refused_mesh("a vertex at minus infinity", "v 0 0 -inf\n" + FACE + "f 1 2 3\n", "m.obj:1:", "finite"),
    refused_mesh("a coordinate beyond doubles", "v 1e400 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("a coordinate beyond floats", "v 1e39 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("a huge coordinate", "v 1e30 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("a coordinate in words", "v abc 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:", "abc"),
    refused_mesh("a decimal comma", "v 1,5 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:", "1.5"),
    refused_mesh("a hexadecimal coordinate", "v 0x10 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("a vertex of two numbers", "v 1 0\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("a vertex of none", "v\n" + FACE + "f 1 2 3\n", "m.obj:1:"),
    refused_mesh("an empty mesh", ""),
    refused_mesh("nothing but blanks", " \n\t\n\r\n"),
    refused_mesh("nothing but comments", "# a mesh\n# with nothing in it\n"),
    refused_mesh("vertices alone", FACE),
    refused_mesh("lines and points alone", FACE + "l 1 2\np 1 2 3\n"),
    refused_mesh("random bytes", bytes(range(256)) * 8),
    refused_mesh("a JPEG called .obj", b"\xff\xd8\xff\xe0\x00\x10JFIF\x00" + bytes(500)),
    refused_mesh("a text of another kind", "#include <vector>\nint main() {}\n"),
    refused_mesh("a zero byte in a line", FACE + "f 1 2 3\0\n", "m.obj:4:"),
    refused_mesh("UTF-16 of an odd number of bytes", (FACE + "f 1 2 3\n").encode("utf-16") + b"\n", "m.obj:5:", "UTF-16"),
    refused_mesh("UTF-32", (FACE + "f 1 2 3\n").encode("utf-32"), "m.obj:1:", "UTF-32"),
    refused_mesh("a no-break space behind v", "v 0 0 0\nv\u00a0 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj:2:", "U+00A0"),
    refused_mesh("a minus sign of a word processor", FACE + "v \u22121 0 0\nf 1 2 3\n", "m.obj:4:", "U+2212"),
    refused_mesh("a byte order mark in the middle", FACE + "\ufeffv 0 0 1\nf 1 2 3\n", "m.obj:4:", "U+FEFF"),
    refused_mesh("a capital V", "v 0 0 0\nV 1 0 0\nv 0 1 0\nf 1 2 3\n", "m.obj:2:", "small letters"),
    refused_mesh("a face in words", FACE + "face 1 2 3\nf 1 2 3\n", "m.obj:4:", "face"),
    refused_mesh("a vertex that Windows calls no number", "v 1.#QNAN 0 0\n" + FACE + "f 1 2 3\n", "m.obj:1:", "finite"),
    refused_mesh("every face without area", FACE + "f 1 1 1\nf 1 2 1\n"),
    refused_mesh("a face of two corners", FACE + "f 1 2\n", "m.obj:4:"),
    refused_mesh("a line of two megabytes", lambda path: path.write_text(FACE + "f " + "1 2 3 " * 350000 + "\n"), "1048576", status=6),
    refused_mesh("a corner too many", FACE + "f " + "1 2 3 " * 3400 + "\n", "10000", status=6),
    refused_mesh("a file beyond the limit", sparse(3 << 30), "2147483648", status=6),
    Row("millions of triangles", {"m.obj": lambda path: path.write_text(FACE + ("f" + " 1 2 3" * 3333 + "\n") * 2500)}, captured("m.obj", "--limit", "memory=100000000000"),
        6, ["20000000"], is_long=True), # on a machine with little memory, that would be said first
    Row("a folder called .obj", {"m.obj/inner": ""}, captured("m.obj"), 3, ["m.obj", "directory"]),
    Row("no such mesh", {}, captured("m.obj"), 3, ["m.obj", "No such file"]),
    Row("a pipe called .obj", {"m.obj": os.mkfifo}, captured("m.obj"), 3, ["m.obj"]),
    Row("a device called .obj", {"m.obj": lambda path: path.symlink_to("/dev/zero")}, captured("m.obj"), 3, ["m.obj"]),
    Row("a link to itself called .obj", {"m.obj": lambda path: path.symlink_to("m.obj")}, captured("m.obj"), 3, ["m.obj"]),
    Row("a link to nothing called .obj", {"m.obj": lambda path: path.symlink_to("gone")}, captured("m.obj"), 3, ["m.obj"]),
    Row("a shade that is not a number", {"m.obj": USES, **with_material("Kd nan 0 0\n")}, captured("m.obj"), 3, ["m.mtl:2:"]),
    Row("a pipe for its materials", {"m.obj": USES, "m.mtl": os.mkfifo}, captured("m.obj"), 3, ["m.obj:1:", '"m.mtl"', "regular file"]),
    Row("materials beyond the limit", {"m.obj": USES, "m.mtl": sparse(20 << 20)}, captured("m.obj"), 6, ["m.mtl", "--limit material-file"]),
    drawn_mesh("a missing material file", USES, "m.mtl"),
    drawn_mesh("a material that is not in the file", USES.replace("usemtl a", "usemtl b"), "b", files=with_material("Kd 1 0 0\n")),
    drawn_mesh("a shade beyond one", USES, "m.mtl", files=with_material("Kd 1e38 1 1\n")),
    drawn_mesh("a negative shade", USES, "m.mtl", files=with_material("Kd -1 1 1\n")),
    drawn_mesh("byte order mark", "\ufeff" + FACE + "f 1 2 3\n"),
    drawn_mesh("a line that goes on", FACE + "f 1 \\\n2 3\n"),
    drawn_mesh("line ends of Windows", FACE.replace("\n", "\r\n") + "f 1 2 3\r\n"),
    drawn_mesh("line ends of old Macintoshes", FACE.replace("\n", "\r") + "f 1 2 3\r"),
    drawn_mesh("no line end at the end", FACE + "f 1 2 3"),
    drawn_mesh("tabs and many blanks", "v\t0   0\t\t0 \nv 1 0 0\t\n  v 0 1 0\nf\t1  2\t3 \n"),
    drawn_mesh("negative indices", FACE + "f -3 -2 -1\n"),
    drawn_mesh("colours behind the coordinates", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n"),
    drawn_mesh("a weight behind the coordinates", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n"),
    drawn_mesh("groups and smoothing", "o thing\ng a b\ns 1\n" + FACE + "s off\nf 1 2 3\n"),
    drawn_mesh("lines and points beside faces", FACE + "l 1 2 3\np 1\nf 1 2 3\n", "m.obj:4:", "m.obj:5:"),
    drawn_mesh("a surface beside faces, twice", FACE + "surf 0 1 0 1 1 2 3\nsurf 0 1 0 1 1 2 3\nf 1 2 3\n", "m.obj:4:", "1 more time"),
    drawn_mesh("faces as they were called once", FACE + "fo 1 2 3\n"),
    drawn_mesh("statements that OBJ does not have", FACE + "f 1 2 3\nhello\n", "m.obj:5:", "hello"),
    drawn_mesh("UTF-16", (FACE + "f 1 2 3\n").encode("utf-16")),
    drawn_mesh("UTF-16 of the other order, without its mark", (FACE + "f 1 2 3\n").encode("utf-16-be")),
    drawn_mesh("statements without names", "mtllib\n" + FACE + "usemtl\nf 1 2 3\n", "m.obj:1:", "m.obj:5:"),
    drawn_mesh("a material file without a material's name", USES, "m.mtl:1:", files={"m.mtl": "newmtl\nKd 1 0 0\nnewmtl a\n"}),
    drawn_mesh("texture places and normals that Windows calls no numbers", FACE + "vt 1.#QNAN -1.#IND\nvn 1.#INF 0 0\nf 1/1/1 2/1/1 3/1/1\n", "m.obj:5:"),
    drawn_mesh("a material file in quotes and capitals", USES.replace("m.mtl", '"M.MTL"'), "m.obj:1:", "read in its place", files=with_material("Kd 1 0 0\n")),
    drawn_mesh("a material file by a path of Windows", USES.replace("m.mtl", "C:\\a b\\m.mtl"), "m.obj:1:", "read in its place", files=with_material("Kd 1 0 0\n")),
    drawn_mesh("a material with a comment behind it", USES.replace("usemtl a", "usemtl a # red"), "m.obj:2:", "is taken for it", files=with_material("Kd 1 0 0\n")),
    drawn_mesh("some faces without area", FACE + "f 1 2 3\nf 1 1 2\n", "1"),
    drawn_mesh("the same face twice, and turned", FACE + "f 1 2 3\nf 1 2 3\nf 3 2 1\n"),
    drawn_mesh("normals of zero length", FACE + "vn 0 0 0\nf 1//1 2//1 3//1\n", "normal"),
    drawn_mesh("tiny coordinates", "v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n", "scale it up"),
]
