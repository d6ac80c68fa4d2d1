# SPDX-License-Identifier: MIT
"""What the pixels of a picture show: depths, normals, places and surfaces as arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from . import _luxel
from ._settings import Settings

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from ._arrays import Bools, Floats


class Geometry(NamedTuple):
    """What each pixel shows: arrays of rows x columns, row 0 on top, as of the field that render() makes.

    All is computed in float64.  As float32 or through a depth map places lie off their surface by their last digits:
    evaluate() takes such with its `surface_tolerance`.
    """

    depth_mm: "Floats"  #: how far it is from the observer along its line of view; 0 where no surface is seen
    normals: "Floats"  #: rows x columns x 3: unit normals towards the observer's side; 0 where no surface is seen
    positions_mm: "Floats"  #: rows x columns x 3: the places in the scene's frame; 0 where no surface is seen
    surfaces: "npt.NDArray[np.int32]"  #: indices in the scene's list; -1 where no surface is seen
    walls: "npt.NDArray[np.uint32]"  #: of a room or box 0 left, 1 right, 2 floor, 3 ceiling, 4 back, 5 front; else 0

    @property
    def mask(self) -> "Bools":
        """Where a surface is seen."""
        seen: "Bools" = self.surfaces >= 0
        return seen


def geometry(handle: "_luxel.SceneHandle", how: Settings) -> Geometry:
    """Looks through all pixels of a scene's picture."""
    import numpy

    columns, rows = _luxel.scene_resolution(handle)
    shape = (rows, columns)
    depth, normals, places = numpy.empty(shape), numpy.empty(shape + (3,)), numpy.empty(shape + (3,))
    surfaces, walls = numpy.empty(shape, numpy.int32), numpy.empty(shape, numpy.uint32)
    _luxel.geometry(handle, depth, normals, places, surfaces, walls, how)
    return Geometry(depth, normals, places, surfaces, walls)
