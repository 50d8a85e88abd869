#!/usr/bin/env python3
"""Drops a file on a window, as a file manager does: the source's side of XDND (Lindahl 1999, "Drag-and-Drop Protocol for the
X Window System", version 5).

drop_file.py WINDOW FILE [FILE...]   with the number of the window, on the display that DISPLAY names
"""
# SPDX-License-Identifier: MIT
import os
import sys
import time
import urllib.parse

from Xlib import X, Xatom, display
from Xlib.protocol import event

TIMEOUT = 20  # seconds, for the window to answer
VERSION = 5


class Drop:
    def __init__(self, target, files):
        self.display = display.Display()
        self.root = self.display.screen().root
        self.target = self.display.create_resource_object("window", target)
        self.source = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.list = "".join("file://" + urllib.parse.quote(os.path.abspath(f)) + "\r\n" for f in files).encode()

    def atom(self, name):
        return self.display.intern_atom(name)

    def tell(self, message, *data):
        data = [self.source.id, *data] + [0] * (4 - len(data))
        self.target.send_event(event.ClientMessage(window=self.target, client_type=self.atom(message), data=(32, data)))

    def until(self, message):
        """Answers what the target asks until it says this."""
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            while self.display.pending_events():
                what = self.display.next_event()
                if what.type == X.SelectionRequest:
                    self.hand_over(what)
                if what.type == X.ClientMessage and what.client_type == self.atom(message):
                    return what.data[1]
            time.sleep(0.005)
        raise SystemExit(f"drop_file.py: no {message} from the window in {TIMEOUT} s")

    def hand_over(self, request):
        request.requestor.change_property(request.property, request.target, 8, self.list)
        request.requestor.send_event(event.SelectionNotify(
            time=request.time, requestor=request.requestor, selection=request.selection, target=request.target,
            property=request.property))

    def run(self):
        if not self.target.get_full_property(self.atom("XdndAware"), Xatom.ATOM):
            raise SystemExit("drop_file.py: this window takes no drops")
        self.source.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.tell("XdndEnter", VERSION << 24, self.atom("text/uri-list"))
        place = self.target.translate_coords(self.root, 0, 0)
        self.tell("XdndPosition", 0, (-place.x + 20) << 16 | (-place.y + 20), X.CurrentTime, self.atom("XdndActionCopy"))
        self.display.flush()
        if not self.until("XdndStatus")[1] & 1:
            raise SystemExit("drop_file.py: the window refuses the drop")
        self.tell("XdndDrop", 0, X.CurrentTime)
        self.display.flush()
        self.until("XdndFinished")


if __name__ == "__main__":
    Drop(int(sys.argv[1]), sys.argv[2:]).run()
