# SPDX-License-Identifier: MIT
"""Values on one line of YAML: read as YAML reads them, and written so that they come back, for any value."""
import json

import yaml

from package import Tap, luxel, run_tests
from tool import SCENE

_flow = luxel._flow

CASES = ["10", "-1.5e-3", "1e3", ".5", "5.", "[0, 0, 1000]", "point", "true", "null", "~", '""', "''", "'it''s'",
         '"a\\tb\\u0416"',
         "{type: ambient, irradiance: 1}", "[[0, 0], [150, 0]]", "[]", "{}", "{a: [1, {b: c d}], e: 'f, g'}",
         '["a:b", c:d, "e"]', "a b c", "http://x", '{"a":1,"b":[2]}', "[a, ]", "+5", "1_000", "0x10", "[ 1 , 2 ]"]


def test_reading(tap, tool):
    for text in CASES:
        expected = yaml.safe_load(text)
        found = _flow.load(text)
        if text in ("1e3", "1_000", "0x10", "5."):  # PyYAML goes by YAML 1.1
            expected = {"1e3": 1000.0, "1_000": "1_000", "0x10": "0x10", "5.": 5.0}[text]
        tap.equal(found, expected, "%s is read" % text)
    tap.equal(_flow.load('"\\ud83d\\ude00"'), "\U0001f600", "a pair of surrogates")


def test_any_value(tap, tool):
    try:
        from hypothesis import HealthCheck, given, settings
        from hypothesis import strategies as some
    except ImportError as error:
        tap.skip("any value comes back", error)
        return
    texts = some.text(some.characters(blacklist_categories=["Cs"]))
    leaves = (some.none() | some.booleans() | some.integers(-2 ** 53, 2 ** 53) |
              some.floats(allow_nan=False, allow_infinity=False) | texts)
    values = some.recursive(leaves, lambda inner: some.lists(inner, max_size=4) |
                            some.dictionaries(texts, inner, max_size=4))

    @settings(max_examples=300, deadline=None, derandomize=True, database=None,
              suppress_health_check=[HealthCheck.too_slow])
    @given(values)
    def comes_back(value):
        assert _flow.load(_flow.dump(value)) == json.loads(json.dumps(value))

    comes_back()
    tap.ok(True, "any value comes back as it was written")

    scene = luxel.Scene(SCENE)

    @settings(max_examples=60, deadline=None, derandomize=True, database=None)
    @given(some.text(some.characters(blacklist_categories=["Cc", "Cs"]), min_size=1, max_size=30).filter(str.strip),
           some.floats(0, 1e300), some.lists(some.floats(-1e6, 1e6), min_size=3, max_size=3).filter(any))
    def is_kept(name, intensity, position):
        other = scene.changed({"lights[0].name": name, "lights[0].intensity": intensity,
                               "lights[0].position": position})
        again = luxel.Scene(other.text)
        for one in (other, again):
            assert one["lights[0].name"] == name
            assert one["lights[0].intensity"] == intensity and one["lights[0].position"] == position

    is_kept()
    tap.ok(True, "any name and number of a scene comes back, from its text too")

    @settings(max_examples=40, deadline=None, derandomize=True, database=None)
    @given(some.floats(-300, 300), some.floats(-300, 300), some.floats(0.1, 1e3))
    def is_linear(x, y, factor):
        """The values of two scenes differ by the factor of the light, within their bounds."""
        one = scene.probe((x, y))
        other = scene.changed({"lights[0].intensity": 10 * factor}).probe((x, y))
        assert (one.value is None) == (other.value is None)
        if one.value is not None:
            assert abs(other.value - factor * one.value) <= other.error + factor * one.error + 1e-15 * other.value

    is_linear()
    tap.ok(True, "values go with the light, within their bounds")


run_tests(Tap(), test_reading, test_any_value)
