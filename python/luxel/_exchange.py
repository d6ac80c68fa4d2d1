# SPDX-License-Identifier: MIT
"""Form factors: of what a side of a surface sends, the share that arrives at another."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

from . import _html, _luxel
from ._arrays import shared
from ._balance import Amount
from ._language import translate
from ._settings import Carried, Progress, settings

if TYPE_CHECKING:
    from ._arrays import Floats


class ExchangeSide(NamedTuple):
    """One side of a surface."""

    surface: int  #: index in the scene's list
    surface_name: Optional[str]
    wall: Optional[str]  #: of a room or box, such as "floor"; None for other surfaces
    side: str  #: "front" or "back" of what is flat, "outside" or "inside" of what is round
    area_m2: float

    def _title(self) -> str:
        title = "surfaces[%d]" % self.surface + (" " + self.surface_name if self.surface_name else "")
        return ", ".join([title] + ([self.wall] if self.wall else []) + [translate(self.side)])


class Exchange:
    """The form factors between all sides: `exchange[i, j]` is the share of what side i sends that arrives at side j."""

    sides: Tuple[ExchangeSide, ...]  #: in the order of the surfaces
    reached: bool  #: each error is at most `reflected_error`

    def __init__(self, found: Any) -> None:
        sides, self._view, self.reached = found
        self.sides = tuple(ExchangeSide(*side) for side in sides)

    @property
    def factors(self) -> "Floats":
        """All factors: sides x sides, rows are the sides that send."""
        factors: "Floats" = shared(self._view)[:, 0::2]
        return factors

    @property
    def errors(self) -> "Floats":
        """Bounds of |factor - truth|."""
        errors: "Floats" = shared(self._view)[:, 1::2]
        return errors

    def __getitem__(self, pair: Tuple[int, int]) -> Amount:
        return Amount(float(self.factors[pair]), float(self.errors[pair]))

    def __len__(self) -> int:
        return len(self.sides)

    def __repr__(self) -> str:
        return "<luxel.Exchange of %d sides>" % len(self.sides)

    def _repr_html_(self) -> str:
        rows = [["%d %s" % (i, side._title()), "%.4g" % side.area_m2] +
                [_html.bounded(self[i, j]) for j in range(len(self))] for i, side in enumerate(self.sides)]
        return _html.table([translate("from side"), translate("area, m²")] +
                           [translate("to %zu").replace("%zu", str(j)) for j in range(len(self))], rows)


class Exchanging:
    """What a scene has of it."""

    __slots__ = ()

    _handle: Any
    _carried: Optional[Carried]

    def exchange(self, *, reflected_error: Optional[float] = None, threads: int = 0,
                 progress: Optional[Progress] = None) -> Exchange:
        """The form factors between all sides of the surfaces, each with a bound of its error.

        `reflected_error` is the error that is wanted, as a share of what a side sends, 1e-3 unless it is given.
        """
        return Exchange(_luxel.find_exchange(self._handle, settings(
            self._carried, None, None, threads, None, None, progress=progress, reflected_error=reflected_error)))
