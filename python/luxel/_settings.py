# SPDX-License-Identifier: MIT
"""How something is computed: the words of the settings as the library's numbers."""
from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

QUANTITIES = ("brightness", "irradiance")
PRECISIONS = ("single", "double")

#: Called at most 20 times a second with the share done, 0 to 1; returning False ends the work with a LuxelError.
Progress = Callable[[float], Any]
#: What luxel._luxel takes.
Settings = Tuple[int, int, int, Optional[str], float, float, float, int, bool, Optional[Progress]]
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
             progress: Optional[Progress] = None, reflected_error: Optional[float] = None) -> Settings:
    """The settings: what is not given is as the picture tells that the scene was read from, or the default."""
    default = carried or (0, 0, 0.0, 0.0, 0.0)
    return (default[0] if quantity is None else choice("quantity", quantity, QUANTITIES),
            default[1] if precision is None else choice("precision", precision, PRECISIONS),
            _count("threads", threads), instruction_set, default[2] if tolerance is None else float(tolerance),
            default[3] if light_error is None else float(light_error),
            default[4] if reflected_error is None else float(reflected_error), _count("stride", stride),
            minimum_reached, progress)


def _count(name: str, number: int) -> int:
    if not 0 <= number < 1 << 32:
        raise ValueError("%s: %r" % (name, number))
    return number
