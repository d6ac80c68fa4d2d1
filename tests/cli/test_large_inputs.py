# SPDX-License-Identifier: MIT
"""Small files that ask for much: validated, or refused, without work that grows beyond their size."""
import math
import resource

from tap import Tap
from tool import SCENE, run_tests

LIGHT = "{type: point, position: [2000, 0, 2000], intensity: 10, attenuation: none}"
SURFACES = SCENE[SCENE.index("surfaces"):SCENE.index("lights")]
PROCESSOR_SECONDS = 20  # no measure of speed: what these files once took was minutes, hours, or all memory


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))


def with_lights(*lights):
    return SCENE.replace(LIGHT, "\n  - ".join(lights))


def outline(corners):
    return "{type: planar, vertices: [%s], radiance: 1}" % ", ".join("[%.6g, %.6g, 2000]" % xy for xy in corners)


def comb(teeth):
    """A polygon of 2 teeth + 2 corners, of which every second one is no ear."""
    return [(i, 0 if i % 2 else 100) for i in range(2 * teeth)] + [(2 * teeth, -100), (0, -100)]


def star(points):
    return [((300 if i % 2 else 100) * math.cos(-math.pi * i / points),
             (300 if i % 2 else 100) * math.sin(-math.pi * i / points)) for i in range(2 * points)]


def many_spheres(count):
    return "surfaces: [%s]\n" % ", ".join(
        "{type: sphere, center: [%d, %d, 500], radius: 1}" % (3 * (i % 50), 3 * (i // 50)) for i in range(count))


def small_files_that_ask_for_much(tap, tool):
    fine_sphere = "{type: volume, sphere: {center: [0, 0, 2000], radius: 9, facets: 1000}, power: 1}"
    cases = {"an outline of 5000 teeth": with_lights(outline(comb(2500))),
             "a star of 5000 corners": with_lights(outline(star(2500))),
             "1000 polyhedra of half a million faces": with_lights(*[fine_sphere] * 1000),
             "800 surfaces and 900 lights": with_lights(*[LIGHT] * 900).replace(SURFACES, many_spheres(800))}
    for title, scene in cases.items():
        tool.write("scene.yaml", scene)
        result = tool.run("check", "scene.yaml", timeout=300, preexec_fn=limited)
        tap.ok(result.code == 0 and len(scene) < 150000, "luxel check: " + title, result)


run_tests(Tap(), small_files_that_ask_for_much)
