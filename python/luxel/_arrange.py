# SPDX-License-Identifier: MIT
"""Layouts: how many luminaires, and how far apart, reach goals of grids and observers."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterable, List, NamedTuple, Optional, Tuple, Union

from . import _html, _luxel
from ._language import translate
from ._room import Limit, limits
from ._settings import Lights, Progress, settings

if TYPE_CHECKING:
    from ._scene import Scene


class LayoutLimit(NamedTuple):
    """A limit of a grid or an observer, and what a layout makes of it."""

    is_observer: bool  #: else a grid
    number: int  #: of it in the scene's list
    limit: Limit


class Layout(NamedTuple):
    """A light in columns and rows, or numbers of keys."""

    n: Tuple[int, int]  #: columns, rows; 0, 0 where keys were changed
    spacing_mm: Tuple[float, float]  #: of the columns, of the rows
    dimming: float  #: the share of its light that each luminaire gives, 1 where they are not dimmed
    reserve: float  #: the least of the values by their goals; below 1 one is missed
    limits: List[LayoutLimit]
    scene: "Scene"  #: with the goals as its limits
    numbers: Dict[str, float] = {}  #: where keys were changed: theirs, and there are no columns and rows

    @property
    def luminaires(self) -> int:
        return self.n[0] * self.n[1]


class Arrangement(NamedTuple):
    """What arrange() finds."""

    light: Optional[int]  #: which light of the scene's list is arranged; None where keys were changed
    layouts: List[Layout]  #: that reach the goals: the fewest luminaires first, of these the least power; may be empty
    missed: List[Layout]  #: of fewer luminaires, or of all where none reaches the goals: the nearest first
    fewest: int  #: fewer luminaires give too little light, wherever they stand
    tried: int  #: how many numbers of columns and rows were looked at
    computed: int  #: layouts whose scene was computed

    def _repr_html_(self) -> str:
        all_of_them = self.layouts + self.missed
        rows = [([_html.number(number, 6) for number in layout.numbers.values()] if layout.numbers else
                 ["%d × %d" % layout.n, "%g × %g mm" % layout.spacing_mm]) + [_html.number(layout.dimming, 3)] +
                [_html.number(of.limit.value, 5) for of in layout.limits] for layout in all_of_them]
        names = [of.limit.name for of in all_of_them[0].limits] if rows else []
        keys = list(all_of_them[0].numbers) if rows else []
        heads = keys or [translate("columns × rows"), translate("spacing, mm")]
        return _html.table(heads + [translate("dimmed to")] + [translate(name) for name in names], rows)


def _layouts(scene: "Scene", found: Any) -> List[Layout]:
    return [Layout(n, spacing, dimming, reserve,
                   [LayoutLimit(is_observer, index, limits(limit)[0]) for is_observer, index, limit in of],
                   scene._of_handle(handle), numbers) for n, spacing, dimming, reserve, of, handle, numbers in found]


def arrange(self: "Scene", *goals: str, light: Union[None, str, int] = None, dimming: bool = False, even: bool = False,
            most: int = 0, free: Union[str, Iterable[str]] = (), tolerance: Optional[float] = None,
            reflected_error: Optional[float] = None, threads: int = 0, lights: Optional[Lights] = None,
            progress: Optional[Progress] = None) -> Arrangement:
    """The fewest luminaires, in columns and rows, that reach the scene's limits and goals such as "average>=500".

    Goals are average, minimum, U0 and ratio with >=, maximum and ugr with <=, after "NAME:" where the scene has several
    grids.  The light is that which has an array, or `light`, by its name or index.  With `dimming` all may be dimmed
    alike, for the least power; `even` keeps columns and rows as far apart as twice their distance from the walls;
    `most` luminaires are tried, 100 unless it is given.  The scene stays as it is.

    With `free` keys, such as "lights[0].aim" or "dimming[windows].factor", numbers of luminaires stay, and the keys are
    found that reach the goals with the greatest reserve or, with `dimming`, with the least flux of all lights.
    """
    if not all(isinstance(goal, str) for goal in goals):
        raise TypeError("goals: texts such as 'average>=500' are expected")
    how = settings(self._carried, None, None, threads, None, tolerance, progress=progress,
                   reflected_error=reflected_error, lights=self._group(lights))
    keys = [free] if isinstance(free, str) else list(free)
    index, found, missed, fewest, tried, computed = _luxel.arrange(
        self._handle, list(goals), keys, (None if light is None else str(light), dimming, even, most), how)
    return Arrangement(None if index < 0 else index, _layouts(self, found), _layouts(self, missed), fewest, tried,
                       computed)
