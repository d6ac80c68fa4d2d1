# SPDX-License-Identifier: MIT
"""How light sources brighten a surface: scenes, exact values with a bound of their error, pictures, figures.

    >>> import luxel
    >>> scene = luxel.Scene("report")
    >>> scene["lights[0].intensity"] = 20
    >>> field = scene.render()
    >>> field.shape
    (360, 360)

Lengths are millimetres, y points up on the screen; docs/SCENE.md of Luxel tells every key of a scene.  NumPy is loaded
when arrays are asked for.  Everything may be used by several threads at once: a scene that is changed while another
thread computes with it goes on there as it was.
"""
from ._arrange import Arrangement, Layout, LayoutLimit
from ._balance import Amount, Balance, LitSide
from ._camera import Camera, measured
from ._daylight import Daylight, DaylightFactor, DaylightGrid, SunGrid, SunHours, SunPatch, Sunlight
from ._document import Document
from ._errors import (Diagnostic, LuxelError, LuxelFileError, LuxelKeyError, LuxelMemoryError, LuxelNotFoundError,
                      LuxelValueError, LuxelWarning)
from ._exchange import Exchange, ExchangeSide
from ._field import Field, compare, read
from ._fit import Fit, FitParameter
from ._geometry import Geometry
from ._glare import Glare, GlareSource, UgrReflectances, UgrRoom, UgrTable
from ._grid import Grid
from ._jacobian import Jacobian, STATES
from ._language import set_language
from ._photometry import Diagram, Greatest, LampSet, Opening, Photometry, PhotometryFigures
from ._pictures import Figure, palettes
from ._probe import Color, Probe, Probes, Share
from ._results import (Alternative, Comparison, Extrema, Extremum, GridArea, GridExtrema, GridExtremum, GridPeak,
                       Histogram, Isophote, Judgement, Light, Mesh, Peak, Profile, Statistics, Summary)
from ._room import Limit, Observer, Room, RoomArray, room
from ._scene import Scene, builtin_scenes, instruction_sets, schema, variant
from ._stereo import StereoSet
from ._study import Study
from ._luxel import version as _version

__version__ = _version()

__all__ = [
    "Alternative", "Amount", "Arrangement", "Balance", "Camera", "Color", "Comparison", "Daylight", "DaylightFactor",
    "DaylightGrid", "Diagnostic", "Diagram", "Document", "Exchange", "ExchangeSide", "Extrema", "Extremum", "Field",
    "Figure", "Fit", "FitParameter", "Geometry", "Glare", "GlareSource", "Greatest", "Grid", "GridArea", "GridExtrema",
    "GridExtremum", "GridPeak", "Histogram", "Isophote", "Jacobian", "Judgement", "LampSet", "Layout", "LayoutLimit",
    "Light", "Limit", "LitSide", "LuxelError", "LuxelFileError", "LuxelKeyError", "LuxelMemoryError",
    "LuxelNotFoundError", "LuxelValueError", "LuxelWarning", "Mesh", "Observer", "Opening", "Peak", "Photometry",
    "PhotometryFigures", "Probe", "Probes", "Profile", "Room", "RoomArray", "STATES", "Scene", "Share", "Statistics",
    "StereoSet", "Study", "Summary", "SunGrid", "SunHours", "SunPatch", "Sunlight", "UgrReflectances", "UgrRoom",
    "UgrTable", "builtin_scenes", "compare", "instruction_sets", "measured", "palettes", "read",
    "room", "schema", "set_language", "variant", "__version__",
]
