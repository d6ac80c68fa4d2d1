# SPDX-License-Identifier: MIT
"""Memory: arrays share a field's numbers without a copy, keep them alive, and cannot write them."""
import gc
import weakref

import numpy

from package import Tap, luxel, raises, run_tests
from tool import SCENE


def address(array):
    return array.__array_interface__["data"][0]


def test_field(tap, tool):
    for precision, kind in (("single", numpy.float32), ("double", numpy.float64)):
        field = luxel.Scene(SCENE).render(precision=precision)
        array, again = numpy.asarray(field), field.values
        view = memoryview(field)
        tap.equal((array.dtype.type, array.shape, view.format, view.ndim),
                  (kind, (36, 36), "fd"[precision == "double"], 2), precision + ": type and shape")
        tap.ok(address(array) == address(again) == address(numpy.frombuffer(view, kind)), precision + ": one memory")
        tap.ok(not array.flags.writeable and view.readonly and array.flags.c_contiguous, precision + ": read alone")
        tap.ok(raises(ValueError, array.__setitem__, (0, 0), 1), precision + ": a value cannot be set")
        tap.ok(raises(ValueError, setattr, array.flags, "writeable", True), precision + ": nor can it be allowed")
        tap.ok(raises(BufferError, numpy.frombuffer, field, kind) is None, precision + ": plain bytes go too")
        expected, mask = array.copy(), field.mask
        tap.equal((mask.dtype.type, mask.shape, mask.flags.writeable), (numpy.bool_, (36, 36), False),
                  precision + ": the mask")
        tap.ok(address(mask) == address(field.mask) and address(field.x_mm) == address(field.x_mm),
               precision + ": mask and places are not copied")
        tap.ok((array[~mask] == 0).all() and mask.any() and not mask.all(), precision + ": off the surface it is 0")
        places = field.x_mm
        del field, again
        gc.collect()
        garbage = [luxel.Scene(SCENE).render(precision=precision) for _ in range(20)]
        tap.ok((array == expected).all() and places[0] == -250 and mask.any() and len(garbage) == 20,
               precision + ": arrays keep the field alive")


def test_lifetimes(tap, tool):
    scene = luxel.Scene(SCENE)
    watched = weakref.ref(scene)
    field = scene.render()
    lines = field.isophotes(4)
    section = scene.section()
    del scene
    gc.collect()
    tap.ok(watched() is None, "a field does not keep the scene object")
    tap.ok(field.extrema().maximum.value > 0, "but what it needs of the scene")
    x = lines[0].x_mm
    expected = x.copy()
    del lines, field
    gc.collect()
    tap.ok((x == expected).all() and not x.flags.writeable, "a line keeps its numbers")
    value = section.value
    tap.equal((value.strides[0] > 8, value.flags.writeable, section.shares.shape), (True, False, (36, 1)),
              "a section's numbers lie where the library has them")
    tap.ok((section.shares[:, 0] == value).all(), "and are the shares of the only light")


def test_handles(tap, tool):
    raw = luxel._luxel
    for kind in (raw.SceneHandle, raw.View, raw.Holder):
        tap.ok(raises(TypeError, kind), "%s is not made by hand" % kind.__name__)
    empty = luxel.Field()
    tap.ok(raises(BufferError, memoryview, empty), "an empty field has no values")
    tap.ok(raises(TypeError, lambda: empty.rows), "nor rows")
    for call in (lambda: raw.scene_text(5), lambda: raw.render(5, luxel.Field, ()), lambda: raw.document_text(5, 1),
                 lambda: raw.grid_write(luxel.Scene(SCENE)._handle, b"x"), lambda: raw.field_about(None),
                 lambda: raw.render(luxel.Scene(SCENE)._handle, int, luxel._settings.settings(None)),
                 lambda: raw.render(luxel.Scene(SCENE)._handle, luxel.Field, (0, 0)),
                 lambda: raw.scene_change(luxel.Scene(SCENE)._handle, ["set"]),
                 lambda: raw.scene_change(luxel.Scene(SCENE)._handle, None)):
        tap.ok(raises(TypeError, call), "what is no handle or tuple is refused")


def test_grey(tap, tool):
    field = luxel.Scene(SCENE).render()
    grey = field.grey()
    tap.equal((grey.dtype, grey.max(), field.grey(16).max()), (numpy.uint8, 255, 65535), "grey levels")
    tap.ok(raises(ValueError, luxel._luxel.field_grey, field, numpy.empty(7, numpy.uint8)), "room that does not fit")
    tap.ok(raises(ValueError, field.grey, 12), "bits that there are not")


run_tests(Tap(), test_field, test_lifetimes, test_handles, test_grey)
