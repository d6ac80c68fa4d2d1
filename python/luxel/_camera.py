# SPDX-License-Identifier: MIT
"""Cameras as computer vision has them: the matrix K of a pinhole camera, where it is, and how its pixels err."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, NamedTuple, Tuple, Union

from ._arrays import floats
from ._settings import real

if TYPE_CHECKING:
    from ._arrays import Floats
    from ._scene import Scene


class Camera(NamedTuple):
    """A pinhole camera without distortion: a place X of the scene is seen at the pixel K (R X + t), over its third.

    The camera looks along its z axis, x runs to the right and y down; lengths are mm.  Pixel (0, 0) is the middle of
    the one at the top left.
    """

    K: "Floats"  #: 3 x 3
    R: "Floats"  #: 3 x 3: turns directions of the scene into the camera's
    t: "Floats"  #: 3: the scene's origin in the camera's frame, mm
    resolution: Tuple[int, int]  #: columns, rows

    def project(self, places: Any) -> "Floats":
        """The pixels (..., 2), columns and rows with fractions, where places (..., 3) are seen."""
        seen = (floats(places) @ self.R.T + self.t) @ self.K.T
        pixels: "Floats" = seen[..., :2] / seen[..., 2:]
        return pixels

    def keys(self, screen_width: float = 0) -> Dict[str, Any]:
        """The scene's keys `screen` and `observer` that see as this camera does; their screen is that wide, in mm.

        Without it the screen goes through the scene's origin, if that lies before the camera, else a metre away.
        ValueError: the middle of the picture is not on the axis, pixels are not square, or K has skew.
        """
        import numpy

        columns, rows = self.resolution
        K = floats(self.K) / self.K[2][2]
        middle = ((columns - 1) / 2, (rows - 1) / 2)
        if abs(K[0, 1]) > 1e-9 * K[0, 0] or abs(K[0, 0] - K[1, 1]) > 1e-6 * K[0, 0]:
            raise ValueError("K: pixels that are square and without skew are expected, not %g, %g and skew %g" %
                             (K[0, 0], K[1, 1], K[0, 1]))
        if abs(K[0, 2] - middle[0]) > 1e-6 * columns or abs(K[1, 2] - middle[1]) > 1e-6 * rows:
            raise ValueError("K: the axis is expected in the middle of the picture, (%g, %g), not at (%g, %g): "
                             "crop or pad it" % (middle + (K[0, 2], K[1, 2])))
        depth = float(self.t[2]) if self.t[2] > 0 else 1000.0
        distance = screen_width * K[0, 0] / columns if screen_width else depth
        position = -self.R.T @ floats(self.t)
        width = columns * distance / K[0, 0]
        target = position + distance * self.R[2]
        return {"screen": {"width": float(width), "height": float(width * rows / columns),
                           "resolution": [columns, rows], "sampling": "centers"},
                "observer": {"position": [float(x) for x in position], "target": [float(x) for x in target],
                             "up": [float(-x) for x in numpy.asarray(self.R[1])], "projection": "perspective"}}


def camera(self: "Scene") -> Camera:
    """The camera that sees what the scene's observer sees.  ValueError: the projection is orthographic."""
    import numpy

    if self["observer.projection"] != "perspective":
        raise ValueError("observer.projection: perspective is expected, an orthographic view has no camera")
    columns, rows = self.resolution
    screen = floats([self["screen.width"], self["screen.height"]])
    nodes = 1 if self["screen.sampling"] == "nodes" else 0
    pixels = floats([columns - nodes, rows - nodes])
    frame = [floats(self.unproject((x, y), z)) for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    right, up, back = (axis - frame[0] for axis in frame[1:])
    if self["observer.position"] is None:
        distance = float(self["observer.z"])
    else:
        distance = float(numpy.linalg.norm(floats(self["observer.position"]) - floats(self["observer.target"])))
    R = numpy.stack([right, -up, -back])
    position = frame[0] + distance * back
    focal = distance * pixels / screen
    K = floats([[focal[0], 0, (columns - 1) / 2], [0, focal[1], (rows - 1) / 2], [0, 0, 1]])
    return Camera(K, R, -R @ position, (columns, rows))


def measured(values: Any, *, noise: Union[float, str] = 0.0, saturated: float = 0, quantum: float = 0,
             truncated: bool = False, seed: int = 0, number: int = 0) -> "Floats":
    """Values as a meter or a camera would give them, by the words of fit(): noise, then saturation, then levels.

    `noise` is a standard deviation, "3%" of each value, or both, "3%+0.01".  It is drawn by counter (Philox): the same
    for a `seed` and the `number` of a picture, whatever was drawn before.
    """
    import numpy

    from ._fit import noise_of

    true = floats(values)
    absolute, share = noise_of(noise)
    random = numpy.random.Generator(numpy.random.Philox(key=seed, counter=[0, 0, 0, number]))
    given = true + numpy.hypot(absolute, share * numpy.abs(true)) * random.standard_normal(true.shape)
    if real("saturated", saturated) > 0:
        given = numpy.minimum(given, saturated)
    if real("quantum", quantum) > 0:
        levels = numpy.floor(given / quantum) if truncated else numpy.rint(given / quantum)
        given = levels * quantum
    read: "Floats" = given
    return read
