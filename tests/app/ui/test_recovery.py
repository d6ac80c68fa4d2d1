# SPDX-License-Identifier: MIT
"""What was not saved when the program ended is offered at the next start, byte for byte."""
import os

from desk import luxel, trial
from waiting import wait


def kept(desk):
    """The files of unsaved work."""
    folder = desk.path("state_home", "luxel")
    return [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".unsaved")]


def after_a_crash(tap, desk):
    path = desk.path("own.yaml")
    with open(path, "wb") as file:
        file.write("# Свет лампы\n".encode() + luxel("scene", "report"))
    app = desk.start(path)
    window = app.window()
    tap.equal(kept(desk), [], "what is as it was saved is not kept")
    window.enter("Intensity", "12.25")
    files = wait("the unsaved work to be kept", lambda: kept(desk))
    tap.equal(len(files), 1, "it is kept in one file")
    tap.equal(os.stat(files[0]).st_mode & 0o777, 0o600, "which nobody else may read")
    wait("the last change", lambda: "12.25" in open(files[0], encoding="utf-8").read())
    app.kill()
    with open(path, "rb") as file:
        expected = file.read().replace(b"intensity: 10", b"intensity: 12.25")

    again = desk.start().window()
    said = wait("the offer", lambda: again.says("Unsaved work was found", "own.yaml"))
    tap.note(said)
    tap.equal(again.values()[0], "2.727591", "until it is taken, the scene is the built-in one")
    again.press("Restore")
    wait("its title", lambda: "own.yaml" in again.title)
    tap.ok(again.title.startswith("•"), "what was restored counts as not saved", again.title)
    wait("its numbers", lambda: again.values()[0] != "2.727591")
    tap.equal(again.save(path), expected, "it is what was lost, byte for byte")
    wait("nothing to be kept", lambda: not kept(desk))
    tap.ok(not again.title.startswith("•"), "once saved, nothing is kept", again.title)


def refused(tap, desk):
    app = desk.start()
    window = app.window()
    window.act("source-duplicate")
    wait("the unsaved work", lambda: kept(desk))
    tap.equal(app.quit(), 0, "it ends in order")
    tap.equal(len(kept(desk)), 1, "unsaved work is kept by an end in order, too")
    again = desk.start()
    window = again.window()
    wait("the offer", lambda: window.says("Unsaved work was found", "a new scene with 2 sources"))
    window.press("Restore")
    wait("the work", lambda: len(window.sources()) == 2)
    tap.equal(window.title, "• a new scene – Luxel", "restored, it has a name")
    tap.equal(again.quit(), 0, "it is left once more")
    again = desk.start()
    window = again.window()
    wait("the offer", lambda: window.says("Unsaved work was found", "a new scene"))
    window.press("Discard")
    wait("the work to go", lambda: not kept(desk))
    tap.equal(window.sources(), ["1  point"], "discarded, it is gone")
    tap.ok(wait("what was done", lambda: window.says("Unsaved work was discarded", "2 sources")), "which is said")
    window.press("Restore")
    wait("the work", lambda: len(window.sources()) == 2)
    tap.ok(True, "and can be taken back")
    wait("the unsaved work", lambda: kept(desk))
    tap.equal(again.quit(), 0, "it is left once more")
    again = desk.start()
    window = again.window()
    wait("the offer", lambda: window.says("Unsaved work was found"))
    window.press("Discard")
    wait("the work to go", lambda: not kept(desk))
    window.press("Close")
    wait("the bar to go", lambda: not window.says("Unsaved work was discarded"))
    again.quit()
    window = desk.start().window()
    tap.ok(not window.says("Unsaved work was found"), "and not offered again")


trial(after_a_crash, refused)
