# SPDX-License-Identifier: MIT
"""Daylight factors: what share of the light under the open sky reaches places indoors."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterable, NamedTuple, Optional, Sequence, Tuple

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


def _factor(found: Any) -> Optional[DaylightFactor]:
    return None if found is None else DaylightFactor(*(Amount(*part) for part in found))


def _grid(found: Any, is_photometric: bool) -> DaylightGrid:
    name, rows, columns, cells, mean, median, shares, is_measured = found
    nothing = ((float("nan"),) * 2,) * 4
    numbers = floats([nothing if cell is None else cell for cell in cells]).reshape(rows, columns, 4, 2)
    return DaylightGrid(name, numbers[:, :, 0, 0], numbers[:, :, 0, 1], numbers[:, :, 1, 0], numbers[:, :, 2, 0],
                        numbers[:, :, 3, 0], Amount(*mean) if is_measured else None,
                        Amount(*median) if is_measured else None,
                        dict(zip(LEVELS, shares)) if is_photometric and is_measured else None)


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
