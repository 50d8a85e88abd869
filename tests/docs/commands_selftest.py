#!/usr/bin/env python3
"""Shows that commands_check.py bites: commands_selftest.py PROGRAM makes up pages with one wrong command each, which must be told
of, and one page of commands that come close to being wrong, and must pass."""
# SPDX-License-Identifier: MIT
import os
import sys
import tempfile
from pathlib import Path

from commands_check import Names, check_page

# (what must be said, what stands on the page)
# Lines of a list, its columns as far apart as a page likes.
BILLIARDS = "billiards  A billiard table for rays that are spread: over lamps, time, lens and rough surfaces."
CANDLE = "candle     A ball in candlelight, after the drawings of shadow in the notebooks of Leonardo da Vinci."
WRONG = [
    ("there is no subcommand catpure", "    build/release/shadowlab catpure still-life -o a.png"),
    ("capture has no option --sise", "`shadowlab capture still-life --sise 64x36 -o a.png`"),
    ("there is no technique shadow-maps", "    build/release/shadowlab capture still-life -t shadow-map,shadow-maps -o a.png"),
    ("there is no technique all", "    build/release/shadowlab capture still-life -t all -o a.png"),
    ("no stage stencil of shadow-map", "    build/release/shadowlab capture still-life -t shadow-map --stage stencil -o a.png"),
    ("there is no parameter shadow-map.resolutoin", "`shadowlab measure still-life -t shadow-map --set shadow-map.resolutoin=64`"),
    ("shadow-map.resolution is 32; it must be 64..32768", "`shadowlab measure still-life --set 2:shadow-map.resolution=32`"),
    ("shadow-map.filter is blur; it must be hard|", "`shadowlab measure still-life --set shadow-map.filter=blur`"),
    ("still-live is none of the scenes", "    build/release/shadowlab inspect still-live"),
    ("still-live is none of the scenes", "    build/release/shadowlab report --quick still-live -o out"),
    ("acme is none of the lessons", "    build/release/shadowlab demo --lesson acme"),
    ("shadow is none of the decks", "    build/release/shadowlab demo --deck shadow"),
    ("the deck shadows has no slide silhouette", "    build/release/shadowlab slides shadows -o out --only silhouette"),
    ("no lesson is called acme", "    build/release/shadowlab slides lessons -o out --only acne,acme"),
    ("lessons is none of the decks", "    build/release/shadowlab demo --deck lessons"),
    ("the deck shadows has no slide acne", "    build/release/shadowlab demo --deck shadows --slide acne"),
    ("walk.json is none of the files", "    build/release/shadowlab capture still-life --path walk.json -o a_####.png"),
    ("no stage stencil of planar", "<!-- picture a: still-life -t planar --stage stencil -->"),
    ("no option --sise", "    build/release/shadowlab capture still-life \\\n        --sise 64x36 -o a.png"),
    # A file that the page gives is read by the program itself.
    ('unknown key "camra"', '`a.json`:\n\n```json\n{"camra": {}}\n```\n\n`shadowlab inspect a.json`'),
    ("does not print `billiardz`", f"```console\n$ shadowlab list scenes\n{BILLIARDS}\nbilliardz\n```"),
    ("not in this order", f"```console\n$ shadowlab list scenes\n{CANDLE}\n{BILLIARDS}\n```"),
]

RIGHT = """
    build/release/shadowlab capture still-life -o a_####.png --frames 2   # not b.png --frams
    build/release/shadowlab capture SCENE --stage ANY -o a.png
`shadowlab report merge part-1 part-2 -o out`, `shadowlab report --hard -o out`
`shadowlab capture still-life -t shadow-map --stage 1:light-depth@key -o a.png`, `shadowlab list limits`, `shadowlab measure`
`shadowlab measure still-life -t all --set 2:shadow-map.filter=hw2x2 --set ray-traced.structure=NAME`
`shadowlab --help`, `shadowlab lesson acne --animate -o acne.mp4`

`mine.json`:

```json
{"camera": {"position": [0, 1, 3], "target": [0, 0, 0]}, "objects": [{"shape": "box", "size": [1, 1, 1]}]}
```

    build/release/shadowlab inspect mine.json --json

```console
$ shadowlab list scenes
BILLIARDS
CANDLE
```
""".replace("BILLIARDS", BILLIARDS).replace("CANDLE", CANDLE)


def main():
    names = Names(os.path.abspath(sys.argv[1]))
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "page.md"
        for said, text in WRONG:
            page.write_text(text, encoding="utf-8")
            complaints, _, _ = check_page(page, names, False, set())
            if len(complaints) != 1 or said not in complaints[0]:
                failures.append(f"of {text!r} it says {complaints}, not {said!r}")
        page.write_text(RIGHT, encoding="utf-8")
        complaints, looked_at, ran = check_page(page, names, False, set())
        if complaints or (looked_at, ran) != (9, 2):
            failures.append(f"of what is right it says {complaints}, {looked_at} looked at, {ran} run")
    print("".join(line + "\n" for line in failures), end="")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
