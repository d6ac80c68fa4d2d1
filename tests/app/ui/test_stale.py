# SPDX-License-Identifier: MIT
"""A scene that cannot be computed: the old picture is dimmed, the line below it says so and offers what mends it."""
from desk import trial
from waiting import wait

BACK = """luxel: 1
screen: {width: 700, height: 700, resolution: [200, 200]}
observer: {z: 1700}
surfaces:
  - {type: rectangle, name: plate, center: [0, 0, 300], size: [400, 400], axis: [0, 0, 1]}
lights:
  - {type: point, position: [420, 300, 1250], intensity: 10}
points: [[0, 0]]
"""


def not_this(window):
    return window.says("Not this scene: ")


def observer_too_low(tap, desk):
    window = desk.start().window()
    window.act("new", "report")
    x, y = window.pixel(100, 60)
    desk.move(x, window.picture_area()[1] + window.picture_area()[3] + 20)
    before_area = window.picture_area()
    before, bright = window.save(), wait("a bright place", lambda: desk.color(x, y)[0])
    slider = window.control("spin button", "Centre, z")
    slider.value = 2620
    said = wait("what is wrong", lambda: not_this(window))
    tap.ok("observer" in said and "2920" in said, "it is said that the picture is not of this scene, and why", said)
    dim = wait("another brightness", lambda: desk.color(x, y)[0] != bright and desk.color(x, y)[0])
    tap.ok(abs(dim - 0x52) < 0.5 * abs(bright - 0x52), "the picture is dimmed towards its ground", bright, dim)
    left, top, width, height = window.picture_area()
    area = window.control("label", said).area()
    edges = window.edges()
    tap.ok(edges[1] + area[1] > top + height and window.picture_area() == (left, top, width, height) == before_area,
           "it stands in the line below the picture, which stays where it was", area, before_area)
    desk.key("Escape")
    window.act("zoom-in")
    window.act("fit")
    tap.ok(not_this(window), "and cannot be closed while it is so")
    tap.ok(b"[0, 0, 2620]" in window.save(), "the document has what was set")
    button = wait("a repair", lambda: next((part for part in window.widget.all("button")
                                            if part.name.startswith("Mend: ")), None))
    tap.equal(button.name, "Mend: Observer, Height z: 3000 mm", "a button says what mends it")
    window.click(button)
    wait("the end of it", lambda: not not_this(window))
    scene = window.save()
    tap.ok(b"z: 3000" in scene and b"[0, 0, 2620]" in scene, "which it does")
    wait("the numbers of now", lambda: window.values() and window.values()[0] != "2.727591")
    window.act("undo")
    wait("the fault again", lambda: not_this(window))
    window.click(next(part for part in window.widget.all("button", "Undo") if part.has("sensitive") and
                      part.area()[1] > 60))
    wait("the good scene", lambda: not not_this(window))
    tap.equal(window.save(), before, "Undo beside it takes the change itself back")
    wait("full brightness", lambda: desk.color(x, y)[0] == bright)


def a_back(tap, desk):
    """A plate that shows its back leaves nothing to be seen: the line below says so, and one click turns it."""
    path = desk.path("back.yaml")
    with open(path, "w") as file:
        file.write(BACK)
    window = desk.start(path).window()
    window.control("spin button", "Axis, z").value = -1
    said = wait("what is wrong", lambda: window.says("shows the observer its back"))
    tap.ok("surfaces[0]" in said, "it is said why nothing is seen", said)
    button = wait("a repair", lambda: next((part for part in window.widget.all("button")
                                            if part.name.startswith("Mend: ")), None))
    tap.ok("Axis" in button.name, "a button says what mends it", button.name)
    window.click(button)
    wait("the end of it", lambda: not window.says("shows the observer its back"))
    tap.ok(b"axis: [0, 0, 1]" in window.save(), "the plate is turned", window.save())
    window.act("undo")
    wait("the back again", lambda: window.says("shows the observer its back"))
    tap.ok(not not_this(window), "the picture is of this scene")


def nothing_wrong_enters(tap, desk):
    """Range of values is a list with limits of its own; what is wrong in them changes nothing."""
    window = desk.start().window()
    window.press("Picture", "toggle button" if window.widget.find("toggle button", "Picture") else "button")
    scene, values = window.save(), window.values()
    window.click(window.control("combo box", "Range of values"))
    desk.key("End", "Return")
    low = window.control("text box", "Range of values, from")
    high = window.control("text box", "Range of values, to")
    wait("a range of one's own", lambda: b"range: [0, " in window.save())
    tap.equal((low.text, float(high.text) > 11), ("0", True), "it begins with the one in force")
    window.enter("Range of values, to", "8,5", "text box")
    wait("the range", lambda: b"range: [0, 8.5]" in window.save())
    steps = window.save()
    for text, reason in (("abc", "is not a number"), ("-3", "from a smaller value to a greater one")):
        window.enter("Range of values, to", text, "text box")
        tap.ok(wait("the reason", lambda: window.says(reason)), "%r is refused, and why is said" % text)
        tap.ok(high.has("invalid"), "and marked")
        tap.equal(window.save(), steps, "the document never has it")
        tap.ok(not not_this(window), "so the picture goes on")
    desk.key("Escape")
    wait("the limit that holds", lambda: high.text == "8.5")
    tap.ok(not window.says("from a smaller value"), "Esc brings the limit that holds back")
    while window.enabled("undo"):
        window.act("undo")
    tap.equal(window.save(), scene, "all of it can be undone")
    tap.equal(window.values(), values, "and no value has changed by it")


def entries(tap, desk):
    """Esc, Ctrl+Z and leaving a field bring back the value that holds."""
    window = desk.start().window()
    scene = window.save()
    field = window.enter("Intensity", "12abc")
    wait("the mark", lambda: field.has("invalid"))
    desk.key("Escape")
    wait("the value", lambda: field.text == "10")
    tap.ok(not field.has("invalid") and not window.says("is not a number"), "Esc restores a wrong entry")
    field = window.enter("Intensity", "12abc")
    wait("the mark", lambda: field.has("invalid"))
    desk.key("ctrl+z")
    tap.ok(wait("the value", lambda: field.text == "10"), "so does Ctrl+Z")
    window.enter("Intensity", "20")
    wait("the number", lambda: b"intensity: 20" in window.save())
    window.enter("Intensity", "-7")
    wait("the mark", lambda: field.has("invalid"))
    desk.key("ctrl+z")
    wait("the value that holds", lambda: field.text == "20")
    tap.ok(b"intensity: 20" in window.save(), "of which the scene knows nothing")
    desk.key("ctrl+z")
    wait("the step before", lambda: field.text == "10")
    tap.equal(window.save(), scene, "a second Ctrl+Z undoes what was done")
    window.enter("Intensity", "much", key="Tab")
    wait("the value", lambda: field.text == "10")
    tap.ok(not field.has("invalid") and window.says("“much” is not a number"),
           "a field that is left has its value again, and says why")
    window.enter("Intensity", "11", key=None)
    desk.key("Escape")
    tap.ok(wait("the value", lambda: field.text == "10"), "Esc takes back a good entry that was not made, too")
    window.press("Points", "toggle button" if window.widget.find("toggle button", "Points") else "button")
    place = window.enter("Point 2: x, y in mm", "60,5", "text box")
    tap.ok(wait("the mark", lambda: place.has("invalid")), "60,5 may be one number or two: it is not taken")
    desk.key("Escape")
    tap.ok(wait("the place", lambda: place.text == "150, 0"), "and Esc brings the place back")
    tap.equal(window.save(), scene, "the scene is as it was")


def bars(tap, desk):
    """Closing a bar leaves the panel where it is."""
    window = desk.start().window()
    window.act("open-path", desk.path("nowhere.yaml"))
    wait("the bar", lambda: window.says("nowhere.yaml"))
    label = window.control("label", "Radius")
    x, y = window.place(label)
    before = wait("the panel to rest", lambda: label.area()[1])
    top = window.edges()[1]
    area = next(part for part in window.widget.all("label") if "nowhere.yaml" in part.name).area()
    left, whole = window.edges()[0], window.widget.area()
    close = next(part for part in window.edge_buttons() if part.area()[2] > 0)  # the bar's own
    desk.click(left + close.area()[0] + close.area()[2] / 2, top + area[1] + area[3] / 2)
    wait("the bar to go", lambda: not window.says("nowhere.yaml"))
    desk.hand("sleep", "0.5")
    tap.ok(abs(label.area()[1] - before) < 70, "the form is not scrolled", before, label.area()[1])


trial(observer_too_low, a_back, nothing_wrong_enters, entries, bars)
