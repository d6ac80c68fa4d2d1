# SPDX-License-Identifier: MIT
"""What is taken home: the results as one text, the picture by a button, a report with the name of who hands it in."""
import json
import subprocess

from gi.repository import GLib

from desk import luxel, tool, trial
from waiting import wait


def copied(tap, desk):
    window = desk.start().window()
    path = desk.path("copied.yaml")
    window.save(path)
    found = json.loads(luxel("stats", path, "--json"))
    points = json.loads(luxel("probe", path, "--json"))["points"]
    window.press("Copy results")
    text = wait("the results", lambda: "P3" in desk.copied() and desk.copied())
    lines = dict(line.split("\t", 1) for line in text.split("\n"))
    maximum = lines["Maximum of the pixels"]
    tap.ok(maximum.startswith("%.7g\tx = " % found["max"]["value"]), "the maximum, and where", text)
    tap.ok("Least value above 0" in lines, "the least value above 0")
    tap.equal([lines["P%d" % (i + 1)].split("\t")[0] for i in range(3)], ["%.7g" % point["value"] for point in points],
              "and the points, as luxel probe prints them")
    window.press("Statistics", "tab")
    wait("the true maximum", lambda: "%.7g" % found["maximum"]["value"] in window.labels())
    tap.ok(window.says("Least value above 0"), "which the statistics list as well")
    tap.equal([text for text in window.labels() if "e-1" in text and "," in text], [], "no place is a rounding error")
    window.press("Copy results")
    tap.ok(wait("the true maximum", lambda: "True maximum\t%.7g" % found["maximum"]["value"] in desk.copied()),
           "once it is known the true maximum is copied, too")


def report(tap, desk):
    app = desk.start()
    window = app.window()
    before = app.on_screen()
    window.act("export", "report")
    opened = wait("the question", lambda: app.on_screen() - before)
    desk.hand("windowfocus", "--sync", *opened)
    # a source has a group as well
    root = wait("its fields", lambda: next((part for part in desk.reader.program(app.process.pid).children()
                                            if part.name == "What the report says of itself"), None))
    for name, text in (("Author", "A. Student"), ("Group", "M-41")):
        wait(name, lambda: root.find("text box", name)).text = text
    root.find("button", "Continue").act()
    chooser = wait("a file to write", lambda: app.on_screen() - before - opened)
    desk.hand("windowfocus", "--sync", *chooser)
    desk.key("Escape")
    wait("the end of it", lambda: app.on_screen() == before)
    path = desk.path("report.pdf")
    window.act("export-path", GLib.Variant("(ss)", ("report", path)))
    wait("the report", lambda: window.says("saved: ", path))
    text = subprocess.run([tool("pdftotext"), path, "-"], capture_output=True, check=True).stdout.decode()
    tap.ok("A. Student" in text and "M-41" in text, "the report names its author and group", text[:600])


def picture(tap, desk):
    app = desk.start()
    window = app.window()
    before = app.on_screen()
    window.press("Save picture")
    opened = wait("a file to write", lambda: app.on_screen() - before)
    tap.ok(opened, "a button in sight saves the picture")
    desk.hand("windowfocus", "--sync", *opened)
    desk.key("Escape")
    wait("the end of it", lambda: app.on_screen() == before)


trial(copied, report, picture)
