# SPDX-License-Identifier: MIT
"""Figures: false colour with axes, isophotes and sections, drawn by the library luxel-figure, which needs cairo."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, List, Optional, Sequence, Tuple, Union

from . import _luxel
from ._settings import Settings, choice

if TYPE_CHECKING:
    from ._scene import Scene

Path = Union[str, "os.PathLike[str]"]
BANDS = ("smooth", "bands", "contours", "lines")


def drawing() -> Any:
    """The module that draws; ImportError where Luxel was built without figures."""
    from . import _figure
    from ._language import add_speaker

    add_speaker(_figure)
    return _figure


def palettes() -> List[str]:
    """The names of the palettes of figures, the default first.  ImportError where Luxel was built without figures."""
    names: List[str] = drawing().palettes()
    return names


class Drawing:
    """What is drawn when it is asked for: to a file, or in memory; a notebook shows it as SVG."""

    __slots__ = ()

    def save(self, path: Path) -> None:
        """Draws it to a file by the extension of its name: .png, .svg or .pdf, whole or not at all.

        Raises LuxelError where it cannot be drawn or written.
        """
        raise NotImplementedError

    def _bytes(self, ending: str) -> bytes:
        raise NotImplementedError

    def png(self) -> bytes:
        """The bytes of a PNG."""
        return self._bytes(".png")

    def svg(self) -> str:
        """The text of an SVG, letters as outlines."""
        return self._bytes(".svg").decode("utf-8")

    def pdf(self) -> bytes:
        """The bytes of a PDF with its fonts."""
        return self._bytes(".pdf")

    def _repr_svg_(self) -> str:
        return self.svg()


class Figure(Drawing):
    """A figure, drawn when it is asked for; a notebook shows it as SVG.

    It shows the scene as it was when the figure was made.
    """

    __slots__ = ("_scene", "_settings", "_look")

    def __init__(self, scene: "Scene", settings: Settings, look: Tuple[Any, ...]) -> None:
        self._scene = scene
        self._settings = settings
        self._look = look

    def save(self, path: Path) -> None:
        capsule = _luxel.scene_capsule(self._scene._handle)
        drawing().write_figure(capsule, self._settings, self._look, os.fsencode(path))

    def _bytes(self, ending: str) -> bytes:
        capsule = _luxel.scene_capsule(self._scene._handle)
        content: bytes = drawing().figure_bytes(capsule, self._settings, self._look, "figure" + ending)
        return content

    def __repr__(self) -> str:
        return "<luxel.Figure of %r>" % (self._scene,)

    def __reduce__(self) -> Tuple[Any, ...]:
        return Figure, (self._scene, self._settings[:-1] + (None,), self._look)


def look(palette: Optional[str], low: Optional[float], high: Optional[float], logarithmic: bool, bands: str,
         levels: Union[int, Sequence[float]], extrema: bool, points: bool,
         section: Union[None, str, Tuple[float, float]], stacked: bool, title: Optional[str], label: Optional[str],
         width_mm: float, dots_per_inch: float, dark: bool, small_print: bool, grid: int,
         daylight: bool) -> Tuple[Any, ...]:
    """What a figure shows, as luxel._figure takes it."""
    nan = float("nan")
    place = (0.0, 0.0)
    if section is None or isinstance(section, str):
        kind = 0 if section is None else 1 + choice("section", section, ("center", "maximum"))
    else:
        kind, place = 3, (float(section[0]), float(section[1]))
    wanted, chosen = (levels, None) if isinstance(levels, int) else (8, [float(level) for level in levels])
    return (palette, nan if low is None else low, nan if high is None else high, logarithmic,
            choice("bands", bands, BANDS), wanted, chosen, extrema, points, kind, place, stacked, title, label,
            width_mm, dots_per_inch, dark, small_print, grid, daylight)
