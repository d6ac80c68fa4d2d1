# SPDX-License-Identifier: MIT
"""The published and precomputed cases of cases.json."""
import json
import os

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'cases.json'), encoding='utf-8') as stream:
    CASES = json.load(stream)['cases']


def places(case):
    """Where the case expects values: screen points (2 numbers each) or free elements (6 numbers each)."""
    return case.get('points') or case['elements']


def absolute_tolerance(case):
    """What the case allows whatever the value is: one that lists values to 8 decimals says so in its source."""
    return 1e-8 if '(absolute 1e-8)' in case['source'] else 0.0
