# SPDX-License-Identifier: MIT
"""Luminaires: what IES LM-63 and EULUMDAT files say, what is read off them, and their diagrams."""
from __future__ import annotations

import os
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple, Union

from . import _html, _luxel
from ._arrays import floats, shared
from ._errors import Diagnostic
from ._glare import UgrRoom, UgrTable, ugr_room, ugr_table
from ._language import translate
from ._pictures import Drawing, Path, drawing
from ._results import Vector
from ._settings import Progress, choice, real, settings

if TYPE_CHECKING:
    from ._arrays import Floats

INTERPOLATIONS = ("angle", "cosine")
DIAGRAMS = ("polar", "cartesian", "cone")


class Opening(NamedTuple):
    """Where the light comes out; which of the lengths count is a matter of the shape."""

    shape: str  #: "point", "rectangle", "box", "disk", ... as `luxel photometry --json` has it
    width_mm: float  #: along C90-C270
    length_mm: float  #: along C0-C180
    height_mm: float  #: along the axis


class LampSet(NamedTuple):
    """The lamps of a EULUMDAT file, or those of an LM-63 file as one set."""

    lamps: float  #: how many; below 0 in EULUMDAT: absolute photometry
    type: str
    lumens: Optional[float]  #: of all lamps of the set; None: the file declares none
    temperature: str
    rendering: str
    watts: float  #: with ballast


class Greatest(NamedTuple):
    """The greatest intensity of a table and its first place."""

    intensity: float  #: cd
    c_deg: float  #: about the axis
    gamma_deg: float  #: from the axis


class PhotometryFigures(NamedTuple):
    """What is read off a luminaire's table; None where a number makes no sense for it."""

    flux: float  #: lm, by the zone rule
    linear_flux: float  #: lm, if the intensity is linear between the angles
    lorl: Optional[float]  #: light output ratio, percent of the declared lumens
    dff: Optional[float]  #: downward flux fraction, percent
    greatest: Greatest
    beam_deg: Optional[float]  #: full angle between the directions of half the greatest intensity
    field_deg: Optional[float]  #: of a tenth of it
    beam_sections_deg: Tuple[Optional[float], ...]  #: in C0-C180 and C90-C270, or horizontal and vertical
    field_sections_deg: Tuple[Optional[float], ...]
    flux_code: Tuple[Optional[float], ...]  #: CIE flux code N1 to N5, percent, not rounded
    direct_ratios: Dict[float, Optional[float]]  #: by the room index
    spacing: Tuple[Optional[float], ...]  #: spacing criteria along C0-C180, along C90-C270, across the diagonals


class Diagram(Drawing):
    """A diagram of a luminaire, drawn when it is asked for; a notebook shows it as SVG."""

    __slots__ = ("_luminaire", "_look")

    def __init__(self, luminaire: "Photometry", look: Tuple[Any, ...]) -> None:
        self._luminaire = luminaire
        self._look = look

    def save(self, path: Path) -> None:
        capsule = _luxel.photometry_capsule(self._luminaire._holder)
        drawing().write_diagram(capsule, self._look, os.fsencode(path))

    def _bytes(self, ending: str) -> bytes:
        capsule = _luxel.photometry_capsule(self._luminaire._holder)
        content: bytes = drawing().diagram_bytes(capsule, self._look, "diagram" + ending)
        return content

    def __reduce__(self) -> Tuple[Any, ...]:
        return Diagram, (self._luminaire, self._look)

    def __repr__(self) -> str:
        return "<luxel.Diagram of %r>" % (self._luminaire,)


def _content_of(path: Path) -> Optional[Tuple[bytes, str]]:
    """The bytes and the name of a plain file, by which the luminaire is pickled; what is none is not read twice."""
    if not os.path.isfile(path):
        return None
    with open(path, "rb") as file:
        return file.read(), os.fsdecode(path).encode("utf-8", "replace").decode("utf-8")


class Photometry:
    """A luminaire: how much light it sends where, as its file tells.

    `Photometry(source)` takes the name of an IES LM-63 or EULUMDAT file, a path, or the bytes of one; `name` is what
    messages call bytes.  Raises LuxelError with everything that is wrong about it, each with its line and column.

    Directions have three components: along the axis (nadir), along C = 0, and along the third of that frame; types A
    and B have their beam along the axis.
    """

    format: str  #: "LM-63-2002", "EULUMDAT", ...
    version: str  #: the first line of an LM-63 file; "" where there is none
    type: str  #: "A", "B" or "C": what the angles are measured about
    symmetry: str  #: "axial", "quadrant", "bilateral 0-180", "bilateral 90-270", "lateral", "none"
    planes: "Floats"  #: degrees, rising: C all around, or horizontal angles
    angles: "Floats"  #: degrees, rising: gamma, or vertical angles
    intensities: "Floats"  #: cd, planes x angles
    is_absolute: bool  #: measured without reference to lamps
    declared_lumens: Optional[float]
    declared_lorl: Optional[float]  #: percent
    declared_dff: Optional[float]  #: percent
    multiplier: float  #: cd for one unit of the file's numbers: all factors together
    watts: float
    opening: Opening
    housing_mm: Vector  #: width, length and height; 0 where not known
    lamp_sets: Tuple[LampSet, ...]
    texts: List[Tuple[str, str]]  #: keyword and text, in the order of the file
    warnings: List[Diagnostic]  #: what is odd about the file

    def __init__(self, source: Union[str, "os.PathLike[str]", bytes], name: str = "<bytes>") -> None:
        if isinstance(source, (bytes, bytearray, memoryview)):
            self._pickled: Optional[Tuple[bytes, str]] = (bytes(source), name)
            self._holder, entries = _luxel.photometry_read_bytes(*self._pickled)
        else:
            self._holder, entries = _luxel.photometry_read(os.fsencode(source))
            self._pickled = _content_of(source)
        self.warnings = [Diagnostic(*entry) for entry in entries]
        (self.format, self.version, self.type, self.symmetry, planes, angles, intensities, self.is_absolute,
         self.declared_lumens, self.declared_lorl, self.declared_dff, self.multiplier, self.watts, opening,
         self.housing_mm, lamps, self.texts) = _luxel.photometry_about(self._holder)
        self._views = (planes, angles, intensities)
        self.opening = Opening(*opening)
        self.lamp_sets = tuple(LampSet(*entry) for entry in lamps)

    def __getattr__(self, name: str) -> Any:
        try:
            return shared(self.__dict__["_views"][("planes", "angles", "intensities").index(name)])
        except (KeyError, ValueError):
            raise AttributeError(name) from None

    @property
    def figures(self) -> PhotometryFigures:
        """What is read off the table, computed when it is asked for."""
        (flux, linear, lorl, dff, greatest, beam, field, beams, fields, code, indices, ratios,
         spacing) = _luxel.photometry_measured(self._holder)
        return PhotometryFigures(flux, linear, lorl, dff, Greatest(*greatest), beam, field, tuple(beams), tuple(fields),
                                 tuple(code), dict(zip(indices, ratios)), tuple(spacing))

    def ugr(self, spacing: float = 0.25) -> Optional[UgrTable]:
        """The table of unified glare ratings in standard rooms by the method of CIE 190.

        `spacing`: the distance of the luminaires over their height above the eye, 1, 1/2, 1/3 ... 1/8; catalogues have
        0.25.  None for what has no luminance towards an observer: points, types A and B.
        """
        return ugr_table(_luxel.photometry_ugr(self._holder, real("spacing", spacing)))

    def room(self, across: float, along: float, spacing: float = 0.25, *, reflected_error: Optional[float] = None,
             threads: int = 0, progress: Optional[Progress] = None) -> UgrRoom:
        """The ratings of one room of ugr() by the light that its surfaces really reflect, as `--room` has them.

        `across`, `along`: the room's size in heights of the luminaires above the eye, of a room of the table, such as
        4 and 8.  `reflected_error` is the bound wanted of reflected light, as a share of the greatest mean
        illuminance, 0.01 where it is not given; where it is missed there is a LuxelWarning.  It takes seconds with a
        spacing of 1, minutes with 0.25.  ValueError: no such room or spacing, a point, types A and B, light upwards.
        """
        size = real("across", across), real("along", along)
        how = settings(None, threads=threads, reflected_error=reflected_error, progress=progress)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "luminaire.ies")
            self.write(path)
            found = _luxel.photometry_room(self._holder, os.fsencode(path), size, real("spacing", spacing), how)
        return ugr_room(found, *size)

    def intensity(self, plane: Any, angle: Any, interpolation: str = "angle") -> Any:
        """The intensity in cd at C (or a horizontal angle) and gamma (or a vertical one), in degrees.

        Numbers give a number, arrays, which are broadcast, an array.  0 where the table has none.  `interpolation`:
        "angle", linear in both angles, or "cosine", linear in the one and in the cosine of the other.
        """
        import numpy

        kind = choice("interpolation", interpolation, INTERPOLATIONS)
        planes, angles = numpy.broadcast_arrays(floats(plane), floats(angle))
        found: "Floats" = numpy.empty(planes.shape)
        _luxel.photometry_intensities(self._holder, kind, numpy.ascontiguousarray(planes),
                                      numpy.ascontiguousarray(angles), found)
        return found if found.shape else float(found)

    def direction(self, plane: Any, angle: Any) -> "Floats":
        """The unit vectors at angles of the table, in degrees; three components more than the arrays have."""
        import numpy

        planes, angles = numpy.broadcast_arrays(floats(plane), floats(angle))
        found: "Floats" = numpy.empty(planes.shape + (3,))
        _luxel.photometry_directions(self._holder, numpy.ascontiguousarray(planes), numpy.ascontiguousarray(angles),
                                     found)
        return found

    def angles_of(self, direction: Any) -> "Floats":
        """The angles of the table, in degrees, at which directions of any length lie: (..., 3) -> (..., 2)."""
        import numpy

        vectors = numpy.ascontiguousarray(floats(direction))
        if vectors.shape[-1:] != (3,):
            raise ValueError("directions have three components, not the shape %r" % (vectors.shape,))
        found: "Floats" = numpy.empty(vectors.shape[:-1] + (2,))
        _luxel.photometry_angles(self._holder, vectors, found)
        return found

    def write(self, path: Path) -> None:
        """Writes the luminaire as LM-63-2002 (.ies) or EULUMDAT (.ldt), whole or not at all.

        Raises LuxelError where it cannot be written.
        """
        _luxel.photometry_write(self._holder, os.fsencode(path))

    def diagram(self, diagram: str = "polar", *, title: Optional[str] = None, width_mm: float = 160,
                dots_per_inch: float = 200, dark: bool = False) -> Diagram:
        """Its "polar", "cartesian" or "cone" diagram; ImportError, when it is drawn, where Luxel has no figures."""
        return Diagram(self, (choice("diagram", diagram, DIAGRAMS), title, float(width_mm), float(dots_per_inch), dark))

    def __reduce__(self) -> Tuple[Any, ...]:
        if self._pickled is None:
            raise TypeError("a luminaire can be pickled that was read from bytes or a plain file")
        return Photometry, self._pickled

    def __repr__(self) -> str:
        return "<luxel.Photometry %s: %d x %d, %s lm>" % (self.format, len(self.planes), len(self.angles),
                                                         _html.number(self.figures.flux, 6))

    def _repr_html_(self) -> str:
        found = self.figures
        rows = [[translate("flux, zone rule"), _html.number(found.flux, 6) + " lm"],
                [translate("declared lumens"), _html.number(self.declared_lumens, 6)],
                [translate("greatest intensity"), _html.number(found.greatest.intensity, 6) + " cd"],
                [translate("beam angle (50 %)"), _html.number(found.beam_deg, 4)],
                [translate("field angle (10 %)"), _html.number(found.field_deg, 4)]]
        return _html.table([self.format, ""], rows)
