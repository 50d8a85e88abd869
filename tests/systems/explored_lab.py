"""The lab of one slide in one browser, as a check sees it: what it shows, where its parts are, and the data that it was made of."""
# SPDX-License-Identifier: MIT
import json
import time

# A picture as a short text: every pixel counts, and so does its place.
DIGEST = ("(canvas => { const data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data; let sum = 0;"
          " for (let i = 0; i < data.length; ++i) sum = (sum * 31 + data[i]) % 1000000007; return sum })")


class Lab:
    """The lab of one slide in one browser."""
    def __init__(self, browser, page, name):
        self.browser, self.name = browser, name
        self.root = f"document.querySelector('#{name} .explore')"
        browser.open("about:blank")
        browser.open(f"{page.as_uri()}#{name}")
        browser.wait(f"{self.root}.dataset.ready", f"the first picture of {name}")
        self.data = json.loads(browser.ask(f"document.getElementById('explore-{name}').textContent"))

    def ask(self, expression):
        return self.browser.ask(expression.replace("ROOT", self.root))

    def wait(self, expression, what):
        return self.browser.wait(expression.replace("ROOT", self.root), what)

    def picture(self):
        """The picture's digest once nothing is drawn any more."""
        digest = None
        for _ in range(50):
            before, digest = digest, self.ask(f"{DIGEST}(ROOT.querySelector('canvas'))")
            if before == digest:
                break
            time.sleep(0.25)
        return digest

    def box(self, selector, index=0):
        """Left, top, width and height of what a selector finds, in view."""
        self.ask(f"ROOT.querySelectorAll('{selector}')[{index}].scrollIntoView({{block: 'nearest'}})")
        time.sleep(0.3)
        return self.ask(f"(at => [at.left, at.top, at.width, at.height])(ROOT.querySelectorAll('{selector}')[{index}].getBoundingClientRect())")

    def click(self, selector, index=0, finger=False):
        left, top, width, height = self.box(selector, index)
        middle = (left + width / 2, top + height / 2)
        self.browser.drag(middle, middle, finger)

    def focus(self, selector):
        self.ask(f"ROOT.querySelector('{selector}').focus()")

    def press(self, *keys):
        for key in keys:
            self.browser.press(key)

    def text(self, selector):
        return self.ask(f"(found => found && found.offsetParent ? found.textContent : '')(ROOT.querySelector('{selector}'))")

    def lamp(self):
        """The number of the lamp's position, by what the slider says."""
        said = self.ask("ROOT.querySelector('input[type=range]').getAttribute('aria-valuetext')")
        return [position["said"] for position in self.data["lamp"]["positions"]].index(said)

    def move_to(self, place):
        """By arrow keys, along the whole track."""
        self.focus("input[type=range]")
        self.press("Home")
        for _ in range(len(self.data["lamp"]["positions"])):
            if self.lamp() == place:
                return
            self.press("ArrowRight")
        raise AssertionError(f"arrow keys do not bring the lamp to position {place}")

    def numbers(self, pane, place, variant=0):
        return next(state["numbers"] for state in self.data["states"] if (state["pane"], state["lamp"], state["variant"]) == (pane, place, variant))

    def expect(self, truth, what):
        if not truth:
            raise AssertionError(f"{self.browser.name}, slide {self.name}: {what}")

    def plan_place(self, place):
        """Where on the screen a position of the lamp is in the plan."""
        left, top, width, height = self.box(".plan")
        plan, (x, y) = self.data["lamp"]["plan"], self.data["lamp"]["positions"][place]["plan"]
        return left + width * x / plan["width"], top + height * y / plan["height"]
