"""Chromium by its DevTools protocol and Firefox by WebDriver BiDi, with the same few calls: open a page, ask it something, press keys, drag by mouse
and by finger, change the window. Neither can reach a network, and each remembers what its pages have asked for.

Needs the package websocket-client (python3-websocket in Debian)."""
# SPDX-License-Identifier: MIT
import base64
import json
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

try:
    import websocket
except ImportError:
    websocket = None

LONGEST = 60    # seconds, for one answer of a browser
STEPS = 8       # places of the pointer on its way
DEAD_PROXY = 9  # the discard port, on which nothing listens: with it as its proxy Firefox has no network
# Keys as WebDriver names them; Chromium takes the names and codes of the web.
KEYS = {"ArrowLeft": ("\ue012", 37), "ArrowUp": ("\ue013", 38), "ArrowRight": ("\ue014", 39), "ArrowDown": ("\ue015", 40), "Home": ("\ue011", 36),
        "End": ("\ue010", 35), "Escape": ("\ue00c", 27), "Tab": ("\ue004", 9), "Enter": ("\ue006", 13), "PageDown": ("\ue00f", 34), " ": (" ", 32)}


def way(start, end):
    """Places of a pointer that is dragged; a tap is one place, for a finger that rests too long asks for a menu."""
    steps = STEPS if start != end else 0
    return [tuple(a + (b - a) * i / max(steps, 1) for a, b in zip(start, end)) for i in range(steps + 1)]


class Browser:
    """One tab. Coordinates are in CSS pixels of the window."""
    def __init__(self, command, pattern):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.requests, self.complaints, self.last = [], [], 0
        self.prepare(Path(self.folder.name))
        log = Path(self.folder.name) / "log"
        with open(log, "wb") as sink:
            self.process = subprocess.Popen([word.replace("FOLDER", self.folder.name) for word in command], stdout=sink, stderr=sink)
        until = time.monotonic() + LONGEST
        while not (found := re.search(pattern, log.read_text(errors="replace"))):
            if time.monotonic() > until or self.process.poll() is not None:
                raise RuntimeError(f"{command[0]} does not start: {log.read_text(errors='replace')[-2000:]}")
            time.sleep(0.1)
        self.connect(found.group(1))

    def prepare(self, folder):
        pass

    def socket_to(self, address):
        self.socket = websocket.create_connection(address, timeout=LONGEST, suppress_origin=True, max_size=None)

    def call(self, method, **words):
        self.last += 1
        self.socket.send(json.dumps({"id": self.last, "method": method, "params": words, **self.session_words()}))
        while True:
            told = json.loads(self.socket.recv())
            if told.get("id") == self.last:
                if "error" in told:
                    raise RuntimeError(f"{method}: {told['error']} {told.get('message', '')}")
                return told["result"]
            self.event(told.get("method", ""), told.get("params", {}))

    def session_words(self):
        return {}

    def wait(self, expression, what, seconds=20):
        """Waits until an expression is true in the page."""
        until = time.monotonic() + seconds
        while not (value := self.ask(expression)):
            if time.monotonic() > until:
                raise AssertionError(f"{self.name}: {what} does not come about: {expression}")
            time.sleep(0.05)
        return value

    def close(self):
        try:
            self.goodbye()
            self.socket.close()
            self.process.wait(10)
        except (OSError, RuntimeError, subprocess.TimeoutExpired, websocket.WebSocketException):
            self.process.kill()
            self.process.wait()
        self.folder.cleanup()


class Chromium(Browser):
    name = "Chromium"
    programs = ("chromium", "chromium-browser", "google-chrome")

    def __init__(self):
        super().__init__([next(filter(shutil.which, self.programs)), "--headless=new", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-component-update",
                          "--disable-background-networking", "--remote-debugging-port=0", "--user-data-dir=FOLDER/profile", "about:blank"],
                         r"DevTools listening on (ws://\S+)")

    def session_words(self):
        return {"sessionId": self.session} if getattr(self, "session", None) else {}

    def connect(self, address):
        self.socket_to(address)
        target = next(each for each in self.call("Target.getTargets")["targetInfos"] if each["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=-1, uploadThroughput=-1)

    def event(self, method, words):
        if method == "Network.requestWillBeSent":
            self.requests.append(words["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            details = words["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded" and words["entry"]["level"] == "error":
            self.complaints.append(words["entry"]["text"])

    def open(self, url):
        self.call("Page.navigate", url=url)
        self.wait(f"document.readyState === 'complete' && location.href.startsWith({json.dumps(url.split('#')[0])})", f"{url} as a page")

    def ask(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails'].get('exception', {}).get('description', answer['exceptionDetails'])}")
        return answer["result"].get("value")

    def window(self, width, height, touch=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch)
        self.call("Emulation.setTouchEmulationEnabled", enabled=touch)

    def prefer(self, **features):
        self.call("Emulation.setEmulatedMedia", media=features.pop("media", ""), features=[{"name": name.replace("_", "-"), "value": value} for name, value in features.items()])

    def press(self, key):
        words = {"key": key, "code": "Space" if key == " " else key, "windowsVirtualKeyCode": KEYS.get(key, (key, ord(key[0].upper())))[1]}
        typed = {"text": {"Enter": "\r"}.get(key, key)} if len(key) == 1 or key == "Enter" else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", **words, **typed)
        self.call("Input.dispatchKeyEvent", type="keyUp", **words)

    def drag(self, start, end, finger=False):
        places = way(start, end)
        if finger:
            for i, (x, y) in enumerate(places):
                self.call("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=[{"x": x, "y": y}])
            self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
            return
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=start[0], y=start[1])
        self.call("Input.dispatchMouseEvent", type="mousePressed", x=start[0], y=start[1], button="left", buttons=1, clickCount=1)
        for x, y in places[1:]:
            self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y, button="left", buttons=1)
        self.call("Input.dispatchMouseEvent", type="mouseReleased", x=end[0], y=end[1], button="left", clickCount=1)

    def picture(self, file):
        Path(file).write_bytes(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def before(self, script):
        """Runs a script in every page from now on, before the page's own."""
        self.call("Page.addScriptToEvaluateOnNewDocument", source=script)

    def names(self):
        """Role and name of each thing that is read out."""
        self.call("Accessibility.enable")
        nodes = self.call("Accessibility.getFullAXTree")["nodes"]
        return [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in nodes if not node["ignored"]]

    def goodbye(self):
        self.session = None
        self.call("Browser.close")


class Firefox(Browser):
    name = "Firefox"
    programs = ("firefox-esr", "firefox")

    def __init__(self):
        super().__init__([next(filter(shutil.which, self.programs)), "--headless", "--no-remote", "--profile", "FOLDER/profile", "--remote-debugging-port=0", "about:blank"],
                         r"WebDriver BiDi listening on (ws://\S+)")

    def prepare(self, folder):
        profile = folder / "profile"
        profile.mkdir()
        wanted = {"network.proxy.type": 1, "network.proxy.http": "127.0.0.1", "network.proxy.http_port": DEAD_PROXY, "network.proxy.ssl": "127.0.0.1",
                  "network.proxy.ssl_port": DEAD_PROXY, "app.update.disabledForTesting": True, "datareporting.policy.dataSubmissionEnabled": False,
                  "browser.shell.checkDefaultBrowser": False, "dom.w3c_touch_events.enabled": 1, "layout.css.devPixelsPerPx": "1.0"}
        (profile / "user.js").write_text("".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in wanted.items()))

    def connect(self, address):
        self.socket_to(address.rstrip("/") + "/session")
        self.call("session.new", capabilities={})
        # The window that Firefox starts with never gets the focus without a display, and without it Enter presses no button.
        self.context = self.call("browsingContext.create", type="window")["context"]
        self.call("session.subscribe", events=["network.beforeRequestSent", "log.entryAdded"])

    def event(self, method, words):
        if method == "network.beforeRequestSent":
            self.requests.append(words["request"]["url"])
        elif method == "log.entryAdded" and words["level"] == "error":
            self.complaints.append(words["text"])

    def open(self, url):
        self.call("browsingContext.navigate", context=self.context, url=url, wait="complete")

    def ask(self, expression):
        answer = self.call("script.evaluate", expression=f"Promise.resolve({expression}).then(value => JSON.stringify([value === undefined ? null : value]))",
                           target={"context": self.context}, awaitPromise=True)
        if answer["type"] == "exception":
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']['text']}")
        return json.loads(answer["result"]["value"])[0]

    def window(self, width, height, touch=False):
        self.call("browsingContext.setViewport", context=self.context, viewport={"width": width, "height": height})

    def act(self, kind, actions, **parameters):
        self.call("input.performActions", context=self.context, actions=[{"type": kind, "id": kind + str(parameters), "actions": actions, **parameters}])

    def press(self, key):
        value = KEYS.get(key, (key,))[0]
        self.act("key", [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}])

    def drag(self, start, end, finger=False):
        places = way(start, end)
        moves = [{"type": "pointerMove", "x": round(x), "y": round(y), "duration": 20 * bool(i)} for i, (x, y) in enumerate(places)]
        self.act("pointer", [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:], {"type": "pointerUp", "button": 0}],
                 parameters={"pointerType": "touch" if finger else "mouse"})

    def picture(self, file):
        Path(file).write_bytes(base64.b64decode(self.call("browsingContext.captureScreenshot", context=self.context)["data"]))

    def before(self, script):
        self.call("script.addPreloadScript", functionDeclaration=f"() => {{ {script} }}")

    def goodbye(self):
        self.call("browser.close")


def installed():
    """The browsers that are there; none without the package that talks to them."""
    return [kind for kind in (Chromium, Firefox) if websocket and any(map(shutil.which, kind.programs))]
