"""A row of the tables: what there is, what is run, and what has to come of it."""
# SPDX-License-Identifier: MIT
import dataclasses
from pathlib import Path

TIME_LIMIT = 60  # seconds; a row takes one or two, also on a busy machine

CAMERA = '"camera": {"position": [3, 2, 5], "target": [0, 0.5, 0]}'
LIGHT = '{"type": "point", "position": [1, 4, 2], "intensity": 40}'
BOX = '{"name": "box", "shape": "box", "size": [1, 1, 1]}'
FACE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


@dataclasses.dataclass
class Row:
    title: str
    files: dict  # name -> text, bytes, or a function of the path that makes what is there
    words: list
    status: int
    says: list  # parts of the one line
    writes: list = dataclasses.field(default_factory=list)  # where the status is 0: the files that are new or another
    environment: dict = dataclasses.field(default_factory=dict)
    prints: bool = False  # may there be something on standard output?
    is_long: bool = False

    def prepare(self, folder: Path):
        for name, content in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            if callable(content):
                content(path)
            elif isinstance(content, bytes):
                path.write_bytes(content)
            else:
                path.write_text(content, encoding="utf-8", newline="")


def captured(scene, *more):
    return ["capture", "-o", "x.png", "--size", "32x24", *more, "--", scene]


def scene(camera=CAMERA, lights=f'"lights": [{LIGHT}]', objects=f'"objects": [{BOX}]', more=""):
    return "{" + ", ".join(part for part in (camera, lights, objects, more) if part) + "}"


def refused_mesh(title, text, *says, status=3, **further):
    return Row(title, {"m.obj": text}, captured("m.obj"), status, ["m.obj", *says], **further)


def drawn_mesh(title, text, *says, files=None):
    return Row(title, {"m.obj": text, **(files or {})}, captured("m.obj"), 0, list(says), ["x.png"])


def refused_scene(title, text, *says, status=3, files=None, **further):
    return Row(title, {"s.json": text, **(files or {})}, captured("s.json"), status, ["s.json", *says], **further)


def drawn_scene(title, text, *says, files=None):
    return Row(title, {"s.json": text, **(files or {})}, captured("s.json"), 0, list(says), ["x.png"])
