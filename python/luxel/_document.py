# SPDX-License-Identifier: MIT
"""Documents: explanations as text, Markdown, LaTeX or HTML."""
from __future__ import annotations

import os
from typing import Any, Dict, Optional, Tuple, Union

from . import _luxel

_FORMATS = ("text", "markdown", "latex", "html")
_ENDINGS = {".txt": "text", ".md": "markdown", ".tex": "latex", ".html": "html"}


class Document:
    """The whole calculation of a value with its numbers, and what each other convention would give.

    In a notebook it shows itself; `print()` shows the text.  It is written in the language that was
    set when it was made.
    """

    __slots__ = ("_holder", "_texts")

    def __init__(self, holder: Optional[_luxel.Holder], texts: Optional[Dict[str, str]] = None) -> None:
        self._holder = holder
        self._texts: Dict[str, str] = texts or {}

    def _text(self, name: str) -> str:
        if name not in self._texts and self._holder is not None:
            self._texts[name] = _luxel.document_text(self._holder, _FORMATS.index(name))
        return self._texts[name]

    @property
    def text(self) -> str:
        """For a terminal: lines of at most 100 columns, formulas in one line."""
        return self._text("text")

    @property
    def markdown(self) -> str:
        """CommonMark with tables, formulas as $...$."""
        return self._text("markdown")

    @property
    def latex(self) -> str:
        """A whole document for pdflatex."""
        return self._text("latex")

    @property
    def html(self) -> str:
        """One HTML 5 page, formulas as MathML."""
        return self._text("html")

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes it by the extension of the name: .txt, .md, .tex or .html.

        Raises LuxelError where it cannot be written.
        """
        if self._holder is not None:
            _luxel.document_write(self._holder, os.fsencode(path))
            return
        ending = os.path.splitext(os.fspath(path))[1].lower()
        if ending not in _ENDINGS:
            raise ValueError("%s: .txt, .md, .tex, .html" % os.fspath(path))
        with open(path, "w", encoding="utf-8") as file:
            file.write(self._text(_ENDINGS[ending]))

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return "<luxel.Document: %s>" % self.text.strip().split("\n", 1)[0]

    def _repr_html_(self) -> str:
        return self.html

    def _repr_markdown_(self) -> str:
        return self.markdown

    def __reduce__(self) -> Tuple[Any, ...]:
        return Document, (None, {name: self._text(name) for name in _FORMATS})
