# SPDX-License-Identifier: MIT
"""NumPy, loaded when it is needed, and arrays that share the library's memory."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    Floats = npt.NDArray[np.float64]
    Bools = npt.NDArray[np.bool_]


def shared(view: Any) -> Any:
    """An array of the numbers of a view, which it keeps alive: nothing is copied."""
    import numpy

    return numpy.asarray(view)


def taken(given: Any) -> Any:
    """An array of what NumPy knows, or of another library's that hands it over by DLPack alone."""
    import numpy

    if hasattr(given, "__dlpack__") and not any(hasattr(given, name) for name in ("__array__", "__array_interface__")):
        return numpy.from_dlpack(given)
    return numpy.asarray(given)


def floats(numbers: Any) -> "Floats":
    """An array of float64; one that is so already is taken as it is.  What is masked is NaN."""
    import numpy

    given: Any = numbers
    if hasattr(given, "filled"):  # a masked array
        given = given.astype(numpy.float64).filled(numpy.nan)
    given = taken(given)
    if given.dtype.kind == "c":
        raise TypeError("real numbers are expected, not complex ones")
    array: "Floats" = numpy.asarray(given, dtype=numpy.float64)
    return array


def spacing(numbers: Any) -> "Optional[Floats]":
    """How far apart the numbers of float32 or float16 are where places of such numbers lie; None of all others."""
    import numpy

    array: Any = taken(numbers)
    if array.dtype.kind != "f" or array.dtype.itemsize > 4 or array.ndim < 1:
        return None
    return floats(numpy.spacing(numpy.abs(array).max(axis=-1)))


class Arithmetic:
    """Operators of what has an array as its `values`: their results are arrays."""

    __slots__ = ()

    def _calculate(self, name: str, *others: Any) -> Any:
        import numpy

        return getattr(numpy.asarray(self), name)(*others)

    def __add__(self, other: Any) -> Any:
        return self._calculate("__add__", other)

    def __radd__(self, other: Any) -> Any:
        return self._calculate("__radd__", other)

    def __sub__(self, other: Any) -> Any:
        return self._calculate("__sub__", other)

    def __rsub__(self, other: Any) -> Any:
        return self._calculate("__rsub__", other)

    def __mul__(self, other: Any) -> Any:
        return self._calculate("__mul__", other)

    def __rmul__(self, other: Any) -> Any:
        return self._calculate("__rmul__", other)

    def __truediv__(self, other: Any) -> Any:
        return self._calculate("__truediv__", other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._calculate("__rtruediv__", other)

    def __pow__(self, other: Any) -> Any:
        return self._calculate("__pow__", other)

    def __neg__(self) -> Any:
        return self._calculate("__neg__")

    def __abs__(self) -> Any:
        return self._calculate("__abs__")

    def __lt__(self, other: Any) -> Any:
        return self._calculate("__lt__", other)

    def __le__(self, other: Any) -> Any:
        return self._calculate("__le__", other)

    def __gt__(self, other: Any) -> Any:
        return self._calculate("__gt__", other)

    def __ge__(self, other: Any) -> Any:
        return self._calculate("__ge__", other)
