# SPDX-License-Identifier: MIT
"""What went wrong: exceptions with every message of the library, each with its place and how to mend it."""
from __future__ import annotations

import sys
import warnings
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple


class Diagnostic(NamedTuple):
    """One message: an error, or advice about a scene that is right."""

    severity: str  #: "error" or "advice"
    id: str  #: a stable name, such as "unknown-key"
    message: str  #: in the user's language
    hint: str  #: how to mend it, or ""
    file: Optional[str]  #: the file, "<text>", "-s" for assignments; None where there is no place
    key: Optional[str]  #: the scene's key, such as "lights[0].intensity"
    line: int  #: from 1; 0 where there is no place
    column: int  #: from 1, in characters; 0 where there is no place
    text: Optional[str]  #: the offending line
    mark_offset: int  #: columns of the text before what is meant
    mark_length: int  #: columns that are meant

    def __str__(self) -> str:
        place = "" if self.file is None else self.file + (":%d:%d" % (self.line, self.column) if self.line else "")
        lines = [(place + ": " if place else "") + self.message]
        if self.text is not None:
            lines += ["    " + self.text, "    " + " " * self.mark_offset + "^" + "~" * (self.mark_length - 1)]
        if self.hint:
            lines.append("  " + self.hint)
        return "\n".join(lines)


class LuxelError(Exception):
    """What was asked for cannot be done.  `str()` of it shows every message with its place.

    A scene, a setting or a value that is wrong is a LuxelValueError, which is a ValueError; a file that cannot be read
    or written a LuxelFileError, which is an OSError; a lack of memory a LuxelMemoryError, which is a MemoryError.
    """

    status: str  #: "argument", "path", "scene", "file", "memory", "range" or "cancelled"
    diagnostics: Tuple[Diagnostic, ...]  #: the messages, of which the library keeps 20
    total: int  #: how many errors there were, those not kept included

    def __init__(self, status: str, diagnostics: Sequence[Diagnostic] = (), total: int = 0) -> None:
        Exception.__init__(self, status, tuple(diagnostics), total)  # a subclass that is an OSError has another
        self.status = status
        self.diagnostics = tuple(diagnostics)
        self.total = total

    def __str__(self) -> str:
        lines = [str(entry) for entry in self.diagnostics]
        left = self.total - sum(entry.severity == "error" for entry in self.diagnostics)
        if left > 0:
            from ._language import translate_plural
            lines.append((translate_plural("and %zu more error\n", "and %zu more errors\n", left).strip()
                          .replace("%zu", str(left))))
        return "\n".join(lines) or {"cancelled": "cancelled", "memory": "out of memory",
                                    "range": "a value is too large for float64"}.get(self.status, self.status)


    def __reduce__(self) -> Tuple[Any, ...]:
        return type(self), (self.status, self.diagnostics, self.total)


class LuxelKeyError(LuxelError, KeyError):
    """A path that names no key or element of the scene; a KeyError too."""


class LuxelValueError(LuxelError, ValueError):
    """A scene that is wrong, a setting out of its range, a place that is no number; a ValueError too."""


class LuxelFileError(LuxelError, OSError):
    """A file that cannot be read or written, or is not what it should be; an OSError too."""

    def __init__(self, status: str, diagnostics: Sequence[Diagnostic] = (), total: int = 0) -> None:
        super().__init__(status, diagnostics, total)
        first = self.diagnostics[0] if self.diagnostics else None
        self.strerror = first.message if first else status
        self.filename = first.file if first else None


class LuxelNotFoundError(LuxelFileError, FileNotFoundError):
    """A name that is neither a file nor a built-in scene; a FileNotFoundError too."""


class LuxelMemoryError(LuxelError, MemoryError):
    """Memory ran out, or would; a MemoryError too."""


class LuxelWarning(UserWarning):
    """A result is less exact than was asked for: light that surfaces reflect to each other missed its bound.  The
    result is made all the same, and tells its bound."""


def warn(message: str) -> None:
    """Warns whoever called the package."""
    frame, level = sys._getframe(1), 2
    while frame.f_back and frame.f_globals.get("__name__", "").split(".")[0] == "luxel":
        frame, level = frame.f_back, level + 1
    warnings.warn(message, LuxelWarning, stacklevel=level)


def make_error(status: str, entries: List[Tuple[str, str, str, str, Optional[str], Optional[str], int, int,
                                                Optional[str], int, int]], total: int) -> LuxelError:
    """The exception of a failure of the library."""
    kind = {"path": LuxelKeyError, "argument": LuxelValueError, "scene": LuxelValueError, "range": LuxelValueError,
            "file": LuxelFileError, "memory": LuxelMemoryError}.get(status, LuxelError)
    return kind(status, [Diagnostic(*entry) for entry in entries], total)
