# SPDX-License-Identifier: MIT
"""How something is computed: the words of the settings as the library's numbers."""
from __future__ import annotations

import struct
from typing import (Any, Callable, Iterable, Optional, Sequence, SupportsFloat, SupportsIndex, Tuple, Type,
                    Union)

QUANTITIES = ("brightness", "irradiance")
PRECISIONS = ("single", "double")
VIEWS = ("luminance", "red", "green", "blue", "cct")

#: Called at most 20 times a second with the share done, 0 to 1; returning False ends the work with a LuxelError.
Progress = Callable[[float], Any]
#: Lights of a scene: a name, an index, or several of them.
Lights = Union[str, int, Iterable[Union[str, int]]]
#: What luxel._luxel takes; the bytes are a group of lights, as group() packs it.
Settings = Tuple[int, int, int, Optional[str], float, float, float, int, bool, bool, Optional[bytes],
                 float, Optional[Progress]]
#: What a picture that carries its scene was made with: quantity, precision, tolerance, light_error.
Carried = Tuple[int, int, float, float, float]


def choice(name: str, word: str, words: Tuple[str, ...]) -> int:
    """The index of a word, which must be one of these."""
    if word not in words:
        from ._language import translate
        raise ValueError("%s: %r: %s" % (name, word, translate("one of") + " " + ", ".join(words)))
    return words.index(word)


def settings(carried: Optional[Carried], quantity: Optional[str] = None, precision: Optional[str] = None,
             threads: int = 0, instruction_set: Optional[str] = None, tolerance: Optional[float] = None,
             light_error: Optional[float] = None, stride: int = 1, minimum_reached: bool = False,
             progress: Optional[Progress] = None, reflected_error: Optional[float] = None,
             lights: Optional[bytes] = None, skip_reflected_pixels: bool = False,
             within: float = 0.0) -> Settings:
    """The settings: what is not given is as the picture tells that the scene was read from, or the default."""
    default = carried or (0, 0, 0.0, 0.0, 0.0)
    return (default[0] if quantity is None else choice("quantity", quantity, QUANTITIES),
            default[1] if precision is None else choice("precision", precision, PRECISIONS),
            _count("threads", threads, "a whole number is expected, 0 for all processors"), instruction_set,
            default[2] if tolerance is None else real("tolerance", tolerance),
            default[3] if light_error is None else real("light_error", light_error),
            default[4] if reflected_error is None else real("reflected_error", reflected_error),
            _count("stride", stride, "a whole number is expected, 1 for every pixel"), minimum_reached,
            skip_reflected_pixels, lights, real("within", within), progress)


def group(lights: Optional[Lights], names: Sequence[Optional[str]]) -> Optional[bytes]:
    """A group of lights as the library takes it, native numbers in a row; `names` are those of all lights."""
    if lights is None:
        return None
    found = [index_of("lights", light, names) for light in ([lights] if isinstance(lights, (str, int)) else lights)]
    return struct.pack("%dN" % len(found), *found)


def _count(name: str, number: int, expected: str) -> int:
    if not isinstance(number, SupportsIndex):
        raise TypeError("%s: %r: %s" % (name, number, expected))
    if not 0 <= number.__index__() < 1 << 32:
        raise ValueError("%s: %r: %s" % (name, number, expected))
    return number.__index__()


def real(name: str, number: Any) -> float:
    """A number of an argument that is called so."""
    try:
        return float(number)
    except (TypeError, ValueError):
        raise type_or_value(number)("%s: %r: a number is expected" % (name, number)) from None


def reals(name: str, numbers: Any, count: int, meaning: str) -> Tuple[float, ...]:
    """So many numbers of an argument that is called so; `meaning` tells what they are, for the message."""
    try:
        found = tuple(float(number) for number in numbers)
    except (TypeError, ValueError):
        found = ()
    if len(found) != count:
        raise type_or_value(numbers)("%s: %r: %s" % (name, numbers, meaning))
    return found


def point(name: str, numbers: Any) -> Tuple[float, float]:
    """A place of the screen that is called so."""
    x, y = reals(name, numbers, 2, "two numbers are expected, x and y in mm")
    return x, y


def type_or_value(thing: Any) -> Type[Exception]:
    """The kind of error for what is no list, number or text, and for one of these that is not as it should be."""
    return ValueError if hasattr(thing, "__len__") or isinstance(thing, SupportsFloat) else TypeError


def index_of(what: str, thing: Union[str, int], names: Sequence[Optional[str]]) -> int:
    """The index of one of several things, by its name or index."""
    if isinstance(thing, str):
        if thing not in names:
            raise KeyError("%s: %r: %s" % (what, thing, ", ".join(name for name in names if name)))
        return names.index(thing)
    if not isinstance(thing, SupportsIndex):
        raise TypeError("%s: %r: a name or an index is expected" % (what, thing))
    if not 0 <= thing.__index__() < len(names):
        raise IndexError("%s: %r: the scene has %d, counted from 0; or a name" % (what, thing, len(names)))
    return thing.__index__()
