# SPDX-License-Identifier: MIT
"""Fits: the keys of a scene that make it give what was measured, with error bars."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, List, NamedTuple, Optional, Tuple, Union

from . import _html, _luxel
from ._arrays import floats
from ._field import Field
from ._jacobian import names_of, places_of
from ._language import translate
from ._settings import Lights, Progress, Settings, choice, real, settings

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._scene import Scene

LOSSES = ("gaussian", "huber", "tukey")


class FitParameter(NamedTuple):
    """A number that was found; None for what the readings do not determine, and for errors where they tell none."""

    key: str  #: with an index where the key has several numbers: "lights[0].position[2]"
    unit: str
    value: Optional[float]
    sd: Optional[float]  #: standard deviation: the truth is within in 68.3 of 100 cases
    low: Optional[float]  #: the interval from here
    high: Optional[float]  #: to here holds the truth in 95 of 100 cases
    is_at_limit: bool  #: the value is the least or greatest legal one, and the readings ask for more


class Fit(NamedTuple):
    """What fit() finds."""

    parameters: List[FitParameter]  #: in the order of the keys; where values are relative their factor, too, is last
    rank: int  #: how many numbers, or combinations of them, are determined
    undetermined: List[str]  #: what is not, in words
    scene: "Scene"  #: the fitted scene; what is not determined is somewhere on what fits as well
    residuals: "Floats"  #: in the form of the values: these less what the fitted scene gives; NaN where none was used
    correlation: "Floats"  #: k x k; NaN where there are no errors
    chi2: float  #: the sum of squares in standard deviations
    dof: int  #: degrees of freedom
    noise: float  #: the standard deviation of a reading
    noise_is_estimated: bool  #: it is told by how the readings scatter
    readings: int  #: that were used
    saturated: int  #: of these, that are saturated
    outliers: int  #: that are off by more than 3.5 standard deviations, where `loss` bears them
    without_derivative: int  #: that say nothing of the errors, as the value jumps or has a kink there
    starts: int  #: how many were taken
    agreed: int  #: how many of them ended here
    converged: bool

    def __getitem__(self, key: Any) -> Any:
        """A parameter by its key, "lights[0].intensity"; a field of the tuple by its index."""
        if not isinstance(key, str):
            return tuple.__getitem__(self, key)
        for parameter in self.parameters:
            if parameter.key == key:
                return parameter
        raise KeyError(key)

    def _repr_html_(self) -> str:
        rows = [[parameter.key, _html.number(parameter.value), _html.number(parameter.sd, 3), translate(parameter.unit)]
                for parameter in self.parameters]
        return _html.table([translate("key"), translate("value"), "sd", ""], rows)


def noise_of(noise: Union[None, float, str]) -> Tuple[float, float]:
    """The standard deviation of a reading, and its share of it: of 0.01, "3%" or "3%+0.01"."""
    if not isinstance(noise, str):
        return (0.0, 0.0) if noise is None else (real("noise", noise), 0.0)
    share, percent, rest = noise.partition("%")
    if not percent:
        return real("noise", noise), 0.0
    if rest and not rest.startswith("+"):
        raise ValueError("noise: %r: a share such as '3%%', a number, or both, '3%%+0.01', are expected" % noise)
    return real("noise", rest[1:]) if rest else 0.0, real("noise", share) / 100


def search(scene: "Scene", keys: List[str], places: "Optional[Floats]", values: "Floats", surface: int,
        how: Tuple[float, float, float, float, bool, bool, int, int], computing: Settings) -> Fit:
    """Fits to values at places, rows of 2, 6 or 9 numbers, or of all pixels."""
    import numpy

    flat = values.reshape(-1) if places is not None else values
    residuals = numpy.empty(flat.shape)
    if places is not None and len(places) != flat.size:
        raise ValueError("values: %d are expected, one for each place, not %d" % (len(places), flat.size))
    (parameters, rank, readings, saturated, without, outliers, estimated, noise, chi2, dof, correlation, starts, agreed,
     converged, undetermined, handle) = _luxel.fit(scene._handle, keys, (places, flat, residuals), surface, how,
                                                   computing)
    return Fit([FitParameter(*parameter) for parameter in parameters], rank, undetermined, scene._of_handle(handle),
               residuals.reshape(values.shape), numpy.array(correlation).reshape(len(parameters), len(parameters)),
               chi2, dof, noise, estimated, readings, saturated, outliers, without, starts, agreed, converged)


def loss_of(loss: str) -> int:
    return choice("loss", loss, LOSSES)


def fit(self: "Scene", keys: Union[str, Iterable[str]], values: Any, points: Any = None, *, elements: Any = None,
        grid: Union[None, str, int] = None, noise: Union[None, float, str] = None, saturated: float = 0,
        loss: str = "gaussian", relative: bool = False, quantum: float = 0, truncated: bool = False,
        starts: int = 0, surface: Union[str, int] = 0, quantity: Optional[str] = None,
        tolerance: Optional[float] = None, reflected_error: Optional[float] = None, threads: int = 0,
        lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Fit:
    """The numbers of keys that make the scene give measured values, with error bars; the scene stays as it is.

    `values` are those at `points` of the screen, the scene's own unless they are given, at `elements` or at the
    cells of a `grid`, as jacobian() takes them; or a Field, or an array of as many rows and columns as the scene
    has pixels, without any of these.  NaN: left out.  The numbers of the scene are the first start.

    `noise` is the standard deviation of a value, or "3%" of it, or both, "3%+0.01"; without, how the values
    scatter tells it.  Values from `saturated` on say only that the truth is no less.  `loss`: "gaussian", "huber"
    or "tukey", which bear outliers.  `relative`: values are known only up to one factor.  `quantum`: the step of
    the levels that they are rounded to, or down to if `truncated`.  What is not determined has no value, and
    `undetermined` tells it in words.
    """
    import numpy

    is_field = isinstance(values, Field)
    array = floats(values.values if is_field else values)
    places_given = sum((points is not None, elements is not None, grid is not None))
    if places_given > 1:
        raise ValueError("one of points, elements and grid is expected")
    pixels = is_field or (places_given == 0 and array.ndim == 2 and array.shape == self.resolution[::-1])
    if is_field and array.shape != self.resolution[::-1]:
        raise ValueError("values: the scene has %d x %d pixels, the picture %d x %d" %
                         (self.resolution + array.shape[::-1]))
    places = None if pixels else places_of(self, points, elements, grid, False)
    if pixels:
        array = numpy.where(self.geometry().mask, array, numpy.nan)
    absolute, share = noise_of(noise)
    how = (absolute, share, real("saturated", saturated), real("quantum", quantum), bool(truncated),
           bool(relative), loss_of(loss), starts)
    computing = settings(self._carried, "irradiance" if grid is not None else quantity, None, threads, None, tolerance,
                         progress=progress, reflected_error=reflected_error, lights=self._group(lights))
    return search(self, names_of(keys), places, array, self._surface(surface), how, computing)
