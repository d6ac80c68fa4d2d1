# SPDX-License-Identifier: MIT
"""Fields: computed pictures whose numbers NumPy shares."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, Union

from . import _luxel
from ._arrays import Arithmetic, shared
from ._results import Comparison, Extrema, Histogram, Isophote, Peak, Profile, Statistics, Summary, extremum, statistics
from ._settings import PRECISIONS, QUANTITIES, VIEWS, Progress, Settings, choice, point, real, settings

if TYPE_CHECKING:
    from ._arrays import Bools, Floats
    from ._scene import Scene

Path = Union[str, "os.PathLike[str]"]
#: A part of the screen in mm: (x, y, width, height) of a rectangle or (x, y, radius) of a circle, from the centre.
Region = Union[Tuple[float, float, float], Tuple[float, float, float, float]]
BOUNDS = {"single": 2e-6, "double": 1e-11}


class Field(Arithmetic, _luxel.FieldHandle):
    """A picture: rows x columns values, row 0 on top, float32 or float64 by its precision; in colour three for each.

    `numpy.asarray(field)` and `memoryview(field)` share its memory, which is never written; they keep it alive.  Off
    the surfaces the value is 0 and `mask` False.  Fields are made by Scene.render(), luxel.read() and Field.of().
    Indices, arithmetic and comparisons (but ==) are those of the array `values`: `field[0, :10]`, `a - b`, `field > 1`.
    """

    __slots__ = ("_made",)
    _made: Settings  #: how it was rendered; not set where it was read

    def _about(self) -> Tuple[int, int, int, int, str, str, str]:
        return _luxel.field_about(self)

    @property
    def columns(self) -> int:
        """The number of columns."""
        return self._about()[0]

    @property
    def rows(self) -> int:
        """The number of rows."""
        return self._about()[1]

    @property
    def shape(self) -> Tuple[int, ...]:
        """Rows and columns, as of the array, and 3 of a picture in colour."""
        values: Any = self  # a buffer, which types before Python 3.12 cannot say
        return memoryview(values).shape or ()

    @property
    def quantity(self) -> str:
        """What was computed: "brightness" or "irradiance"."""
        return QUANTITIES[self._about()[2]]

    @property
    def quantity_word(self) -> str:
        """What it is called: "luminance" and "illuminance" in photometric units; "values" where it is not known."""
        return self._about()[4]

    @property
    def precision(self) -> str:
        """ "single" (float32) or "double" (float64)."""
        return PRECISIONS[self._about()[3]]

    @property
    def unit(self) -> str:
        """The unit of the values, such as "W/sr"; "" where it is not known."""
        return self._about()[5]

    @property
    def instruction_set(self) -> str:
        """Whose kernels computed it; "" for one that was read."""
        return self._about()[6]

    @property
    def scene_text(self) -> Optional[str]:
        """The scene as YAML; None where it is not known, as of a stride above 1."""
        return _luxel.field_text(self)

    @property
    def scene(self) -> "Optional[Scene]":
        """A copy of the scene as it was rendered; None of a field that was read from a file without one."""
        handle = _luxel.field_scene(self)
        from ._scene import Scene

        if handle is not None:
            return Scene._of_handle(handle)
        text = self.scene_text
        return None if text is None else Scene.from_text(text)

    @property
    def values(self) -> Any:
        """The values as an array, float32 or float64, which shares the field's memory.

        Of a scene with `channels: rgb` they are rows x columns x 3, red, green and blue in linear sRGB.
        """
        return shared(self)

    @property
    def luminance(self) -> Any:
        """The luminance of a picture in colour, rows x columns, which its statistics are of; else the values."""
        return shared(_luxel.field_luminance(self))

    def view(self, name: str) -> "Field":
        """The field of a channel, "red", "green" or "blue", or of "cct", the colour temperature in K.

        Where a pixel has no colour temperature it is off the mask of that.  Raises LuxelError of a grey picture.
        """
        field: Field = _luxel.field_view(Field, self, choice("name", name, VIEWS))
        return field

    @property
    def mask(self) -> "Bools":
        """Where a surface is seen: an array of bool."""
        array: "Bools" = shared(_luxel.field_mask(self))
        return array

    @property
    def x_mm(self) -> "Optional[Floats]":
        """The places of the columns' samples on the screen, from the left; None where they are not known."""
        view = _luxel.field_places(self)[0]
        return None if view is None else shared(view)

    @property
    def y_mm(self) -> "Optional[Floats]":
        """The places of the rows' samples on the screen, from the top down; None where they are not known."""
        view = _luxel.field_places(self)[1]
        return None if view is None else shared(view)

    @property
    def error(self) -> float:
        """How far a value may be from the truth: 2e-6 of the picture's maximum, with precision "double" 1e-11.

        NaN of a field that was read from a file.
        """
        found = self.statistics.maximum
        if not self.instruction_set:
            return float("nan")
        return BOUNDS[self.precision] * (found.value if found else 0.0)

    @property
    def conventions(self) -> Dict[str, str]:
        """The conventions that decide the numbers, such as {"sampling": "nodes"}."""
        scene = self.scene
        return scene.conventions if scene is not None else {}

    @property
    def statistics(self) -> Statistics:
        """The extrema of the pixels, their mean, and how many show a surface."""
        return statistics(_luxel.field_statistics(self))

    def __len__(self) -> int:
        return self.rows

    def __bytes__(self) -> bytes:
        """The values as they lie in memory."""
        return memoryview(self.values).tobytes()

    def __getitem__(self, index: Any) -> Any:
        return self.values[index]

    def max(self, axis: Any = None, **how: Any) -> Any:
        """The greatest of all values, as of the array; `statistics` has those of surfaces alone."""
        return self.values.max(axis, **how)

    def min(self, axis: Any = None, **how: Any) -> Any:
        """The least of all values, as of the array: 0 where a pixel shows no surface."""
        return self.values.min(axis, **how)

    def mean(self, axis: Any = None, **how: Any) -> Any:
        """The mean of all values, as of the array; `statistics.mean` is that of the pixels that show a surface."""
        return self.values.mean(axis, **how)

    def __dlpack__(self, *, stream: Any = None, **how: Any) -> Any:
        """The values for another library of arrays, such as torch.from_dlpack(field): a copy, which may be written."""
        if how.get("copy") is False:
            raise BufferError("a field cannot be written, so what is handed over is a copy")
        return self.values.copy().__dlpack__(stream=stream)

    def __dlpack_device__(self) -> Tuple[int, int]:
        return 1, 0  # the memory of the processor

    def summary(self, region: Optional[Region] = None) -> Summary:
        """Mean, median, deviation, extrema and evenness of the pixels of a region, or of all."""
        found = _luxel.field_summary(self, region)
        return Summary(found[0], extremum(found[1]), extremum(found[2]), *found[3:])

    def histogram(self, bins: int = 50, *, region: Optional[Region] = None, logarithmic: bool = False,
                  low: Optional[float] = None, high: Optional[float] = None) -> Histogram:
        """How many pixels lie in each of the bins from low to high; else from the least to the greatest value."""
        import numpy

        nan = float("nan")
        edges, counts, *rest = _luxel.field_histogram(self, region, logarithmic, nan if low is None else low,
                                                      nan if high is None else high, bins)
        return Histogram(numpy.array(edges), numpy.array(counts, dtype=numpy.int64), *rest)

    def grey(self, bits: int = 8) -> Any:
        """The grey levels by the rule of the scene's `picture`: an array of uint8, or of uint16 for 16 bits."""
        import numpy

        if bits not in (8, 16):
            raise ValueError("bits: 8, 16")
        levels = numpy.empty(self.luminance.shape, numpy.uint8 if bits == 8 else numpy.uint16)
        _luxel.field_grey(self, levels)
        return levels

    def _settings(self, threads: int, tolerance: Optional[float], progress: Optional[Progress]) -> Settings:
        made = getattr(self, "_made", None)
        return settings(None, quantity=self.quantity, threads=threads, tolerance=tolerance, progress=progress,
                        lights=made[10] if made else None)

    def _exact(self) -> "_luxel.SceneHandle":
        handle = _luxel.field_scene(self)
        if handle is None:
            raise ValueError("this field does not know its scene: render it, or ask with exact=False")
        return handle

    def extrema(self, region: Optional[Region] = None, *, threads: int = 0, tolerance: Optional[float] = None,
                progress: Optional[Progress] = None) -> Extrema:
        """The true maximum and minimum of the exact function, between the pixels, with bounds of their errors."""
        found = _luxel.field_extrema(self._exact(), self, region, self._settings(threads, tolerance, progress))
        return Extrema(*(None if peak is None else Peak(*peak) for peak in found))

    def isophotes(self, levels: Union[int, Sequence[float]] = 8, *, exact: bool = True, logarithmic: bool = False,
                  threads: int = 0, tolerance: Optional[float] = None,
                  progress: Optional[Progress] = None) -> List[Isophote]:
        """The lines of equal value, of these levels or of about so many round ones.

        Exact ones lie on their level to 1e-9; else they are those of the picture.
        """
        if isinstance(levels, int):
            found = self.statistics.maximum
            levels = _luxel.round_levels(0.0, found.value if found else 0.0, logarithmic, levels)
        scene = self._exact() if exact else None
        lines = _luxel.field_isophotes(self, scene, [real("levels[%d]" % i, level) for i, level in enumerate(levels)],
                                       self._settings(threads, tolerance, progress))
        return [Isophote(level, closed, shared(x), shared(y)) for level, closed, x, y in lines]

    def profile(self, start: Tuple[float, float], end: Tuple[float, float], samples: Optional[int] = None) -> Profile:
        """The pixels' values along a line of the screen, in mm; Scene.profile() gives the exact ones."""
        path = (False, *point("start", start), *point("end", end),
                max(2, *self.shape) if samples is None else samples)
        return profile(_luxel.field_profile(self, path))

    def write(self, path: Path, *, bits: int = 8) -> None:
        """Writes it to a file by the extension of its name: .png, .exr, .npy, .pfm or .csv, whole or not at all.

        `bits` of a grey level in .png: 8 or 16.  PNG and EXR carry the scene.  Raises LuxelError.
        """
        _luxel.field_write(self, os.fsencode(path), bits)

    def to_xarray(self) -> Any:
        """An xarray.DataArray over y_mm and x_mm, with unit, quantity and conventions as attributes.

        Off the surfaces it holds NaN, so it is a copy; of a picture in colour, the luminance.
        Raises ValueError where the places are not known.
        """
        import importlib

        import numpy

        xarray: Any = importlib.import_module("xarray")
        if self.x_mm is None or self.y_mm is None:
            raise ValueError("this field does not know its places")
        seen = self.luminance
        values = numpy.where(self.mask, seen, seen.dtype.type(numpy.nan))
        attributes = {"units": self.unit, "quantity": self.quantity_word, "precision": self.precision,
                      "long_name": self.quantity_word}
        attributes.update({"convention_" + key: value for key, value in self.conventions.items()})
        return xarray.DataArray(values, dims=("y_mm", "x_mm"), coords={"y_mm": self.y_mm, "x_mm": self.x_mm},
                                name=self.quantity_word, attrs=attributes)

    def png(self, bits: int = 8) -> bytes:
        """The bytes of the picture that write() makes of it."""
        return self.to_bytes(".png", bits)

    def to_bytes(self, extension: str, bits: int = 8) -> bytes:
        """The bytes of the file that write() makes of a name with this extension, such as ".npy"."""
        content: bytes = _luxel.field_bytes(self, "field" + extension, bits)
        return content

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        return "<luxel.Field %d x %d: %s%s, %s>" % (self.columns, self.rows, self.quantity_word,
                                                    " in " + self.unit if self.unit else "", self.precision)

    def __reduce__(self) -> Tuple[Any, ...]:
        if _luxel.field_scene(self) is not None:
            return _rendered, (self.scene, self._made)
        if self.scene_text is not None:
            return _of_bytes, (self.to_bytes(".exr"),)
        columns, rows, quantity, precision, word, unit = self._about()[:6]
        places = [None if view is None else shared(view).tobytes() for view in _luxel.field_places(self)]
        return _of_parts, (columns, rows, precision, -1 if word == "values" else quantity, unit or None,
                           self.values.tobytes(), self.mask.tobytes(), *places)

    @classmethod
    def of(cls, values: Any, *, mask: Any = None, x_mm: Any = None, y_mm: Any = None, unit: Optional[str] = None,
           quantity: Optional[str] = None) -> "Field":
        """A field of your own values, such as those of another program or of a measurement, to compare, draw and write.

        `values`: rows x columns, row 0 on top, which are copied: float32 stays, all else becomes float64.  `mask`: as
        many of bool, true on a surface; else that is where the value is not 0.  `x_mm`, `y_mm`: the places of the
        columns, going up, and of the rows, going down; both or none.  `quantity`: "brightness" or "irradiance", where
        it is known.  Raises LuxelError, ValueError where shapes do not fit.
        """
        import numpy

        array = numpy.asarray(values)
        if array.ndim != 2 or 0 in array.shape:
            raise ValueError("rows x columns of values are needed, not the shape %r" % (array.shape,))
        is_single = array.dtype == numpy.float32
        kinds = (numpy.float32 if is_single else numpy.float64, numpy.bool_, numpy.float64, numpy.float64)
        shapes = (array.shape, array.shape, array.shape[1:], array.shape[:1])
        parts = [None if part is None else numpy.ascontiguousarray(part, dtype=kind)
                 for part, kind in zip((array, mask, x_mm, y_mm), kinds)]
        for name, part, shape in zip(("values", "mask", "x_mm", "y_mm"), parts, shapes):
            if part is not None and part.shape != shape:
                raise ValueError("%s has the shape %r, not %r" % (name, part.shape, shape))
        kind = -1 if quantity is None else choice("quantity", quantity, QUANTITIES)
        return _luxel.field_of_values(cls, array.shape[1], array.shape[0], 0 if is_single else 1, kind, unit, *parts)


def made(handle: "_luxel.SceneHandle", how: Settings) -> Field:
    """Renders a scene."""
    field: Field = _luxel.render(handle, Field, how)
    field._made = how[:-1] + (None,)
    return field


def _rendered(scene: "Scene", how: Settings) -> Field:
    """Renders a field that was pickled."""
    return made(scene._handle, how)


def _of_bytes(content: bytes) -> Field:
    """A field that was pickled as a picture that carries its scene."""
    return _luxel.field_read_bytes(Field, content, "<pickle>.exr")


def _of_parts(columns: int, rows: int, precision: int, quantity: int, unit: Optional[str], *parts: Any) -> Field:
    """A field that was pickled as its values, mask and places."""
    return _luxel.field_of_values(Field, columns, rows, precision, quantity, unit, *parts)


def profile(found: Any) -> Profile:
    """The profile of a tuple of the library."""
    arrays: Any = [None if view is None else shared(view) for view in found]
    return Profile(*arrays)


def read(path: Path) -> Field:
    """Reads a field from an .npy, .pfm, .csv or .exr file; docs/FILES.md tells what goes.  Raises LuxelError."""
    field: Field = _luxel.field_read(Field, os.fsencode(path))
    return field


def compare(a: Field, b: Field) -> Comparison:
    """How far two pictures of the same size are apart, pixel by pixel; differences are b - a.

    Raises LuxelError where their sizes or places differ.
    """
    found = _luxel.compare(a, b, Field)
    fields: Any = (*found[:3], extremum(found[3]), *found[4:])
    return Comparison(*fields)
