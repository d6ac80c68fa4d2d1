# SPDX-License-Identifier: MIT
"""The published and precomputed cases of cases.json."""
import json
import os

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'cases.json'), encoding='utf-8') as stream:
    CASES = json.load(stream)['cases']


def places(case):
    """Where the case expects values: screen points (2 numbers each) or free elements (6 numbers each)."""
    return case.get('points') or case['elements']
