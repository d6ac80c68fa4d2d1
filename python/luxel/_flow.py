# SPDX-License-Identifier: MIT
"""Values of keys as YAML on one line, read into Python's values and written from them."""
from __future__ import annotations

import json
import os
import re
from typing import Any, List, Tuple

from ._settings import point

_NUMBER = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?\Z")
_WHOLE = re.compile(r"[-+]?[0-9]+\Z")
_WORDS = {"true": True, "True": True, "TRUE": True, "false": False, "False": False, "FALSE": False,
          "null": None, "Null": None, "NULL": None, "~": None, "": None}
_ESCAPES = {"0": "\0", "a": "\a", "b": "\b", "t": "\t", "n": "\n", "v": "\v", "f": "\f", "r": "\r", "e": "\x1b",
            "N": "\x85", "_": "\xa0", "L": "\u2028", "P": "\u2029"}
_CODES = {"x": 2, "u": 4, "U": 8}


def _scalar(text: str) -> Any:
    """A plain scalar, by the core schema of YAML 1.2."""
    if text in _WORDS:
        return _WORDS[text]
    if _WHOLE.match(text):
        return int(text)
    return float(text) if _NUMBER.match(text) else text


class _Reader:
    """Reads one value from a place of a text."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def blanks(self) -> None:
        while self.at < len(self.text) and self.text[self.at] in " \t\r\n":
            self.at += 1

    def peek(self) -> str:
        self.blanks()
        return self.text[self.at:self.at + 1]

    def single_quoted(self) -> str:
        found: List[str] = []
        while True:
            end = self.text.index("'", self.at)
            found.append(self.text[self.at:end])
            self.at = end + 1
            if self.text[self.at:self.at + 1] != "'":
                return "".join(found)
            found.append("'")
            self.at += 1

    def escape(self) -> str:
        sign = self.text[self.at]
        self.at += 1
        if sign in _CODES:
            digits = self.text[self.at:self.at + _CODES[sign]]
            self.at += _CODES[sign]
            return chr(int(digits, 16))
        return _ESCAPES.get(sign, sign)

    def double_quoted(self) -> str:
        found: List[str] = []
        while self.text[self.at] != '"':
            sign = self.text[self.at]
            self.at += 1
            found.append(self.escape() if sign == "\\" else sign)
        self.at += 1
        # Pairs of surrogates, as JSON has them.
        return "".join(found).encode("utf-16", "surrogatepass").decode("utf-16", "replace")

    def plain(self, inside: bool) -> str:
        start = self.at
        while self.at < len(self.text):
            sign, following = self.text[self.at], self.text[self.at + 1:self.at + 2]
            if inside and (sign in ",[]{}" or (sign == ":" and following in ("", " ", ",", "]", "}"))):
                break
            self.at += 1
        return self.text[start:self.at].strip()

    def sequence(self) -> List[Any]:
        found: List[Any] = []
        while self.peek() != "]":
            found.append(self.value(True))
            if self.peek() == ",":
                self.at += 1
        self.at += 1
        return found

    def mapping(self) -> Any:
        found = {}
        while self.peek() != "}":
            key = self.value(True)
            if self.peek() == ":":
                self.at += 1
            found[key] = self.value(True)
            if self.peek() == ",":
                self.at += 1
        self.at += 1
        return found

    def value(self, inside: bool) -> Any:
        sign = self.peek()
        if sign in ("[", "{", "'", '"') and sign:
            self.at += 1
            return {"[": self.sequence, "{": self.mapping, "'": self.single_quoted, '"': self.double_quoted}[sign]()
        return _scalar(self.plain(inside))


def load(text: str) -> Any:
    """The value of a line of YAML as luxel_scene_get() gives it."""
    return _Reader(text).value(False)


def _simple(value: Any) -> Any:
    """What JSON does not know: arrays and numbers of NumPy, paths."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError("a value of a scene cannot be %s" % type(value).__name__)


def dump(value: Any) -> str:
    """A value as JSON on one line, which is YAML too."""
    return json.dumps(value, ensure_ascii=False, default=_simple)


def assignment(key: str, value: Any) -> str:
    """KEY=VALUE as `luxel -s` takes it."""
    return "%s=%s" % (key, dump(value))


def pairs(points: Any) -> List[Tuple[float, float]]:
    """Points of the screen from a list of pairs or an array of two columns."""
    rows = points.tolist() if hasattr(points, "tolist") else points
    if not hasattr(rows, "__iter__"):
        raise TypeError("points: %r: pairs of numbers are expected, x and y in mm" % (points,))
    return [point("points[%d]" % i, row) for i, row in enumerate(rows)]
