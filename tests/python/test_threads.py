# SPDX-License-Identifier: MIT
"""Many threads at once, a scene that is changed meanwhile, and processes that were forked after threads."""
import os
import threading

import numpy

from package import Tap, luxel, run_tests
from tool import SCENE


def test_together(tap, tool):
    scene = luxel.Scene(SCENE)
    expected = {i: numpy.asarray(scene.changed({"lights[0].intensity": i}).render()).tobytes() for i in range(1, 9)}
    wrong, stop = [], threading.Event()

    def change():
        number = 0
        while not stop.is_set():
            scene["lights[0].intensity"] = 1 + number % 8
            number += 1

    def compute():
        for _ in range(60):
            field = scene.render(threads=2)
            intensity = field.scene["lights[0].intensity"]
            if numpy.asarray(field).tobytes() != expected.get(intensity) and intensity != 10:
                wrong.append(intensity)
            field.extrema()
            scene.probe()

    changer = threading.Thread(target=change)
    workers = [threading.Thread(target=compute) for _ in range(4)]
    for thread in [changer, *workers]:
        thread.start()
    for thread in workers:
        thread.join()
    stop.set()
    changer.join()
    tap.equal(wrong, [], "each picture is that of the scene as it was when it was begun")


def test_edits(tap, tool):
    scene = luxel.Scene(SCENE)

    def add():
        for _ in range(40):
            scene.insert("lights", 0, {"type": "ambient", "irradiance": 1})

    threads = [threading.Thread(target=add) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    tap.equal(scene.size("lights"), 161, "no edit is lost")


def test_fork(tap, tool):
    scene = luxel.Scene(SCENE)
    expected = numpy.asarray(scene.render(threads=4)).tobytes()
    if "LUXEL_SANITIZED" in os.environ:
        tap.skip("a forked process", "threads of the sanitizer do not live in it")
        return
    child = os.fork()
    if child == 0:
        good = numpy.asarray(scene.render(threads=4)).tobytes() == expected
        os._exit(0 if good else 1)
    tap.equal(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0, "a forked process computes the same")


run_tests(Tap(), test_together, test_edits, test_fork)
