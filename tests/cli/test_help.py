# SPDX-License-Identifier: MIT
"""luxel help KEY: every key of a scene is explained, however it is written."""
from tap import Tap
from tool import run_tests


def every_key(tap, tool):
    keys = tool.run("help", "--json").json()["keys"]
    tap.ok(len(keys) > 40, "keys are listed")
    for path in sorted({key["path"] for key in keys}):
        result = tool.run("help", path)
        tap.ok(result.code == 0 and result.out.startswith(path + "\n"), "help " + path, result)
        last = path.split(".")[-1]
        result = tool.run("help", last)
        tap.ok(result.code == 0 and path in result.out or last == "help", "help " + last, result)
    for key in keys:
        tap.ok(key["meaning"] and key["type"], "%s of %s has a meaning and a type" % (key["path"], key["of_type"]), key)


def forms(tap, tool):
    expected = tool.run("help", "lights[].intensity")
    for topic in "lights[0].intensity", "lights.0.intensity", "lights[12].intensity":
        tap.equal(tool.run("help", topic).out, expected.out, "help " + topic)
    for text in "W/sr", "point", "spot", "0.01", "10000":
        tap.ok(text in expected.out, "the intensity's help has " + text, expected)
    shininess = tool.run("help", "shininess")
    for text in "surfaces[].material.shininess", "number", "20", "1", "500":
        tap.ok(text in shininess.out, "the shininess's help has " + text, shininess)
    tap.equal(tool.run("help", "material.shininess").out, shininess.out, "help material.shininess")
    tap.ok("nodes" in tool.run("help", "sampling").out, "choices are listed")
    tap.ok("required" in tool.run("help", "screen.width").out, "a required key")
    group = tool.run("help", "screen")
    tap.ok(group.code == 0 and "screen.resolution" in group.out, "a group lists its keys", group)
    kind = tool.run("help", "spot")
    tap.ok(kind.code == 0 and "lights[].falloff" in kind.out, "a type lists its keys", kind)
    tap.equal(tool.run("help", "render", "--json").code, 2, "a command has no JSON help")


run_tests(Tap(), every_key, forms)
