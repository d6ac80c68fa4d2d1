# SPDX-License-Identifier: MIT
"""What pixels show as arrays: against probes and closed forms, for every kind of surface and observer; places that
rounding took off their surface are put back onto it."""
import time

import numpy

from package import Tap, luxel, raises, run_tests

MATERIAL = {"model": "lambert"}
KINDS = {
    "sphere": {"type": "sphere", "center": [30, -20, 300], "radius": 220},
    "inside of a sphere": {"type": "sphere", "center": [0, 0, 100], "radius": 320, "inside": True},
    "disk": {"type": "disk", "center": [10, 0, 200], "radius": 240, "axis": [0.31, -0.23, 1.07]},
    "rectangle": {"type": "rectangle", "center": [10, 0, 200], "size": [400, 300], "axis": [0.23, 0.51, 1.09]},
    "cylinder": {"type": "cylinder", "center": [0, 0, 300], "radius": 90, "height": 380, "axis": [1, 0.4, 0.2]},
    "mesh": {"type": "mesh", "file": "ball.obj", "position": [0, 0, 300], "rotate": [20, 30, 0]},
    "room": {"type": "room", "center": [0, 0, 900], "size": [900, 700, 1800]},
}
OBSERVERS = ({"z": 1500, "projection": "orthographic"}, {"z": 1500, "projection": "perspective"},
             {"position": [500, 400, 1500], "target": [20, 0, 250], "projection": "perspective"},
             {"position": [500, 400, 1500], "target": [20, 0, 250], "projection": "orthographic"})
LAMP = {"type": "point", "position": [40, 60, 1400], "intensity": 10}


def scene_of(*surfaces, observer=OBSERVERS[0], resolution=(41, 37)):
    return {"luxel": 1, "screen": {"width": 410, "height": 370, "resolution": list(resolution)}, "observer": observer,
            "surfaces": [{**surface, **({} if surface["type"] == "room" else {"material": MATERIAL})}
                         for surface in surfaces], "lights": [LAMP]}


def write_ball(tool):
    """An octahedron, as a mesh."""
    tool.write("ball.obj", "".join("v %d %d %d\n" % corner for corner in (
        (200, 0, 0), (-200, 0, 0), (0, 200, 0), (0, -200, 0), (0, 0, 200), (0, 0, -200))) + "".join(
            "f %d %d %d\n" % face for face in ((1, 3, 5), (3, 2, 5), (2, 4, 5), (4, 1, 5), (3, 1, 6), (2, 3, 6),
                                               (4, 2, 6), (1, 4, 6))))


def read(tool, text):
    return luxel.Scene.from_text(luxel._flow.dump(text), beside=tool.file("scene.yaml"))


def test_probes(tap, tool):
    """Every pixel is what a probe sees there by the reference, and its value that of the picture."""
    write_ball(tool)
    for name, surface in KINDS.items():
        for observer in OBSERVERS:
            if name in ("inside of a sphere", "room") and "position" in observer:
                observer = {**observer, "position": [100, 80, 240 if name != "room" else 1500]}
            scene = read(tool, scene_of(surface, observer=observer))
            found, field = scene.geometry(threads=2), scene.render(precision="double")
            title = "%s from %r: " % (name, observer)
            columns, rows = scene.resolution
            probes = scene.probe([(x, y) for y in field.y_mm for x in field.x_mm], tolerance=1e-3)
            seen = numpy.array([probe.on_surface for probe in probes]).reshape(rows, columns)
            same = tap.ok((found.mask == seen).all() and (found.mask == field.mask).all() and seen.any(),
                          title + "the same pixels", (found.mask != seen).sum(), (found.mask != field.mask).sum())
            if not same:
                continue
            lit = [probe for probe in probes if probe.on_surface]
            places = numpy.array([probe.position_mm for probe in lit])
            normals = numpy.array([probe.normal for probe in lit])
            tap.ok(numpy.abs(found.positions_mm[seen] - places).max() <= 1e-9 and
                   numpy.abs(found.normals[seen] - normals).max() <= 1e-11, title + "places and normals",
                   numpy.abs(found.positions_mm[seen] - places).max(), numpy.abs(found.normals[seen] - normals).max())
            heights = numpy.array([scene.height(place) for place in places])
            eye = scene["observer.z"] if "z" in observer else numpy.linalg.norm(
                numpy.subtract(observer["position"], observer["target"]))
            tap.ok(numpy.abs(found.depth_mm[seen] - (eye - heights)).max() <= 1e-9, title + "depths")
            values = scene.evaluate(found.positions_mm, found.normals)["value"]
            tap.ok(numpy.abs(values[seen] - field.values[seen]).max() <= 1e-10 * field.max() and
                   numpy.isnan(values[~seen]).all(), title + "evaluate() gives the picture",
                   numpy.abs(values[seen] - field.values[seen]).max())
            tap.ok((found.surfaces[seen] == 0).all() and (found.surfaces[~seen] == -1).all() and
                   not found.positions_mm[~seen].any() and not found.normals[~seen].any() and
                   not found.depth_mm[~seen].any(), title + "nothing beside it")
            words = [("left", "right", "floor", "ceiling", "back", "front")[wall] for wall in found.walls[seen]]
            tap.ok(name != "room" or words == [probe.wall for probe in lit], title + "walls")


def test_many(tap, tool):
    """Surfaces one before the other, few and many; the same for any number of threads and every instruction set."""
    balls = [{"type": "sphere", "center": [40 * (i % 9) - 160.31, 40 * (i // 9) - 120.73, 7 * i % 90], "radius": 30}
             for i in range(60)]
    for count in 2, 60:
        scene = luxel.Scene(scene_of(*balls[:count], resolution=(287, 259)))
        one = scene.geometry(threads=1)
        x, y = numpy.meshgrid(scene.render().x_mm, scene.render().y_mm)
        heights = numpy.full(x.shape, -numpy.inf)
        owners = numpy.full(x.shape, -1)
        for i, ball in enumerate(balls[:count]):
            left = 30 ** 2 - (x - ball["center"][0]) ** 2 - (y - ball["center"][1]) ** 2
            z = numpy.where(left > 0, ball["center"][2] + numpy.sqrt(numpy.maximum(left, 0)), -numpy.inf)
            owners = numpy.where(z > heights, i, owners)
            heights = numpy.maximum(z, heights)
        tap.ok((one.surfaces == owners).all(), "%d balls: the nearest of each pixel" % count)
        tap.ok(numpy.abs(one.depth_mm - (1500 - heights))[one.mask].max() < 1e-10, "%d balls: depths" % count)
        for name in luxel.instruction_sets():
            again = scene.geometry(threads=3, instruction_set=name)
            tap.ok(all(numpy.abs(a - b).max() <= (0 if i > 2 else 1e-10) for i, (a, b) in enumerate(zip(one, again))),
                   "%d balls: %s and three threads" % (count, name))
        many = scene.geometry(threads=3)
        tap.ok(all((a == b).all() for a, b in zip(one, many)), "%d balls: three threads, the same bytes" % count)


def test_work(tap, tool):
    """As quick as pictures: some 30 ns a pixel, where pixel by pixel it took a microsecond; to be cancelled."""
    scene = luxel.Scene(scene_of(KINDS["sphere"], KINDS["disk"], resolution=(820, 740)))
    scene.geometry(threads=1)
    start = time.process_time()
    scene.geometry(threads=1)
    spent = time.process_time() - start
    tap.ok(spent < 0.5, "600 000 pixels in less than half a second of the processor", spent)
    told = []
    large = luxel.Scene(scene_of(KINDS["sphere"], KINDS["disk"], resolution=(2050, 1850)))
    error = raises(luxel.LuxelError, large.geometry, threads=1, progress=lambda done: bool(told.append(done)))
    tap.equal(error.status, "cancelled", "cancelled by what progress() returns")
    told.clear()
    scene.geometry(progress=lambda done: told.append(done) or True)
    tap.ok(told == sorted(told) and all(0 <= done <= 1 for done in told), "progress", told)


def test_rounded(tap, tool):
    """Places in float32 and float16, and by float32 depths: no place that is lit in truth is dark, for each kind of
    surface; the same places as float64 show why."""
    write_ball(tool)
    for name, surface in KINDS.items():
        if surface["type"] == "room":
            continue
        observer = {**OBSERVERS[0], "z": 240 if "inside" in name else 1500}
        lamp = {**LAMP, "position": [40, 60, 200 if "inside" in name else 1400]}
        scene = read(tool, {**scene_of(surface, observer=observer), "lights": [lamp]})
        found = scene.geometry()
        places, normals = found.positions_mm[found.mask], found.normals[found.mask]
        exact = scene.evaluate(places, normals)
        lit = exact["value"] > 1e-3 * exact["value"].max()
        for kind, off in (("f4", 1e-4), ("f2", 1)):
            rounded = scene.evaluate(places.astype(kind), normals)
            near = numpy.spacing(numpy.abs(places.astype(kind)).max(1))
            tap.ok((rounded["value"][lit] > 0).all() and
                   numpy.abs(rounded["value"] - exact["value"]).max() <= off * exact["value"].max(),
                   "%s: %s is lit as it should be" % (name, kind), (rounded["value"][lit] == 0).sum(),
                   numpy.abs(rounded["value"] - exact["value"]).max() / exact["value"].max())
            tap.ok((rounded["moved_mm"] <= 4 * near).all() and (rounded["moved_mm"] > 0).any(),
                   "%s: %s, and how far places were moved is told" % (name, kind), rounded["moved_mm"].max())
            plain = scene.evaluate(places.astype(kind).astype("f8"), normals)
            tap.equal(plain.dtype.names, ("value", "error"), "float64 places stay where they are")
            if name in ("sphere", "cylinder"):
                tap.ok((plain["value"][lit] == 0).mean() > 0.2, "%s: which is dark in part" % name)
        depths = found.depth_mm[found.mask].astype("f4")
        by_depth = places * [1, 1, 0] + [0, 0, observer["z"]] - depths[:, None] * [0, 0, 1.0]
        of_depth = scene.evaluate(by_depth, normals, surface_tolerance=numpy.spacing(depths))
        tap.ok((of_depth["value"][lit] > 0).all(), name + ": by a float32 depth map")
        none = scene.evaluate(places.astype("f4"), normals, surface_tolerance=0)
        tap.ok(not none["moved_mm"].any(), name + ": a tolerance of 0 moves nothing")
    tap.ok((exact == scene.evaluate(places, normals, surface_tolerance=1e-3)[["value", "error"]]).all(),
           "what lies on a surface is left")
    above = scene.evaluate(places + 5 * normals, normals, surface_tolerance=1)
    tap.ok(not above["moved_mm"].any(), "what is far from it, too")


def test_materials(tap, tool):
    """What is put onto a surface has its material; names of surfaces are taken as their indices."""
    dark = {"type": "disk", "center": [0, 0, 0], "radius": 900, "name": "floor",
            "material": {**MATERIAL, "diffuse": 0.1}}
    ball = {"type": "sphere", "center": [0, 0, 300], "radius": 200, "name": "ball",
            "material": {**MATERIAL, "diffuse": 0.9}}
    scene = luxel.Scene({**scene_of(KINDS["disk"]), "surfaces": [dark, ball]})
    top = numpy.array([[0, 0, 500.00001]], "f4").astype("f8") + [[0, 0, 2e-5]]
    lit = [scene.evaluate(top, [0, 0, 1], surface=surface, surface_tolerance=near)["value"][0]
           for surface, near in ((0, 0), (1, 0), (0, 1e-4), ("floor", 0), ("ball", 0), ("floor", 1e-4))]
    tap.ok(lit[0] == lit[3] and lit[1] == lit[4] and lit[2] == lit[5] and
           abs(lit[1] / lit[0] - 9) < 0.01 and abs(lit[2] / lit[1] - 1) < 1e-6, "its material", lit)
    tap.equal(scene.probe_element([0, 0, 600], [0, 0, 1], surface="ball").value,
              scene.probe_element([0, 0, 600], [0, 0, 1], surface=1).value, "names in probe_element(), too")
    tap.ok("floor, ball" in str(raises(KeyError, scene.evaluate, [0, 0, 0], [0, 0, 1], surface="bowl")), "no such name")
    tap.ok("the scene has 2" in str(raises(IndexError, scene.evaluate, [0, 0, 0], [0, 0, 1], surface=2)), "no index")
    tap.ok("a name or an index" in str(raises(TypeError, scene.evaluate, [0, 0, 0], [0, 0, 1], surface=1.5)), "neither")


run_tests(Tap(), test_probes, test_many, test_work, test_rounded, test_materials)
