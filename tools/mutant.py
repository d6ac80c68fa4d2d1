# SPDX-License-Identifier: MIT
"""Faults that are put into the sources on purpose: those that tools/mutants/ lists, and others drawn by chance.

The lists consist of blocks with empty lines between:

    [name] a few words
    the/file.c
    - a text that stands once in the file; several such lines are one text
    + what replaces it; without one the text goes
    = why no test can tell the difference, if that is so
"""
import glob
import os
import random
import re

LISTS = os.path.join("tools", "mutants", "*.txt")
# Where random faults are put: what decides about numbers, not what reads and writes texts.
CORE = ["src/light/**/*.c", "src/material/*.c", "src/surface/*.c", "src/kernel/*.[ch]", "src/world/**/*.[ch]",
        "src/flux/*.[ch]", "src/picture/**/*.[ch]", "src/field/*.c",
        "src/base/bounded.[ch]", "src/base/number.c", "src/base/wide.[ch]", "src/base/pose.c",
        "src/scene/conventions.c", "src/scene/validate.c", "src/scene/mend.c",
        "src/parameter/value.c", "src/parameter/rules.c",
        "src/format/npy.c", "src/format/exr*.c", "src/format/png.c", "src/format/pfm.c", "src/format/csv*.c",
        "src/format/samples.c", "src/api/probe.c", "src/api/grid.c", "src/api/render.c", "src/api/evaluator.c",
        "src/exercise/judge.c", "src/exercise/advise*.c", "src/exercise/alternatives.c"]

# Comments, texts, lines for the preprocessor, assertions that the compiler proves, and the lengths of arrays.
DEAD = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'"
                  r"|\b(?:double|float|char|bool|int|unsigned|size_t|uint\d+_t|(?:lx|luxel)_\w+) \**\w+(?:\[[^]\n]*\])+"
                  r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*|\b_Static_assert\s*\(.*?\);", re.DOTALL | re.MULTILINE)
# Operators with an operand on both sides stand between blanks, since clang-format sets them so.
PLACES = [(re.compile(pattern), others) for pattern, others in (
    (r"(?<= )[-+*/](?= )", {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"]}),
    (r"(?<= )(?:[-+*/]=)(?= )", {"+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="]}),
    (r"(?<= )(?:<=|>=|<|>|==|!=)(?= )", {"<": ["<=", ">"], "<=": ["<", ">="], ">": [">=", "<"], ">=": [">", "<="],
                                         "==": ["!="], "!=": ["=="]}),
    (r"(?<= )(?:&&|\|\|)(?= )", {"&&": ["||"], "||": ["&&"]}),
    (r"!(?=[\w(])", {"!": [""]}),
    (r"(?<=[(\[,=?:] )-(?=[\w(])|(?<=[(\[])-(?=[\w(])|(?<=return )-(?=[\w(])", {"-": [""]}),
    (r"\b(?:fmin|fmax|sin|cos|true|false)\b", {"fmin": ["fmax"], "fmax": ["fmin"], "sin": ["cos"], "cos": ["sin"],
                                               "true": ["false"], "false": ["true"]}),
    (r"\+\+|--", {"++": ["--"], "--": ["++"]}),
)]
NUMBER = re.compile(r"(?<![\w.])(?:\d+\.\d*(?:e[-+]?\d+)?|\d+e[-+]?\d+|\d+)(?![\w.])")


class Mutant:
    """One fault: a text that stands once in a file, or at a given place of it, and what replaces it."""

    def __init__(self, name, path, old, new, place=None, words="", equivalent=""):
        self.name, self.path, self.old, self.new = name, path, old, new
        self.place, self.words, self.equivalent = place, words, equivalent

    def __str__(self):
        return "%s: %s" % (self.name, self.words)

    def apply(self, text):
        if self.place is not None:
            return text[:self.place] + self.new + text[self.place + len(self.old):]
        if text.count(self.old) != 1:
            raise ValueError("%s: its text stands %d times in %s" % (self.name, text.count(self.old), self.path))
        return text.replace(self.old, self.new)


def read_list(root):
    """The mutants of the lists."""
    mutants = []
    for path in sorted(glob.glob(os.path.join(root, LISTS))):
        with open(path, encoding="utf-8") as file:
            blocks = re.split(r"\n{2,}", file.read().strip())
        for block in blocks:
            lines = [line for line in block.split("\n") if not line.startswith("#")]
            if lines:
                mutants.append(read_block(path, lines))
    return mutants


def read_block(path, lines):
    head = re.fullmatch(r"\[([a-z0-9-]+)\] (.+)", lines[0])
    if not head or len(lines) < 3:
        raise ValueError("%s: not a mutant: %r" % (path, lines))
    parts = {"- ": [], "+ ": [], "= ": []}
    for line in lines[2:]:
        parts[(line + " ")[:2]].append(line[2:])
    return Mutant(head.group(1), lines[1], "\n".join(parts["- "]), "\n".join(parts["+ "]), words=head.group(2),
                  equivalent=" ".join(parts["= "]))


def core_files(root):
    return sorted({os.path.relpath(path, root) for pattern in CORE
                   for path in glob.glob(os.path.join(root, pattern), recursive=True)})


def other_numbers(text):
    """What may stand for a number: one more, and twice as much or nothing."""
    if re.fullmatch(r"\d+", text):
        return [str(int(text) + 1)] + (["0"] if text == "1" else [])
    return ["(1.01 * %s)" % text] if float(text) else ["0.01"]


def places(text):
    """Every place of a source text that can be made wrong, with what may stand there instead."""
    bare = DEAD.sub(lambda match: re.sub(r"[^\n]", "\x00", match.group()), text)
    for pattern, others in PLACES:
        for match in pattern.finditer(bare):
            yield match.start(), match.group(), others[match.group()]
    for match in NUMBER.finditer(bare):
        yield match.start(), match.group(), other_numbers(match.group())


def random_mutants(root, paths, count, seed):
    """Each place of all files is as likely as any other; the same seed draws the same mutants from the same sources."""
    texts = {}
    for path in paths:
        with open(os.path.join(root, path), encoding="utf-8") as file:
            texts[path] = file.read()
    everywhere = [(path, place) for path in paths for place in sorted(places(texts[path]))]
    draw = random.Random(seed)
    mutants = []
    for number, (path, (start, old, others)) in enumerate(draw.sample(everywhere, min(count, len(everywhere))), 1):
        new = draw.choice(others)
        text = texts[path]
        line = text[text.rfind("\n", 0, start) + 1:text.find("\n", start)].strip()
        words = "%s:%d  %s -> %s  in  %s" % (path, text.count("\n", 0, start) + 1, old, new or "nothing", line)
        mutants.append(Mutant("random-%d-%d" % (seed, number), path, old, new, place=start, words=words))
    return mutants
