# SPDX-License-Identifier: MIT
"""How values change with keys of the scene: derivatives at many places as arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterable, List, Literal, NamedTuple, Optional, Tuple, Union, overload

from . import _luxel
from ._arrays import floats
from ._settings import Lights, Progress, Settings, settings

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._arrays import Bools, Floats
    from ._scene import Scene

#: What a state of a derivative is called, in the order of the library.
STATES = ("exists", "one-sided", "no value", "kink", "jump")


class Jacobian(NamedTuple):
    """Derivatives at n places by k numbers of keys, and what else is known of them."""

    derivatives: "Floats"  #: n x k: in the value's unit per that of the key; NaN where there is none
    errors: "Floats"  #: n x k: about how far each may be off; NaN where there is none
    states: "npt.NDArray[np.uint8]"  #: n x k: indices in luxel.STATES, which tell why there is none
    values: "Floats"  #: n: the values themselves; NaN where there is none
    value_errors: "Floats"  #: n: bounds of their errors
    columns: List[str]  #: k: the keys, with an index where a key has several numbers

    @property
    def mask(self) -> "Bools":
        """n x k: where there is a derivative."""
        there: "Bools" = self.states <= 1
        return there


def names_of(keys: Union[str, Iterable[str]]) -> List[str]:
    """A list of keys, of one or of several."""
    names = [keys] if isinstance(keys, str) else list(keys)
    if not names:
        raise ValueError("keys: name at least one, such as 'lights[0].intensity'")
    return names


def columns_of(handle: "_luxel.SceneHandle", keys: List[str]) -> List[str]:
    """The numbers that keys have: 'lights[0].position[2]', or the key itself where it has one."""
    return [key if count == 1 else "%s[%d]" % (key, i)
            for key, count in zip(keys, _luxel.derive_numbers(handle, keys)) for i in range(count)]


def elements_of(elements: Any) -> "Floats":
    """Places, normals and views of elements side by side: rows of six or nine numbers."""
    import numpy

    if isinstance(elements, (tuple, list)) and len(elements) in (2, 3):
        arrays = numpy.broadcast_arrays(*(floats(part) for part in elements))
        if arrays[0].ndim and arrays[0].shape[-1] == 3:
            joined: "Floats" = numpy.concatenate([array.reshape(-1, 3) for array in arrays], 1)
            return joined
    array = floats(elements)
    if array.ndim < 1 or array.shape[-1] not in (6, 9):
        raise ValueError("elements: places and normals (..., 3) are expected, and views if they have their own")
    return array.reshape(-1, array.shape[-1])


def derive(handle: "_luxel.SceneHandle", keys: List[str], places: "Floats", surface: int, how: Settings, grid: int,
           full: bool) -> "Union[Floats, Jacobian]":
    """Derives the values at places, rows of 2, 6 or 9 numbers, or of a grid, whose cells the places then are."""
    import numpy

    columns = columns_of(handle, keys)
    shape: Tuple[int, int] = (len(places), len(columns))
    found = numpy.empty(shape)
    if not full:
        _luxel.derive(handle, keys, (places, None, None, found, None, None), surface, grid, how)
        return found
    values, value_errors = numpy.empty(shape[0]), numpy.empty(shape[0])
    errors, states = numpy.empty(shape), numpy.empty(shape)
    _luxel.derive(handle, keys, (places, values, value_errors, found, errors, states), surface, grid, how)
    return Jacobian(found, errors, states.astype(numpy.uint8), values, value_errors, columns)


def places_of(scene: "Scene", points: Any, elements: Any, grid: Union[None, str, int], pixels: bool) -> "Floats":
    """Places as rows of numbers: x, y of the screen, or place and normal, and view, of an element."""
    import numpy

    if elements is not None:
        return elements_of(elements)
    if grid is not None:
        plane = scene.grid(grid, lights=[])
        if plane.measure != "plane":
            raise ValueError("grid: one that measures on its plane is expected, not %s" % plane.measure)
        cells = plane.positions_mm
        cells[~plane.mask] = numpy.nan  # inside of bodies nobody measures
        return elements_of((cells, plane.axis))
    if pixels:
        picture = scene.render(quantity="irradiance", lights=[])
        x, y = numpy.meshgrid(floats(picture.x_mm), floats(picture.y_mm))
        return floats(numpy.stack([x.ravel(), y.ravel()], 1))
    array = floats(scene.points if points is None else points)
    if array.size and array.shape[-1] != 2:
        raise ValueError("points: pairs x, y in mm are expected")
    return array.reshape(-1, 2)


@overload
def jacobian(self: "Scene", keys: Union[str, Iterable[str]], points: Any = ..., *, elements: Any = ...,
             grid: Union[None, str, int] = ..., pixels: bool = ..., full: Literal[False] = ...,
             surface: Union[str, int] = ..., quantity: Optional[str] = ..., tolerance: Optional[float] = ...,
             reflected_error: Optional[float] = ..., threads: int = ..., lights: Optional[Lights] = ...,
             progress: Optional[Progress] = ...) -> "Floats": ...


@overload
def jacobian(self: "Scene", keys: Union[str, Iterable[str]], points: Any = ..., *, elements: Any = ...,
             grid: Union[None, str, int] = ..., pixels: bool = ..., full: Literal[True],
             surface: Union[str, int] = ..., quantity: Optional[str] = ..., tolerance: Optional[float] = ...,
             reflected_error: Optional[float] = ..., threads: int = ..., lights: Optional[Lights] = ...,
             progress: Optional[Progress] = ...) -> Jacobian: ...


def jacobian(self: "Scene", keys: Union[str, Iterable[str]], points: Any = None, *, elements: Any = None,
             grid: Union[None, str, int] = None, pixels: bool = False, full: bool = False,
             surface: Union[str, int] = 0, quantity: Optional[str] = None, tolerance: Optional[float] = None,
             reflected_error: Optional[float] = None, threads: int = 0, lights: Optional[Lights] = None,
             progress: Optional[Progress] = None) -> "Union[Floats, Jacobian]":
    """How values change with keys of the scene: an array (n, k), a row a place and a column a number of a key.

    A derivative is by the key's own unit: mm, degrees, W/sr.  NaN: there is none, as at the border of a hard
    shadow, or no value; `full` gives a Jacobian, which tells why, with errors, columns and the values.

    Places are `points` of the screen (n, 2), which stay there where a surface moves, or the scene's own; or free
    `elements`, a pair of places and normals (..., 3) and a third array of views if they have their own; or the
    cells of a `grid`, by name or index, row by row, for its irradiance; or the samples of all `pixels`, row by
    row from the top.  Light of points, cones, directions and from everywhere is derived by rules, all numbers at
    once; integrals, reflected light and tabulated luminaires take 4 to 16 values of all places for each number.
    """
    import numpy

    if sum((points is not None, elements is not None, grid is not None, pixels)) > 1:
        raise ValueError("one of points, elements, grid and pixels is expected")
    how = settings(self._carried, "irradiance" if grid is not None else quantity, None, threads, None, tolerance,
                   progress=progress, reflected_error=reflected_error, lights=self._group(lights))
    names = names_of(keys)
    if grid is not None:
        index = self._grid_index(grid)
        cells = self.grid(index, lights=[]).values.size
        return derive(self._handle, names, numpy.zeros((cells, 2)), 0, how, index, full)
    places = places_of(self, points, elements, None, pixels)
    return derive(self._handle, names, places, self._surface(surface), how, -1, full)
