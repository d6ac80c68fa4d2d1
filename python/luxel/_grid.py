# SPDX-License-Identifier: MIT
"""Measuring grids: the irradiance on a plane, cell by cell, and how even it is."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional, Tuple, Union

from . import _html, _luxel
from ._arrays import shared
from ._balance import Amount
from ._language import translate
from ._results import GridArea, GridExtrema, GridExtremum, GridPeak, Vector
from ._room import Limit, limits
from ._settings import Progress, Settings

if TYPE_CHECKING:
    from ._arrays import Bools, Floats
    from ._scene import Scene


def _extremum(found: Any) -> Optional[GridExtremum]:
    return None if found is None else GridExtremum(*found)


def _area(found: Any) -> Optional[GridArea]:
    if found is None:
        return None
    measured, average, average_error, minimum, maximum, *rest = found
    error, u0, center, size = rest
    return GridArea(measured, average, average_error, _extremum(minimum), _extremum(maximum), error, u0, center, size)


class Grid:
    """A measured grid.  It is pickled as its scene, and then measured again.

    Row 0 is the top one, farthest along `up`; column 0 the first along up x axis.  The irradiance of each cell is
    that at its centre.  Where a source lies on a cell, or the cell is inside a body, there is no value: `mask` is
    False, the value 0.  A body is what a surface closes around, unless a light shines in it.
    """

    name: Optional[str]  #: in the scene
    center_mm: Vector
    size_mm: Tuple[float, float]  #: along up x axis, and along up
    axis: Vector  #: the normal of the elements, a unit vector
    up: Vector
    across: Vector  #: up x axis
    unit: str
    values: "Floats"  #: rows x columns
    errors: "Floats"  #: bounds of |value - truth|
    mask: "Bools"  #: True where the cell has a value
    inside: "Bools"  #: True where the cell is inside the body of a surface
    measured: int  #: how many have one
    blocking_light: Optional[int]  #: where a light lies on some: the one on the first
    error: float  #: the largest of the bounds
    average: Optional[float]  #: the mean of the values
    average_error: Optional[float]  #: bounds its distance from the mean of the true values
    minimum: Optional[GridExtremum]
    maximum: Optional[GridExtremum]
    u0: Optional[float]  #: minimum / average (EN 12665)
    ud: Optional[float]  #: minimum / maximum
    mean: Optional[float]  #: of the whole plane: its integral by its area
    mean_error: Optional[float]
    flux: Optional[float]  #: the power that falls on the plane
    flux_error: Optional[float]
    flux_unit: Optional[str]  #: "W" or "lm"
    sampling_error: Optional[float]  #: how far the average may be from the plane's mean
    sampling_is_bound: bool  #: a bound, else an estimate
    is_coarse: bool  #: finer cells are needed
    enclosing_surface: Optional[int]  #: a surface inside whose body some cells are
    enclosed: int  #: how many are
    tolerance_reached: bool
    measure: str  #: "plane", or "cylindrical" and so on: what the values are
    #: of a cylindrical grid the ratio of its average to that on its plane, its least and its greatest at a cell
    modelling: Optional[Tuple[Amount, Amount, Amount]]
    surround: Optional[GridArea]  #: where the scene asks for it and the walls leave room
    background: Optional[GridArea]

    def __init__(self, scene: "Scene", index: int, how: Settings) -> None:
        found: Any = _luxel.measure(scene._handle, index, how)
        self._again = (scene.copy(), index, how[:-1] + (None,))
        (self._holder, self.name, place, self.unit, values, errors, mask, inside, self.measured, self.blocking_light,
         self.error, self.average, self.average_error, minimum, maximum, self.u0, self.ud, plane, sampling,
         self.enclosing_surface, self.tolerance_reached, self.enclosed, self.measure, modelling, surround,
         background) = found
        self.surround, self.background = _area(surround), _area(background)
        self.modelling = (Amount(*modelling[0]), Amount(*modelling[1]), Amount(*modelling[2])) if modelling else None
        self.center_mm, self.size_mm, self.axis, self.up, self.across = place
        self._views = (values, errors, mask, inside)
        self.minimum, self.maximum = _extremum(minimum), _extremum(maximum)
        self.mean, self.mean_error, self.flux_unit, self.flux, self.flux_error = plane or (None,) * 5
        self.sampling_error, self.sampling_is_bound, self.is_coarse = sampling or (None, False, False)

    def __getattr__(self, name: str) -> Any:
        try:
            return shared(self.__dict__["_views"][("values", "errors", "mask", "inside").index(name)])
        except (KeyError, ValueError):
            raise AttributeError(name) from None

    @property
    def positions_mm(self) -> "Floats":
        """The centres of the cells: rows x columns x 3."""
        import numpy

        array: "Floats" = numpy.empty(self.values.shape + (3,))
        _luxel.grid_positions(self._holder, array)
        return array

    def extrema(self, *, progress: Optional[Progress] = None) -> GridExtrema:
        """The greatest and the least value on the whole plane, its sides and corners included, with their bounds.

        They are found with the settings that the grid was measured with, in its scene as it was then; neither is less
        extreme than `maximum` and `minimum`, which are those of the cells.  What is narrower than the places that are
        looked at lie apart may be missed.  Raises LuxelError.
        """
        scene, index, how = self._again
        found = _luxel.grid_extrema(scene._handle, index, how[:-1] + (progress,))
        return GridExtrema(*(None if peak is None else GridPeak(*peak) for peak in found))

    @property
    def limits(self) -> Tuple[Limit, ...]:
        """The limits of the grid (the key `limits`) in the scene as it was measured, and whether they are kept.

        Where the grid is to have some average those of the areas around it follow, as EN 12464-1 has them.
        """
        scene, index, _ = self._again
        return limits(_luxel.judge_grid(scene._handle, index, self._holder))

    def write(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the cells to a .csv file.  Raises LuxelError where it cannot be written."""
        _luxel.grid_write(self._holder, os.fsencode(path))

    def __reduce__(self) -> Tuple[Any, ...]:
        return Grid, self._again

    def __repr__(self) -> str:
        rows, columns = self.values.shape
        return "<luxel.Grid %s: %d x %d, %s %s>" % (self.name or "", columns, rows, _html.number(self.average, 6),
                                                     self.unit)

    def _repr_html_(self) -> str:
        rows = [[translate("average"), _html.number(self.average)],
                [translate("minimum"), _html.number(self.minimum and self.minimum.value)],
                [translate("maximum"), _html.number(self.maximum and self.maximum.value)],
                ["U0", _html.number(self.u0, 6)], ["Ud", _html.number(self.ud, 6)]]
        if self.flux is not None:
            rows.append([translate("flux") + " (%s)" % translate(self.flux_unit or ""), _html.number(self.flux)])
        return _html.table([self.name or "", translate(self.unit)], rows)
