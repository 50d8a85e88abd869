#!/usr/bin/env python3
"""tour_check.py: what docs/tour.md names in code at a stop stands in a file that this stop links. (That the files exist is
checked with all links.)"""
# SPDX-License-Identifier: MIT
import re
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent.parent / "docs"
LEAST_NAMES = 12  # so that a tour that is no longer read is noticed
STOP = re.compile(r"^\d+\. .*?(?=^\d+\. |^## |^$)", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((\.\./[^)#]+)\)")
NAME = re.compile(r"`([A-Za-z_][\w.]*)`")


def main():
    complaints, found = [], 0
    for stop in STOP.findall((DOCS / "tour.md").read_text(encoding="utf-8")):
        sources = "\n".join((DOCS / file).read_text(encoding="utf-8") for file in LINK.findall(stop))
        for name in NAME.findall(stop):
            found += 1
            if not re.search(rf"\b{re.escape(name)}\b", sources):
                complaints.append(f"docs/tour.md: {name} stands in none of the files of stop {stop.split('.')[0]}")
    if found < LEAST_NAMES:
        complaints.append(f"docs/tour.md: only {found} names were found, at least {LEAST_NAMES} were expected")
    print("".join(complaint + "\n" for complaint in complaints), end="")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
