# SPDX-License-Identifier: MIT
"""The light on surfaces that reflect it to each other: the mean of each side, and what becomes of the flux."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional, Tuple

from . import _html
from ._language import translate


class Amount(NamedTuple):
    """A number and the bound of its error."""

    value: float
    error: float  #: bounds |value - truth|


class LitSide(NamedTuple):
    """The light on one side of a surface."""

    surface: int  #: index in the scene's list
    surface_name: Optional[str]
    wall: Optional[str]  #: of a room or box, such as "floor"; None for other surfaces
    side: str  #: "front" or "back" of what is flat, "outside" or "inside" of what is round
    area_m2: float
    reflectance: float  #: how much of the light it sends back
    direct: Amount  #: the mean irradiance by light that comes from the sources
    irradiance: Amount  #: the mean irradiance by all light

    def _title(self) -> str:
        title = "surfaces[%d]" % self.surface + (" " + self.surface_name if self.surface_name else "")
        return ", ".join([title] + ([self.wall] if self.wall else []) + [translate(self.side)])


class Balance(NamedTuple):
    """The mean irradiance of each side of the surfaces, and the balance of the flux, each number with its bound.

    What arrives is absorbed or escapes, after any number of reflections; of what is given off some may meet no surface.
    """

    unit: str  #: of irradiances
    flux_unit: str  #: "W" or "lm"
    sides: Tuple[LitSide, ...]  #: those that light may reach, in the order of the surfaces
    emitted: Optional[Amount]  #: by all sources; None with ambient or distant light, and unless all throw shadows
    missed: Optional[Amount]  #: of that, what meets no surface: emitted - arrives
    arrives: Amount  #: at surfaces directly
    absorbed: Amount  #: by all surfaces
    escaped: Amount  #: was reflected, and meets no surface any more
    pending: Amount  #: is reflected after the last of N bounces; 0 with all of them
    difference: Amount  #: absorbed + escaped + pending - arrives, in truth 0
    closes: bool  #: the difference is within its bound, and no more arrives than is emitted
    reached: bool  #: each error of a mean is at most `reflected_error` times the greatest

    def _repr_html_(self) -> str:
        sides = [[side._title(), "%.4g" % side.area_m2, "%.3g" % side.reflectance, _html.bounded(side.direct),
                  _html.bounded(side.irradiance)] for side in self.sides]
        unit = translate(self.unit)
        fluxes = [("given off by the sources", self.emitted), ("of that meets no surface", self.missed),
                  ("arrives at surfaces directly", self.arrives), ("absorbed by surfaces", self.absorbed),
                  ("escapes after reflections", self.escaped),
                  ("reflected after the last bounce", self.pending if self.pending.error > 0 else None),
                  ("difference, in truth 0", self.difference)]
        return _html.table(["", translate("area, m²"), translate("reflects"), translate("direct, %s") % unit,
                            translate("all light, %s") % unit], sides) + _html.table(
            ["", translate(self.flux_unit)],
            [[translate(name), _html.bounded(flux)] for name, flux in fluxes if flux is not None])


def balance(found: Any) -> Optional[Balance]:
    """The balance of a tuple of the library."""
    if found is None:
        return None
    unit, flux_unit, sides, *fluxes, closes, reached = found
    lit: Any = [(*side[:-2], Amount(*side[-2]), Amount(*side[-1])) for side in sides]
    amounts: Any = [None if flux is None else Amount(*flux) for flux in fluxes]
    fields: Any = (unit, flux_unit, tuple(LitSide(*side) for side in lit), *amounts, closes, reached)
    return Balance(*fields)
