# SPDX-License-Identifier: MIT
"""The date of a sun, and of that of a sky: it is typed, and its label is dragged through the hours of its day."""
import re

from desk import trial
from waiting import wait

YARD = b"""\
luxel: 1
screen: {width: 6000, height: 6000, resolution: [8, 8]}
observer: {z: 9000}
surfaces:
  - {type: rectangle, center: [0, 0, 0], size: [6000, 6000]}
lights:
  - {type: sun, irradiance: 800, date: "2026-03-21T12:00+01:00", latitude: 50, longitude: 15}
  - {type: sky, kind: 12, zenith: 10, sun: {date: "2026-03-21T12:00+01:00", latitude: 50, longitude: 15}}
points: [[0, 0]]
"""


def dates(window):
    """Of the sun and of the sky, as they are in the scene."""
    return re.findall(rb'date: "?([^",}]*)', window.save())


def yard(desk):
    with open(desk.path("yard.yaml"), "wb") as file:
        file.write(YARD)
    return desk.start(desk.path("yard.yaml")).window()


def typed(tap, desk):
    window = yard(desk)
    values = window.values()
    field = window.enter("Date", "2026-06-21T12:00+01:00", "text box")
    wait("other numbers", lambda: window.values() != values)
    tap.equal(dates(window)[0], b"2026-06-21T12:00+01:00", "a date that is typed is taken")
    for wrong in ("2026-13-01T12:00", "2026-06-21T23:30+01:00", "noon"):
        window.enter("Date", wrong, "text box")
        tap.ok(wait("the mark", lambda: field.has("invalid")), "nor one of no day, night or form: " + wrong)
        tap.equal(dates(window)[0], b"2026-06-21T12:00+01:00", "and the scene keeps its own")
        desk.key("Escape")
        wait("the date that holds", lambda: field.text == "2026-06-21T12:00+01:00")
    window.act("undo")
    tap.ok(wait("the numbers of before", lambda: window.values() == values), "undo takes it back")


def drag(window, name, dots, **how):
    x, y = window.place(window.control("label", name))
    window.desk.drag((x, y), (x + dots, y), **how)
    return dates(window)


def dragged(tap, desk):
    window = yard(desk)
    values = window.values()
    tap.equal(drag(window, "Date", 75), [b"2026-03-21T15:00+01:00", b"2026-03-21T12:00+01:00"],
              "the label of a date is dragged by hours, and the rest of it stays")
    wait("other numbers", lambda: window.values() != values)
    tap.equal(window.control("text box", "Date").text, "2026-03-21T15:00+01:00", "the field follows")
    window.act("undo")
    tap.ok(wait("the numbers of before", lambda: window.values() == values), "one undo takes the drag back")
    tap.equal(drag(window, "Date", -20, held=("shift",))[0], b"2026-03-21T11:55+01:00", "with Shift by minutes")
    tap.equal(drag(window, "Date", 60, held=("ctrl",))[0], b"2026-03-21T14:00+01:00", "with Ctrl to full hours")
    before = dates(window)[0]
    last = drag(window, "Date", 180, steps=40)[0]
    tap.ok(before < last < b"2026-03-21T18:30+01:00", "the sun is not dragged below the horizon", last)
    field = window.control("text box", "Date")
    tap.equal(field.text.encode(), last, "the field has what holds when the hand is off")
    desk.key("2")
    wait("the sky's rows", lambda: window.control("text box", "Date").text == "2026-03-21T12:00+01:00")
    tap.equal(drag(window, "Date", -75), [last, b"2026-03-21T09:00+01:00"], "so is that of a sky's sun")


trial(typed, dragged)
