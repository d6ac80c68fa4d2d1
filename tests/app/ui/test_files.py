# SPDX-License-Identifier: MIT
"""What the app writes is what the tool writes, byte for byte; scenes keep their comments; pictures bring them back."""
import json
import os

from gi.repository import GLib

from desk import luxel, trial
from waiting import wait

EXPORTS = [("png8", ".png", []), ("png16", ".png", ["--bits", "16"]), ("exr", ".exr", []), ("npy", ".npy", []),
           ("csv", ".csv", [])]


def read(path):
    with open(path, "rb") as file:
        return file.read()


def export(desk, window, name, ending):
    path = desk.path("by-the-app-%s%s" % (name, ending))
    window.act("export-path", GLib.Variant("(ss)", (name, path)))
    wait("the file", lambda: os.path.exists(path))
    wait("a word about it", lambda: window.says("saved", path))
    return path


def exports(tap, desk):
    window = desk.start().window()
    window.enter("Position, y", "700")
    window.enter("Intensity", "12,5")
    wait("the changes", lambda: b"position: [2000, 700, 2000], intensity: 12.5" in window.save())
    scene = desk.path("exported.yaml")
    window.save(scene)
    for quantity in ("brightness", "irradiance"):
        window.act("quantity", quantity)
        for name, ending, options in EXPORTS:
            own = desk.path("by-the-tool-%s%s" % (name, ending))
            luxel("render", scene, "-q", "-o", own, "--quantity", quantity, *options)
            path = export(desk, window, name, ending)
            tap.ok(read(path) == read(own), "%s of %s is that of luxel render" % (name, quantity))
            os.remove(path)
    window.act("quantity", "brightness")
    for name, ending, start in (("figure-svg", ".svg", b"<?xml"), ("figure-pdf", ".pdf", b"%PDF"),
                                ("figure-png", ".png", b"\x89PNG"), ("report", ".pdf", b"%PDF")):
        tap.ok(read(export(desk, window, name, ending)).startswith(start), "%s is what its name says" % name)


def the_screen_does_not_count(tap, desk):
    """Zoom, colours and exposure are the view's own."""
    window = desk.start().window()
    plain = read(export(desk, window, "png8", ".png"))
    window.act("zoom-in")
    window.act("false-color")
    window.act("isophotes")
    os.remove(desk.path("by-the-app-png8.png"))
    tap.ok(read(export(desk, window, "png8", ".png")) == plain, "the view changes nothing of what is exported")


def there_and_back(tap, desk):
    path = desk.path("own.yaml")
    text = (b"# \xd0\xa1\xd1\x86\xd0\xb5\xd0\xbd\xd0\xb0, with a comment\r\n"
            + luxel("scene", "three-lights").replace(b"\n", b"   # kept\n", 3) + b"# the end\n")
    with open(path, "wb") as file:
        file.write(text)
    app = desk.start(path)
    window = app.window()
    tap.equal(window.save(), text, "a scene that was not touched is saved as it was read")
    window.enter("Intensity", "41.5")
    tap.equal(wait("the change", lambda: b"41.5" in window.save() and window.save()),
              text.replace(b"intensity: 40", b"intensity: 41.5"), "one that was changed differs in that value alone")
    picture = export(desk, window, "png16", ".png")
    window.act("open-path", picture)
    other = app.window(2)
    wait("its sources", lambda: len(other.sources()) == 3)
    tap.equal(other.values(), window.values(), "a picture is opened as the scene that it carries, with its numbers")
    again = export(desk, other, "png8", ".png")
    other.save(desk.path("saved-again.yaml"))
    luxel("render", desk.path("saved-again.yaml"), "-q", "-o", desk.path("tool.png"))
    tap.ok(read(again) == read(desk.path("tool.png")), "and exports the same picture")
    tap.ok(b"41.5" in other.save(), "with the value as it was changed")


def nowhere(tap, desk):
    window = desk.start().window()
    window.act("save-path", desk.path("no-such-folder", "a.yaml"))
    tap.ok(wait("a word about it", lambda: window.says("no-such-folder")), "what cannot be written is said")
    tap.ok(window.values(), "and the work goes on")


def not_opened(tap, desk):
    """A file that is none: what is wrong with it, and that what stands in the window is another scene."""
    path = desk.path("picture.png")
    with open(path, "wb") as file:
        file.write(bytes(range(128, 256)) + bytes(range(64)))
    window = desk.start(path).window()
    tap.ok(wait("the fault", lambda: window.says("picture.png:1:1", "not a text file")), "what is wrong")
    tap.ok(window.says("was not opened. Still shown: "), "and what is shown instead", window.labels())


def outside(tap, desk):
    """Another program changes the file: it is read anew, but for unsaved work, which is asked about and not lost."""
    path, text = desk.path("shared.yaml"), luxel("scene", "report")

    def write(intensity):
        with open(path + "~", "wb") as file:
            file.write(text.replace(b"intensity: 10", b"intensity: %d" % intensity))
        os.replace(path + "~", path)  # as most editors do

    def of_file():
        return ["%.7g" % point["value"] for point in json.loads(luxel("probe", path, "--json"))["points"]]

    write(10)
    window = desk.start(path).window()
    write(33)
    tap.ok(wait("the file as it is", lambda: window.values() == of_file()), "a file without unsaved work is read anew")
    window.enter("Intensity", "12")
    wait("unsaved work", lambda: window.title.startswith("•"))
    write(44)
    tap.ok(wait("the question", lambda: window.says("Another program has changed ", "shared.yaml")), "else it is asked")
    window.act("save")
    tap.ok(b"intensity: 44" in read(path), "saving overwrites nothing")
    window.press("Overwrite the file")
    wait("the file", lambda: b"intensity: 12" in read(path))
    tap.ok(not window.says("Another program"), "the work here holds where that is wished")
    window.enter("Intensity", "13")
    wait("unsaved work", lambda: window.title.startswith("•"))
    write(55)
    wait("the question", lambda: window.says("Another program"))
    window.press("Read the file")
    tap.ok(wait("the file as it is", lambda: window.values() == of_file()), "or that of the file")
    window.enter("Intensity", "14")
    window.act("save")
    wait("the file", lambda: b"intensity: 14" in read(path))
    tap.ok(not window.says("Another program"), "what is saved here is no change of another program")


trial(outside, exports, the_screen_does_not_count, there_and_back, nowhere, not_opened)
