# SPDX-License-Identifier: MIT
"""The reference pages: Doxygen reads the public headers without a complaint, so no name is undocumented.

Arguments: Doxygen ("" where there is none) and its configuration.
"""
import os
import subprocess
import sys
import tempfile

from tap import Tap


def main():
    doxygen, configuration = sys.argv[1:]
    tap = Tap()
    name = "every name of the public headers is documented"
    if not doxygen:
        tap.skip(name, "no Doxygen")
        tap.finish()
    with tempfile.TemporaryDirectory() as folder:
        text = "@INCLUDE = %s\nOUTPUT_DIRECTORY = %s\n" % (configuration, folder)
        run = subprocess.run([doxygen, "-"], input=text, capture_output=True, text=True)
        complaints = [line for line in run.stderr.splitlines() if line.strip()]
        tap.ok(run.returncode == 0 and not complaints, name, *complaints)
        tap.ok(os.path.exists(os.path.join(folder, "html", "scene_8h.html")), "the pages are written")
    tap.finish()


main()
