# SPDX-License-Identifier: MIT
"""What helps to begin: the pictures of scenes and recent files, and the hint until a mark was dragged."""
from desk import luxel, trial
from waiting import wait


def card(window, start):
    """The first card whose name begins so."""
    return wait("a card of %s" % start, lambda: next(
        (button for button in window.widget.all("button") if button.name.startswith(start)), None))


def names(window, group):
    """What the cards of a group are called."""
    return [button.name.split(":")[0] for widget in window.widget.all(name=group) for button in widget.all("button")]


def colors(desk, window, widget):
    left, top = window.edges()
    x, y, width, height = widget.area()
    data = desk.screen(round(left + x), round(top + y), width, height)
    return {tuple(data[i:i + 3]) for i in range(0, len(data), 3)}


def pictures(tap, desk):
    path = desk.path("own.yaml")
    with open(path, "wb") as file:
        file.write(luxel("scene", "tin"))
    app = desk.start()
    window = app.window()
    desk.key("F2")
    first = card(window, "report: ")
    found = names(window, "Built-in scenes")
    listed = [line.split()[0] for line in luxel("scene", "--list").decode().splitlines()]
    tap.equal(sorted(found), sorted(listed), "the built-in scenes are there, each once")
    tap.ok(wait("its picture", lambda: len(colors(desk, window, first)) > 100), "with their pictures")
    desk.key("Escape")
    tap.ok(wait("the scene", lambda: window.state("gallery") is False), "Esc goes back to the scene")
    window.toggle("Scenes").act()
    card(window, "three-lights: ").act()
    tap.ok(wait("the scene", lambda: window.title == "three-lights – Luxel"), "a card opens its scene")
    tap.equal(window.state("gallery"), False, "and the pictures are gone")
    window.act("open-path", path)
    wait("the file", lambda: app.windows()[-1].name == "own.yaml – Luxel")
    window.act("gallery")
    own = card(window, "own.yaml: ")
    tap.equal(names(window, "Recent files"), ["own.yaml"], "recent files come first")
    tap.ok(wait("its picture", lambda: len(colors(desk, window, own)) > 100), "with their pictures, too")
    own.act()
    tap.ok(wait("the file", lambda: window.title == "own.yaml – Luxel"), "and are opened")


def keys(tap, desk):
    window = desk.start().window()
    desk.key("F2")
    first = card(window, "report: ")
    tap.ok(wait("the focus", lambda: first.has("focused")), "the first card has the keyboard")
    desk.key("c")
    desk.key("Right", "Return")
    tap.ok(wait("another scene", lambda: not window.title.startswith("report")), "arrows and Enter choose")
    tap.equal(window.state("false-color"), False, "keys of the picture do nothing meanwhile")


def hint(tap, desk):
    desk.environment["GSETTINGS_BACKEND"] = "keyfile"
    app = desk.start()
    window = app.window()
    picture = window.widget.find("image")
    tap.ok(wait("the hint", lambda: picture.description), "the first scene says that its lamp can be dragged")
    x, y, width, height = window.picture_area()
    lamp = (x + width - 20, y + height / 2)

    def dragged():
        desk.drag(lamp, (x + width - 90, y + height / 2 - 60))
        return not picture.description

    tap.ok(wait("no hint", dragged), "and no longer when it was")
    app.quit()
    app = desk.start()
    window = app.window()
    tap.equal(window.widget.find("image").description, "", "nor when the program starts anew")


trial(pictures, keys, hint)
