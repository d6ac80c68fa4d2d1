# SPDX-License-Identifier: MIT
"""NumPy, loaded when it is needed, and arrays that share the library's memory."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Bools = npt.NDArray[np.bool_]


def shared(view: Any) -> Any:
    """An array of the numbers of a view, which it keeps alive: nothing is copied."""
    import numpy

    return numpy.asarray(view)


def floats(numbers: Any) -> "Floats":
    """An array of float64; one that is so already is taken as it is."""
    import numpy

    array: "Floats" = numpy.asarray(numbers, dtype=numpy.float64)
    return array
