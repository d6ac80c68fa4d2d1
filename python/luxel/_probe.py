# SPDX-License-Identifier: MIT
"""Probes: the exact value at a place, light by light, with a bound of its error."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Tuple

from . import _html
from ._language import translate
from ._results import Vector

if TYPE_CHECKING:
    from ._arrays import Floats


class Color(NamedTuple):
    """The channels of a value in a scene with `channels: rgb`, and the colour that they are."""

    rgb: Vector  #: red, green and blue in linear sRGB, whose luminance is the value
    error: Vector  #: bounds of |channel - truth|
    xy: Optional[Tuple[float, float]]  #: the chromaticity of 1931; None where the luminance is 0
    cct: Optional[float]  #: the temperature of the nearest black body in u, v, in K; None where it means nothing
    duv: Optional[float]  #: the distance from it in u, v, above 0 on the side of green


class Share(NamedTuple):
    """What one light gives to a probe."""

    light: int  #: index in the scene's list
    type: str
    name: Optional[str]
    irradiance: float
    diffuse: float  #: its diffuse or ambient brightness
    specular: float  #: its highlight
    error: float  #: bounds the error of its share of the value
    parts: int  #: points that an extended source was split into; 0: there is a closed form
    color: Optional[Color]  #: of its share of the value, in a scene with channels: rgb


class Probe(NamedTuple):
    """The answer at one place.  What there is not is None: a value off every surface, a pixel off the screen."""

    screen_mm: Optional[Tuple[float, float]]  #: the place on the screen; None for a free element
    pixel: Optional[Tuple[int, int]]  #: column and row of the pixel that it falls in
    on_surface: bool
    value: Optional[float]  #: None off every surface and where a source lies on the element
    error: Optional[float]  #: bounds |value - truth|
    tolerance_reached: bool
    pixel_value: Optional[float]  #: what the picture shows there
    position_mm: Optional[Vector]
    normal: Optional[Vector]
    view: Optional[Vector]  #: the unit vector to the observer
    #: of light from all sides alike, the share that the material sends there; None of more than 1000 places
    albedo: Optional[float]
    surface: Optional[int]  #: whose material counts, as an index in the scene's list
    surface_name: Optional[str]
    wall: Optional[str]  #: of a room or box, such as "floor"; None for other surfaces
    lies_on_surface: bool
    enclosing_surface: Optional[int]  #: the surface inside whose body a free element is
    blocking_light: Optional[int]  #: the light that lies on the element, which then has no value
    #: what other surfaces send: irradiance, its part of the value, the bound of that part's error
    reflected: Optional[Tuple[float, float, float]]
    color: Optional[Color]  #: of a scene with channels: rgb
    shares: Tuple[Share, ...]  #: one for each enabled light
    unit: str

    def _repr_html_(self) -> str:
        return Probes([self])._repr_html_()


def color(found: Any) -> Optional[Color]:
    """The colour of a tuple of the library."""
    return Color(*found) if found else None


def probes(found: List[Any], unit: str) -> List[Probe]:
    """The probes of tuples of the library."""
    made = []
    for entry in found:
        shares = tuple(Share(*share[:-1], color(share[-1])) for share in entry[-1])
        fields: Any = (*entry[:-2], color(entry[-2]), shares, unit)
        made.append(Probe(*fields))
    return made


class Probes(Tuple[Probe, ...]):
    """Probes of several places: a tuple that shows itself as a table, with the numbers as arrays."""

    __slots__ = ()

    def _numbers(self, name: str) -> "Floats":
        import numpy

        array: "Floats" = numpy.array([numpy.nan if getattr(probe, name) is None else getattr(probe, name)
                                       for probe in self], dtype=numpy.float64)
        return array

    @property
    def value(self) -> "Floats":
        """The exact values; NaN where there is none."""
        return self._numbers("value")

    @property
    def error(self) -> "Floats":
        """Bounds of |value - truth|."""
        return self._numbers("error")

    @property
    def pixel_value(self) -> "Floats":
        """What the picture shows at the same places."""
        return self._numbers("pixel_value")

    def _repr_html_(self) -> str:
        unit = self[0].unit if self else ""
        rows = []
        for number, probe in enumerate(self, 1):
            place = probe.screen_mm or probe.position_mm or ()
            rows.append(["P%d (%s)" % (number, ", ".join("%.6g" % x for x in place)), _html.number(probe.value, 12),
                         _html.number(probe.error, 2), _html.number(probe.pixel_value, 6),
                         "(%d, %d)" % probe.pixel if probe.pixel else "—"])
        return _html.table([translate("point x, y (mm)"), _html.valued(unit), translate("error at most"),
                            translate("pixel value"), translate("pixel (u, v)")], rows)
