# SPDX-License-Identifier: MIT
"""A window of luxel-app, by the names that people know its parts by."""
import itertools
import os
import re

from accessible import Rejected
from waiting import Late, wait

PLACE = re.compile(r"x (\S+)  y (\S+) (?:mm|мм)")
VALUE = re.compile(r"P(\d+) [^:]*: (.*)")
HOVER = 5  # seconds a tooltip is waited for before the pointer moves again
WHEEL = 60  # how far a notch moves the panel
saved = itertools.count(1)


class Window:
    def __init__(self, app, widget, number):
        self.app, self.desk, self.root = app, app.desk, widget
        self.path = "/org/luxel/Luxel/window/%d" % number
        self.screen_id = None

    @property
    def widget(self):
        """The window itself, of an app that runs; else what the app said in the end is told."""
        self.app.running()
        return self.root

    def appear(self):
        """Waits until it stands on the screen with its numbers, and gives it the keyboard."""
        wait("the panes", lambda: self.widget.find("widget", "GtkPaned"))
        is_shut = not self.panes()[2]
        if is_shut:
            self.act("numbers")
        wait("the first numbers", self.values)
        if is_shut:
            self.act("numbers")
        ids = wait("a window on the screen",
                   lambda: self.app.on_screen() - {window.screen_id for window in self.app.known})
        self.screen_id = max(ids, key=int)
        self.raise_()
        return self

    def raise_(self):
        self.desk.hand("windowraise", self.screen_id, "windowfocus", "--sync", self.screen_id)

    # ---- actions ----

    def act(self, name, *parameters):
        self.app.running()
        try:
            self.desk.reader.activate(self.path, name, *parameters)
        except Rejected:
            self.app.running()  # which says why not
            raise

    def state(self, name):
        """The state of an action."""
        return self.desk.reader.state(self.path, name)[1]

    def enabled(self, name):
        return self.desk.reader.state(self.path, name)[0]

    def save(self, path=None):
        """Saves the scene; its bytes."""
        path = path or self.desk.path("scene-%d.yaml" % next(saved))
        if os.path.exists(path):
            os.remove(path)
        self.act("save-path", path)
        with open(path, "rb") as file:
            return file.read()

    # ---- what it shows ----

    @property
    def title(self):
        return self.widget.name

    def labels(self):
        """All texts that stand in it."""
        return self.widget.names("label")

    def says(self, *parts):
        """The first text that has all these parts."""
        return next((text for text in (label.name for label in self.widget.all("label"))
                     if all(part in text for part in parts)), None)

    def values(self):
        """The exact values of the points as they stand in the table, in their order."""
        found = {}
        for text in self.numbers():
            match = VALUE.fullmatch(text)
            if match:
                found[int(match.group(1))] = match.group(2)
        return [found[number] for number in sorted(found)]

    def sources(self):
        """The rows of the list of sources."""
        return self.widget.find("list").names("list item")

    # ---- controls ----

    def control(self, role, name):
        return wait("%s %r" % (role, name), lambda: self.widget.find(role, name))

    def press(self, name, role="button"):
        self.control(role, name).act()

    def toggle(self, name):
        """A button that stays pressed; newer versions of GTK have a role of their own for it."""
        return wait("toggle %r" % name,
                    lambda: self.widget.find("toggle button", name) or self.widget.find("button", name))

    def place(self, widget):
        """The middle of a widget on the screen, brought into view where it is in the panel on the left."""
        frame, panel = self.widget.area(), self.panel()
        edges = self.edges()
        for _ in range(40):
            x, y, width, height = widget.area()
            middle = (x + width / 2, y + height / 2)
            over, under = panel[1] - y, y + height - panel[1] - panel[3]
            if middle[0] > panel[0] + panel[2] or (over <= 0 and under <= 0):
                return edges[0] + middle[0], edges[1] + middle[1]
            self.desk.click(edges[0] + panel[0] + 3, edges[1] + frame[3] / 2, 4 if over > 0 else 5)
            wait("the panel moves", lambda: widget.area()[1] != y)
        raise AssertionError("%r cannot be brought into view" % widget)

    def panes(self):
        """Scene, picture and numbers, from left to right: what is in one of them is sooner found there.  In a narrow
        window the numbers are a drawer over the picture, None while it is shut."""
        scene, *_, right = self.widget.find("widget", "GtkPaned").children()
        picture, *others = right.children()
        over = picture.children()[0].children()
        return scene, picture, next((part for part in others + over if part.find("tab")), None)

    def numbers(self):
        """All texts beside the picture."""
        numbers = self.panes()[2]
        return numbers.names("label") if numbers else []

    def panel(self):
        """The area of the panel on the left in the window."""
        return self.panes()[0].area()

    def edge(self):
        """The labels of the line at the lower edge."""
        return self.widget.children()[0].children()[-1].all("label")

    def edge_buttons(self):
        """The buttons in it."""
        return self.widget.children()[0].children()[-1].all("button")

    def place_said(self):
        """The place under the pointer, in millimetres, as that line says it; None where it says none."""
        return next((tuple(float(number.replace(",", ".").replace("\u2212", "-")) for number in match.groups())
                     for match in (PLACE.match(label.name) for label in self.edge()) if match), None)

    def edges(self):
        """The upper left corner of what areas are measured from, on the screen."""
        numbers = dict(line.split("=") for line in
                       self.desk.hand("getwindowgeometry", "--shell", self.screen_id).split())
        area = self.widget.area()
        return (int(numbers["X"]) + (int(numbers["WIDTH"]) - area[2]) / 2,
                int(numbers["Y"]) + (int(numbers["HEIGHT"]) - area[3]) / 2)

    def click(self, widget, button=1, count=1):
        self.desk.click(*self.place(widget), button, count)

    def enter(self, name, text, role="spin button", key="Return"):
        """Types into a field in place of what it has."""
        field = self.control(role, name)
        x, y = self.place(field)
        self.desk.click(x - field.area()[2] / 4, y)
        self.desk.key("ctrl+a")
        self.desk.type(text)
        if key:
            self.desk.key(key)
        return field

    def choose(self, name, place):
        """One of a list of choices, by its place from above."""
        self.click(self.control("combo box", name))
        self.desk.hand("sleep", "0.3")  # until it is open
        self.desk.key("Home", *["Down"] * place, "Return")

    # ---- the picture ----

    def picture_area(self):
        """x, y, width, height on the screen."""
        x, y, width, height = self.panes()[1].find("image").area()
        left, top = self.edges()
        return left + x, top + y, width, height

    def pointed(self, x, y):
        """Where on the scene's screen, in millimetres, a place of the screen is: what the line at the edge says."""
        area = self.picture_area()
        self.desk.move(area[0] + area[2] / 2, area[1] + area[3] + 20)  # off the picture
        wait("no place", lambda: not self.place_said())
        self.desk.move(x, y)
        return wait("the place under the pointer", self.place_said)

    def tooltip(self, x, y, beginning):
        """The tooltip at a place of the screen, one that begins so.  On a busy machine GTK loses the one it has
        prepared, and waits for the next motion: so the pointer moves by a dot until there is one."""
        shifts = itertools.cycle((0, -1))

        def shown():
            self.desk.move(x + next(shifts), y)
            try:
                return wait("a tooltip", lambda: next((text for text in self.floating() if text.startswith(beginning)),
                                                      None), HOVER)
            except Late:
                return None

        return wait("the tooltip " + beginning, shown)

    def floating(self):
        """Texts of the program's windows and of what pops up of them, tooltips among them."""
        for top in self.desk.reader.program(self.app.process.pid).children():
            for part in top.all("label"):
                yield part.name

    def map(self):
        """How millimetres become pixels: scale and where the origin is."""
        x, y, width, height = self.picture_area()
        middle = (round(x + width / 2), round(y + height / 2))
        step = round(min(width, height) / 4)
        first, second = self.pointed(*middle), self.pointed(middle[0] + step, middle[1] - step)
        scale = step / (second[0] - first[0])
        return scale, middle[0] - first[0] * scale, middle[1] + first[1] * scale

    def pixel(self, x_mm, y_mm):
        """Where on the screen a place of the scene's screen is."""
        scale, x, y = self.map()
        return x + x_mm * scale, y - y_mm * scale
