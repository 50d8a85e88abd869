#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the models of the built-in scenes: OBJ and MTL files and an image, into the folder of this script.

    python3 make_models.py

Every model is a list of closed shells: each edge has exactly two faces, and every face is counter-clockwise seen from
outside, which is what shadow volumes ask of a mesh. Only leaves and the lattice of the screen are open on purpose: thin
sheets, seen from both sides. Where two shells meet (a leg and the table top) they overlap by a
few millimetres, so that no light leaks through the joint. Units are metres, y is up. The same script gives the same bytes.
"""

import struct
import zlib
from math import acos, cos, degrees, pi, sin, sqrt
from pathlib import Path

FOLDER = Path(__file__).resolve().parent

OPEN = {"leaf", "lattice"}  # shells of these materials are sheets
ALPHA_MAPS = {"lattice": "lattice.png"}  # images that cut holes, one grey byte per texel, laid on by texture coordinates

# Name: (Kd, Ks, Ns, Ke). Linear RGB, as everywhere in this program.
MATERIALS = {
    "plaster": ((0.72, 0.71, 0.69), (0, 0, 0), 32),
    "marble": ((0.60, 0.59, 0.56), (0, 0, 0), 32),
    "wood": ((0.50, 0.43, 0.36), (0, 0, 0), 32),
    "ceramic": ((0.58, 0.60, 0.62), (0.04, 0.04, 0.04), 60),
    "wax": ((0.72, 0.68, 0.60), (0, 0, 0), 32, (0.06, 0.042, 0.02)),  # a little of the flame shines through
    "wick": ((0.08, 0.07, 0.06), (0, 0, 0), 32),
    "brass": ((0.46, 0.32, 0.12), (0.12, 0.09, 0.04), 60),
    "clay": ((0.60, 0.19, 0.07), (0, 0, 0), 32),
    "soil": ((0.10, 0.08, 0.06), (0, 0, 0), 32),
    "stem": ((0.24, 0.30, 0.13), (0, 0, 0), 32),
    "leaf": ((0.20, 0.34, 0.13), (0.03, 0.03, 0.03), 40),
    "lattice": ((0.42, 0.27, 0.15), (0, 0, 0), 32),
    "ebony": ((0.10, 0.095, 0.09), (0, 0, 0), 32),
    "maple": ((0.66, 0.60, 0.50), (0, 0, 0), 32),
}


# Vectors ------------------------------------------------------------------------------------------------------------


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def mul(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return mul(a, 1 / sqrt(dot(a, a)))


# Shells: (points, faces), a face being a list of point indices ------------------------------------------------------


def grid(rows, closed_rows):
    """Quads between neighbouring rows of points; every row is a ring. A row of one point is a pole."""
    points, first = [], []
    for row in rows:
        first.append(len(points))
        points += row
    faces = []
    pairs = list(zip(range(len(rows) - 1), range(1, len(rows))))
    if closed_rows:
        pairs.append((len(rows) - 1, 0))
    for a, b in pairs:
        count = max(len(rows[a]), len(rows[b]))
        for i in range(count):
            j = (i + 1) % count
            low = [first[a]] if len(rows[a]) == 1 else [first[a] + i, first[a] + j]
            high = [first[b]] if len(rows[b]) == 1 else [first[b] + j, first[b] + i]
            faces.append(low + high)
    return points, faces


def ring(radius, y, around):
    """Points about the y axis, counter-clockwise seen from above. `radius`: a number or a function of the angle."""
    if radius == 0:
        return [(0, y, 0)]
    angles = [2 * pi * i / around for i in range(around)]
    radii = [radius(a) if callable(radius) else radius for a in angles]
    return [(r * cos(a), y, -r * sin(a)) for a, r in zip(angles, radii)]


def lathe(profile, around):
    """A solid of revolution about y: (radius, y) from the lower end of the axis, up the outside, back to the axis."""
    return grid([ring(radius, y, around) for radius, y in profile], closed_rows=False)


def tube(centre, tangent, outward, radius, along, around):
    """A closed tube about a closed curve. `outward(t)` is any vector field along the curve, never along the tangent."""
    rows = []
    for i in range(along):
        t = 2 * pi * i / along
        side = unit(cross(tangent(t), outward(t)))
        up = cross(side, tangent(t))
        angles = [2 * pi * j / around for j in range(around)]
        rows.append([add(centre(t), add(mul(up, radius * cos(a)), mul(side, radius * sin(a)))) for a in angles])
    return grid(rows, closed_rows=True)


def box(lower, upper, taper=1.0):
    """A box; `taper` scales its lower face about the middle (for table legs)."""
    (x0, y0, z0), (x1, y1, z1) = lower, upper
    xm, zm = (x0 + x1) / 2, (z0 + z1) / 2
    corners = [(x0, z0), (x0, z1), (x1, z1), (x1, z0)]
    points = [(xm + taper * (x - xm), y0, zm + taper * (z - zm)) for x, z in corners]
    points += [(x, y1, z) for x, z in corners]
    sides = [[i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4] for i in range(4)]
    return points, [[3, 2, 1, 0], [4, 5, 6, 7]] + sides


def extrude(outline, length):
    """A prism along x, centred; `outline` is a list of (z, y), clockwise seen from +x."""
    count = len(outline)
    points = [(x, y, z) for x in (-length / 2, length / 2) for z, y in outline]
    faces = [[i, i + count, (i + 1) % count + count, (i + 1) % count] for i in range(count)]
    return points, [list(range(count)), list(range(2 * count - 1, count - 1, -1))] + faces


def moved(shell, offset):
    return [add(point, offset) for point in shell[0]], shell[1]


def triangles(shell):
    """Bent quads made definite: split along the shorter diagonal."""
    points, faces = shell
    out = []
    for face in faces:
        if len(face) != 4:
            out.append(face)
            continue
        a, b, c, d = face
        ac, bd = sub(points[c], points[a]), sub(points[d], points[b])
        out += [[a, b, c], [a, c, d]] if dot(ac, ac) <= dot(bd, bd) else [[a, b, d], [b, c, d]]
    return points, out


# Normals and files --------------------------------------------------------------------------------------------------


def area_vector(points, face):
    """Twice the area times the outward normal (Newell's sum: right for any planar polygon)."""
    total = (0, 0, 0)
    for i, index in enumerate(face):
        total = add(total, cross(points[index], points[face[(i + 1) % len(face)]]))
    return total


def corner_angle(points, face, k):
    before = unit(sub(points[face[k - 1]], points[face[k]]))
    after = unit(sub(points[face[(k + 1) % len(face)]], points[face[k]]))
    return acos(max(-1, min(1, dot(before, after))))


def corner_normals(shell, crease_degrees):
    """Per face and corner: the mean normal of the faces about the point that bend away by less than the crease."""
    points, faces = shell
    normals = [unit(area_vector(points, face)) for face in faces]
    about = {}
    for f, face in enumerate(faces):
        for k, index in enumerate(face):
            about.setdefault(index, []).append((f, corner_angle(points, face, k)))
    limit = cos(crease_degrees * pi / 180)
    out = []
    for f, face in enumerate(faces):
        out.append([])
        for index in face:
            total = (0, 0, 0)
            for other, angle in about[index]:
                if other == f or dot(normals[f], normals[other]) > limit:
                    total = add(total, mul(normals[other], angle))
            out[-1].append(unit(total))
    return out


def check_sheet(name, shell):
    """Every directed edge at most once: consistently wound; and some edges without an opposite: open."""
    edges = [(face[i - 1], face[i]) for face in shell[1] for i in range(len(face))]
    if len(set(edges)) != len(edges) or {(b, a) for a, b in edges} == set(edges):
        raise SystemExit(f"{name}: a sheet is wound two ways, or is not open")


def check_closed(name, shell):
    """Every directed edge once, and its opposite once: closed and consistently wound; and the volume is positive."""
    points, faces = shell
    edges = [(face[i - 1], face[i]) for face in faces for i in range(len(face))]
    if len(set(edges)) != len(edges) or {(b, a) for a, b in edges} != set(edges):
        raise SystemExit(f"{name}: a shell is not closed")
    middle = mul((sum(p[0] for p in points), sum(p[1] for p in points), sum(p[2] for p in points)), 1 / len(points))
    volume = sum(dot(sub(points[face[0]], middle), area_vector(points, face)) for face in faces)
    if volume <= 0:
        raise SystemExit(f"{name}: a shell is inside out")


def number(x, digits):
    text = f"{x:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def write_model(name, description, parts, crease_degrees=40.0):
    """`parts`: (material, shell) each, a shell being (points, faces) or (points, faces, texture coordinates of the points), and
    a material one name or a list of them, one for each face.
    Positions get 5 decimals (10 micrometres), normals 4."""
    lines = [f"# {description}", "# Written by make_models.py", f"mtllib {name}.mtl"]
    normal_index = {}
    first, first_texcoord, count = 1, 1, 0
    current, used = None, []
    for material, shell in parts:
        points, faces, *texcoords = shell
        materials = material if isinstance(material, list) else [material] * len(faces)
        (check_sheet if materials[0] in OPEN else check_closed)(name, shell)
        lines += ["v " + " ".join(number(x, 5) for x in point) for point in points]
        for uv in texcoords[0] if texcoords else []:
            lines.append("vt " + " ".join(number(x, 4) for x in uv))
        corners = []
        for normals in corner_normals((points, faces), crease_degrees):
            corners.append([])
            for normal in normals:
                text = "vn " + " ".join(number(x, 4) for x in normal)
                if text not in normal_index:
                    normal_index[text] = len(normal_index) + 1
                    lines.append(text)
                corners[-1].append(normal_index[text])
        used += dict.fromkeys(materials)
        for material, face, normals in sorted(zip(materials, faces, corners), key=lambda one: materials.index(one[0])):
            if material != current:
                lines.append(f"usemtl {material}")
                current = material
            image = [f"{v + first_texcoord}" if texcoords else "" for v in face]
            lines.append("f " + " ".join(f"{v + first}/{t}/{n}" for v, t, n in zip(face, image, normals)))
            count += len(face) - 2
        first += len(points)
        first_texcoord += len(points) if texcoords else 0
    (FOLDER / f"{name}.obj").write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")

    lines = ["# Written by make_models.py"]
    for material in dict.fromkeys(used):
        diffuse, specular, shininess, emission = (*MATERIALS[material], (0, 0, 0))[:4]
        lines += [f"newmtl {material}", "Kd " + " ".join(number(x, 4) for x in diffuse)]
        lines += ["Ks " + " ".join(number(x, 4) for x in specular), f"Ns {shininess}"]
        lines += ["Ke " + " ".join(number(x, 4) for x in emission)] if any(emission) else []
        lines += [f"map_d {ALPHA_MAPS[material]}"] if material in ALPHA_MAPS else []
    (FOLDER / f"{name}.mtl").write_text("\n".join(lines) + "\n", encoding="ascii", newline="\n")
    size = (FOLDER / f"{name}.obj").stat().st_size
    print(f"{name:12} {count:6} triangles {size / 1000:6.0f} kB")


def write_image(name, side, is_solid):
    """A square PNG, white where is_solid(x, y) and black elsewhere; x to the right and y up, each from -1 to 1. Stored, not
    packed: what packs best is not the same for every version of zlib."""
    middles = [(2 * i + 1) / side - 1 for i in range(side)]
    rows = b"".join(b"\0" + bytes(255 if is_solid(x, -y) else 0 for x in middles) for y in middles)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)  # 8 bits of grey
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 0)) + chunk(b"IEND", b"")
    (FOLDER / f"{name}.png").write_bytes(png)


def arc(centre, radii, degrees_from, degrees_to, steps):
    """Points of a profile on an ellipse about (radius, y) = `centre`; 0 degrees is outward, 90 up."""
    angles = [(degrees_from + (degrees_to - degrees_from) * i / steps) * pi / 180 for i in range(steps + 1)]
    return [(centre[0] + radii[0] * cos(a), centre[1] + radii[1] * sin(a)) for a in angles]


def curve(knots, steps):
    """A smooth profile through (radius, y) points (Catmull and Rom, 1974), `steps` pieces between neighbours."""
    ends = [knots[0]] + list(knots) + [knots[-1]]
    out = []
    for i in range(len(knots) - 1):
        p0, p1, p2, p3 = ends[i : i + 4]
        for s in range(steps):
            t = s / steps
            weights = (-t + 2 * t**2 - t**3, 2 - 5 * t**2 + 3 * t**3, t + 4 * t**2 - 3 * t**3, t**3 - t**2)
            out.append(tuple(sum(w * p[k] for w, p in zip(weights, (p0, p1, p2, p3))) / 2 for k in (0, 1)))
    return out + [knots[-1]]


# The models ---------------------------------------------------------------------------------------------------------


def torus_knot():
    """A (2,3) torus knot: twice about the axis while three times through the hole. It stands, 1 m high."""
    major, minor, thickness = 0.3, 0.145, 0.075

    def centre(t):
        radius = major + minor * cos(3 * t)
        return (radius * cos(2 * t), radius * sin(2 * t), minor * sin(3 * t))

    def tangent(t):
        radius, slope = major + minor * cos(3 * t), -3 * minor * sin(3 * t)
        return unit(
            (
                slope * cos(2 * t) - 2 * radius * sin(2 * t),
                slope * sin(2 * t) + 2 * radius * cos(2 * t),
                3 * minor * cos(3 * t),
            )
        )

    def outward(t):  # away from the circle about which the knot winds: never along the tangent
        return (cos(3 * t) * cos(2 * t), cos(3 * t) * sin(2 * t), sin(3 * t))

    shell = triangles(tube(centre, tangent, outward, thickness, 128, 24))
    # One lobe points down and would stand on its tip; half a turn gives it two feet. Then scaled to a height of 1.
    points = [(-x, -y, z) for x, y, z in shell[0]]
    low, high = min(p[1] for p in points), max(p[1] for p in points)
    points = [mul(sub(p, (0, low, 0)), 1 / (high - low)) for p in points]
    write_model("torus_knot", "A (2,3) torus knot, 1 m high", [("plaster", (points, shell[1]))], 60.0)


def column():
    """A fluted column, 4 m high: plinth and base, shaft with entasis, capital."""
    flutes, per_flute, low, high = 20, 4, 0.36, 3.72

    def radius(y):  # entasis: the shaft narrows upward, the faster the higher
        s = (y - low) / (high - low)
        return 0.30 - 0.012 * s - 0.038 * s * s

    def fluted(y, depth):
        return lambda a: radius(y) * (1 - depth * sin(pi * ((a * flutes / (2 * pi)) % 1.0)))

    around = flutes * per_flute
    levels = [low + (high - low) * i / 7 for i in range(8)]
    rows = [[(0, low, 0)]] + [ring(fluted(y, 0.09), y, around) for y in levels] + [[(0, high, 0)]]
    shaft = grid(rows, closed_rows=False)
    base = [(0, 0.14), (0.40, 0.14)] + arc((0.36, 0.20), (0.055, 0.06), -90, 90, 6)[1:]
    base += [(0.335, 0.27)] + arc((0.325, 0.31), (0.035, 0.04), -90, 90, 5) + [(0.315, 0.37), (0, 0.37)]
    capital = [(0, 3.70), (0.262, 3.70), (0.262, 3.74)]
    capital += [(0.275, 3.76)] + arc((0.275, 3.88), (0.105, 0.11), -70, 0, 5) + [(0.38, 3.90), (0, 3.90)]
    parts = [
        ("marble", box((-0.44, 0, -0.44), (0.44, 0.15, 0.44))),
        ("marble", lathe(base, 40)),
        ("marble", shaft),
        ("marble", lathe(capital, 40)),
        ("marble", box((-0.42, 3.89, -0.42), (0.42, 4.0, 0.42))),
    ]
    write_model("column", "A fluted column, 4 m high, standing on the origin", parts)


def entablature():
    """What columns carry: a beam in two bands, a plain frieze and a cornice. 1 m long in x, to be scaled in x."""
    half = [(0.30, 0), (0.30, 0.24), (0.33, 0.24), (0.33, 0.46), (0.37, 0.50), (0.31, 0.50), (0.31, 0.84)]
    half += [(0.40, 0.92), (0.56, 0.92), (0.56, 1.02), (0.62, 1.10)]
    outline = half + [(-z, y) for z, y in reversed(half)]
    write_model("entablature", "An entablature, 1 m long and 1.1 m high", [("marble", extrude(outline, 1.0))])


def table():
    """A table 1.8 m x 0.9 m x 0.75 m; the middle of its top is the origin, so that things stand on y = 0."""
    parts = [("wood", box((-0.9, -0.035, -0.45), (0.9, 0, 0.45)))]
    for x in (-0.8, 0.8):
        for z in (-0.36, 0.36):
            parts.append(("wood", box((x - 0.035, -0.75, z - 0.035), (x + 0.035, -0.03, z + 0.035), taper=0.6)))
    for z in (-0.36, 0.36):
        parts.append(("wood", box((-0.79, -0.12, z - 0.012), (0.79, -0.03, z + 0.012))))
    for x in (-0.8, 0.8):
        parts.append(("wood", box((x - 0.012, -0.12, -0.35), (x + 0.012, -0.03, 0.35))))
    write_model("table", "A table, the middle of its top at the origin", parts)


def vase():
    """A vase, 0.36 m high, turned on a lathe with a wall 5 mm thick, open above."""
    knots = [(0.058, 0.012), (0.088, 0.07), (0.112, 0.15), (0.100, 0.22), (0.056, 0.275), (0.042, 0.31), (0.058, 0.352)]
    outside = curve(knots, 3)
    rim = [(0.058, 0.357), (0.055, 0.36), (0.052, 0.357)]
    inside = [(r - 0.006, y + 0.002) for r, y in reversed(outside[:-1])]
    profile = [(0, 0), (0.058, 0)] + outside + rim + inside + [(0, 0.014)]
    write_model("vase", "A vase, 0.36 m high, open above", [("ceramic", lathe(profile, 96))])


def pawn():
    """A chess pawn, 1 m high: a shadow that everybody knows."""
    profile = [(0, 0), (0.30, 0), (0.31, 0.02), (0.31, 0.08), (0.29, 0.11)]
    profile += curve([(0.265, 0.12), (0.25, 0.17), (0.16, 0.30), (0.115, 0.46), (0.10, 0.60)], 4)
    profile += [(0.10, 0.605), (0.185, 0.625), (0.20, 0.645), (0.185, 0.665), (0.11, 0.69)]
    # The head is a ball of radius 0.175 whose top is at 1.
    start = -degrees(acos(0.11 / 0.175))
    profile += arc((0, 0.825), (0.175, 0.175), start, 90, 14)[1:-1] + [(0, 1.0)]
    write_model("pawn", "A chess pawn, 1 m high", [("plaster", lathe(profile, 56))])


def candle():
    """A candle in a brass dish with a ring to hold it by; the wick ends at y = 0.325."""
    dish = [(0, 0), (0.060, 0), (0.066, 0.004)] + curve([(0.078, 0.010), (0.090, 0.022), (0.094, 0.030)], 4)
    dish += [(0.092, 0.032), (0.089, 0.030)] + curve([(0.086, 0.024), (0.075, 0.013), (0.062, 0.008)], 4) + [(0, 0.007)]
    socket = [(0, 0.005), (0.030, 0.005), (0.026, 0.012), (0.024, 0.040), (0.029, 0.044), (0.029, 0.048), (0, 0.048)]
    wax = [(0, 0.045), (0.0150, 0.045), (0.0125, 0.296), (0.0115, 0.299), (0.0100, 0.300)]
    wax += [(0.0070, 0.298), (0.0035, 0.296), (0, 0.2955)]
    wick = [(0, 0.290), (0.0016, 0.290), (0.0014, 0.323), (0.0007, 0.325), (0, 0.325)]

    def centre(t):
        return (0.024 * cos(t), 0.024 * sin(t), 0)

    def tangent(t):
        return (-sin(t), cos(t), 0)

    def outward(t):
        return (cos(t), sin(t), 0)

    handle = moved(tube(centre, tangent, outward, 0.0042, 40, 10), (0.112, 0.026, 0))
    parts = [("brass", lathe(dish, 56)), ("brass", lathe(socket, 40)), ("brass", handle)]
    parts += [("wax", lathe(wax, 40)), ("wick", lathe(wick, 8))]
    write_model("candle", "A candle in a brass holder, 0.325 m high", parts)


def flame():
    """The flame of the candle, 0.05 m high, its lower end at the origin. Let it cast no shadow: the light is inside."""
    knots = [(0.0035, 0.0008), (0.0072, 0.008), (0.0075, 0.014), (0.0048, 0.027), (0.0018, 0.040)]
    profile = [(0, 0)] + curve(knots, 4) + [(0, 0.05)]
    write_model("flame", "A candle flame, 0.05 m high", [("wax", lathe(profile, 24))], 60.0)


def rod(centres, across, radii, around):
    """A closed rod along points of a plane whose normal is `across`: round, and pointed at both ends."""
    rows = [[centres[0]]]
    for i in range(1, len(centres) - 1):
        tangent = unit(sub(centres[i + 1], centres[i - 1]))
        up = cross(across, tangent)
        angles = [2 * pi * j / around for j in range(around)]
        rows.append([add(centres[i], mul(add(mul(up, cos(a)), mul(across, sin(a))), radii[i])) for a in angles])
    return grid(rows + [[centres[-1]]], closed_rows=False)


def leaf(base, along, up, length, width):
    """A sheet from `base` along the unit vector `along`, its upper side toward `up`: folded at the middle, drooping at the tip."""
    steps, fold, droop = 8, 0.30, 0.38
    side = unit(cross(along, up))
    up = cross(side, along)
    points, faces = [base], []
    for i in range(1, steps):
        s = i / steps
        half = 0.5 * width * sin(pi * s**0.8) ** 0.8
        middle = add(base, add(mul(along, length * (s - 0.12 * s**3)), mul(up, length * (0.1 * s - droop * s * s))))
        rise = mul(up, fold * half)
        points += [add(add(middle, mul(side, -half)), rise), middle, add(add(middle, mul(side, half)), rise)]
    points.append(add(base, add(mul(along, length * 0.88), mul(up, length * (0.1 - droop)))))
    last = len(points) - 1
    faces += [[0, 2, 1], [0, 3, 2], [last - 3, last - 2, last], [last - 2, last - 1, last]]
    for i in range(steps - 2):
        a = 1 + 3 * i
        faces += [[a, a + 1, a + 4, a + 3], [a + 1, a + 2, a + 5, a + 4]]
    return triangles((points, faces))


def plant():
    """A pot plant, 0.75 m high: arching stems with pairs of leaves, each an open sheet."""
    pot = [(0, 0), (0.085, 0), (0.09, 0.004), (0.118, 0.150), (0.130, 0.152), (0.133, 0.156), (0.136, 0.186)]
    pot += [(0.133, 0.190), (0.126, 0.190), (0.122, 0.186), (0.105, 0.10), (0.082, 0.016), (0, 0.014)]
    soil = [(0, 0.10), (0.103, 0.10), (0.115, 0.160), (0.110, 0.168), (0.06, 0.174), (0, 0.176)]
    parts = [("clay", lathe(pot, 64)), ("soil", lathe(soil, 48))]
    stems, leaves = [], []
    for k in range(9):
        azimuth = k * pi * (3 - sqrt(5))  # the golden angle: no two stems above one another
        outward = (cos(azimuth), 0, -sin(azimuth))
        across = (sin(azimuth), 0, cos(azimuth))
        lean = 0.16 + 0.034 * k  # the first stand upright, the last lean far out
        height = 0.60 - 0.026 * k

        def at(t):
            return add(mul(outward, 0.02 + 0.004 * k + lean * (0.35 * t + 0.65 * t * t)), (0, 0.165 + height * (t - 0.16 * t * t), 0))

        steps = 14
        stems.append(rod([at(i / steps) for i in range(steps + 1)], across, [0.0065 * (1 - 0.75 * i / steps) for i in range(steps + 1)], 6))
        for pair in range(6):
            t = 0.34 + 0.62 * pair / 5
            tangent = unit(sub(at(t + 0.01), at(t - 0.01)))
            upward = unit(cross(across, tangent))
            upward = upward if upward[1] > 0 else mul(upward, -1)
            size = 0.155 * (0.72 + 0.28 * sin(pi * pair / 5)) * (1 - 0.015 * k)
            for s in (-1, 1):
                along = unit(add(add(mul(across, s), mul(tangent, 0.55 + 0.1 * pair)), mul(upward, 0.15 * sin(7 * k + 3 * pair + s))))
                leaves.append(leaf(at(t), along, upward, size, 0.40 * size))
        leaves.append(leaf(at(1), unit(sub(at(1), at(0.97))), unit(add(mul(outward, -0.5), (0, 1, 0))), 0.13, 0.052))
    parts += [("stem", stem) for stem in stems] + [("leaf", one) for one in leaves]
    write_model("plant", "A plant in a pot, 0.75 m high; its leaves are open sheets", parts, 60.0)


def screen():
    """A wooden screen, 1.3 m wide and 1.9 m high: a frame about a lattice of eight-pointed stars, which is two triangles and
    an image. The image is one star; it is repeated four times across and six times up."""
    width, height, post, depth, across, up = 1.2, 1.8, 0.05, 0.025, 4, 6

    def is_solid(x, y):
        x, y = abs(x), abs(y)
        tip = 1.0  # the points of neighbouring stars meet
        strap = 0.09
        square = abs(max(x, y) - tip / sqrt(2)) < strap
        diamond = abs((x + y) / sqrt(2) - tip / sqrt(2)) < strap
        return square or diamond

    write_image("lattice", 96, is_solid)
    x, low, high = width / 2, post, post + height
    points = [(-x, low, 0), (x, low, 0), (x, high, 0), (-x, high, 0)]
    sheet = (points, [[0, 1, 2], [0, 2, 3]], [(0, 0), (across, 0), (across, up), (0, up)])
    overlap = 0.004  # of the frame and the sheet
    parts = [("wood", box((s * x - post / 2 + s * (post / 2 - overlap), 0, -depth), (s * x + post / 2 + s * (post / 2 - overlap), high + post, depth))) for s in (-1, 1)]
    parts += [("wood", box((-x, y0, -depth * 0.9), (x, y1, depth * 0.9))) for y0, y1 in ((0, low + overlap), (high - overlap, high + post))]
    write_model("screen", "A screen, 1.9 m high: a lattice cut out of one sheet by an image", parts + [("lattice", sheet)])


def chessboard():
    """A chessboard, 1.2 m wide and 30 mm thick, its top at y = 0: one shell, light and dark squares in one plane."""
    side, squares, border, thickness = 0.14, 8, 0.04, 0.03
    half = side * squares / 2
    lines = [-half - border] + [side * i - half for i in range(squares + 1)] + [half + border]
    n = len(lines)
    points = [(x, y, z) for y in (0, -thickness) for z in lines for x in lines]

    def at(layer, row, column):
        return layer * n * n + row * n + column

    faces, materials = [], []
    for row in range(n - 1):
        for column in range(n - 1):
            corners = [(row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1)]
            faces += [[at(0, *corner) for corner in corners], [at(1, *corner) for corner in reversed(corners)]]
            on_board = 0 < row < n - 2 and 0 < column < n - 2
            materials += ["maple" if on_board and (row + column) % 2 == 0 else "ebony", "ebony"]
    rim = [(0, i) for i in range(n - 1)] + [(i, n - 1) for i in range(n - 1)]
    rim += [(n - 1, n - 1 - i) for i in range(n - 1)] + [(n - 1 - i, 0) for i in range(n - 1)]
    for here, there in zip(rim, rim[1:] + rim[:1]):
        faces.append([at(0, *here), at(0, *there), at(1, *there), at(1, *here)])
        materials.append("ebony")
    write_model("chessboard", "A chessboard, 1.2 m wide, its top at y = 0", [(materials, (points, faces))])


if __name__ == "__main__":
    for model in (torus_knot, column, entablature, table, vase, pawn, candle, flame, plant, screen, chessboard):
        model()
