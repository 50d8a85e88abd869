"""The scenes that radiosity, our paths and Blender's Cycles draw, as the program's JSON, and the same as plain polygons and lamps."""
# SPDX-License-Identifier: MIT
import json
import math
import re
from dataclasses import dataclass
from pathlib import Path

IN_FRONT = 0.0001  # metres: of two polygons in one plane Cycles would show now the one, now the other
ASSETS = Path(__file__).resolve().parent.parent.parent / "assets/scenes"


ROOM, OUTDOORS = 0.02, 0.03  # how far blocks of radiosity may be from those of paths: RMS, shares of the mean


@dataclass
class Trial:
    """One scene, how large its picture is, and how far radiosity may be from the others."""
    name: str
    scene: dict
    size: tuple
    allowed: float
    least_blocks: int  # to be compared, of those that the picture has


def quad(name, size, translate, rotate=(0, 0, 0), material="white"):
    return {"name": name, "shape": "quad", "size": list(size), "rotateDegrees": list(rotate), "translate": list(translate),
            "material": material}


def box(name, size, translate, turn=0.0, material="white"):
    return {"name": name, "shape": "box", "size": list(size), "rotateDegrees": [0, turn, 0], "translate": list(translate),
            "material": material}


def closed_room(low, high, **materials):
    """Six quads that face inward. Of what: `floor`, `ceiling`, `left` (-x), `right`, `back` (-z), `front`."""
    size = [b - a for a, b in zip(low, high)]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    of = lambda side: materials.get(side, "white")
    return [
        quad("floor", (size[0], size[2]), (middle[0], low[1], middle[2]), material=of("floor")),
        quad("ceiling", (size[0], size[2]), (middle[0], high[1], middle[2]), (180, 0, 0), of("ceiling")),
        quad("back", (size[0], size[1]), (middle[0], middle[1], low[2]), (90, 0, 0), of("back")),
        quad("front", (size[0], size[1]), (middle[0], middle[1], high[2]), (-90, 0, 0), of("front")),
        quad("left", (size[1], size[2]), (low[0], middle[1], middle[2]), (0, 0, -90), of("left")),
        quad("right", (size[1], size[2]), (high[0], middle[1], middle[2]), (0, 0, 90), of("right")),
    ]


def cornell_room():
    text = (ASSETS / "cornell-room.json").read_text(encoding="utf-8")
    return json.loads(re.sub(r"//.*", "", text))


def yard():
    """Under a low sun and a blue sky: walls on two sides, a box, and ground that goes on outside."""
    return {
        "camera": {"position": [5.5, 4.8, 6.5], "target": [-0.8, 0.4, -0.8], "fovYDegrees": 40},
        "background": [0.25, 0.35, 0.55],
        "lights": [{"name": "sun", "type": "directional", "direction": [-0.6, -1, -0.8], "color": [1, 0.92, 0.8], "intensity": 5}],
        "materials": {"ground": {"diffuse": [0.5, 0.47, 0.42]}, "brick": {"diffuse": [0.65, 0.2, 0.12]},
                      "plaster": {"diffuse": [0.8, 0.78, 0.72]}},
        "objects": [
            quad("ground", (200, 200), (0, 0, 0), material="ground"),
            box("back wall", (8, 2.6, 0.3), (0, 1.3, -3.15), material="plaster"),
            box("left wall", (0.3, 2.6, 6), (-3.85, 1.3, 0), material="brick"),
            box("box", (1.2, 1.2, 1.2), (0.2, 0.6, -0.6), 25, "plaster"),
        ],
    }


def door(ceiling_over_lamp):
    """Two rooms and a doorway between them. A panel in the ceiling of the one shines, the eye stands in the other. The panel lies in the
    ceiling, or closes a hole in it."""
    size, height, x, z = 0.8, 2.5, -1.5, 0
    room = closed_room((-3, 0, -2), (3, height, 2), floor="boards", ceiling="plaster", back="plaster", front="plaster", left="plaster",
                       right="blue")
    if not ceiling_over_lamp:
        low, high = x - size / 2, x + size / 2
        near, far = z - size / 2, z + size / 2
        pieces = ((-3, low, -2, 2), (high, 3, -2, 2), (low, high, -2, near), (low, high, far, 2))
        room = [thing for thing in room if thing["name"] != "ceiling"] + [
            quad(f"ceiling {n}", (b - a, d - c), ((a + b) / 2, height, (c + d) / 2), (180, 0, 0), "plaster")
            for n, (a, b, c, d) in enumerate(pieces)]
    return {
        "camera": {"position": [2.8, 1.5, 1.7], "target": [0.2, 0.95, -0.5], "fovYDegrees": 65},
        "lights": [{"name": "lamp", "type": "rect", "position": [x, height, z], "edgeU": [size, 0, 0], "edgeV": [0, 0, size],
                    "color": [1, 0.95, 0.85], "intensity": 12}],
        "materials": {"plaster": {"diffuse": [0.75, 0.73, 0.7]}, "boards": {"diffuse": [0.5, 0.35, 0.22]},
                      "blue": {"diffuse": [0.25, 0.35, 0.6]}},
        "objects": [
            *room,
            box("wall behind the door", (0.12, height, 1.6), (0, height / 2, -1.2), material="plaster"),
            box("wall before the door", (0.12, height, 1.5), (0, height / 2, 1.25), material="plaster"),
            box("lintel", (0.12, 0.45, 0.9), (0, 2.275, 0.05), material="plaster"),
            box("chest", (0.6, 0.7, 0.6), (1.2, 0.35, -0.7), 20, "plaster"),
        ],
    }


def white_room():
    """Closed, and nine tenths of all light are reflected each time. A bulb, and a wall behind the eye that glows."""
    return {
        "camera": {"position": [-0.9, 1.5, 1.3], "target": [0.2, 0.8, -1.0], "fovYDegrees": 65},
        "lights": [{"name": "bulb", "type": "point", "position": [0.3, 1.7, -0.2], "intensity": 1}],
        "materials": {"white": {"diffuse": [0.9, 0.9, 0.9]},
                      "glowing": {"diffuse": [0.9, 0.9, 0.9], "emission": [0.04, 0.08, 0.16], "emits": "front"}},
        "objects": [*closed_room((-1.5, 0, -1.5), (1.5, 2.4, 1.5), front="glowing"),
                    box("block", (0.7, 0.7, 0.7), (0.5, 0.35, -0.6), 30)],
    }


TRIALS = (
    Trial("Cornell room", cornell_room(), (80, 80), ROOM, 90),
    Trial("yard under a sun", yard(), (96, 56), OUTDOORS, 80),
    Trial("room behind a door", door(True), (96, 56), ROOM, 80),
    Trial("lamp in a hole", door(False), (96, 56), ROOM, 80),
    Trial("white closed room", white_room(), (96, 56), ROOM, 80),
)


def under_one_lamp(lamp):
    """A plane from above, for which the radiance has a closed form (`radiance_under`)."""
    return {"camera": {"position": [0, 4, 0], "target": [0, 0, 0], "up": [0, 0, -1], "fovYDegrees": 40}, "lights": [lamp],
            "materials": {"grey": {"diffuse": [0.6, 0.4, 0.2]}}, "objects": [quad("plane", (20, 20), (0, 0, 0), material="grey")]}


# One lamp of each kind. Twice as wide and a quarter as bright would be noticed, and so would a power in place of a radiance.
LAMPS = (
    {"type": "point", "position": [0.5, 2, 0.25], "intensity": 7},
    {"type": "directional", "direction": [0.3, -1, 0.5], "intensity": 3},
    {"type": "rect", "position": [3, 2, 0], "edgeU": [0, 0, 0.4], "edgeV": [0, 0.6, 0], "intensity": 20},
)


def radiance_under(lamp, at, reflectance):
    """What a plane y = 0 sends up at (x, z): Lambert's law, ρ/π times the irradiance. The rectangle's by Lambert's own formula for a
    polygon."""
    x, z = at
    if lamp["type"] == "directional":
        direction = lamp["direction"]
        irradiance = lamp["intensity"] * -direction[1] / math.hypot(*direction)
    elif lamp["type"] == "point":
        to = [a - b for a, b in zip(lamp["position"], (x, 0, z))]
        irradiance = lamp["intensity"] * to[1] / math.hypot(*to) ** 3
    else:
        corners = [[c - o for c, o in zip(corner, (x, 0, z))] for corner in rectangle(lamp)]
        total = 0.0
        for a, b in zip(corners, corners[1:] + corners[:1]):
            across = cross(a, b)
            total += across[1] / math.hypot(*across) * math.acos(dot(a, b) / (math.hypot(*a) * math.hypot(*b)))
        irradiance = lamp["intensity"] * abs(total) / 2
    return [rho / math.pi * irradiance for rho in reflectance]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [p / math.hypot(*a) for p in a]


def rectangle(lamp):
    """The corners of a `rect`, counter-clockwise for those to whom it shines."""
    return [[p + s * u / 2 + t * v / 2 for p, u, v in zip(lamp["position"], lamp["edgeU"], lamp["edgeV"])]
            for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def turned(point, degrees):
    """About x, then y, then z (docs/scene_format.md)."""
    x, y, z = point
    for axis, angle in enumerate(degrees):
        s, c = math.sin(math.radians(angle)), math.cos(math.radians(angle))
        if axis == 0:
            y, z = c * y - s * z, s * y + c * z
        elif axis == 1:
            x, z = c * x + s * z, c * z - s * x
        else:
            x, y = c * x - s * y, s * x + c * y
    return [x, y, z]


def faces_of(thing):
    """The polygons of an object, counter-clockwise from where they are seen."""
    if thing["shape"] == "quad":
        w, d = (side / 2 for side in thing["size"])
        faces = [[(-w, 0, d), (w, 0, d), (w, 0, -d), (-w, 0, -d)]]
    else:
        half = [side / 2 for side in thing["size"]]
        faces = []
        for axis in range(3):
            for sign in (-1, 1):
                around = ((-1, -1), (1, -1), (1, 1), (-1, 1))[::sign]
                face = []
                for s, t in around:
                    corner = [0, 0, 0]
                    corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = sign, s, t
                    face.append([c * h for c, h in zip(corner, half)])
                faces.append(face)
    move = thing.get("translate", (0, 0, 0))
    return [[[c + m for c, m in zip(turned(corner, thing.get("rotateDegrees", (0, 0, 0))), move)] for corner in face] for face in faces]


def for_blender(scene, size):
    """The scene without any notion of ours: polygons of one reflectance and one radiance, lamps, and the axes of the eye. A `rect` is a
    polygon that shines: as for our rays it hides what lies behind it. It is put IN_FRONT of its place, for it may lie in another one."""
    black = [0, 0, 0]
    materials = {"white": {"diffuse": [0.8] * 3}, **scene["materials"]}
    polygons, lamps = [], []
    for thing in scene["objects"]:
        material = materials[thing.get("material", "white")]
        for face in faces_of(thing):
            polygons.append({"corners": face, "reflectance": material["diffuse"], "radiance": material.get("emission", black)})
    for lamp in scene["lights"]:
        color = [c * lamp["intensity"] for c in lamp.get("color", (1, 1, 1))]
        if lamp["type"] == "rect":
            forward = unit(cross(lamp["edgeU"], lamp["edgeV"]))
            corners = [[c + IN_FRONT * f for c, f in zip(corner, forward)] for corner in rectangle(lamp)]
            polygons.append({"corners": corners, "reflectance": black, "radiance": color})
        else:
            lamps.append({"type": lamp["type"], "color": color, "position": lamp.get("position"), "direction": lamp.get("direction")})
    camera = scene["camera"]
    back = unit([p - t for p, t in zip(camera["position"], camera["target"])])
    right = unit(cross(camera.get("up", (0, 1, 0)), back))
    return {"size": size, "background": scene.get("background", black), "polygons": polygons, "lamps": lamps,
            "eye": {"position": camera["position"], "right": right, "up": cross(back, right), "back": back,
                    "fovY": math.radians(camera["fovYDegrees"])}}
