# SPDX-License-Identifier: MIT
"""The form at the left: rows are found by label and key in whichever section, and sections stay as they were left."""
from desk import trial
from waiting import wait


def look_for(desk, window, text):
    desk.key("ctrl+k")
    wait("the field", lambda: window.widget.find(None, "Search the form").has("focused") or
         any(part.has("focused") for part in window.widget.find(None, "Search the form").all()))
    desk.type(text)


def finds(tap, desk):
    window = desk.start().window()
    look_for(desk, window, "shinin")
    tap.ok(wait("what is found", lambda: [text for text in window.floating() if "material.shininess" in text]),
           "a row is found by its label, and its key is told")
    desk.key("Return")
    field = window.control("spin button", "Shininess n")
    tap.ok(wait("the keyboard", lambda: field.has("focused")), "Enter gives it the keyboard")
    tap.equal(window.widget.find("checkbox", "Isophotes"), None, "a section is shut")
    look_for(desk, window, "isophotes")
    wait("what is found", lambda: [text for text in window.floating() if text.startswith("Isophotes\n")])
    desk.key("Return")
    box = window.control("checkbox", "Isophotes")
    tap.ok(wait("the keyboard", lambda: box.has("focused")), "and opened where a row of it is chosen")
    panel = window.panel()
    tap.ok(wait("the row in view", lambda: panel[1] <= box.area()[1] <= panel[1] + panel[3] - box.area()[3]),
           "which is scrolled into view")


def remembers(tap, desk):
    desk.environment["GSETTINGS_BACKEND"] = "keyfile"
    app = desk.start()
    window = app.window()
    tap.ok(window.widget.find("spin button", "Shininess n"), "the material is open at first")
    window.press("Material", None)
    window.press("Picture", None)
    wait("the section", lambda: window.widget.find("checkbox", "Isophotes"))
    app.quit()
    window = desk.start().window()
    tap.ok(wait("the section", lambda: window.widget.find("checkbox", "Isophotes")), "what was opened is open again")
    tap.equal(window.widget.find("spin button", "Shininess n"), None, "and what was shut is shut")


trial(finds, remembers)
