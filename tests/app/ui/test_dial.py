# SPDX-License-Identifier: MIT
"""The colour bar as a dial: ends and exposure by mouse, keys and names; lock and logarithm; the needle."""
from desk import trial
from waiting import wait

NEEDLE = (204, 26, 26)


def shown(window, name):
    """What a slider of the dial says of itself, as a number."""
    return float(window.control("slider", name).description.split()[0])


def becomes(tap, name, question):
    tap.ok(wait(name, question), name)


def turns(tap, desk):
    window = desk.start().window()
    low, high, exposure = (window.control("slider", name) for name in
                           ("Lower end of the scale", "Upper end of the scale", "Exposure"))
    lock = window.toggle("Lock range")
    scene, start = window.save(), shown(window, "Upper end of the scale")
    length = exposure.area()[2] - 44
    x, y = window.place(high)
    desk.drag((x, y), (x - length / 4, y))
    becomes(tap, "a drag of the upper end takes it to the value that stood there",
            lambda: abs(shown(window, "Upper end of the scale") - 0.75 * start) < 0.02 * start)
    becomes(tap, "and locks the range", lambda: lock.has("pressed") or lock.has("checked"))
    x, y = window.place(low)
    desk.drag((x, y), (x + length / 3, y))
    becomes(tap, "the lower end likewise",
            lambda: abs(shown(window, "Lower end of the scale") - 0.25 * start) < 0.02 * start)
    before = shown(window, "Lower end of the scale")
    desk.key("Left")
    becomes(tap, "an arrow moves the end that was taken", lambda: shown(window, "Lower end of the scale") < before)
    lock.act()
    becomes(tap, "without the lock the range is the picture's again",
            lambda: shown(window, "Lower end of the scale") == 0 and shown(window, "Upper end of the scale") == start)
    x, y = window.place(exposure)
    desk.drag((x, y), (x + 45, y))
    becomes(tap, "a drag between the ends is a stop of exposure for each 45 pixels",
            lambda: exposure.description == "+1.00 EV")
    becomes(tap, "after which the last colour stands for half the value",
            lambda: abs(shown(window, "Upper end of the scale") - start / 2) < 1e-3 * start)
    desk.key("Right", "shift+Left")
    becomes(tap, "arrows change it, too", lambda: exposure.description == "+0.25 EV")
    window.act("reset-display")
    becomes(tap, "and R resets it", lambda: exposure.description == "+0.00 EV")
    window.toggle("Logarithmic scale").act()
    becomes(tap, "logarithmic the range is four decades",
            lambda: abs(shown(window, "Lower end of the scale") - start * 1e-4) < 1e-6 * start)
    tap.equal(window.save(), scene, "none of it changes the scene")


def needle(tap, desk):
    window = desk.start().window()
    bar = window.control("slider", "Exposure")
    left, top = window.edges()
    area = bar.area()
    frame = tuple(round(number) for number in (left + area[0], top + area[1], area[2], area[3]))

    def place():
        data = desk.screen(*frame)
        found = [i // 3 % frame[2] for i in range(0, len(data), 3) if tuple(data[i:i + 3]) == NEEDLE]
        return sum(found) / len(found) if found else None

    desk.move(*window.pixel(0, 0))
    highest = shown(window, "Upper end of the scale")

    def stands_right():
        text, middle = window.says("P ("), place()
        if not text or middle is None:
            return False
        return abs(middle - 22 - (area[2] - 44) * float(text.split(")")[-1].split()[0]) / highest) < 2

    becomes(tap, "the needle stands at the pointer's value", stands_right)
    desk.move(frame[0] + frame[2] / 2, frame[1] + frame[3] - 4)
    becomes(tap, "and goes with the pointer", lambda: place() is None)


trial(turns, needle)
