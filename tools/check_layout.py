#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface of the structures: programs that were compiled earlier find their members where they were.

    check_layout.py ROOT CAIRO CC... -- TABLE...            the test
    check_layout.py ROOT CAIRO CC... -- TABLE... --update   takes new structures and members into the tables

CAIRO is the folder of cairo's headers, CC the compiler's command.  A table, tests/abi/NAME_1.layout, has each structure
of the library's headers with its size, and under it its members with their offsets and sizes, as a small program prints
them where long and pointers have 8 bytes.  What may change of them stands in luxel.h, "Growth".
"""
import os
import re
import subprocess
import sys
import tempfile

HEAD = ("# SPDX-License-Identifier: MIT\n"
        "# Structures of %s: size; members: offset and size.  `make abi` adds what is new.\n")
FIGURE = ("figure.h", "drawing.h")
ADVICE = """New members take the place of `reserved`, or stand behind the last one of what the library alone makes:
luxel.h, "Growth".  Anything else breaks programs that were compiled earlier and takes a new soname; then remove
the structure from %s by hand and run `make abi`."""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def structures(root, headers):
    """Each structure of the headers with its members, and whether it may grow: the library alone makes it."""
    text = "".join(re.sub(r"/\*.*?\*/", "", read(os.path.join(root, "include", "luxel", header)), flags=re.DOTALL)
                   for header in headers)
    found = {}
    for name, body in re.findall(r"^typedef struct (\w+) \{(.*?)^\} \1;", text, re.DOTALL | re.MULTILINE):
        members = [re.search(r"\(\*(\w+)\)|(\w+)(?:\[\w+\])*$", member.strip()) for member in body.split(";")[:-1]]
        handed_out = r"\b%s_free\(%s \*|const %s \*\w+_(?:get|kind)\(" % (name, name, name)
        found[name] = ([match.group(1) or match.group(2) for match in members], bool(re.search(handed_out, text)))
    if len(found) != text.count("typedef struct") - len(re.findall(r"typedef struct \w+ \w+;", text)):
        sys.exit("a structure is written in another way than the others")
    return found


def measured(root, cairo, command, headers, found):
    """The size of each structure, with offset and size of its members; None where a long has other than 8 bytes."""
    lines = ["#include <luxel/%s>" % header for header in headers] + ["#include <stdio.h>", "int main(void) {"]
    lines.append('printf("long %zu %zu\\n", sizeof(long), sizeof(void *));')
    for name, (members, _) in found.items():
        lines.append('printf("%s %%zu\\n", sizeof(%s));' % (name, name))
        lines += ['printf("    %s %%zu %%zu\\n", offsetof(%s, %s), sizeof(((%s *)0)->%s));'
                  % (member, name, member, name, member) for member in members]
    with tempfile.TemporaryDirectory() as folder:
        source, program = os.path.join(folder, "layout.c"), os.path.join(folder, "layout")
        with open(source, "w", encoding="utf-8") as file:
            file.write("\n".join(["#include <stddef.h>"] + lines + ["return 0; }\n"]))
        folders = ["-I" + os.path.join(root, "include")] + (["-isystem", cairo] if cairo else [])
        subprocess.run(command + folders + [source, "-o", program], check=True)
        first, _, text = subprocess.run([program], capture_output=True, text=True, check=True).stdout.partition("\n")
    return parsed(text) if first == "long 8 8" else None


def parsed(text):
    table = {}
    for line in text.splitlines():
        words = line.split()
        if line.startswith("    "):
            members[words[0]] = (int(words[1]), int(words[2]))
        elif words and not line.startswith("#"):
            members = {}
            table[words[0]] = (int(words[1]), members)
    return table


def faults(known, now, grows):
    """What programs of the table would miss in a structure as it is now."""
    size, members = known
    if size > now[0] or (size != now[0] and not grows):
        yield "its size was %d and is %d" % (size, now[0])
    for member, place in members.items():
        if member != "reserved" and now[1].get(member) != place:
            yield "%s was at %d of size %d and is %s" % ((member,) + place + (
                "gone" if member not in now[1] else "at %d of size %d" % now[1][member],))
    for member, place in now[1].items():
        inside = members.get("reserved", (size, 0))
        if member not in members and place[0] < inside[0]:
            yield "%s stands among the members that were there" % member


def main():
    root, cairo, rest = sys.argv[1], sys.argv[2], sys.argv[3:]
    split = rest.index("--")
    from tap import Tap
    tap = Tap()
    for path in [argument for argument in rest[split + 1:] if argument != "--update"]:
        name = os.path.basename(path)
        every = sorted(file for file in os.listdir(os.path.join(root, "include", "luxel")) if file.endswith(".h"))
        headers = [file for file in every if (file in FIGURE) == name.startswith("luxel-figure")]
        found = structures(root, headers)
        now = measured(root, cairo, rest[:split], headers, found)
        known = parsed(read(path)) if os.path.exists(path) else {}
        broken = ["%s: %s" % (one, fault) for one in known for fault in
                  (faults(known[one], now[one], found[one][1]) if now and one in now else ["it is gone"])]
        if now is None:
            tap.skip(name, "long or pointers have other than 8 bytes")
        elif "--update" not in rest:
            tap.ok(known and not broken, name + ": programs find what they were compiled with",
                   *broken + [ADVICE % name])
            new = [one for one in now if now[one] != known.get(one)]
            tap.ok(broken or not new, name + ": every structure stands there as it is (`make abi` takes new members)",
                   *new)
        elif broken:
            sys.exit("\n".join(broken + [ADVICE % name]))
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(HEAD % name.replace(".layout", "").upper().replace("-", "_"))
                for one, (size, members) in sorted(now.items()):
                    file.write("%s %d\n" % (one, size))
                    file.writelines("    %s %d %d\n" % ((member,) + members[member]) for member in members)
    if "--update" not in rest:
        tap.finish()


main()
