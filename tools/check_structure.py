# SPDX-License-Identifier: MIT
"""The structure of the library that a newcomer sees: folders of a size to be read, units that do not go in circles, and
struct tags with one meaning.

A unit is a header with its source.  Units that include each other in a circle can only be understood together, so the
largest circle may shrink but not grow: the limit below is what it is, to be lowered with it.
"""
import collections
import os
import re
import sys

from tap import Tap

MOST_FILES = 60
LARGEST_CIRCLE = 4
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
TAG = re.compile(r"^(?:struct|enum|union) (lx_\w+) \{", re.MULTILINE)


def read_sources(root):
    """The text of each source file of the library, by its path from src/."""
    source = os.path.join(root, "src")
    texts = {}
    for where, folders, files in os.walk(source):
        folders.sort()
        for name in sorted(files):
            if name.endswith((".c", ".h")):
                path = os.path.join(where, name)
                with open(path, encoding="utf-8") as file:
                    texts[os.path.relpath(path, source)] = file.read()
    return texts


def unit_of(path):
    return os.path.splitext(path)[0]


def graph_of(texts):
    """Which units each unit includes."""
    graph = {unit_of(path): set() for path in texts}
    for path, text in texts.items():
        for target in INCLUDE.findall(text):
            other = unit_of(os.path.normpath(os.path.join(os.path.dirname(path), target)))
            if other in graph and other != unit_of(path):
                graph[unit_of(path)].add(other)
    return graph


def reachable(graph, start):
    seen, waiting = set(), [start]
    while waiting:
        for other in graph[waiting.pop()] - seen:
            seen.add(other)
            waiting.append(other)
    return seen


def circles(graph):
    """Groups of units each of which reaches every other, the largest first."""
    reach = {unit: reachable(graph, unit) for unit in graph}
    groups = {frozenset(other for other in reach[unit] if unit in reach[other]) for unit in graph}
    return sorted((sorted(group) for group in groups if len(group) > 1), key=len, reverse=True)


def main():
    tap = Tap()
    texts = read_sources(sys.argv[1])

    folders = collections.Counter(os.path.dirname(path) for path in texts)
    large = ["src/%s: %d files" % item for item in sorted(folders.items()) if item[1] > MOST_FILES]
    tap.ok(not large, "no folder has more than %d files" % MOST_FILES, *large)

    found = circles(graph_of(texts))
    wide = [", ".join(group) for group in found if len(group) > LARGEST_CIRCLE]
    tap.ok(not wide, "no more than %d units include each other in a circle" % LARGEST_CIRCLE, *wide)
    largest = len(found[0]) if found else 0
    tap.ok(largest >= LARGEST_CIRCLE, "the limit of circles is the largest one",
           "the largest is of %d units: set LARGEST_CIRCLE to that" % largest)

    homes = collections.defaultdict(list)
    for path, text in texts.items():
        for tag in TAG.findall(text):
            homes[tag].append(path)
    doubled = ["%s: %s" % (tag, ", ".join(paths)) for tag, paths in sorted(homes.items()) if len(paths) > 1]
    tap.ok(not doubled, "each tag has one meaning", *doubled)
    tap.finish()


main()
