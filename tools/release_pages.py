#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is told of a release: release_pages.py FOLDER VERSION SECONDS writes changelog.html, of CHANGELOG.md, and
luxel-VERSION.cdx.json, its bill of materials (CycloneDX 1.5): each file with its sum, and the libraries inside."""
import datetime
import hashlib
import html
import json
import pathlib
import re
import subprocess
import sys
import urllib.parse
import uuid

ROOT = pathlib.Path(__file__).resolve().parents[1]
LICENCES = {"libfyaml": "MIT", "libpng1.6": "libpng-2.0", "zlib": "Zlib", "openexr": "BSD-3-Clause",
            "imath": "BSD-3-Clause", "musl": "MIT", "cairo": "LGPL-2.1-only OR MPL-1.1", "libffi": "MIT",
            "pcre2": "BSD-3-Clause", "glib2.0": "LGPL-2.1-or-later", "fribidi": "LGPL-2.1-or-later",
            "harfbuzz": "MIT", "pango1.0": "LGPL-2.0-or-later", "pixman": "MIT", "glibc": "LGPL-2.1-or-later",
            "mingw-w64": "ZPL-2.1 AND MIT", "gcc-mingw-w64": "GPL-3.0-or-later WITH GCC-exception-3.1"}
# C libraries and what belongs to compilers: the package whose version is theirs.
OF_PACKAGES = {"musl": "emscripten", "glibc": "libc6", "mingw-w64": "mingw-w64-common",
               "gcc-mingw-w64": "gcc-mingw-w64-x86-64-posix"}
DRAWING = ["cairo", "libffi", "pcre2", "glib2.0", "fribidi", "harfbuzz", "pango1.0", "pixman"]
# What is inside of which files, by their names; archives of programs bring the page, too.
INSIDE = [(r"-windows-|-linux-|\.whl$|\.tgz$|\.html$|-page\.zip$", ["libfyaml", "libpng1.6", "zlib"]),
          (r"-windows-|-linux-|\.whl$", ["openexr", "imath"]),
          (r"-windows-|-win_amd64", ["mingw-w64", "gcc-mingw-w64"] + DRAWING),
          (r"-linux-", ["glibc"]),
          (r"-windows-|-linux-|\.tgz$|\.html$|-page\.zip$", ["musl"])]
STYLE = "body{font:16px/1.5 sans-serif;max-width:50em;margin:2em auto;padding:0 1em}code{font-size:.9em}"


def inline(text):
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    text = re.sub(r"\*\*([^*]*)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\[([^]]*)\]\((https?:[^)]*)\)", r'<a href="\2">\1</a>', text)


def blocks(markdown):
    """Headings, paragraphs and items of lists: their kind and text."""
    kind, lines = None, []
    for line in markdown.splitlines() + [""]:
        heading, item = re.match(r"(#+) (.*)", line), re.match(r"- (.*)", line)
        if lines and (not line.strip() or heading or item):
            yield kind, " ".join(lines)
            kind, lines = None, []
        if heading:
            yield f"h{len(heading[1])}", heading[2]
        elif item:
            kind, lines = "li", [item[1]]
        elif line.strip():
            kind, lines = kind or "p", lines + [line.strip()]


def page(markdown, version):
    body, in_list = [], False
    for kind, text in blocks(markdown):
        if (kind == "li") != in_list:
            body.append("</ul>" if in_list else "<ul>")
            in_list = not in_list
        body.append(f"<{kind}>{inline(text)}</{kind}>")
    end = "</ul>\n" if in_list else ""
    return (f'<!doctype html>\n<html lang="en">\n<meta charset="utf-8" />\n'
            f'<meta name="viewport" content="width=device-width" />\n<title>Luxel {version}: what is new</title>\n'
            f"<style>{STYLE}</style>\n" + "\n".join(body) + f"\n{end}</html>\n")


def versions():
    """Those of libraries that are built here, by their sources, and of others."""
    found = {}
    for place in ("build/linux", "build/windows", "build-web"):
        sources = ROOT / place / "libraries/sources"
        for path in [*sources.glob("*/debian/changelog"), *sources.glob("drawing/*/debian/changelog")]:
            name, version = re.match(r"(\S+) \(([^)]+)\)", path.read_text(encoding="utf-8")).groups()
            found[name] = version
        for path in sources.glob("drawing/pixman-*/"):  # which comes without Debian's changes
            found["pixman"] = path.name.removeprefix("pixman-")
    for name, package in OF_PACKAGES.items():
        query = ["dpkg-query", "-W", "-f=${Version}", package]
        told = subprocess.run(query, capture_output=True, text=True, check=False)
        if told.returncode == 0:
            found[name] = told.stdout
    return found


def component(name, version):
    source = "emscripten" if name == "musl" else name
    return {"type": "library", "bom-ref": name, "name": name, "version": version,
            "licenses": [{"expression": LICENCES[name]}],
            "purl": f"pkg:deb/debian/{source}@{urllib.parse.quote(version)}?arch=source"}


def materials(folder, version, seconds):
    libraries = {name: found for name, found in sorted(versions().items()) if name in LICENCES}
    files, dependencies = [], []
    for path in sorted(folder.iterdir()):
        if path.suffix == ".json" or path.name in ("SHA256SUMS", "changelog.html"):
            continue
        files.append({"type": "file", "bom-ref": path.name, "name": path.name, "version": version,
                      "hashes": [{"alg": "SHA-256", "content": hashlib.sha256(path.read_bytes()).hexdigest()}],
                      "licenses": [{"expression": "MIT AND Apache-2.0"}]})
        inside = [name for pattern, names in INSIDE if re.search(pattern, path.name) for name in names]
        dependencies.append({"ref": path.name, "dependsOn": [name for name in inside if name in libraries]})
    sums = "".join(file["hashes"][0]["content"] for file in files)
    return {"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
            "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, sums)}",
            "metadata": {"timestamp": datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc).isoformat(),
                         "component": {"type": "application", "bom-ref": "luxel", "name": "luxel", "version": version}},
            "components": files + [component(name, found) for name, found in libraries.items()],
            "dependencies": [{"ref": "luxel", "dependsOn": [file["bom-ref"] for file in files]}] + dependencies}


def main(place, version, seconds):
    folder = pathlib.Path(place)
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    (folder / "changelog.html").write_text(page(text, version), encoding="utf-8")
    told = json.dumps(materials(folder, version, int(seconds)), indent=2, ensure_ascii=False)
    (folder / f"luxel-{version}.cdx.json").write_text(told + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
