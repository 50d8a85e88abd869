"""Pixels that are picked in the window: what is said of them, and what lets go of them. A part of drive_window.py."""
# SPDX-License-Identifier: MIT
from window_driver import check, pane


def picking(window, place, sky):
    """Ctrl and a click ask about a pixel: the panel tells, and the camera's way, a parameter or a technique changes what."""
    w = window
    x, y = place

    def click(at, what, expected):
        w.hand("mousemove", *at)
        w.wait(f"the mouse before {what}", lambda s: s["mouse"] == list(at) and s["settled"])
        w.hand("keydown", "ctrl", "click", 1, "keyup", "ctrl")
        return w.wait(what, lambda s: expected(s) and s["settled"])

    before = w.state
    first = click((x, y), "a picked pixel", lambda s: s["picked"])
    check(first["camera"] == before["camera"] and first["selection"] == before["selection"], "it moved or chose something", first)
    check(first["picture"] != before["picture"], "nobody sees which pixel was picked", first)
    check(first["picked"]["pixel"][0] == x and 0 < first["picked"]["pixel"][1] < y, f"at {place} lies {first['picked']}", first)
    check(first["picked"]["technique"] == pane(first)["technique"], "another technique was asked", first)
    second = click((x + 30, y - 20), "another pixel", lambda s: s["picked"] != first["picked"])
    check([a - b for a, b in zip(second["picked"]["pixel"], first["picked"]["pixel"])] == [30, -20], "another pixel was picked", second)
    w.key("3", "technique-3")
    w.wait("the other technique's facts", lambda s: s["picked"]["technique"] == pane(s)["technique"] and s["settled"])
    for number in range(1, 10):
        w.key(str(number), f"technique-{number}")
        if pane(w.state)["technique"] == "ray-traced":
            break
    traced = w.wait("rays", lambda s: s["picked"]["technique"] == "ray-traced" and s["settled"])
    check(traced["picked"]["rays"] >= 1 + len(traced["lights"]), f"technique {number} follows {traced['picked']['rays']} rays", traced)
    w.key("o", "outside")
    rays = w.state["picture"]
    w.key("Escape", "leave")
    check(w.state["picked"] is None and pane(w.state)["stage"] == "outside", "Escape takes more than the pixel, or less", w.state)
    check(w.state["picture"] != rays, "from outside all pixels look like the one that was picked", w.state)
    w.key("Escape", "leave")
    check(pane(w.state)["stage"] == "", "the stage stays", w.state)
    second_pixel(w, x, y)
    # The background has nothing to tell.
    click((x, y), "a pixel again", lambda s: s["picked"])
    click((x, sky), "the background", lambda s: s["picked"] is None)
    w.close()


def second_pixel(window, x, y):
    """Shift+X, or Shift, Ctrl and a click, pick one beside the first, which it never is without; Escape lets go of it first."""
    w = window
    w.hand("mousemove", x, y)
    w.wait("the mouse before a first pixel", lambda s: s["mouse"] == [x, y] and s["settled"])
    w.key("shift+x", "pick-partner")
    w.wait("a first pixel", lambda s: s["picked"] and s["settled"])
    check(w.state["partner"] is None, "a second pixel without a first", w.state)
    alone = w.state
    w.hand("mousemove", x + 40, y + 10)
    w.wait("the mouse before a second pixel", lambda s: s["mouse"] == [x + 40, y + 10] and s["settled"])
    w.hand("keydown", "ctrl", "keydown", "shift", "click", 1, "keyup", "shift", "keyup", "ctrl")
    both = w.wait("a second pixel", lambda s: s["partner"] and s["settled"])
    check([a - b for a, b in zip(both["partner"], both["picked"]["pixel"])] == [40, 10], "another second pixel was picked", both)
    check(both["picked"]["pixel"] == alone["picked"]["pixel"] and both["camera"] == alone["camera"], "the first pixel, or the camera, moved", both)
    check(both["picture"] != alone["picture"], "nobody sees which second pixel was picked", both)
    w.key("Escape", "leave")
    w.wait("the second pixel alone let go", lambda s: s["partner"] is None and s["picked"] and s["settled"])
    w.key("Escape", "leave")
    w.wait("both let go", lambda s: s["picked"] is None and s["settled"])
