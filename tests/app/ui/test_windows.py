# SPDX-License-Identifier: MIT
"""Two windows have nothing to do with one another; what was not saved in one that was closed is offered later."""
from desk import trial
from waiting import wait


def two_windows(tap, desk):
    app = desk.start()
    first = app.window()
    app.act("new-window")
    second = app.window(2)
    values, own = first.values(), second.values()
    second.enter("Intensity", "20")
    wait("the second one's numbers", lambda: second.values() != own)
    first.act("source-add", "spot")
    wait("the first one's numbers", lambda: first.values() != values)
    tap.equal((len(first.sources()), len(second.sources())), (2, 1), "each has its own sources")
    tap.ok(b"intensity: 20" in second.save() and b"intensity: 20" not in first.save(), "and its own scene")
    second.act("undo")
    wait("the undo", lambda: second.values() == own)
    tap.ok(not second.enabled("undo") and first.enabled("undo"), "each has its own history")
    second.enter("Intensity", "30")
    wait("unsaved work", lambda: second.title.startswith("•"))
    expected = first.save()
    second.raise_()
    desk.key("ctrl+w")
    wait("one window", lambda: len(app.windows()) == 1)
    tap.equal(first.save(), expected, "closing one leaves the other as it is")
    first.act("source-delete")
    tap.equal(len(wait("its list", first.sources)), 1, "and alive")
    first.act("undo")
    first.save()
    app.quit()
    again = desk.start().window()
    wait("the offer", lambda: again.says("Unsaved work was found"))
    again.press("Restore")
    wait("the restored scene", lambda: again.title.startswith("•"))
    tap.ok(b"intensity: 30" in again.save(), "what was not saved in the closed window is offered at the next start")


trial(two_windows)
