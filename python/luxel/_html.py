# SPDX-License-Identifier: MIT
"""Tables for notebooks."""
from __future__ import annotations

from decimal import ROUND_CEILING, Context
from math import floor, log10
from typing import Iterable, Optional, Sequence, Tuple

from ._language import translate


def number(value: Optional[float], digits: int = 9) -> str:
    """A number as tables show it; "—" where there is none."""
    return "—" if value is None else "%.*g" % (digits, value)


def bounded(amount: Tuple[float, float]) -> str:
    """A value with no digits beyond those of its error's bound, 0 where all are, and the bound of what is shown,
    rounded up."""
    value, error = amount
    if error > 0:
        told = 0.0 if abs(value) < error / 10 else round(value, 1 - floor(log10(error))) + 0.0
    else:
        told = value
    shown = "%.7g" % told
    whole = error + abs(float(shown) - value)
    return "%s ± %.2g" % (shown, Context(prec=2, rounding=ROUND_CEILING).create_decimal_from_float(whole))


def table(heading: Sequence[str], rows: Iterable[Sequence[str]], caption: str = "") -> str:
    """An HTML table: the first column is text, all others are numbers."""
    from html import escape

    parts = ["<table>"]
    if caption:
        parts.append("<caption>%s</caption>" % escape(caption))
    parts.append("<thead><tr>%s</tr></thead><tbody>" % "".join("<th>%s</th>" % escape(cell) for cell in heading))
    for row in rows:
        cells = ['<td style="text-align:%s">%s</td>' % ("right" if i else "left", escape(cell))
                 for i, cell in enumerate(row)]
        parts.append("<tr>%s</tr>" % "".join(cells))
    parts.append("</tbody></table>")
    return "".join(parts)


def valued(unit: str) -> str:
    """The heading of a column of values."""
    return translate("exact value") + (" (%s)" % translate(unit) if unit else "")
