# SPDX-License-Identifier: MIT
"""Scenes: read, changed by the paths of `luxel -s`, rendered, probed, measured."""
from __future__ import annotations

import json
import os
from _thread import allocate_lock
from typing import (TYPE_CHECKING, Any, Dict, Iterable, Iterator, List, Mapping, Optional, Sequence, Tuple, Union,
                    overload)

from . import _arrange, _camera, _daylight, _exchange, _fit, _flow, _jacobian, _luxel, _stereo, _torch
from ._arrays import floats, spacing
from ._balance import Balance, balance
from ._document import Document
from ._errors import Diagnostic, LuxelError, LuxelNotFoundError
from ._field import Field, made, profile
from ._geometry import Geometry, geometry
from ._grid import Grid
from ._language import translate
from ._pictures import Figure, drawing, look
from ._probe import Probe, Probes, probes
from ._results import Alternative, Judgement, Light, Mesh, Profile, Statistics, Vector, alternatives, statistics
from ._room import Rated
from ._settings import (QUANTITIES, Carried, Lights, Progress, choice, group, index_of, point as _point, real, reals,
                        settings)

if TYPE_CHECKING:
    import numpy
    import numpy.typing as npt

    from ._arrays import Floats

Path = Union[str, "os.PathLike[str]"]
Pair = Tuple[float, float]
Edit = Tuple[str, str, int, int, Optional[str]]
ARC_SAMPLES = 181
_known_keys: List[str] = []


def builtin_scenes() -> Dict[str, str]:
    """The built-in scenes: names and titles."""
    return dict(_luxel.builtin_scenes())


def instruction_sets() -> List[str]:
    """The instruction sets whose kernels this machine can run, best first."""
    return _luxel.instruction_sets()


def schema() -> Dict[str, Any]:
    """The JSON Schema of scenes: every key with type, range, default and meaning."""
    found: Dict[str, Any] = json.loads(_luxel.scene_schema())
    return found


def _keys() -> List[str]:
    """The keys of the first level of scenes."""
    if not _known_keys:
        _known_keys.extend(schema()["properties"])
    return _known_keys


def variant(number: int) -> "Scene":
    """The variant of the exercise with this number, from 1 to 1 000 000: always the same scene for the same number."""
    return Scene.from_text(_luxel.variant_text(number), "variant %d" % number)


def _missing(path: str) -> LuxelNotFoundError:
    """What the tool says of a name that is neither a file nor a built-in scene."""
    from difflib import get_close_matches

    message = translate("%s: no such file, and no built-in scene of that name") % path
    near = get_close_matches(path, list(builtin_scenes()), 1)
    hint = translate("did you mean %s?") % near[0] if near else ""
    entry = Diagnostic("error", "no-such-scene", message, hint, None, None, 0, 0, None, 0, 0)
    return LuxelNotFoundError("file", [entry], 1)


class Scene(Rated, _exchange.Exchanging, _daylight.Daylit):
    """A scene, always a right one: what would make it wrong raises LuxelError and changes nothing.

    `Scene(source)` takes the name of a built-in scene or a file ("report" without an argument), a path, the text of a
    scene (anything with a line break, or that begins with "{"), bytes of such a text or of a PNG or EXR picture that
    carries its scene, a dictionary, or another scene, which it copies.  list(scene) are the keys of its first level.

    `scene["lights[0].intensity"]` is the value of a key, by the paths of `luxel -s`: numbers, texts, lists,
    dictionaries, None where there is neither a value nor a default.  Setting one checks the whole scene.  Several that
    only go together are set by update().  A key that there is not raises LuxelKeyError.
    """

    __slots__ = ("_handle", "_path", "_name", "_carried", "_lock", "__weakref__")

    _handle: "_luxel.SceneHandle"
    _path: Optional[str]
    _name: str
    _carried: Optional[Carried]
    jacobian, fit, arrange = _jacobian.jacobian, _fit.fit, _arrange.arrange
    camera, torch_function, stereo = _camera.camera, _torch.torch_function, _stereo.stereo

    def __init__(self, source: "Union[str, bytes, os.PathLike[str], Mapping[str, Any], Scene]" = "report") -> None:
        if isinstance(source, Scene):
            self._become(source._handle, source._name, source._path, source._carried)
        elif isinstance(source, bytes):
            self._read(source, "<bytes>", None)
        elif isinstance(source, os.PathLike):
            self._open(os.fspath(source))
        elif isinstance(source, str):
            if "\n" in source or source.lstrip().startswith("{"):
                self._read(source.encode("utf-8", "surrogateescape"), "<text>", None)
            elif os.path.exists(source) or source not in builtin_scenes():
                self._open(source)
            else:
                self._become(_luxel.open_builtin(source), source, None, None)
        elif isinstance(source, Mapping):
            self._read(_flow.dump(dict(source)).encode("utf-8"), "<dict>", None)
        else:
            raise TypeError("a scene cannot be made of %s" % type(source).__name__)

    def _become(self, handle: "_luxel.SceneHandle", name: str, path: Optional[str], carried: Optional[Carried]) -> None:
        self._handle = handle
        self._name = name
        self._path = path
        self._carried = carried
        self._lock = allocate_lock()

    def _open(self, path: str) -> None:
        if not os.path.exists(path):
            raise _missing(path)
        absolute = os.path.abspath(path)
        handle = _luxel.open_file(os.fsencode(path), os.fsencode(absolute))
        self._become(handle, path, absolute, _luxel.scene_carried(handle))

    def _read(self, text: bytes, name: str, beside: Optional[str]) -> None:
        handle = _luxel.open_text(text, name, beside)
        self._become(handle, name, beside, _luxel.scene_carried(handle))

    @classmethod
    def _of_handle(cls, handle: "_luxel.SceneHandle") -> "Scene":
        scene = cls.__new__(cls)
        scene._become(handle, "scene", None, None)
        return scene

    @classmethod
    def from_text(cls, text: Union[str, bytes], name: str = "<text>", beside: Optional[Path] = None) -> "Scene":
        """A scene from YAML or JSON.  `name` stands in messages; files that it names are beside the path `beside`."""
        scene = cls.__new__(cls)
        scene._read(text.encode("utf-8", "surrogateescape") if isinstance(text, str) else text, name,
                    None if beside is None else os.path.abspath(beside))
        return scene

    @classmethod
    def from_file(cls, path: Path) -> "Scene":
        """A scene from a file: YAML, JSON, or a .png or .exr picture of Luxel.  Raises LuxelError."""
        scene = cls.__new__(cls)
        scene._open(os.fspath(path))
        return scene

    # ---- keys ----

    def __getitem__(self, key: str) -> Any:
        text = _luxel.scene_get(self._handle, key)[0]
        return None if text is None else _flow.load(text)

    def __setitem__(self, key: str, value: Any) -> None:
        self._change([("set", _flow.assignment(key, value), 0, 0, None)])

    def __delitem__(self, key: str) -> None:
        """Takes out an element of a list or a key with its value."""
        self._change([("remove", key, 0, 0, None)])

    def keys(self) -> List[str]:
        """The keys of the scene's first level that it writes itself, such as "screen" and "lights"."""
        return [key for key in _keys() if key in self]

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, key: str) -> bool:
        """Whether the scene itself writes this key."""
        try:
            return _luxel.scene_get(self._handle, key)[1]
        except LuxelError:
            return False

    def _change(self, edits: List[Edit]) -> None:
        with self._lock:
            self._handle = _luxel.scene_change(self._handle, edits)

    def update(self, values: Mapping[str, Any]) -> None:
        """Sets several keys, in their order, and checks the scene when all are set."""
        self._change([("set", _flow.assignment(key, value), 0, 0, None) for key, value in values.items()])

    def set(self, *assignments: str) -> None:
        """Sets keys by KEY=VALUE as `luxel -s` takes them, VALUE being YAML."""
        self._change([("set", assignment, 0, 0, None) for assignment in assignments])

    def insert(self, path: str, index: int, value: Any) -> None:
        """Puts an element before another one of a list such as "lights"."""
        self._change([("insert", path, index, 0, _flow.dump(value))])

    def append(self, path: str, value: Any) -> None:
        """Puts an element at the end of a list such as "lights"."""
        self.insert(path, self.size(path), value)

    def move(self, path: str, start: int, end: int) -> None:
        """Moves an element of a list to another place; `end` is its index afterwards."""
        self._change([("move", path, start, end, None)])

    def size(self, path: str) -> int:
        """How many elements a list such as "lights" has."""
        return _luxel.scene_size(self._handle, path)

    def copy(self) -> "Scene":
        """An independent copy."""
        return Scene(self)

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Scene":
        return self.copy()

    def changed(self, values: Mapping[str, Any]) -> "Scene":
        """A copy with these keys set."""
        other = self.copy()
        other.update(values)
        return other

    # ---- what it is ----

    @property
    def text(self) -> str:
        """The scene as text: the one that it was made from, comments and layout kept, with what was changed since."""
        return _luxel.scene_text(self._handle)

    def save(self, path: Path) -> None:
        """Writes that text to a file, whole or not at all.  Raises LuxelError."""
        _luxel.scene_write(self._handle, os.fsencode(path))

    @property
    def points(self) -> List[Pair]:
        """The measuring points on the screen, x and y in mm."""
        return _luxel.scene_points(self._handle)

    @property
    def resolution(self) -> Tuple[int, int]:
        """Columns and rows of the picture."""
        return _luxel.scene_resolution(self._handle)

    @property
    def conventions(self) -> Dict[str, str]:
        """The conventions that decide the numbers, such as {"sampling": "nodes"}."""
        return dict(_luxel.scene_conventions(self._handle))

    @property
    def grids(self) -> List[str]:
        """The names of the measuring grids; "grid 1" and so on for those without."""
        return [self["grids[%d].name" % i] or "grid %d" % (i + 1) for i in range(_luxel.grid_count(self._handle))]

    @property
    def lights(self) -> List[Light]:
        """The lights with their flux, intensity, place and direction."""
        return [Light(*light) for light in _luxel.scene_lights(self._handle)]

    @property
    def meshes(self) -> List[Mesh]:
        """The meshes that surfaces and volume sources read from files, and what they are as bodies."""
        return [Mesh(*mesh) for mesh in _luxel.scene_meshes(self._handle)]

    def unit(self, quantity: str = "brightness") -> str:
        """The unit of a quantity in this scene, such as "W/sr" or "relative"."""
        return _luxel.scene_unit(self._handle, choice("quantity", quantity, QUANTITIES), None)[0]

    def project(self, position_mm: Sequence[float]) -> Optional[Pair]:
        """The point of the screen at which a place is seen; None where it is not in front of the observer."""
        x, y, z = position_mm
        return _luxel.scene_project(self._handle, x, y, z)

    def unproject(self, screen_mm: Sequence[float], z_mm: float) -> Optional[Vector]:
        """The place at a height above the screen that is seen at a point of it."""
        x, y = screen_mm
        return _luxel.scene_unproject(self._handle, x, y, z_mm)

    def height(self, position_mm: Sequence[float]) -> Optional[float]:
        """How high a place is above the screen: its z, unless the observer has a position."""
        x, y, z = position_mm
        return _luxel.scene_height(self._handle, x, y, z)

    def advice(self) -> List[Diagnostic]:
        """What is legal but odd about the scene, and what would make it show more."""
        return [Diagnostic(*entry) for entry in _luxel.scene_advice(self._handle)]

    # ---- pictures ----

    def render(self, *, quantity: Optional[str] = None, precision: Optional[str] = None, threads: int = 0,
               light_error: Optional[float] = None, reflected_error: Optional[float] = None, within: float = 0.0,
               stride: int = 1, minimum_reached: bool = False, instruction_set: Optional[str] = None,
               lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Field:
        """Computes the picture, with the interpreter's lock released; Ctrl-C ends it.

        `quantity`: "brightness" or "irradiance".  `precision`: "single" (float32, within 2e-6 of the maximum) or
        "double" (float64, 1e-11); where values of scenes are subtracted, as by SciPy's optimizers for derivatives,
        "double" is needed: a step of 1e-8 changes nothing in float32.  `threads` 0: as many as pay.  `stride` n: a
        quick look at each n-th pixel.  `light_error` E: many points may be taken together, within E of the value.
        `reflected_error`: the bound wanted of what surfaces reflect, a share of the maximum; `statistics` tell which
        was reached.  `within`: the seconds for each solution of that light, after which the best bound so far stands
        and values depend on the machine; 0: as long as it takes, here and everywhere else.  `progress` is called with
        the share done; False ends the work with a LuxelError.  The same bytes for any number of threads.

        `lights`: a name, an index or several: these alone give light, whether they are enabled or not, as everywhere
        else that takes `lights`.  Groups that have each light once add up to the picture of all."""
        return made(self._handle, settings(self._carried, quantity, precision, threads, instruction_set, None,
                                           light_error, stride, minimum_reached, progress, reflected_error,
                                           self._group(lights), within=within))

    def _group(self, lights: Optional[Lights]) -> Optional[bytes]:
        return None if lights is None else group(lights, [light.name for light in self.lights])

    def render_files(self, *paths: Path, bits: int = 8, quantity: Optional[str] = None,
                     precision: Optional[str] = None, threads: int = 0, light_error: Optional[float] = None,
                     reflected_error: Optional[float] = None, within: float = 0.0,
                     instruction_set: Optional[str] = None, lights: Optional[Lights] = None,
                     progress: Optional[Progress] = None) -> Statistics:
        """Computes the picture and writes it to files, row by row: it need not fit in memory."""
        how = settings(self._carried, quantity, precision, threads, instruction_set, None, light_error,
                       progress=progress, reflected_error=reflected_error, lights=self._group(lights), within=within)
        return statistics(_luxel.render_files(self._handle, [os.fsencode(path) for path in paths], bits, how))

    def geometry(self, *, threads: int = 0, instruction_set: Optional[str] = None,
                 progress: Optional[Progress] = None) -> Geometry:
        """What each pixel of the picture shows: depths, normals, places and surfaces as arrays, as quick as a picture.

        `scene.evaluate(found.positions_mm, found.normals)` are the exact values of the pixels; NaN off the surfaces.
        """
        return geometry(self._handle, settings(None, threads=threads, instruction_set=instruction_set,
                                               progress=progress))

    # ---- exact values ----

    @overload
    def probe(self, points: Pair, *, quantity: Optional[str] = ..., tolerance: Optional[float] = ...,
              reflected_error: Optional[float] = ..., within: float = ..., threads: int = ...,
              lights: Optional[Lights] = ..., skip_reflected_pixels: bool = ..., progress: Optional[Progress] = ...
              ) -> Probe: ...

    @overload
    def probe(self, points: "Union[None, Iterable[Pair], npt.NDArray[Any]]" = ..., *, quantity: Optional[str] = ...,
              tolerance: Optional[float] = ..., reflected_error: Optional[float] = ..., within: float = ...,
              threads: int = ..., lights: Optional[Lights] = ..., skip_reflected_pixels: bool = ...,
              progress: Optional[Progress] = ...) -> Probes: ...

    def probe(self, points: Any = None, *, quantity: Optional[str] = None, tolerance: Optional[float] = None,
              reflected_error: Optional[float] = None, within: float = 0.0, threads: int = 0,
              lights: Optional[Lights] = None, skip_reflected_pixels: bool = False,
              progress: Optional[Progress] = None) -> Union[Probe, Probes]:
        """The exact values at points of the screen, x and y in mm, light by light, with bounds of their errors.

        One pair gives a Probe; a list of pairs or an array of two columns gives Probes; None takes the scene's points.
        Thousands at once are fastest, elements by evaluate(). `reflected_error` is the bound wanted of reflected light,
        relative to the value (0.001), `within` the seconds for it; `skip_reflected_pixels`: no pixel values that take
        such light of their own.
        """
        points = self.points if points is None else points
        shape = getattr(points, "shape", None)
        is_one = len(shape) == 1 if shape is not None else (
            isinstance(points, (tuple, list)) and len(points) == 2 and not hasattr(points[0], "__len__"))
        found = self._probe(_flow.pairs([points] if is_one else points), quantity, tolerance, reflected_error, threads,
                            self._group(lights), progress, skip_reflected_pixels, within)
        return found[0] if is_one else Probes(found)

    def probe_element(self, position_mm: Sequence[float], normal: Sequence[float], *,
                      view: Optional[Sequence[float]] = None, surface: Union[str, int] = 0,
                      quantity: Optional[str] = None, tolerance: Optional[float] = None,
                      reflected_error: Optional[float] = None, within: float = 0.0, threads: int = 0,
                      lights: Optional[Lights] = None) -> Probe:
        """The exact value of a free surface element, with all that evaluate() leaves out.

        An element on a surface has its material, else that of `surface`, a name or an index; the view is the scene's
        or its own.
        """
        surface = self._surface(surface)
        triple = "three numbers are expected, x, y and z"
        place = reals("position_mm", position_mm, 3, triple) + reals("normal", normal, 3, triple)
        direction = None if view is None else reals("view", view, 3, triple)
        return self._probe([place + (direction, surface)], quantity, tolerance, reflected_error, threads,
                           self._group(lights), None, within=within)[0]

    def _probe(self, places: List[Any], quantity: Optional[str], tolerance: Optional[float],
               reflected_error: Optional[float], threads: int, lights: Optional[bytes], progress: Optional[Progress],
               skips_pixels: bool = False, within: float = 0.0) -> List[Probe]:
        how = settings(self._carried, quantity, None, threads, None, tolerance, progress=progress,
                       reflected_error=reflected_error, lights=lights, skip_reflected_pixels=skips_pixels,
                       within=within)
        return probes(_luxel.probe(self._handle, places, how), _luxel.scene_unit(self._handle, how[0], lights)[0])

    def _surface(self, surface: Union[str, int]) -> int:
        return index_of("surface", surface, [self["surfaces[%d].name" % i] if isinstance(surface, str) else None
                                             for i in range(max(self.size("surfaces"), 1))])

    def evaluate(self, places: "npt.ArrayLike", normals: "npt.ArrayLike", view: "Optional[npt.ArrayLike]" = None, *,
                 surface: Union[str, int] = 0, per_light: bool = False, quantity: Optional[str] = None,
                 tolerance: Optional[float] = None, surface_tolerance: "Optional[npt.ArrayLike]" = None,
                 threads: int = 0, lights: Optional[Lights] = None, out: "Optional[npt.NDArray[numpy.void]]" = None,
                 progress: Optional[Progress] = None) -> "npt.NDArray[numpy.void]":
        """The exact values of free surface elements: arrays (..., 3) of places in mm and of normals of any length.

        Returns a structured array of the shape (...) with the fields `value` and `error`, which bounds |value - truth|,
        and, `per_light`, `shares` (..., lights).  Places and normals are broadcast against each other.  float64 arrays
        are read where they lie, whatever their strides.  `view` is the direction to the observer, else the scene's.
        `surface` is the one, by name or index, whose material elements have that lie on no surface.  Where a number is
        not finite, a normal is 0, or a source lies on the element, value and error are NaN.  `out`: an array of this
        kind that an earlier call returned.

        `surface_tolerance`, in mm, one or for each place: so far may a place lie off the surface that it is meant for.
        It is put onto it along its normal, and the field `moved_mm` tells how far; without, a place that rounding took
        into a body is dark.  Of places in float32 or float16 it is the spacing of these numbers there unless it is
        given; of float64 it is 0, and the field is missing.  Places that were computed from a float32 depth map need
        one, such as numpy.spacing(depth).
        """
        import numpy

        p, n = floats(places), floats(normals)
        v = None if view is None else floats(view)
        for array in (p, n) if v is None else (p, n, v):
            if array.ndim < 1 or array.shape[-1] != 3:
                raise ValueError("places, normals and view are arrays (..., 3)")
        shape = numpy.broadcast_shapes(*(array.shape for array in ((p, n) if v is None else (p, n, v))))[:-1]
        near = spacing(places) if surface_tolerance is None else floats(surface_tolerance)
        fields: List[Any] = [("value", "f8"), ("error", "f8")]
        if per_light:
            fields.append(("shares", "f8", (self.size("lights"),)))
        if near is not None:
            fields.append(("moved_mm", "f8"))
        result = numpy.empty(shape, fields) if out is None else out
        if result.shape != shape or result.dtype != numpy.dtype(fields):
            raise ValueError("out: the shape %r and the fields %r are expected" % (shape, fields))
        flat = result.reshape(-1)
        if flat.size and not numpy.shares_memory(flat, result):
            raise ValueError("out: its elements must lie in one piece")

        def rows(array: "Floats") -> "Floats":
            return numpy.broadcast_to(array, shape + (3,)).reshape(-1, 3)

        how = settings(self._carried, quantity, None, threads, None, tolerance, progress=progress,
                       lights=self._group(lights))
        arrays = (rows(p), rows(n), None if v is None else rows(v), flat["value"], flat["error"],
                  flat["shares"] if per_light else None,
                  None if near is None else numpy.broadcast_to(near, shape).reshape(-1),
                  None if near is None else flat["moved_mm"])
        _luxel.evaluate(self._handle, arrays, self._surface(surface), how)
        return result

    def grid(self, name: Union[str, int] = 0, *, tolerance: Optional[float] = None,
             reflected_error: Optional[float] = None, within: float = 0.0, threads: int = 0,
             lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Grid:
        """Measures a grid, by its name or index: the irradiance of its cells, average, extrema, uniformity, flux.

        `within`: the seconds for each solution of reflected light, as for render().

        KeyError, IndexError: there is no such grid; the message names those that there are.
        """
        try:
            index = self._grid_index(name)
        except ValueError as error:
            raise (KeyError if isinstance(name, str) else IndexError)(str(error)) from None
        how = settings(self._carried, None, None, threads, None, tolerance, progress=progress,
                       reflected_error=reflected_error, lights=self._group(lights), within=within)
        return Grid(self, index, how)

    def balance(self, *, tolerance: Optional[float] = None, reflected_error: Optional[float] = None,
                within: float = 0.0, threads: int = 0, progress: Optional[Progress] = None) -> Optional[Balance]:
        """The mean irradiance of each side of the surfaces, and the balance of the flux, with bounds of their errors.

        None where surfaces reflect no light to each other (the scene's key `reflections`).  `reflected_error` is the
        bound wanted of the means, as a share of the greatest, 0.01 unless it is given, `within` the seconds for it;
        where it is missed there is a LuxelWarning.
        """
        how = settings(self._carried, None, None, threads, None, tolerance, progress=progress,
                       reflected_error=reflected_error, within=within)
        return balance(_luxel.find_balance(self._handle, how))


    def profile(self, start: Pair, end: Pair, samples: Optional[int] = None, *, arc: bool = False,
                quantity: Optional[str] = None, tolerance: Optional[float] = None, threads: int = 0,
                lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Profile:
        """The exact values from one point of the screen to another, light by light, in mm.

        `arc`: along the great circle of a sphere through the two places that are seen there, by the angle in degrees.
        """
        count = samples if samples is not None else ARC_SAMPLES if arc else max(2, *self.resolution)
        path = (arc, *_point("start", start), *_point("end", end), count)
        how = settings(self._carried, quantity, None, threads, None, tolerance, progress=progress,
                       lights=self._group(lights))
        return profile(_luxel.scene_profile(self._handle, path, how))

    def section(self, through: Pair = (0.0, 0.0), angle: float = 0.0, samples: Optional[int] = None, *,
                quantity: Optional[str] = None, tolerance: Optional[float] = None, threads: int = 0,
                lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Profile:
        """The exact values along the line across the screen through a point.

        `angle` in degrees from the x axis, counter-clockwise: 0 horizontal, 90 vertical.
        """
        ends = _luxel.line_across(self._handle, *_point("through", through), real("angle", angle))
        return self.profile(ends[:2], ends[2:], samples, quantity=quantity, tolerance=tolerance, threads=threads,
                            lights=lights, progress=progress)

    # ---- for people ----

    def explain(self, point: Pair = (0.0, 0.0), *, quantity: Optional[str] = None,
                tolerance: Optional[float] = None) -> Document:
        """The whole calculation of the value at a point, and what each other convention would give."""
        how = settings(self._carried, quantity, None, 0, None, tolerance)
        return Document(_luxel.explain(self._handle, *_point("point", point), how))

    def alternatives(self, point: Pair = (0.0, 0.0), *, quantity: Optional[str] = None,
                     tolerance: Optional[float] = None) -> Tuple[Alternative, ...]:
        """The value that each other choice of a convention would give at a point."""
        how = settings(self._carried, quantity, None, 0, None, tolerance)
        return alternatives(_luxel.find_alternatives(self._handle, *_point("point", point), how))

    def judge(self, point: Pair, answer: float, *, tolerance: float = 1e-3, rounding: float = 0.0,
              quantity: Optional[str] = None) -> Judgement:
        """Judges an answer for a point: right, explained by another convention, too coarse, or wrong.

        `rounding` is half a unit of the last digit that was given; an answer NaN says "off the surface".
        """
        how = settings(self._carried, quantity)
        verdict, value, error, reasons = _luxel.judge(self._handle, *_point("point", point), answer, tolerance,
                                                      rounding, how)
        return Judgement(verdict, value, error, alternatives(reasons))

    def _grid_index(self, grid: Union[str, int]) -> int:
        """The index of the grid of this name or index, as of `grids`."""
        names = tuple(self.grids)
        if not names:
            raise ValueError("grid: %r: %s" % (grid, translate("%s has no measuring grids") % self._name))
        if isinstance(grid, str):
            return choice("grid", grid, names)
        if not 0 <= grid < len(names):
            raise ValueError("grid: %r: 0 to %d (%s)" % (grid, len(names) - 1, ", ".join(names)))
        return grid

    def figure(self, *, grid: Union[None, str, int] = None, daylight: bool = False, palette: Optional[str] = None,
               low: Optional[float] = None, high: Optional[float] = None, logarithmic: bool = False,
               bands: str = "contours", levels: Union[int, Sequence[float]] = 8, extrema: bool = True,
               points: bool = True, section: Union[None, str, Pair] = None, stacked: bool = False,
               title: Optional[str] = None, label: Optional[str] = None, width_mm: float = 160.0,
               dots_per_inch: float = 200.0, dark: bool = False, small_print: bool = True,
               quantity: Optional[str] = None, precision: Optional[str] = None, threads: int = 0,
               lights: Optional[Lights] = None, progress: Optional[Progress] = None) -> Figure:
        """A figure in false colour with a bar, axes in mm, isophotes and marks, drawn when it is shown or saved.

        `bands`: "smooth", "bands", "contours" or "lines".  `section`: None, "center", "maximum" or a point.
        `grid`: the plane of a measuring grid instead of the picture, by its name or index, from 0 on
        as of `grids` and `grid()`: its irradiance with the values of its points, the lights over it, average, minimum,
        maximum and U0, or with `daylight` its daylight factors in percent; it has no sections.
        ImportError when it is drawn where Luxel was built without figures.
        """
        number = 0 if grid is None else 1 + self._grid_index(grid)  # as `luxel figure --grid` counts
        if number and section is not None:
            raise ValueError("section: %r: the figure of a grid has no sections" % (section,))
        if number and quantity not in (None, "irradiance"):
            raise ValueError("quantity: %r: a measuring grid has the irradiance" % quantity)
        how = settings(self._carried, quantity, precision, threads, progress=progress, lights=self._group(lights))
        return Figure(self.copy(), how, look(palette, low, high, logarithmic, bands, levels, extrema, points, section,
                                             stacked, title, label, width_mm, dots_per_inch, dark, small_print, number,
                                             daylight))

    def report(self, path: Path, *, title: Optional[str] = None, author: Optional[str] = None,
               group: Optional[str] = None, date: Optional[str] = None, palette: Optional[str] = None,
               institution: Optional[str] = None, faculty: Optional[str] = None, course: Optional[str] = None,
               teacher: Optional[str] = None, place: Optional[str] = None, aim: Optional[str] = None,
               quantity: Optional[str] = None, precision: Optional[str] = None,
               progress: Optional[Progress] = None, purpose: str = "exercise") -> None:
        """Writes the report that the exercise asks for, by the extension of the name: .pdf, .html, .md or .tex.

        `purpose="lighting"`: what a lighting designer hands over, as `luxel report --for lighting`.
        """
        texts = (title, author, group, date, palette, institution, faculty, course, teacher, place, aim,
                 choice("purpose", purpose, ("exercise", "lighting")))
        how = settings(self._carried, quantity, precision, progress=progress)
        drawing().write_report(_luxel.scene_capsule(self._handle), how, texts, os.fsencode(path))

    def _repr_png_(self) -> bytes:
        return self.render().png()

    def __repr__(self) -> str:
        columns, rows = self.resolution
        return "<luxel.Scene %s: %d x %d, %d surfaces, %d lights>" % (self._name, columns, rows, self.size("surfaces"),
                                                                      self.size("lights"))

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restore, (self.text, self._name, self._path, self._carried)


def _restore(text: str, name: str, path: Optional[str], carried: Optional[Carried]) -> Scene:
    """A scene that was pickled: its text, and the file that others are beside."""
    scene = Scene.from_text(text, name, path)
    scene._carried = carried
    return scene
