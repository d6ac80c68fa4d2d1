# SPDX-License-Identifier: MIT
"""The panes at the sides keep the widths that a hand gave them in windows of any size: small, large, maximized."""
import shutil
import subprocess

from desk import trial
from waiting import wait

NEAR = 3  # pixels
LEAST_SHARES = {(1024, 700): 0.5, (1280, 800): 0.5, (1600, 1000): 0.6}  # of the window's area that the picture has


def widths(window):
    """Of the panel on the left, the picture, and what stands at its right."""
    picture, whole = window.widget.find("image").area(), window.widget.area()
    return window.panel()[2], picture[2], whole[2] - picture[0] - picture[2]


def near(found, expected):
    return abs(found - expected) <= NEAR


def resize(desk, window, width, height):
    desk.hand("windowsize", "--sync", window.screen_id, width, height)
    wait("the size", lambda: abs(window.widget.area()[2] - width) < 80)
    desk.hand("sleep", "0.5")


def small_and_large(tap, desk):
    desk.environment["GSETTINGS_BACKEND"] = "keyfile"
    app = desk.start()
    window = app.window()
    left, _middle, right = wait("the widths", lambda: widths(window)[0] > 0 and widths(window))
    resize(desk, window, 960, 700)
    resize(desk, window, 1380, 860)
    tap.ok(wait("the widths of before", lambda: near(widths(window)[0], left) and near(widths(window)[2], right)),
           "a window that was small gives the panes their widths back", (left, right), widths(window))
    resize(desk, window, 960, 700)
    app.quit()
    app = desk.start()
    window = app.window()
    resize(desk, window, 1380, 860)
    tap.ok(near(widths(window)[2], right), "what a small window made of them is not kept", right, widths(window))
    # by a hand
    edge = window.picture_area()
    x, y = edge[0] + edge[2] + 3, edge[1] + edge[3] / 2
    desk.drag((x, y), (x - 120, y))
    wider = wait("a wider pane", lambda: widths(window)[2] > right + 100 and widths(window)[2])
    resize(desk, window, 1360, 800)
    app.quit()
    window = desk.start().window()
    tap.ok(near(wait("the width", lambda: widths(window)[2]), wider), "a divider that a hand moved stays there", wider,
           widths(window))


def share_of_picture(window):
    width, height = window.widget.find("image").area()[2:]
    return width * height / (window.widget.area()[2] * window.widget.area()[3])


def steady(tap, window, what, before):
    window.desk.hand("sleep", "0.5")  # until all that comes has come
    tap.equal((window.panel(), window.picture_area()), before, what)


def picture_first(tap, desk, language):
    """The picture has its share at three sizes, and nothing that comes or goes moves it."""
    desk.environment["LANGUAGE"] = language
    window = desk.start().window()
    for (width, height), least in LEAST_SHARES.items():
        resize(desk, window, width, height)
        tap.ok(wait("the share of the picture", lambda: share_of_picture(window) >= least),
               "%s: the picture has its share of %d x %d" % (language, width, height), share_of_picture(window))
        title = window.control("label", "report – Luxel")
        tap.ok(title.area()[2] >= 60, "%s: the title is not cut" % language, title.area())
        before = window.panel(), window.picture_area()
        window.act("why")
        x, y, wide, high = window.picture_area()
        window.pointed(x + wide / 2, y + high / 3)
        wait("the card", lambda: window.says("x = ", "y = "))
        steady(tap, window, "%s: Why? moves nothing" % language, before)
        window.act("why")
        window.act("pin")
        wait("a comparison", lambda: window.enabled("unpin"))
        steady(tap, window, "%s: nor does a picture that is pinned" % language, before)
        window.act("unpin")
        window.act("open-path", "/nowhere.yaml")
        wait("what is wrong", lambda: window.says("/nowhere.yaml"))
        steady(tap, window, "%s: nor does a message" % language, before)
    resize(desk, window, 1024, 700)
    before = window.panel(), window.picture_area()
    tap.equal(window.panes()[2], None, "%s: in a small window the numbers are a drawer, which is shut" % language)
    window.act("numbers")
    wait("the drawer", lambda: window.panes()[2])
    steady(tap, window, "%s: it opens over the picture" % language, before)
    window.press({"en": "Points", "ru": "Точки"}[language], "tab")
    beginning = {"en": "Values: ", "ru": "Величина: "}[language]
    said = wait("what the values are", lambda: next((label for label in window.widget.all("label")
                                                     if label.name.startswith(beginning) and label.area()[2]), None))
    tap.ok(wait("room for it", lambda: said.area()[0] + said.area()[2] <= window.widget.area()[2]),
           "%s: what is said below the table of points is not cut off" % language, said.area())
    window.act("numbers")
    tap.ok(wait("no drawer", lambda: not window.panes()[2]), "%s: and goes" % language)
    resize(desk, window, 1380, 860)
    tap.ok(wait("the numbers", lambda: window.panes()[2]), "%s: a large window has them beside the picture" % language)


def english(tap, desk):
    picture_first(tap, desk, "en")


def russian(tap, desk):
    picture_first(tap, desk, "ru")


def maximized(tap, desk):
    if not shutil.which("openbox"):
        tap.skip("maximized windows", "no window manager (openbox) is installed")
        return
    manager = subprocess.Popen(["openbox"], env=desk.environment, stderr=subprocess.DEVNULL)
    desk.children.append(manager)
    desk.environment["GSETTINGS_BACKEND"] = "keyfile"
    desk.hand("sleep", "1")
    found = []
    for _ in range(3):
        app = desk.start()
        window = app.window()
        if not found:
            window.press("Maximize")
        wait("the whole screen", lambda: window.widget.area()[2] > desk.size[0] - 60)
        desk.hand("sleep", "0.7")
        found.append(widths(window))
        app.quit()
    tap.ok(all(near(one[2], found[0][2]) and near(one[1], found[0][1]) for one in found),
           "each maximized window has the picture as large as the one before", found)
    tap.ok(found[0][2] < 420, "and no more of it is given to the numbers than a hand gave them", found)


trial(small_and_large, english, russian, maximized, size=(1700, 1100))
