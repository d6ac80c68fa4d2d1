# SPDX-License-Identifier: MIT
"""Rooms to begin a lighting design with, and verdicts by the limits of grids and observers."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, NamedTuple, Optional, Sequence, Tuple

from . import _luxel
from ._balance import Amount
from ._glare import Glare, glare, sight
from ._settings import Lights, Progress, Settings, reals, settings

if TYPE_CHECKING:
    from ._results import Vector
    from ._scene import Scene


class Limit(NamedTuple):
    """A limit of a grid or an observer, and whether it is kept."""

    name: str  #: the key, such as "average"
    wanted: float
    value: Optional[float]  #: None where there is none
    error: Optional[float]  #: bounds |value - truth|
    verdict: str  #: "pass", "fail", or "undecided" where the bound spans the limit


class Observer(NamedTuple):
    """An observer of a scene (its key `observers`) and how much the lights dazzle."""

    name: Optional[str]
    eye_mm: "Vector"
    view: "Vector"
    glare: Glare
    limits: Tuple[Limit, ...]


class RoomArray(NamedTuple):
    """A regular array of luminaires and what it gives on the work plane, reflected light included."""

    n: Tuple[int, int]  #: columns along x, rows along y
    average: Amount  #: of the values, lx
    uniformity: float  #: U0


class Room(NamedTuple):
    """A room as a scene, as `luxel room` writes it."""

    text: str  #: the scene file
    chosen: RoomArray
    smaller: Optional[RoomArray]  #: the next smaller array, where one was looked for

    @property
    def scene(self) -> "Scene":
        from ._scene import Scene

        return Scene.from_text(self.text, "room")


def limits(found: Any) -> Tuple[Limit, ...]:
    """Those of the library's tuples."""
    return tuple(Limit(*limit) for limit in found)


class Rated:
    """What a scene does for observers."""

    __slots__ = ()

    def glare(self: "Scene", eye_mm: Sequence[float], view: Sequence[float],  # type: ignore[misc]
              up: Optional[Sequence[float]] = None, *, tolerance: Optional[float] = None,
              reflected_error: Optional[float] = None, within: float = 0.0, threads: int = 0,
              lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Glare:
        """The unified glare rating (UGR) of an observer: where the eye is, and the way it looks.

        The background is the light that surfaces reflect (the scene's key `reflections`) and ambient light; without
        both there is no rating.  `up` is the observer's upward direction, else the scene's `observer.up`, else z.
        ValueError: a direction is 0, `up` is along the view, or the scene is in radiometric units.
        """
        how = _settings(self, tolerance, reflected_error, threads, lights, progress, within)
        return glare(_luxel.rate_glare(self._handle, sight(eye_mm, view, up), how))

    def observers(self: "Scene", *, tolerance: Optional[float] = None,  # type: ignore[misc]
                  reflected_error: Optional[float] = None, within: float = 0.0, threads: int = 0,
                  lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> List[Observer]:
        """The scene's observers (its key `observers`), rated as glare() does, and whether they keep their limits.

        ValueError: the scene is in radiometric units.
        """
        how = _settings(self, tolerance, reflected_error, threads, lights, progress, within)
        found: List[Observer] = []
        for i, (name, eye, view) in enumerate(_luxel.observers(self._handle)):
            rating, judged = _luxel.rate_observer(self._handle, i, how)
            found.append(Observer(name, eye, view, glare(rating), limits(judged)))
        return found


def _settings(scene: "Scene", tolerance: Optional[float], reflected_error: Optional[float], threads: int,
              lights: Optional[Lights], progress: Optional[Progress], within: float) -> Settings:
    """Those of ratings; a scene in radiometric units has none."""
    if scene["units"] != "photometric":
        raise ValueError("glare is rated by luminances, and the scene is in radiometric units: units: photometric")
    return settings(scene._carried, None, None, threads, None, tolerance, progress=progress,
                    reflected_error=reflected_error, lights=scene._group(lights), within=within)


def _array(found: Any) -> Optional[RoomArray]:
    return None if found is None else RoomArray(found[0], Amount(found[1], found[2]), found[3])


def room(x: float, y: float, z: float, *, file: Optional[str] = None, array: Optional[Tuple[int, int]] = None,
         target: Optional[float] = None, reflectances: Sequence[float] = (0.7, 0.5, 0.2), plane: float = 0.75,
         maintenance: float = 0.8, reflected_error: Optional[float] = None, threads: int = 0,
         progress: Optional[Progress] = None) -> Room:
    """A room of x by y metres, z high, with luminaires in a regular array, as `luxel room` makes it.

    `file` is a photometry file, without which there are panels of 3600 lm; `array` the columns and rows, without which
    the least regular array is found whose mean on the work plane reaches `target` (500 lx).  Raises LuxelError.
    """
    how = settings(None, None, None, threads, None, None, progress=progress, reflected_error=reflected_error)
    asked = ((float(x), float(y), float(z)), file, (0, 0) if array is None else tuple(array),
             0.0 if target is None else float(target),
             reals("reflectances", reflectances, 3, "three numbers are expected, of ceiling, walls and floor"),
             float(plane), float(maintenance))
    text, chosen, smaller = _luxel.design_room(asked, how)
    found = _array(chosen)
    assert found is not None
    return Room(text, found, _array(smaller))
