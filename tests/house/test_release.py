# SPDX-License-Identifier: MIT
"""What a release is made by: the version in all places, recipes for other systems, archives of the same bytes, the page
of changes and the bill of materials.

Argument: the project's folder.
"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

import yaml

from tap import Tap

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
import deterministic_zip  # noqa: E402
import release_pages  # noqa: E402

VERSION = re.search(r"^  version: '([\d.]+)'", (ROOT / "meson.build").read_text(encoding="utf-8"), re.M).group(1)
tap = Tap()


def version(root, *arguments):
    command = [sys.executable, root / "tools/version", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout.strip(), done.stderr


def versions():
    """One place decides; another one is told, and all are written."""
    tap.equal(version(ROOT, "--check"), (0, VERSION, ""), "the version stands everywhere")
    with tempfile.TemporaryDirectory() as place:
        copy = pathlib.Path(place)
        for name in ("meson.build", "include/luxel/version.h", "debian/changelog", "CHANGELOG.md", "tools/version",
                     "data/desktop/org.luxel.Luxel.metainfo.xml.in", "packaging/conda/recipe.yaml",
                     "packaging/homebrew/luxel.rb"):
            (copy / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, copy / name)
        header = copy / "include/luxel/version.h"
        text = header.read_text(encoding="utf-8")
        header.write_text(re.sub(r"(VERSION_MINOR) \d+", r"\1 77", text), encoding="utf-8")
        code, _, told = version(copy, "--check")
        tap.ok(code != 0 and "version.h: 77" in told, "another version is told", told)
        tap.equal(version(copy, "--set", "3.14.15"), (0, "3.14.15", ""), "a new one is written")
        tap.equal(version(copy, "--check"), (0, "3.14.15", ""), "to all places")
        tap.ok("VERSION_PATCH 15" in header.read_text(encoding="utf-8"), "and its numbers")
        tap.ok(version(copy, "--set", "3.14")[0] != 0, "what is no version is refused")


def recipes():
    """That what the core cannot do without is named."""
    texts = {name: (ROOT / "packaging" / name).read_text(encoding="utf-8")
             for name in ("conda/recipe.yaml", "homebrew/luxel.rb", "flatpak/org.luxel.Luxel.yml")}
    built = (ROOT / "meson.build").read_text(encoding="utf-8")
    wanted = re.findall(r"^(?:fyaml|png|zlib) = dependency\('(\w+)'", built, re.M)
    tap.equal(wanted, ["libfyaml", "libpng", "zlib"], "what meson.build needs")
    conda = yaml.safe_load(texts["conda/recipe.yaml"])
    host = {line.split()[0] for line in conda["requirements"]["host"]}
    tap.ok({*wanted, "openexr", "cairo", "pango", "meson-python"} <= host, "conda: libraries", host)
    brewed = set(re.findall(r'depends_on "([\w-]+)"$', texts["homebrew/luxel.rb"], re.M))
    tap.ok({"libfyaml", "libpng", "openexr", "cairo", "pango"} <= brewed, "homebrew: libraries", brewed)
    flatpak = yaml.safe_load(texts["flatpak/org.luxel.Luxel.yml"])
    modules = [module["name"] for module in flatpak["modules"]]
    tap.equal(modules, ["libfyaml", "imath", "openexr", "luxel"], "flatpak: modules")
    sums = [source["sha256"] for module in flatpak["modules"] for source in module["sources"] if "url" in source]
    tap.ok(len(sums) == 3 and all(re.fullmatch("[0-9a-f]{64}", each) for each in sums), "flatpak: sums", sums)
    options = (ROOT / "meson_options.txt").read_text(encoding="utf-8")
    given = {option for text in texts.values() for option in re.findall(r"-D([a-z]\w*)=", text)}
    tap.ok(given and all(f"option('{name}'" in options for name in given), "options that there are", given)


def archives():
    """The same files give the same bytes, whatever their dates and the order of the folder."""
    with tempfile.TemporaryDirectory() as place:
        sums = []
        for names in ("abc", "cba"):
            folder = pathlib.Path(place, names)
            for name in names:
                (folder / name).mkdir(parents=True)
                (folder / name / "text").write_text(name, encoding="utf-8")
                os.utime(folder / name / "text", (ord(names[0]) * 1e7, 0))
            target = folder.with_suffix(".zip")
            deterministic_zip.pack(target, deterministic_zip.files_of(folder, "in"))
            sums.append(hashlib.sha256(target.read_bytes()).hexdigest())
        tap.equal(sums[0], sums[1], "archives")


def options():
    """A build folder that was made with other options is made anew, and another one stays."""
    with tempfile.TemporaryDirectory() as place:
        meson = pathlib.Path(place, "meson")
        meson.write_text('#!/bin/sh\ntouch "$2/build.ninja"\n', encoding="utf-8")
        meson.chmod(0o755)
        for given, stays in (("-Da=1", False), ("-Da=1", True), ("-Da=2", False), ("", False)):
            command = f". tools/programs; MESON={meson}; configure {place}/build {given}; ls {place}/build"
            done = subprocess.run(["sh", "-ec", command], cwd=ROOT, capture_output=True, text=True, check=False)
            tap.equal(done.stdout.split(), ["build.ninja"] + ["object"] * stays + ["options"], f'options "{given}"')
            pathlib.Path(place, "build/object").touch()


def sources():
    """The archive of the sources makes itself again where there is no Git."""
    with tempfile.TemporaryDirectory() as place:
        sums = []
        for root in (ROOT, pathlib.Path(place, f"luxel-{VERSION}")):
            target = pathlib.Path(place, f"{len(sums)}.tar.gz")
            subprocess.run([root / "tools/source_archive", target], check=True,
                           env=os.environ | {"SOURCE_DATE_EPOCH": "1700000000"})
            with tarfile.open(target) as archive:
                sums.append({entry.name: (entry.mode, entry.isfile() and archive.extractfile(entry).read())
                             for entry in archive if "/." not in entry.name})
                archive.extractall(place)
        tap.ok(len(sums[0]) > 1000, "files", len(sums[0]))
        beside = {name: content for name, (_, content) in sums[0].items() if name.count("/") == 1 and content}
        tap.equal([name for name, content in beside.items() if b"\0" in content], [], "no picture lies beside them")
        tap.ok(sums[0] == sums[1], "the sources", sorted(set(sums[0]) ^ set(sums[1])))


def pages():
    page = release_pages.page("# A `b`\n\nText <1>\nand **more**.\n\n- one\n  of two\n- two\n\n## C\n", "1.2.3")
    body = page[page.index("<h1>"):]
    tap.equal(body, "<h1>A <code>b</code></h1>\n<p>Text &lt;1&gt; and <b>more</b>.</p>\n<ul>\n<li>one of two</li>\n"
                    "<li>two</li>\n</ul>\n<h2>C</h2>\n</html>\n", "the page of changes")
    with tempfile.TemporaryDirectory() as place:
        pathlib.Path(place, "luxel-1.2.3-linux-x86_64.tar.gz").write_bytes(b"content")
        release_pages.main(place, "1.2.3", "0")
        told = json.loads(pathlib.Path(place, "luxel-1.2.3.cdx.json").read_text(encoding="utf-8"))
        first = told["components"][0]
        tap.equal((first["name"], first["hashes"][0]["content"]),
                  ("luxel-1.2.3-linux-x86_64.tar.gz", hashlib.sha256(b"content").hexdigest()), "the bill of materials")
        names = {part["bom-ref"] for part in told["components"]}
        tap.ok(all(set(part["dependsOn"]) <= names for part in told["dependencies"]), "names what it lists")


for test in (versions, recipes, archives, options, sources, pages):
    tap.run(test)
tap.finish()
