# SPDX-License-Identifier: MIT
"""Completion in the shells that are installed here: test_completion.py LUXEL BASH_SCRIPT ZSH_SCRIPT FISH_SCRIPT."""
import os
import re
import sys

import shells
from tap import Tap
from tool import run_tests

# (line, every word that is offered); words are what stands in the place of the last one.
EXACT = [
    ("luxel rend", "render"),
    ("luxel sch", "schema"),
    ("luxel render --qua", "--quantity"),
    ("luxel render --quantity ", "brightness irradiance luminance illuminance"),
    ("luxel render --quantity b", "brightness"),
    ("luxel probe --precision ", "single double"),
    ("luxel probe --poi", "--point --points"),
    ("luxel --json render --qua", "--quantity"),
    ("luxel render --threads 2 --precision d", "double"),
    ("luxel render --bits ", "16 8"),
    ("luxel figure --palette c", "cividis coolwarm"),
    ("luxel photometry --spacing ", "0.25 1"),
    ("luxel photometry --room 4,", "4,2 4,3 4,4 4,6 4,8 4,12"),
    ("luxel scene thr", "three-lights"),
    ("luxel scene --lis", "--list"),
    ("luxel render my", "my.yaml"),
    ("luxel render -q my", "my.yaml"),
    ("luxel check -- -od", "-odd.yaml"),
    ("luxel help shini", "shininess"),
    ("luxel help probe", "probe"),
    ("luxel help spo", "spot"),
    ("luxel set my.yaml units", "units="),
    ("luxel set my.yaml -q screen.width=5 lights.0.att", "lights.0.attenuation="),
    ("luxel set my.yaml -o new", "new.yaml new.yml new.json"),
    ("luxel render my.yaml my", ""),
    ("luxel render -s units", "units="),
    ("luxel render -s screen.w", "screen.width="),
    ("luxel render --set screen.samp", "screen.sampling="),
    ("luxel render -s lights.3.att", "lights.3.attenuation="),
    ("luxel render -s surfaces.0.material.over", "surfaces.0.material.over_pi="),
    ("luxel figure office --grid f", "floor"),
    ("luxel figure named.yaml --grid ", "desk"),
    ("luxel figure -q named.yaml --title x --grid d", "desk"),
    ("luxel render named.yaml --lights ", "key fill"),
    ("luxel probe --quantity irradiance named.yaml --lights f", "fill"),
    ("luxel figure two-spheres --grid ", ""),
    ("luxel figure broken.yaml --grid ", ""),
    ("luxel check --names ", "grids lights"),
]

# (line, words that are offered, words that are not)
SOME = [
    ("luxel ", "render probe grid figure report check scene schema help", "window my.yaml"),
    ("luxel render --", "--output --set --quantity --json --quiet --help --version", "--point --list"),
    ("luxel probe --", "--point --at --set --output", "--list --palette"),
    ("luxel --", "--help --version", "--output --json"),
    ("luxel render ", "report spot two-spheres my.yaml", "notes.txt render"),
    ("luxel scene ", "report spot", "my.yaml render"),
    ("luxel schema ", "", "report my.yaml render"),
    ("luxel grid -o sphere", "sphere.csv", "sphere.png sphere.npy"),
    ("luxel figure -o sphere", "sphere.png sphere.svg sphere.pdf", "sphere.npy"),
    ("luxel figure --section ", "report my.yaml", "center maximum"),
    ("luxel render -o sphere", "sphere.png sphere.npy sphere.pfm", "report"),
    ("luxel render -o sphere.p", "sphere.png sphere.pfm", "sphere.npy"),
    ("luxel help ", "render intensity spot screen", "my.yaml"),
    ("luxel render -s obs", "observer.z= observer.view=", "observer= screen.width="),
    ("luxel render -s li", "lights.0.intensity= lights.0.type=", "lights= lights[].intensity="),
]

# (line, the line after Tab) on a terminal, by bash and by zsh
INSERTED = [
    ("luxel rend", "luxel render ", None),
    ("luxel render --quantity=b", "luxel render --quantity=brightness ", None),
    ("luxel render --quan", "luxel render --quantity ", "luxel render --quantity="),
    ("luxel render -s screen.w", "luxel render -s screen.width=", None),
    ("luxel render -s observer.view=obs", "luxel render -s observer.view=observer ", None),
    ("luxel render -s lights.2.attenuation=pr", "luxel render -s lights.2.attenuation=practical ", None),
    ("luxel render -s 'lights[2].patt", "luxel render -s 'lights[2].pattern=", None),
    ("luxel render -s 'lights[2].pattern=lam", "luxel render -s 'lights[2].pattern=lambertian' ", None),
    ("luxel render -s lights[2].patt", "luxel render -s lights[2].pattern=", r"luxel render -s lights\[2\].pattern="),
    ("luxel render --set=units=ph", "luxel render --set=units=photometric ", None),
    ("luxel figure --section=max", "luxel figure --section=maximum ", None),
    ("luxel render -o pic/sphere.n", "luxel render -o pic/sphere.npy ", None),
    ("luxel check my", "luxel check my.yaml ", None),
    ("luxel check 'two w", "luxel check 'two words.yaml' ", None),
    ("luxel check pi", "luxel check pic/", None),
    ("luxel figure office --grid fl", "luxel figure office --grid floor ", None),
    ("luxel figure office --grid desk", r"luxel figure office --grid desk\ at\ the\ w", None),
    ("luxel figure office --grid 'desk at the wi", "luxel figure office --grid 'desk at the window' ", None),
    ("luxel render named.yaml --lights key,f", "luxel render named.yaml --lights key,fill ",
     "luxel render named.yaml --lights key,fill"),
]

NAMED = """luxel: 1
screen: {width: 500, height: 500, resolution: [50, 50]}
observer: {z: 2000}
surfaces: [{type: sphere, center: [0, 0, 1000], radius: 200}]
lights:
  - {type: point, name: key, position: [900, 900, 2000], intensity: 10}
  - {type: point, position: [0, 900, 2000], intensity: 5}
  - {type: point, name: fill, position: [-900, 0, 2000], intensity: 5}
grids: [{name: desk, center: [0, 0, 0], size: [100, 100], n: [2, 2]}]
"""


def files(folder):
    os.makedirs(os.path.join(folder, "pic"))
    with open(os.path.join(folder, "named.yaml"), "w") as file:
        file.write(NAMED)
    with open(os.path.join(folder, "broken.yaml"), "w") as file:
        file.write("lights: [")
    for name in "my.yaml", "-odd.yaml", "notes.txt", "two words.yaml":
        open(os.path.join(folder, name), "w").close()


def offered(tap, shell):
    for line, words in EXACT:
        tap.equal(shell.offers(line), set(words.split()), "%s: %s" % (shell.name, line))
    for line, wanted, unwanted in SOME:
        offers = shell.offers(line)
        tap.ok(set(wanted.split()) <= offers and not set(unwanted.split()) & offers, "%s: %s" % (shell.name, line),
               sorted(offers))


def every_command(tap, tool, shell):
    usage = tool.run("help").out
    commands = set(re.findall(r"^  (\w+)  +\w", usage, re.M))
    tap.equal(shell.offers("luxel ") & commands, commands, "%s: every command" % shell.name)
    for command in sorted(commands):
        page = tool.run("help", command).out.split("\nExamples:")[0]
        own, common = page.split("\nCommon options, ")
        options = set(re.findall(r"^ +(?:-\w, )?(--[\w-]+)", own, re.M)) | set(re.findall(r"--[\w-]+", common))
        tap.ok(options, "luxel %s has options" % command)
        # fish offers an option that may have a value in two forms, --csv and --csv=
        offers = {word.rstrip("=") for word in shell.offers("luxel %s --" % command) if word.startswith("--")}
        tap.equal(offers, options,
                  "%s: every option of %s" % (shell.name, command))


def every_key(tap, tool, shell):
    keys = tool.run("help", "--json").json()["keys"]
    paths = {key["path"].replace("[]", ".0") for key in keys}
    leaves = {path + "=" for path in paths if not any(other.startswith(path + ".") for other in paths)}
    tap.equal(shell.offers("luxel render -s "), leaves, "%s: every key" % shell.name)


def completion(tap, tool):
    for shell in shells.installed(tool.folder, sys.argv[2:5]):
        files(shell.folder)
        tap.run(offered, tap, shell)
        tap.run(every_command, tap, tool, shell)
        tap.run(every_key, tap, tool, shell)
        for line, after, after_in_zsh in INSERTED if shell.inserted else ():
            wanted = after_in_zsh if shell.name == "zsh" and after_in_zsh else after
            tap.equal(shell.inserted(line), wanted, "%s: Tab after %s" % (shell.name, line))


run_tests(Tap(), completion)
