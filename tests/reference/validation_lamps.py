# SPDX-License-Identifier: MIT
"""Luminaire files in docs/VALIDATION.md: CIE 171 with a file, one lamp in both formats and turned, a near panel.

All files are written here, from formulas.  What is exact is worked out in 50 digits from the whole table, which knows
nothing of the symmetries by which a file stores only a part of it.
"""
import math
import os
import tempfile

from mpmath import mp, mpf

import model
from cases import CASES
from luxel import generator
from validation_page import STAGE, figures, off_exact, off_printed, power_above

ROUNDED = -12  # of powers of ten: angles that a compiler rounds otherwise move an intensity by some 1e-14

# The planes that a file of each symmetry stores, as a share of those all around: LM-63's, EULUMDAT's number and planes.
SYMMETRIES = {
    'none': ((0, 360), 0, (0, 345)),
    'about the axis': ((0, 0), 1, (0, 0)),
    'about C0-C180': ((0, 180), 2, (0, 180)),
    'about C90-C270': ((90, 270), 3, (270, 450)),
    'about both': ((0, 90), 4, (0, 90)),
}
TURNED = {'about C0-C180': 'about C90-C270', 'about C90-C270': 'about C0-C180'}  # by 90 degrees; the others stay


class Table:
    """Intensities in cd of a lamp in steps of C and γ, all around."""

    def __init__(self, symmetry, intensity, step_c, step_gamma, last=90):
        self.symmetry, self.step_c, self.step_gamma = symmetry, step_c, step_gamma
        self.gammas = [step_gamma * i for i in range(round(last / step_gamma) + 1)]
        self.rows = {c: [intensity(c, gamma) for gamma in self.gammas] for c in range(0, 360, step_c)}

    def turned(self):
        """The lamp turned by 90 degrees in its file."""
        twin = Table(TURNED.get(self.symmetry, self.symmetry), lambda c, gamma: 0, self.step_c, self.step_gamma,
                     self.gammas[-1])
        twin.rows = {c: self.rows[(c - 90) % 360] for c in self.rows}
        return twin

    def stored(self, ends):
        return list(range(ends[0], ends[1] + 1, self.step_c))

    def ies(self, opening=(0, 0)):
        """LM-63-1995; the opening's size along C0 and along C90, in m."""
        planes = self.stored(SYMMETRIES[self.symmetry][0])
        return '\n'.join([
            'IESNA:LM-63-1995', '[TEST] own', '[TESTLAB] own', '[ISSUEDATE] now', '[MANUFAC] own', 'TILT=NONE',
            f'1 -1 1 {len(self.gammas)} {len(planes)} 1 2 {opening[1]} {opening[0]} 0', '1 1 10',
            ' '.join(map(repr, self.gammas)), ' '.join(map(str, planes)),
            *(' '.join(map(repr, self.rows[c % 360])) for c in planes), ''])

    def ldt(self, opening=(0, 0)):
        """EULUMDAT with lamps of 2000 lm, so that half the candelas are cd/klm; what it calls length lies along C90."""
        _, number, ends = SYMMETRIES[self.symmetry]
        sides = [f'{1000 * opening[1]:g}', f'{1000 * opening[0]:g}']
        around = self.stored((0, 359))
        return '\n'.join([
            'own', '1', str(number), str(len(around)), str(self.step_c), str(len(self.gammas)), repr(self.step_gamma),
            '', '', '', '', '', *sides, '0', *sides, *'0000', '100', '100', '1', '0', '1', '1', 'LED', '2000', '', '',
            '20', *'0' * 10, *map(str, around), *map(repr, self.gammas),
            *(repr(value / 2) for c in self.stored(ends) for value in self.rows[c % 360]), ''])

    def at(self, towards, axis, c0):
        """The intensity towards a unit way from the lamp, linear in C and γ."""
        across = cross(c0, axis)
        gamma = mp.degrees(mp.acos(dot(towards, axis))) / mpf(self.step_gamma)
        azimuth = mp.degrees(mp.atan2(dot(towards, across), dot(towards, c0))) % 360 / self.step_c
        i, j = int(mp.floor(azimuth)), int(mp.floor(gamma))
        if j >= len(self.gammas) - 1:
            return mpf(0)
        u, v = azimuth - i, gamma - j
        near, far = self.rows[self.step_c * i], self.rows[self.step_c * (i + 1) % 360]
        return ((1 - u) * ((1 - v) * near[j] + v * near[j + 1]) + u * ((1 - v) * far[j] + v * far[j + 1]))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def exact_unit(vector):
    length = mp.sqrt(sum(mpf(x) ** 2 for x in vector))
    return [mpf(x) / length for x in vector]


def illuminance(table, element, position, axis, c0):
    """At an element, for a lamp whose axis and c0 are perpendicular to each other."""
    place, normal = element[:3], exact_unit(element[3:])
    way = [mpf(x) - mpf(y) for x, y in zip(place, position)]
    towards, square = exact_unit(way), sum(x * x for x in way) / 10 ** 6
    return table.at(towards, exact_unit(axis), exact_unit(c0)) * max(mpf(0), -dot(towards, normal)) / square


def lux(page, elements, lights, *options):
    scene = {**STAGE, 'units': 'photometric', 'shadows': 'none', 'lights': [
        {'type': 'luminaire', **light} for light in lights]}
    return page.luxel.probe(scene, elements=elements, options=['--quantity', 'irradiance', *options])['points']


def written(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, 'w', encoding='ascii') as file:
        file.write(text)
    return path


def lambert(step):
    """1000 cos γ in that step: 0 at 90 degrees, as the formula has it."""
    return Table('about the axis', lambda c, gamma: 1000 * math.cos(math.radians(gamma)) if gamma < 90 else 0.0, 90,
                 step)


def point_source(page, folder):
    """Test 5.2 with the source in a file."""
    page.heading('CIE 171, test 5.2 with luminaire files',
                 'The same source, as LM-63 files that hold 1000 cos γ in steps of 5° and of 1°. Between the angles of '
                 'a table the intensity is linear in γ (`interpolation: angle`), which makes it up to 1 - cos(step/2), '
                 'that is 0.095 % and 0.004 %, less than the formula; or linear in cos γ (`cosine`), which gives this '
                 'formula back. *off the map* is against the map of the file in 50 digits; here and in the next '
                 'tables powers of ten are 1e-12 at least.')
    case = next(case for case in CASES if case['id'] == 'cie171-5.2')
    elements, position = case['elements'], case['scene']['lights'][0]['position']
    columns = ['x, y, z (mm)', 'formula (lx)', 'printed (lx)']
    rows = [[', '.join(f'{x:g}' for x in element[:3]),
             figures(model.probe_element(case['scene'], element, highlights=False).irradiance),
             f'{printed:g}'] for element, printed in zip(elements, case['printed']['values'], strict=True)]
    for step in (5.0, 1.0):
        table = lambert(step)
        lamp = {'file': written(folder, 'lambert.ies', table.ies()), 'position': position}
        values = [point['value'] for point in lux(page, elements, [lamp])]
        columns += [f'{step:g}° (lx)', 'off the map', 'off the formula', 'off the printed']
        for row, element, value, printed in zip(rows, elements, values, case['printed']['values'], strict=True):
            row += [figures(value), off_exact(value, illuminance(table, element, position, (0, 0, -1), (1, 0, 0)),
                                              ROUNDED), off_printed(value, float(row[1])), off_printed(value, printed)]
        if step == 5:
            cosine = [point['value'] for point in lux(page, elements, [{**lamp, 'interpolation': 'cosine'}])]
    columns += ['5°, `cosine` (lx)', 'off the formula']
    for row, element, value in zip(rows, elements, cosine, strict=True):
        exact = model.probe_element(case['scene'], element, highlights=False).irradiance
        row += [figures(value), off_exact(value, exact, ROUNDED)]
    page.table(columns, rows)


def lamp_of(symmetry):
    """A lamp of two beams that has this symmetry and no other, rounded as files are."""
    waves = {'none': (0.25, 0.125), 'about C0-C180': (0, 0.25), 'about C90-C270': (0.25, 0)}
    sine, cosine = waves.get(symmetry, (0, 0))
    beam = 0 if symmetry == 'about the axis' else 0.5

    def intensity(plane, angle):
        c, gamma = math.radians(plane), math.radians(angle)
        around = beam * math.cos(2 * c) + sine * math.sin(c) + cosine * math.cos(c)
        return round(800 * math.cos(gamma) * (1 + 2 * math.sin(gamma) ** 2 * (1 + around)), 2)

    return Table(symmetry, intensity, 15, 7.5)


def turned_about_z(vector, degrees):
    c, s = {90: (0.0, 1.0)}.get(degrees, (math.cos(math.radians(degrees)), math.sin(math.radians(degrees))))
    return [c * vector[0] - s * vector[1], s * vector[0] + c * vector[1], vector[2]]


def twins(page, folder):
    """One lamp in both formats and turned, each symmetry."""
    page.heading('One lamp in two formats, and turned',
                 'A lamp of two beams of each symmetry, in steps of 15° and 7.5°, written as LM-63 and as EULUMDAT; '
                 'turned by 90° in the file (about C0-C180 becomes about C90-C270, and the sides of its opening change '
                 'places), and turned back by `c0`; and turned by 37° with all the room. 60 elements around it. The '
                 'numbers are the largest deviations of illuminances from the map in 50 digits. *opening*: with '
                 '`opening: file`, 300 mm × 200 mm, whether all five agree within the errors that the probes tell, '
                 'which are at most 1e-6 of the values.')
    rng = generator('lamps')
    position = [200.0, -100.0, 2500.0]
    elements = []
    while len(elements) < 60:
        way = [rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, -0.05)]
        r = rng.uniform(400, 3000) / math.hypot(*way)
        elements.append([*(p + r * x for p, x in zip(position, way)), *(rng.uniform(-0.3, 0.3) - x for x in way)])
    rows = []
    for symmetry in SYMMETRIES:
        table = lamp_of(symmetry)
        exact = [illuminance(table, element, position, (0, 0, -1), (1, 0, 0)) for element in elements]
        size = (0.3, 0.2)
        files = [('a.ies', table.ies(size), [1, 0, 0], 0), ('a.ldt', table.ldt(size), [1, 0, 0], 0),
                 ('b.ies', table.turned().ies(size[::-1]), [0, -1, 0], 0),
                 ('b.ldt', table.turned().ldt(size[::-1]), [0, -1, 0], 0), ('a.ies', table.ies(size), [1, 0, 0], 37)]
        row, spread = [symmetry], []
        for name, text, c0, degrees in files:
            lamp = {'file': written(folder, name, text), 'position': turned_about_z(position, degrees),
                    'c0': turned_about_z(c0, degrees)}
            places = [turned_about_z(e[:3], degrees) + turned_about_z(e[3:], degrees) for e in elements]
            found = lux(page, places, [lamp])
            row.append(power_above(max(abs(point['value'] / right - 1) for point, right in zip(found, exact)), ROUNDED))
            spread.append(lux(page, places, [{**lamp, 'opening': 'file'}], '--tolerance', '1e-6'))
        first = spread[0]
        agree = all(abs(a['value'] - b['value']) <= a['error'] + b['error'] and b['error'] <= 1e-6 * b['value']
                    for other in spread[1:] for a, b in zip(first, other, strict=True))
        rows.append([*row, 'within' if agree else 'NOT WITHIN'])
    page.table(['symmetry', '.ies', '.ldt', 'turned .ies', 'turned .ldt', 'turned room', 'opening'], rows)


def near_panel(page, folder):
    """A Lambertian panel near by, whose closed form is the planar source's."""
    page.heading('A luminaire near by: its luminous opening',
                 'Below the middle of a Lambertian panel of 0.6 m × 0.6 m and 1000 lm, from a file of two angles that '
                 '`interpolation: cosine` makes I₀ cos γ. With `opening: file` its illuminance is the closed form of a '
                 'planar source, here in 50 digits; as a point it is what far-field photometry says, which is in '
                 'excess near by. From five times the side on the two are less than 1.4 % apart.')
    table = Table('about the axis', lambda c, gamma: 1000 / math.pi if gamma == 0 else 0.0, 90, 90)
    lamp = {'file': written(folder, 'panel.ies', table.ies((0.6, 0.6))), 'interpolation': 'cosine',
            'position': [0, 0, 4000]}
    rows = []
    for below in (300, 600, 1000, 2000, 3000):
        element = [0, 0, 4000 - below, 0, 0, 1]
        planar = {**STAGE, 'shadows': 'none', 'lights': [
            {'type': 'planar', 'rectangle': {'center': [0, 0, 4000], 'size': [600, 600]}, 'power': 1000}]}
        exact = model.probe_element(planar, element, highlights=False).irradiance
        value, far = [lux(page, [element], [{**lamp, 'opening': how}], '--tolerance', '1e-10')[0]['value']
                      for how in ('file', 'point')]
        rows.append([f'{below / 1000:g}', figures(exact), figures(value), off_exact(value, exact, ROUNDED),
                     figures(far), off_printed(far, float(exact))])
    page.table(['distance (m)', 'exact (lx)', 'Luxel, `opening: file` (lx)', 'off the exact', 'as a point (lx)',
                'off the exact'], rows)


def lamps(page):
    with tempfile.TemporaryDirectory() as folder:
        for part in (point_source, twins, near_panel):
            part(page, folder)
