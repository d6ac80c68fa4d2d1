# SPDX-License-Identifier: MIT
"""luxel help KEY: every key of a scene is explained, however it is written."""
import re

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
    of_material, others = tool.run("help", "material.shininess").out, "surfaces[].materials.floor.shininess"
    tap.ok(shininess.out.startswith(of_material) and others in shininess.out and others not in of_material and
           shininess.out.count("the exponent of the highlight") == 1, "help material.shininess", shininess)
    tap.ok("nodes" in tool.run("help", "sampling").out, "choices are listed")
    tap.ok("required" in tool.run("help", "screen.width").out, "a required key")
    group = tool.run("help", "screen")
    tap.ok(group.code == 0 and "screen.resolution" in group.out, "a group lists its keys", group)
    kind = tool.run("help", "spot")
    tap.ok(kind.code == 0 and "lights[].falloff" in kind.out, "a type lists its keys", kind)
    described = tool.run("help", "render", "--json").json()
    tap.equal((described["command"], described["options"][0]["name"]), ("render", "output"), "a command as JSON")
    for word, said in (("luminance", "cd/m²"), ("Lux", "lx"), ("яркость", "cd/m²"), ("ЛЮКС", "lx"), ("Ёж", None),
                       ("candela", "cd"), ("cd", "cd"), ("W", "watt"), ("W/sr", "intensity"), ("IES", "LM-63"),
                       ("irradiance", "W/m²"), ("ambient light", None), ("UGR", "luxel glare"),
                       ("glare rating", "UGR"), ("daylight factor", "luxel daylight"), ("en12464", "spacing: en12464"),
                       ("EN 12464", "spacing: en12464"), ("workplane", "grids"), ("work plane", "grids"),
                       ("Рабочая плоскость", "grids"), ("array", "points"), ("dimming", "maintenance_factor"),
                       ("LLF", "maintenance_factor"), ("maintenance factor", "maintenance_factor"),
                       ("light output ratio", "luxel photometry"), ("polar diagram", "luxel photometry")):
        result = tool.run("help", word)
        tap.ok(result.code == (0 if said else 2) and (not said or said in result.out), "a word: " + word, result)
        for line in re.findall(r"^  (luxel (?:help|grid).*)$", result.out.split("\nSee:")[-1], re.M) if said else []:
            tap.equal(tool.run(*line.split()[1:]).code, 0, word + " leads to " + line)
    glare = tool.run("help", "UGR").out
    command = re.search(r"^  luxel (glare .*)$", glare, re.M).group(1)
    tap.ok("not computed" not in glare and tool.run(*command.split()).code == 0, "glare is computed", glare)
    words = tool.run("help", "lux", "--json").json()
    tap.ok(words["keys"] == [] and words["words"][0]["see"], "a word as JSON", words)


def rules(tap, tool):
    for topic, words in (("lights[].k", "required with attenuation: practical"), ("axis", "excludes aim"),
                         ("aim", "excludes axis"), ("inner", "at most outer"), ("aim", "must differ from position"),
                         ("observer.z", "must be > 0 with projection: perspective"),
                         ("shininess", "has effect only with model: blinn-phong, phong")):
        result = tool.run("help", topic)
        tap.ok(words in " ".join(result.out.split()), "help %s: %s" % (topic, words), result)
    told = tool.run("help", "lights[].k").out
    tap.equal(told.count("lights[].k"), 1, "a key is not the same for itself")
    keys = {(key["path"], key["of_type"]): key["rules"] for key in tool.run("help", "--json").json()["keys"]}
    tap.ok({"rule": "excludes", "key": "aim", "choices": None} in keys["lights[].axis", "spot"], "rules as JSON")
    tap.equal(keys["screen.width", None], [], "a key without rules")


def kinds(tap, tool):
    kinds = tool.run("help", "--json").json()["kinds"]
    choices = {key["path"]: key["choices"] for key in tool.run("help", "--json").json()["keys"]}
    for name in "surfaces", "lights":
        tap.equal(", ".join(kind["name"] for kind in kinds if kind["list"] == name), choices[name + "[].type"],
                  "the kinds of " + name)
    for kind in kinds:
        result = tool.run("help", kind["name"])
        tap.ok(kind["meaning"] in " ".join(result.out.split()) and (kind["example"] or "") in result.out,
               "help %s has its meaning and an example" % kind["name"], result)
    tap.equal([kind["name"] for kind in kinds if not kind["example"]], ["mesh", "points", "luminaire"],
              "those that need a file have none")
    both = tool.run("help", "points").out
    tap.ok(both.startswith("points\n") and "points of the list lights" in both and "lights[].file" in both,
           "a key and a kind of one name", both)


def commands(tap, tool):
    usage = tool.run("help").out
    for command in re.findall(r"^  (\w+)  +\w", usage, re.M):
        text = tool.run("help", command).out
        tap.ok(text.startswith("Usage: luxel " + command) and "Examples:" in text, "help " + command, text)
        for code in "0 done", "2 wrong usage", "3 a scene", "4 a file", "5 a tolerance", "130 interrupted":
            tap.ok(code in " ".join(text.split()), "help %s tells exit code %s" % (command, code.split()[0]))
        own = text.split("\n%s of the list" % command)[0]  # what follows tells of a kind of surface of that name
        tap.ok(max(map(len, own.split("\n"))) <= 100, "help %s is not too wide" % command)


run_tests(Tap(), every_key, forms, rules, kinds, commands)
