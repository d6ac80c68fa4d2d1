# SPDX-License-Identifier: MIT
"""Daylight: what share of the light under the open sky reaches places indoors, and when the sun shines on them."""
from __future__ import annotations

import datetime
from typing import TYPE_CHECKING, Any, Dict, Iterable, NamedTuple, Optional, Sequence, Tuple, Union

from . import _html, _luxel
from ._arrays import floats
from ._balance import Amount
from ._language import translate
from ._settings import Carried, Progress, settings

if TYPE_CHECKING:
    from ._arrays import Floats

LEVELS = (100, 300, 500, 750)  #: lx, of EN 17037
STEPS = (("minimum", 300, 100), ("medium", 500, 300), ("high", 750, 500))  #: of half a plane, and of 95 %


class DaylightFactor(NamedTuple):
    """The daylight factor of an element in percent, and the parts that it is the sum of."""

    value: Amount
    sky: Amount  #: from the sky
    external: Amount  #: from the ground
    internal: Amount  #: from surfaces that reflect, as the scene's key `reflections` says


class DaylightGrid(NamedTuple):
    """The daylight factors of a measuring grid in percent, rows x columns; NaN for a cell without a value."""

    name: Optional[str]
    values: "Floats"
    errors: "Floats"  #: bounds of |value - truth|
    sky: "Floats"
    external: "Floats"
    internal: "Floats"
    mean: Optional[Amount]
    median: Optional[Amount]
    shares: Optional[Dict[int, float]]  #: of the cells that reach 100, 300, 500, 750 lx for certain; None: radiometric
    without_sky: Optional[float]  #: the share of the cells from which no sky is seen: behind the no-sky line

    @property
    def level(self) -> Optional[str]:
        """What EN 17037 recommends that it keeps: "minimum", "medium", "high", or None."""
        shares = self.shares or dict.fromkeys(LEVELS, 0.0)
        kept = [name for name, half, most in STEPS if shares[half] >= .5 and shares[most] >= .95]
        return kept[-1] if kept else None


class Daylight(NamedTuple):
    """Daylight factors, as `luxel daylight` has them."""

    horizontal: Amount  #: the irradiance of a horizontal plane under the open sky, in the scene's unit
    outdoor: Optional[float]  #: lx under the open sky that `shares` are for; None in radiometric units
    grids: Tuple[DaylightGrid, ...]
    elements: Tuple[Optional[DaylightFactor], ...]  #: None where a source lies on one
    reached: bool  #: all errors are as small as was asked

    def _repr_html_(self) -> str:
        rows = [[grid.name or str(number), _html.bounded(grid.mean), _html.bounded(grid.median)]
                for number, grid in enumerate(self.grids, 1) if grid.mean and grid.median]
        return _html.table(["", translate("mean") + ", %", translate("median") + ", %"], rows)


class SunHours(NamedTuple):
    """When the sun shines on a place on a day."""

    hours: float
    spans: Tuple[Tuple[float, float], ...]  #: beginnings and ends, in seconds from the day's midnight by its clock
    level: Optional[str]  #: what EN 17037 recommends that it keeps: "none", "minimum", ...; None: not on such a day


class SunGrid(NamedTuple):
    """The sun on the cells of a measuring grid."""

    name: Optional[str]
    hours: "Floats"  #: rows x columns
    cells: Tuple[Tuple[SunHours, ...], ...]  #: row by row


class Sunlight(NamedTuple):
    """The sun of a day, as `luxel daylight --sun-hours` has it."""

    latitude: float  #: of the place, in degrees
    longitude: float
    offset: datetime.timedelta  #: of the day's clock from UTC
    open: SunHours  #: under the open sky
    grids: Tuple[SunGrid, ...]
    elements: Tuple[SunHours, ...]

    def _repr_html_(self) -> str:
        rows = [["P%d" % number, "%.4f" % one.hours] for number, one in enumerate(self.elements, 1)]
        rows += [[grid.name or str(number), "%.4f" % grid.hours.mean()] for number, grid in enumerate(self.grids, 1)]
        return _html.table(["", translate("sun, h")], rows)


class SunPatch(NamedTuple):
    """A part of a flat surface's front on which the scene's sun shines: a convex polygon."""

    surface: int  #: index in the scene's list
    name: Optional[str]
    part: Optional[str]  #: of a room or a box, such as "floor"
    room: Optional[int]  #: the room through whose opening the sun comes; None: through none
    opening: Optional[int]  #: which of its openings
    area: float  #: in mm2
    corners: "Floats"  #: n x 3 in mm, counter-clockwise as seen from the front
    others: Tuple[int, ...]  #: surfaces that are not flat and may take some of it


LEVEL_NAMES = ("none", "minimum", "medium", "high", None)


def _hours(found: Any) -> SunHours:
    seconds, level, spans = found
    return SunHours(seconds / 3600, tuple(spans), LEVEL_NAMES[level])


def _sun_grid(found: Any) -> SunGrid:
    name, rows, columns, cells = found
    made = [_hours(cell) for cell in cells]
    lines = tuple(tuple(made[row * columns:(row + 1) * columns]) for row in range(rows))
    return SunGrid(name, floats([cell.hours for cell in made]).reshape(rows, columns), lines)


def _factor(found: Any) -> Optional[DaylightFactor]:
    return None if found is None else DaylightFactor(*(Amount(*part) for part in found))


def _grid(found: Any, is_photometric: bool) -> DaylightGrid:
    name, rows, columns, cells, mean, median, shares, is_measured = found
    nothing = ((float("nan"),) * 2,) * 4
    numbers = floats([nothing if cell is None else cell for cell in cells]).reshape(rows, columns, 4, 2)
    return DaylightGrid(name, numbers[:, :, 0, 0], numbers[:, :, 0, 1], numbers[:, :, 1, 0], numbers[:, :, 2, 0],
                        numbers[:, :, 3, 0], Amount(*mean) if is_measured else None,
                        Amount(*median) if is_measured else None,
                        dict(zip(LEVELS, shares)) if is_photometric and is_measured else None,
                        _without_sky(cells) if is_measured else None)


def _without_sky(cells: Any) -> float:
    skies = [cell[1] for cell in cells if cell is not None]
    return sum(not value + error > 0 for value, error in skies) / len(skies)


class Daylit:
    """What measures the daylight of a scene."""

    __slots__ = ()

    _handle: "_luxel.SceneHandle"
    _carried: Optional[Carried]

    def daylight(self, elements: Iterable[Sequence[float]] = (), *, outdoor: Optional[float] = None,
                 tolerance: Optional[float] = None, reflected_error: Optional[float] = None, within: float = 0.0,
                 threads: int = 0, progress: Optional[Progress] = None) -> Daylight:
        """The daylight factors of all measuring grids, and of free elements (x, y, z, nx, ny, nz), in percent.

        `outdoor` is the illuminance under the open sky for the shares of EN 17037, else that of the scene's sky.
        LuxelError: there is no sky.
        """
        how = settings(self._carried, None, None, threads, None, tolerance, progress=progress,
                       reflected_error=reflected_error, within=within)
        places = [tuple(float(number) for number in element) for element in elements]
        found: Any = _luxel.find_daylight(self._handle, places, outdoor or 0.0, how)
        horizontal, lux, grids, factors, reached = found
        return Daylight(Amount(*horizontal), lux, tuple(_grid(grid, lux is not None) for grid in grids),
                        tuple(_factor(factor) for factor in factors), reached)

    def sunlight(self, date: Union[str, datetime.date], elements: Iterable[Sequence[float]] = (), *,
                 place: Optional[Sequence[float]] = None, least_altitude: float = 0.0, threads: int = 0,
                 progress: Optional[Progress] = None) -> Sunlight:
        """When the sun shines on all measuring grids, and on free elements (x, y, z, nx, ny, nz), on a day.

        `date` is "2026-03-21", by UTC, or "2026-03-21+01:00", by another clock. `place` is its latitude and longitude
        in degrees, else that of the scene's light that has them. Lower than `least_altitude` degrees the sun does not
        count. LuxelError: the date cannot be read, or there is no place.
        """
        how = settings(self._carried, None, None, threads, None, None, progress=progress)
        places = [tuple(float(number) for number in element) for element in elements]
        where = None
        if place is not None:
            north, east = place
            where = (float(north), float(east))
        found: Any = _luxel.find_sunlight(self._handle, places, str(date), where, float(least_altitude), how)
        latitude, longitude, minutes, above, grids, hours = found
        return Sunlight(latitude, longitude, datetime.timedelta(minutes=minutes), _hours(above),
                        tuple(_sun_grid(grid) for grid in grids), tuple(_hours(one) for one in hours))

    def sun_patches(self) -> Tuple[SunPatch, ...]:
        """On which parts of rectangles, boxes and rooms the scene's sun shines, less the shadows of all that is flat.

        LuxelError: there is no sun.
        """
        found: Any = _luxel.find_sun_patches(self._handle)
        return tuple(SunPatch(surface, name, part, room, opening, area, floats(corners).reshape(-1, 3), tuple(others))
                     for surface, name, part, room, opening, area, corners, others in found[1])
