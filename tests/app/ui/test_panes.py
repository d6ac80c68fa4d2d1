# SPDX-License-Identifier: MIT
"""The panes at the sides keep the widths that a hand gave them in windows of any size: small, large, maximized."""
import shutil
import subprocess

from desk import trial
from waiting import wait

NEAR = 3  # pixels
LEAST_SHARE = 0.45  # of the window's area that the picture has


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
    resize(desk, window, 1300, 800)
    app.quit()
    window = desk.start().window()
    tap.ok(near(wait("the width", lambda: widths(window)[2]), wider), "a divider that a hand moved stays there", wider,
           widths(window))


def share_of_picture(window):
    width, height = window.widget.find("image").area()[2:]
    return width * height / (window.widget.area()[2] * window.widget.area()[3])


def picture_first(tap, desk, language):
    window = desk.start(LANGUAGE=language).window()
    resize(desk, window, 1024, 700)
    tap.ok(wait("the share of the picture", lambda: share_of_picture(window) >= LEAST_SHARE),
           "%s: the picture has its share of a small window" % language, share_of_picture(window))
    window.press({"en": "Points", "ru": "Точки"}[language], "tab")
    beginning = {"en": "Values: ", "ru": "Величина: "}[language]
    said = wait("what the values are", lambda: next((label for label in window.widget.all("label")
                                                     if label.name.startswith(beginning) and label.area()[2]), None))
    tap.ok(wait("room for it", lambda: said.area()[0] + said.area()[2] <= window.widget.area()[2]),
           "%s: what is said below the table of points is not cut off" % language, said.area())
    window.press({"en": "Plan", "ru": "План"}[language], "tab")
    before = window.picture_area()
    window.act("open-path", "/nowhere.yaml")
    wait("what is wrong", lambda: window.says("/nowhere.yaml"))
    desk.hand("sleep", "0.7")  # until the message has come in
    tap.equal(window.picture_area(), before, "%s: a message does not move the picture" % language)
    x, y, width, height = before
    window.pointed(x + width / 2, y + height / 2)
    tap.equal(window.picture_area(), before, "%s: nor does what is under the pointer" % language)


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


trial(small_and_large, english, russian, maximized)
