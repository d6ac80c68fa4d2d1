# SPDX-License-Identifier: MIT
"""Says why the Python package is not tried here."""
from tap import Tap

tap = Tap()
tap.skip("the Python package", "it was not built: the headers of Python 3.11 or newer are needed (python3-dev)")
tap.finish()
