# SPDX-License-Identifier: MIT
"""Stillness: nothing moves under a dragging hand, and the columns of the line at the edge stay where they are."""
from desk import trial
from waiting import wait

ROLES = ("button", "toggle button", "checkbox", "combo box", "spin button", "entry", "image", "tab", "list",
         "list item")
GAP = 8  # dots between columns, at the least
GROUND = 8  # how far a dot of the ground may be from it


def layout(window):
    """Where everything is that has a place of its own: what can be pressed, the pictures, the lists."""
    return [(role, widget.name, widget.area()) for widget in window.widget.all() for role in (widget.role,)
            if role in ROLES]


def line(window):
    """The label of the line at the edge, where the pointer is on a surface."""
    return next((label for label in window.edge() if label.name.startswith("x ") and "\tP (" in label.name), None)


def strip(desk, window, label):
    """Whether there is ink in each column of dots of the line at the edge; and that of each dot."""
    x, y, width, height = label.area()
    left, top = window.edges()
    data = desk.screen(round(left + x), round(top + y), width, height)
    ground = data[-3:]  # its end stays empty
    ink = [[max(abs(data[3 * (row * width + column) + k] - ground[k]) for k in range(3)) > GROUND
            for row in range(height)] for column in range(width)]
    return [any(column) for column in ink], ink


def starts(inked):
    """Where ink begins behind a wide gap."""
    return [x for x in range(GAP, len(inked)) if inked[x] and not any(inked[x - GAP:x])]


def drag_moves_nothing(tap, desk):
    """A lamp on the picture, and one in the plan, is dragged step by step; at each step all stands as before."""
    window = desk.start("three-lights").window()
    scale, x, y = window.map()
    place = (x, y + 100 * scale)  # off the lamps, on the surface
    start = window.save()
    window.pointed(*place)
    desk.click(*place)  # which chooses the surface
    desk.hand("mousedown", 1)
    before = layout(window)
    moved, seen = [], start
    for step in range(1, 6):
        desk.move(place[0] + 7 * step, place[1] - 5 * step)
        scene = wait("the next step", lambda: window.save() if window.save() != seen else None)
        seen = scene
        now = layout(window)
        moved += [pair for pair in zip(before, now) if pair[0] != pair[1]] if len(now) == len(before) else [len(now)]
    desk.hand("mouseup", 1)
    tap.ok(seen != start, "the surface follows the hand")
    tap.equal(moved[:4], [], "and nothing else in the window moves")


def columns_stay(tap, desk):
    """The line at the edge: each of its columns begins at one place, whatever is read."""
    window = desk.start("three-lights").window()
    scale, x, y = window.map()
    desk.move(x, y)
    label = wait("the line at the edge", lambda: line(window))  # found once, as each look takes its time

    def drawn(before=None):
        """The line when it stands on the screen, which is later than it is told."""
        seen = strip(desk, window, label)
        return seen if seen[1] != before and len(starts(seen[0])) >= label.name.count("\t") else None

    inked, first = wait("its ink", drawn)
    texts, moved, ink = {label.name}, [], first
    columns = starts(inked)[-label.name.count("\t"):]
    tap.equal(len(columns), 5, "place, normal, value, grey level and sources are seen apart")
    for place in ((-83.4, 47.6), (61, -80), (-60, -90), (7, 103), (110, 3)):
        desk.move(x + place[0] * scale, y - place[1] * scale)
        wait("other numbers", lambda: label.name not in texts and "\tgrey" in label.name)
        inked, ink = wait("their ink", lambda last=ink: drawn(last))
        texts.add(label.name)
        for number, column in enumerate(columns):
            is_apart = not any(inked[column - 2:column - 1]) and any(inked[column:column + 4])
            has_letter = number == 2 or ink[column:column + 5] == first[column:column + 5]  # a value begins as it likes
            if not (is_apart and has_letter):
                moved.append((place, column, label.name))
    tap.equal(len(texts), 6, "each place has its own numbers")
    tap.equal(moved, [], "which begin where those of the others do")


def narrow(tap, desk):
    """Where there is no room for all columns the normal goes, and the sources' shares stay."""
    window = desk.start("three-lights").window()
    for width, has_normal in ((1380, True), (1000, False), (1380, True)):
        desk.hand("windowsize", "--sync", window.screen_id, width, 700)
        wait("the size", lambda: abs(window.widget.area()[2] - width) < 80)

        def told():
            desk.move(*window.pixel(0, 0))
            label = line(window)
            return label and ("\tN (" in label.name) == has_normal and "\tsources 1: " in label.name

        tap.ok(wait("the line", told), "%d dots: %s" % (width, "with the normal" if has_normal else "without"))


trial(drag_moves_nothing, columns_stay, narrow)
