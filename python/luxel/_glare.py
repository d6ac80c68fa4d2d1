# SPDX-License-Identifier: MIT
"""Unified glare ratings (UGR): of observers in a scene, and of a luminaire in the standard rooms."""
from __future__ import annotations

from math import hypot, isfinite
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

from . import _html, _luxel
from ._balance import Amount
from ._language import translate
from ._settings import reals

if TYPE_CHECKING:
    from ._arrays import Floats

#: Why a light counts or does not, in the order of the library.
STATUSES = ("counts", "no_area", "unseen", "hidden", "dark", "background")
#: The number that catalogues quote is that of this room, 4 by 8 heights, with the first reflectances.
CATALOGUE = (4.0, 8.0)


class GlareSource(NamedTuple):
    """One light, or one place of its array, as an observer sees it."""

    light: int  #: index in the scene's list
    type: str
    name: Optional[str]
    #: "counts"; else "no_area", "unseen" (outside the field of view), "hidden", "dark" (it shines elsewhere) or
    #: "background" (ambient light)
    status: str
    luminance: float  #: its mean towards the eye, cd/m²
    solid_angle: float  #: sr
    seen: float  #: the share of its light that surfaces let through
    position_index: Optional[float]  #: None outside the field of view
    share: float  #: of the glare, 0 to 1
    place: Optional[int] = None  #: of its array, row by row, each a source; None without one


class Glare(NamedTuple):
    """The unified glare rating of an observer, UGR = 8 lg(0.25 / Lb · Σ L² ω / p²), as `luxel glare` has it."""

    ugr: Optional[float]  #: None where nothing dazzles or the background is dark
    error: Optional[float]  #: bounds |ugr - truth|
    background: Amount  #: Lb in cd/m²: reflected and ambient light at the eye over pi
    sources: Tuple[GlareSource, ...]  #: the lights that give light
    reached: bool  #: reflected light is known as well as `reflected_error` asks for

    def _repr_html_(self) -> str:
        words = _luxel.glare_reasons()
        rows = [[(source.name or "lights[%d]" % source.light) +
                 ("" if source.place is None else translate(", place %zu").replace("%zu", str(source.place + 1))),
                 source.type, _html.number(source.luminance, 6),
                 _html.number(source.solid_angle, 4), "%.4g %%" % (100 * source.seen),
                 _html.number(source.position_index, 4),
                 "%.2f %%" % (100 * source.share) if source.status == "counts"
                 else translate(words[STATUSES.index(source.status)])] for source in self.sources]
        rating = "—" if self.ugr is None or self.error is None else _html.bounded((self.ugr, self.error))
        return _html.table([translate("light"), translate("type"), translate("luminance, cd/m²"),
                            translate("solid angle, sr"), translate("seen"), translate("position index"),
                            translate("share of the glare")], rows, "UGR " + rating)


class UgrReflectances(NamedTuple):
    """Reflectances of a standard room."""

    ceiling: float
    walls: float
    floor: float


class UgrTable(NamedTuple):
    """UGR of a luminaire in the 19 standard rooms by the tabular method of CIE 190, as `luxel photometry` has it."""

    spacing: float  #: between luminaires, over their height H above the eye
    rooms: Tuple[Tuple[float, float], ...]  #: across and along the line of sight, in H
    reflectances: Tuple[UgrReflectances, ...]  #: five of them
    crosswise: "Floats"  #: rooms x reflectances, the plane C0 along the line of sight; NaN where nothing dazzles
    endwise: "Floats"  #: rooms x reflectances, the plane C90 along it

    @property
    def catalogue(self) -> Tuple[float, float]:
        """What catalogues quote: the room of 4H by 8H, reflectances 0.7, 0.5, 0.2, crosswise and endwise."""
        room = self.rooms.index(CATALOGUE)
        return float(self.crosswise[room, 0]), float(self.endwise[room, 0])

    def _repr_html_(self) -> str:
        parts = [[translate(title)] + ["%.0f" % (100 * getattr(triple, part)) for triple in self.reflectances] * 2
                 for title, part in (("ceiling, %", "ceiling"), ("walls, %", "walls"), ("floor, %", "floor"))]
        ratings = [["%gH × %gH" % room] + ["—" if x != x else "%.1f" % x for x in (*across, *along)]
                   for room, across, along in zip(self.rooms, self.crosswise.tolist(), self.endwise.tolist())]
        title: str = translate("\n  UGR (CIE 190), luminaires %.3g of their height above the eye apart: crosswise, "
                               "endwise\n\n") % self.spacing
        return _html.table([""] * 11, parts + ratings, title.strip())


class UgrRoom(NamedTuple):
    """UGR of a luminaire in one standard room by the light that its surfaces really reflect, any number of times."""

    spacing: float  #: between luminaires, over their height H above the eye
    across: float  #: the size of the room, in H
    along: float
    reflectances: Tuple[UgrReflectances, ...]  #: five of them; so many numbers the arrays have
    background: "Floats"  #: Lb in cd/m² where the luminaires are 1 m above the eye
    background_error: "Floats"  #: bounds its error
    background_by_table: "Floats"  #: what the tabular method has
    crosswise: "Floats"  #: the plane C0 along the line of sight; NaN where nothing dazzles
    endwise: "Floats"  #: the plane C90 along it
    error: "Floats"  #: bounds what the error of the background makes of both
    reached: bool  #: reflected light is known as well as `reflected_error` asks for

    def _repr_html_(self) -> str:
        rows = [[translate(title)] + ["%.0f" % (100 * getattr(triple, part)) for triple in self.reflectances]
                for title, part in (("ceiling, %", "ceiling"), ("walls, %", "walls"), ("floor, %", "floor"))]
        for title, form, values in (("background by the table, cd/m²", "%.4g", self.background_by_table),
                                    ("background, cd/m²", "%.4g", self.background),
                                    ("its error at most", "%.2g", self.background_error),
                                    ("crosswise", "%.2f", self.crosswise), ("endwise", "%.2f", self.endwise),
                                    ("error at most", "%.2g", self.error)):
            rows.append([translate(title)] + ["—" if x != x else form % x for x in values.tolist()])
        return _html.table([""] * 6, rows, "UGR, %gH × %gH" % (self.across, self.along))


def sight(eye_mm: Any, view: Any, up: Any) -> Tuple[Tuple[float, ...], ...]:
    """The observer as the library takes it; an upward direction of 0 is the scene's."""
    triple = "three numbers are expected, x, y and z"
    eye, way = reals("eye_mm", eye_mm, 3, triple), reals("view", view, 3, triple)
    above = (0.0, 0.0, 0.0) if up is None else reals("up", up, 3, triple)
    for name, numbers in (("eye_mm", eye), ("view", way), ("up", above)):
        if not all(isfinite(number) for number in numbers):
            raise ValueError("%s: %r: finite numbers are expected" % (name, numbers))
    if not any(way):
        raise ValueError("view: %r: a direction is expected" % (way,))
    across = [way[i - 2] * above[i - 1] - way[i - 1] * above[i - 2] for i in range(3)]
    if up is not None and hypot(*across) <= 1e-9 * hypot(*way) * hypot(*above):
        raise ValueError("up: %r: a direction that is not along the view is expected" % (above,))
    return eye, way, above


def glare(found: Any) -> Glare:
    """The rating of a tuple of the library."""
    ugr, error, background, sources, reached = found
    seen: Any = [(*source[:3], STATUSES[source[3]], *source[4:]) for source in sources]
    return Glare(ugr, error, Amount(*background), tuple(GlareSource(*source) for source in seen), reached)


def ugr_table(found: Any) -> Optional[UgrTable]:
    """The table of a tuple of the library; None: there is none."""
    if found is None:
        return None
    import numpy

    spacing, rooms, reflectances, ratings = found
    array: "Floats" = numpy.array(ratings, dtype=numpy.float64).reshape(len(rooms), 2, len(reflectances))
    return UgrTable(spacing, tuple(rooms), tuple(UgrReflectances(*triple) for triple in reflectances), array[:, 0],
                    array[:, 1])


def ugr_room(found: Any, across: float, along: float) -> UgrRoom:
    """The ratings of one room of a tuple of the library."""
    import numpy

    spacing, reflectances, by_table, ratings = found
    background, background_error, crosswise, endwise, error = numpy.array([row[:5] for row in ratings]).T.copy()
    return UgrRoom(spacing, across, along, tuple(UgrReflectances(*triple) for triple in reflectances), background,
                   background_error, numpy.array(by_table), crosswise, endwise, error, all(row[5] for row in ratings))
