# SPDX-License-Identifier: MIT
"""What is read off scenes and pictures: plain tuples with names.  Lengths in mm, values in the result's unit."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Tuple

from . import _html
from ._language import translate

if TYPE_CHECKING:
    from ._arrays import Bools, Floats
    from ._field import Field

Vector = Tuple[float, float, float]
TABLE_ROWS = 21  #: of a profile in a notebook


class Extremum(NamedTuple):
    """The greatest or least value of a picture's pixels; ties: the first in row order."""

    value: float
    column: int  #: from 0 at the left
    row: int  #: from 0 at the top
    x_mm: float  #: of the pixel's sample on the screen; NaN where the picture does not know its places
    y_mm: float


class Statistics(NamedTuple):
    """What is read off a picture at a glance, over the pixels that show a surface."""

    maximum: Optional[Extremum]
    minimum: Optional[Extremum]  #: of the values from 1.2e-38 up
    mean: Optional[float]
    lit: Optional[float]  #: share of the pixels from 1.2e-38 up
    pixels: int  #: how many show a surface
    minimum_reached: Optional[Extremum]  #: the least value where light arrives, if it was asked for
    reflected_error: Optional[float]  #: bounds what reflected light may be off, as a share of the maximum
    #: where light may go over more mirrors than the scene counts: bounds the error of any pixel, as a share of the
    #: maximum (inf: no bound is known); 0.0: it does not
    mirrored_error: float = 0.0

    def _repr_html_(self) -> str:
        rows = [[translate(name), _html.number(e and e.value), "(%d, %d)" % (e.column, e.row) if e else "—"]
                for name, e in (("maximum", self.maximum), ("minimum above 0", self.minimum))]
        rows.append([translate("mean"), _html.number(self.mean), ""])
        return _html.table(["", translate("value"), translate("pixel (u, v)")], rows)


class Summary(NamedTuple):
    """What is read off the pixels of a part of a picture."""

    pixels: int  #: that show a surface, in the region
    maximum: Optional[Extremum]
    minimum: Optional[Extremum]  #: of all values, 0 and below included
    mean: float
    median: float
    standard_deviation: float  #: of the pixels themselves
    lit: float  #: share of the pixels from 1.2e-38 up
    u0: Optional[float]  #: minimum / mean, the uniformity U0 (EN 12665); None where the mean is 0
    ud: Optional[float]  #: minimum / maximum, the diversity Ud

    def _repr_html_(self) -> str:
        rows = [[translate(name), _html.number(value)] for name, value in (
            ("maximum", self.maximum and self.maximum.value), ("minimum", self.minimum and self.minimum.value),
            ("mean", self.mean), ("median", self.median), ("standard deviation", self.standard_deviation))]
        rows += [["U0", _html.number(self.u0)], ["Ud", _html.number(self.ud)]]
        return _html.table(["", translate("value")], rows)


class Histogram(NamedTuple):
    """How many pixels have values from where to where."""

    edges: "Floats"  #: bins + 1 of them; a bin takes in its lower edge, the last its upper one too
    counts: Any  #: int64, one for each bin
    below: int  #: pixels under the lowest edge
    above: int  #: pixels over the highest edge
    pixels: int  #: all of them


class Peak(NamedTuple):
    """A true extremum of the exact function, between the pixels."""

    value: float
    error: float  #: bounds |value - truth at this very place|
    x_mm: float  #: on the screen
    y_mm: float
    surface: int  #: index in the scene's list
    wall: Optional[str]  #: of a room or box, such as "floor"; None for other surfaces
    position_mm: Vector  #: on the surface
    normal: Vector  #: the unit normal there
    place: str  #: "inside", "limb", "border" (of screen or region), "jump" or "plateau"


class Extrema(NamedTuple):
    """The true maximum and minimum; None where no surface is seen."""

    maximum: Optional[Peak]
    minimum: Optional[Peak]

    def _repr_html_(self) -> str:
        rows = [[translate(name), _html.number(peak.value, 12), _html.number(peak.error, 2), _html.number(peak.x_mm, 7),
                 _html.number(peak.y_mm, 7)]
                for name, peak in (("maximum", self.maximum), ("minimum", self.minimum)) if peak]
        return _html.table(["", _html.valued(""), translate("error at most"), translate("x (mm)"), translate("y (mm)")],
                           rows)


class Isophote(NamedTuple):
    """A line of equal value on the screen; the greater values lie to the left along it."""

    level: float
    closed: bool  #: it comes back to where it began, and does not repeat its first vertex
    x_mm: "Floats"  #: of the vertices
    y_mm: "Floats"


class Profile(NamedTuple):
    """The values along a line of the screen or a great circle of a sphere: one entry for each sample."""

    abscissa: "Floats"  #: mm from the beginning, or degrees along a great circle
    x_mm: "Floats"
    y_mm: "Floats"
    has_value: "Bools"  #: false off the surfaces, and where a source lies on the element; the value is 0 there
    value: "Floats"
    error: "Floats"  #: bounds |value - truth|; 0 where the value is the picture's
    shares: "Optional[Floats]"  #: samples x lights: what each light gives; None where the value is the picture's

    def _repr_html_(self) -> str:
        """Some of the samples, evenly along the line, the ends included."""
        count = len(self.value)
        some = sorted({round(i * (count - 1) / (TABLE_ROWS - 1)) for i in range(TABLE_ROWS)}) if count else []
        rows = [[_html.number(self.x_mm[i], 7), _html.number(self.y_mm[i], 7),
                 _html.number(self.value[i] if self.has_value[i] else None, 12),
                 _html.number(self.error[i] if self.has_value[i] else None, 2)] for i in some]
        return _html.table([translate("x (mm)"), translate("y (mm)"), translate("value"), translate("error at most")],
                           rows)


class Comparison(NamedTuple):
    """How far two pictures are apart, over the pixels that show a surface in both: differences are b - a."""

    pixels: int
    only_a: int  #: pixels that show a surface in a alone
    only_b: int
    largest: Optional[Extremum]  #: the largest |b - a| and where it is
    a: float  #: the value of a there
    b: float
    mean: float
    mean_magnitude: float
    rms: float
    scale: float  #: the largest |a| or |b|
    largest_relative: float  #: largest / scale
    rms_relative: float
    difference: "Field"  #: the picture of b - a


class GridExtremum(NamedTuple):
    """The greatest or least value of a measuring grid."""

    value: float
    column: int
    row: int
    position_mm: Vector  #: the centre of its cell


class GridArea(NamedTuple):
    """An area around the plane of a grid, as far as the walls: the surrounding or the background area of a task."""

    measured: int  #: how many cells it has
    average: Optional[float]
    average_error: Optional[float]
    minimum: Optional[GridExtremum]
    maximum: Optional[GridExtremum]
    error: Optional[float]  #: the largest of the bounds of the values
    u0: Optional[float]  #: minimum / average
    center_mm: Vector  #: of the rectangle around it
    size_mm: Tuple[float, float]


class GridPeak(NamedTuple):
    """The greatest or least value on the whole plane of a measuring grid, between its points."""

    value: float
    error: float  #: bounds |value - truth at this very place|
    position_mm: Vector
    on_plane_mm: Tuple[float, float]  #: from the plane's middle, along up x axis and along up


class GridExtrema(NamedTuple):
    """The maximum and minimum on the whole plane; None where no place has a value, and with light that surfaces
    reflect to each other."""

    maximum: Optional[GridPeak]
    minimum: Optional[GridPeak]


class Light(NamedTuple):
    """A light of a scene."""

    type: str
    name: Optional[str]
    enabled: bool
    flux: Optional[float]  #: W or lm, all that it gives off; None for ambient and distant light
    intensity: Optional[float]  #: W/sr or cd; None where there is no such
    position_mm: Optional[Vector]
    direction: Optional[Vector]  #: in which it shines, of length 1


class Mesh(NamedTuple):
    """What a mesh that a surface or a volume source reads is as a body."""

    key: str  #: that names the file, such as "surfaces[0].file"
    file: str
    triangles: int
    corners: int  #: at different places
    edges: int
    open_edges: int  #: of one face alone
    crowded_edges: int  #: of more than two faces
    closed: bool  #: no edge is open or crowded
    euler_number: int  #: corners - edges + faces: 2 of what is like a ball, 0 of what is like a ring
    parts: int  #: that share no edge
    flipped_faces: int  #: that look to the other side than most of the faces that they go on with
    one_sided: bool  #: no two sides can be told, as of a Moebius strip
    volume_mm3: Optional[float]  #: below 0 where its faces look inwards; None unless closed and without flipped faces
    scale_mm: float  #: how long a unit of the file is
    size_mm: Vector  #: the sides of the box around it, along the axes of the file


class Alternative(NamedTuple):
    """One choice of a convention and the value that it would give."""

    convention: str  #: in the user's language, as are choice and meaning
    choice: str
    meaning: str
    assignment: Optional[str]  #: what makes it: for Scene.set(); None where it is no key of the scene
    present: bool  #: whether it is what the scene says
    value: Optional[float]
    error: Optional[float]  #: bounds |value - truth|


class Judgement(NamedTuple):
    """What an answer is found to be."""

    verdict: str  #: "right", "convention" (another convention gives it), "coarse" (too few digits) or "wrong"
    value: Optional[float]  #: the exact value; None off every surface
    error: Optional[float]  #: bounds |value - truth|
    explanations: Tuple[Alternative, ...]  #: of "convention": the choices that together give the answer


def extremum(found: Any) -> Optional[Extremum]:
    """The extremum of a tuple of the library."""
    return None if found is None else Extremum(*found)


def statistics(found: Any) -> Statistics:
    """The statistics of a tuple of the library."""
    maximum, minimum, mean, lit, pixels, reached, reflected_error, mirrored_error = found
    return Statistics(extremum(maximum), extremum(minimum), mean, lit, pixels, extremum(reached), reflected_error,
                      mirrored_error)


def alternatives(found: List[Any]) -> Tuple[Alternative, ...]:
    """The alternatives of tuples of the library."""
    return tuple(Alternative(*entry) for entry in found)
