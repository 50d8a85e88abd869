"""Every kind of output there is: how it comes to be, what is there before, and how to tell that a file is whole."""
# SPDX-License-Identifier: MIT
import json
import re
import shutil
import struct
import subprocess
import zlib
from dataclasses import dataclass, field
from pathlib import Path

SCENE = """{"camera": {"position": [-3, 2.5, 4], "target": [0, 0.5, 0]}, "ambient": [0.05, 0.05, 0.05],
"lights": [{"name": "key", "type": "point", "position": [2, 5, 3], "intensity": 40}],
"objects": [{"shape": "quad", "size": [12, 12]}, {"shape": "box", "size": [1, 1, 1], "translate": [0, 0.5, 0]}]}
"""
DECK = """{"title": "Two", "scene": "box.json", "slides": [
  {"name": "one", "title": "One", "slots": [{"technique": "unshadowed"}], "alt": "A box."},
  {"name": "two", "title": "Two", "slots": [{"technique": "shadow-map"}], "alt": "A box and its shadow."}]}
"""
TEMPORARY = re.compile(r"\..+\.tmp\.\d+\.\d+")  # of the writers; what a killed run may leave
UNFINISHED = re.compile(r"[^/]+\.unfinished\.json")  # what a deck goes on by, until it has come to its end


@dataclass
class Output:
    name: str
    words: list  # of the command; FOLDER stands for the folder that it writes into
    old: dict = field(default_factory=dict)  # files that are there before: name and content
    prepared_by: list = field(default_factory=list)  # commands that fill the folder first
    without: list = field(default_factory=list)  # of what they made, what is taken away again
    once: bool = False  # a second run is refused: what it would make is there
    appends: bool = False  # a second run adds to what the first has made
    program: str = "shadowlab"
    resumes: bool = False  # a run that was stopped goes on, by what it has noted in DECK.unfinished.json


SMALL = ["--size", "32x24"]
REPORT = ["report", "box.json", "--quick", "--size", "160x120", "-t", "unshadowed,shadow-map", "-o"]
SHORT = [
    Output("picture", ["capture", "box.json", "-o", "FOLDER/x.png", *SMALL], {"x.png": "old"}),
    Output("statistics", ["capture", "box.json", "-o", "/dev/null", *SMALL, "--stats", "FOLDER/s.json"]),
    Output("report", [*REPORT, "FOLDER"], prepared_by=[[*REPORT, "FOLDER"]],
           without=["parts/box@key/unshadowed.json", "charts", "points.csv"]),
]
LONG = SHORT + [
    Output("sequence", ["capture", "box.json", "-o", "FOLDER/f_#.png", *SMALL, "--frames", "3", "--orbit-light", "90"], {"f_1.png": "old"}),
    Output("visibility", ["capture", "box.json", "-o", "FOLDER/v.png", *SMALL, "--stage", "visibility"]),
    Output("animation", ["capture", "box.json", "-o", "FOLDER/a.png", *SMALL, "--frames", "3", "--orbit-light", "90", "--animate"]),
    Output("diagram", ["probe", "box.json", "--pixel", "16,15", *SMALL, "--diagram", "FOLDER/d.svg"], {"d.svg": "old"}),
    Output("lesson", ["lesson", "acne", "-o", "FOLDER/l.png"]),
    Output("slides", ["slides", "deck.json", "--size", "640x360", "--supersample", "1", "-o", "FOLDER"], {"deck.html": "old"}, resumes=True),
    Output("technique", ["new-technique", "my-own", "-o", "FOLDER/my-own"], once=True),
    Output("packed scene", ["pack", "box.json", "-o", "FOLDER/packed"], once=True),
    Output("exported scene", ["export", "box.json", "-o", "FOLDER/exported", "--to", "pov"], once=True),
    Output("exercises", ["exercise", "--seed", "7", "--questions", "2", "-o", "FOLDER/sheet", "--key", "FOLDER/key.html"], {"key.html": "old"}, once=True),
    Output("judged picture", ["judge", "seen.png", "box.json", "-o", "FOLDER"], {"errors.png": "old"},
           prepared_by=[["capture", "box.json", "-t", "ray-traced", "--stage", "visibility", "-o", "seen.png", *SMALL]]),
    Output("merged report", ["report", "merge", "made/report", "-o", "FOLDER"], prepared_by=[[*REPORT, "made/report"]]),
    Output("window settings", ["window-settings", "FOLDER"], program="writer_trial"),
    Output("slide of the window", ["slide", "FOLDER"], {"slides.json": DECK.replace("box.json", "still-life")}, appends=True,
           program="writer_trial"),
]
CARELESS = Output("careless writer", ["careless", "FOLDER"], {"careless.json": '{"a": 0, "b": 0}\n'}, program="writer_trial")


def write_inputs(place):
    (place / "box.json").write_text(SCENE)
    (place / "deck.json").write_text(DECK)


def fill(output, folder, place, programs):
    """The folder as it is before the command runs."""
    folder.mkdir(parents=True)
    for words in output.prepared_by:
        words = [word.replace("FOLDER", str(folder)) for word in words]
        subprocess.run([programs["shadowlab"], *words], cwd=place, check=True, capture_output=True, timeout=600)
    for name in output.without:
        path = folder / name
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    for name, text in output.old.items():
        (folder / name).write_text(text)


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def is_whole_png(data):
    at, kind = 8, b""
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        return False
    while at + 12 <= len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 4:at + 8 + length]
        if len(data) < at + 12 + length or zlib.crc32(body) != struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]:
            return False
        at += 12 + length
    return kind == b"IEND" and at == len(data)


def is_json(data):
    try:
        json.loads(data)
        return data.endswith(b"}\n")
    except ValueError:
        return False


def is_whole(name, data, reference):
    """For a file that holds measured times, or its own place, and so never twice the same bytes: whether it comes to its end."""
    suffix = Path(name).suffix
    if suffix == ".png":
        return is_whole_png(data)
    if suffix == ".json":
        return is_json(data)
    if suffix in (".csv", ".md"):
        return data.endswith(b"\n") and data.count(b"\n") == reference.count(b"\n")
    if suffix in (".svg", ".html"):
        return data.rstrip().endswith(f"</{suffix[1:]}>".encode())
    return False
