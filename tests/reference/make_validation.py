# SPDX-License-Identifier: MIT
"""Writes docs/VALIDATION.md from what it measures with the built luxel command, or checks that page.

    make_validation.py LUXEL               prints the page
    make_validation.py LUXEL --check PAGE  a test: the page holds, to its printed digits, what luxel gives now

Deviations are printed as the next power of ten above them, so that the page is the same for every compiler.
"""
import argparse
import math

import numpy as np
from mpmath import mp, mpf

import model
from cases import CASES
from luxel import TOLERANCE, Luxel
from tap import Tap
from validation_daylight import daylight
from validation_inverse import inverse
from validation_lamps import lamps
from validation_page import STAGE, Page, figures, off_exact, off_printed, power_above

UNIT_RADIANCE = 1 / math.pi  # so that the irradiance is the configuration factor

HEAD = """\
# Validation

What Luxel gives where the right answer is known: the tests of CIE 171:2006 (*Test cases to assess the accuracy of
lighting computer programs*), luminaire files, reflected light, configuration factors of radiative heat transfer,
integrals of highlights, derivatives, and fits of a lamp.
This page is written by a program, `tests/reference/make_validation.py`, from what it measures with the built command.
`make validation` writes it anew; a test of `make check` compares it with what the command gives.

- *Luxel*: the value of `luxel probe` or `luxel grid`.
- *exact*: the same by an independent program (`tests/reference/model.py`), in 50-digit arithmetic or, for highlights,
  by another cubature that is certain to some 1e-14; or the closed form that stands with the table. The numbers of the
  scene count as the float64 numbers that they are read as.
- *printed*: what the publication prints; *reference*: values to 8 digits by the closed forms that are named there.
- *off the exact*: |Luxel - exact| / exact, rounded up to a power of ten, 1e-14 at least.
- *off the printed*, *off the reference*: Luxel / that - 1, in percent.
"""


def case_named(name):
    return next(case for case in CASES if case['id'] == name)


def exact_irradiance(scene, element):
    return model.probe_element(scene, element, highlights=False).irradiance


def elements_table(page, scene, elements, unit, printed=(), skip=(), places=None, digits=10):
    """One row per element: place and normal, the values, the deviations.  Nothing hides anything."""
    found = page.luxel.values_at({**scene, 'shadows': 'none'}, elements=elements, options=['--quantity', 'irradiance'])
    rows = []
    for index, (element, value) in enumerate(zip(elements, found)):
        where = places[index] if places else ', '.join(f'{x:g}' for x in element[:3])
        print_value = printed[index] if index < len(printed) and index not in skip else None
        exact = exact_irradiance(scene, element)
        row = [where, *([] if places else [direction_words(element[3:])])]
        row += [figures(exact, digits), figures(value, digits)]
        if printed:
            row.append(f'{print_value:g}' if print_value else '')
        row.append(off_exact(value, exact))
        if printed:
            row.append(off_printed(value, print_value))
        rows.append(row)
    columns = ['place'] if places else ['x, y, z (mm)', 'faces']
    columns += [f'exact ({unit})', f'Luxel ({unit})'] + ([f'printed ({unit})'] if printed else [])
    page.table(columns + ['off the exact'] + (['off the printed'] if printed else []), rows)


def direction_words(normal):
    words = {(0, 0, 1): 'up, +z', (0, 0, -1): 'down, -z', (0, 1, 0): '+y', (1, 0, 0): '+x'}
    return words.get(tuple(normal), ', '.join(f'{x:.4g}' for x in normal))


# CIE 171.

CIE_CASES = (
    ('4.1 to 4.6', 'measured rooms: compact fluorescent lamps, opal and semi-specular luminaires, grey and black walls',
     'no', 'not tried: needs the intensity tables of those luminaires'),
    ('5.2', 'point sources', 'yes',
     'the Lambertian pattern, as a source and in luminaire files; the asymmetric one needs intensity tables'),
    ('5.3', 'area sources', 'yes', 'the Lambertian pattern; the asymmetric one needs intensity tables'),
    ('5.4', 'conservation of luminous flux', 'yes', ''),
    ('5.5', 'directional transmittance of clear glass', 'no', 'glass is in windows alone: tests/cli/test_sky.py'),
    ('5.6', 'reflection by diffuse surfaces', 'yes', 'the reflecting square is given as a source'),
    ('5.7', 'diffuse reflection with an internal obstruction', 'yes',
     'the reflecting wall is given as a source; the printed numbers are the corrected ones'),
    ('5.8', 'interreflection in a cube', 'yes', 'the printed means, and points of a wall'),
    ('5.9, 5.10', 'sky component under a roof opening, unglazed and glazed', 'yes',
     'printed numbers that are off; tests/reference/cie_daylight.py prints all'),
    ('5.11, 5.12', 'sky and ground through a facade opening, unglazed and glazed', 'yes',
     'printed numbers that are off; tests/reference/cie_daylight.py prints all'),
    ('5.13, 5.14', 'the same with horizontal and vertical masks', 'no',
     'not said: what light the masks themselves send, which the printed numbers hold; others who tried them found '
     'table B.22 wrong under overcast skies, A to D of B.25 and B.26 too high, and F under sky 12 printed as 1.02 for '
     '6.76'),
)


def cie(page):
    page.heading('CIE 171: which cases are here, and which are not',
                 'The publication has 19 cases. Those of light from point and area sources, direct and reflected, and '
                 'of daylight are on this page; the others are not.')
    page.table(['case', 'subject', 'here', 'remark'], CIE_CASES)

    case = case_named('cie171-5.2')
    page.heading('CIE 171, test 5.2: a point source over a plane',
                 'A point source of 1000 cd with a Lambertian pattern, I = 1000 cos θ, hangs 3 m above a horizontal '
                 'plane. Illuminance on the plane at places around the foot of the source.')
    elements_table(page, {**case['scene'], 'units': 'photometric'}, case['elements'], 'lx', case['printed']['values'])

    case = case_named('cie171-5.3')
    page.heading('CIE 171, test 5.3: an area source',
                 'A square Lambertian source of 1 m × 1 m in the middle of the ceiling of a black room of 4 m × 4 m '
                 '× 3 m; luminance 1000 cd/m². The origin is a corner of the room. Illuminance on a wall (y = 0) and '
                 'on the floor, along the line under the middle of the source.')
    elements_table(page, {**case['scene'], 'units': 'photometric'}, case['elements'], 'lx', case['printed']['values'])

    closed_room(page)

    for size, words in (('500', '0.5 m'), ('4000', '4 m'), ('500000', '500 m')):
        case = case_named(f'cie171-5.6-{size}mm')
        printed = case.get('printed', {})
        page.heading(f'CIE 171, test 5.6: a square of {words}',
                     f'A uniform square Lambertian source of {words} × {words} lies on the floor around the middle of '
                     'a room of 4 m × 4 m × 3 m and shines upwards. Configuration factors in percent (the irradiance '
                     'for an exitance of 100) on a wall (y = 0) and on the ceiling; the origin is a corner of the room.'
                     + ('' if size == '4000' else ' No printed values of this size are at hand.'))
        elements_table(page, case['scene'], case['elements'], '%', printed.get('values', ()), printed.get('skip', ()))

    obstruction(page)


def obstruction(page):
    """Test 5.7: what the box leaves of the wall is a rectangle above a level line, which has a closed form."""
    page.heading('CIE 171, test 5.7: a box before a lit wall',
                 'The wall y = 4 m of a black room of 4 m × 4 m × 3 m shines as Lambert has it; before it, from y = '
                 '2.5 m to 2.7 m, stands a black box as wide as the room and 1 m high. Configuration factors in '
                 'percent (the irradiance for an exitance of 100) on the wall opposite (y = 0) and on the floor, in '
                 'the middle of the room. Table 19 of the publication is wrong; the printed numbers are the corrected '
                 'ones (I. Ashdown, errata of CIE 171; NVIDIA Iray report, Table 14).')
    # a wall of the room that looks away from the box, and the box's own sides
    plates = [{'center': [2000, 2500, 500], 'size': [4000, 1000], 'axis': [0, -1, 1e-9], 'up': [0, 0, 1]},
              {'center': [2000, 2700, 500], 'size': [4000, 1000], 'axis': [0, 1, 1e-9], 'up': [0, 0, 1]},
              {'center': [2000, 2600, 1000], 'size': [4000, 200]}]
    stage = {**STAGE, 'observer': {'z': 20000}}

    def lit(low, high, surfaces):
        wall = {'center': [2000, 4000, (low + high) / 2], 'size': [4000, high - low], 'axis': [0, -1, 0],
                'up': [0, 0, 1]}
        return {**stage, **({'surfaces': surfaces} if surfaces else {}),
                'lights': [{'type': 'planar', 'rectangle': wall, 'radiance': 100 / math.pi}]}

    rows = []
    printed = (16.07, 16.33, 15.40, 13.32, 10.32, 7.08, 3.38, 3.63, 3.01, 0, 0)
    places = [(0, 2750 - 500 * i) for i in range(6)] + [(250 + 500 * i, 0) for i in range(5)]
    elements = [[2000, y, z, *((0, 1, 0) if y == 0 else (0, 0, 1))] for y, z in places]
    found = page.luxel.values_at(lit(0, 3000, [{'type': 'rectangle', **plate} for plate in plates]), elements=elements,
                                 options=['--quantity', 'irradiance'])
    for (y, z), element, value, print_value in zip(places, elements, found, printed, strict=True):
        # the wall is seen above the higher of the lines over the box's two upper edges
        level = max(z + (1000 - z) * (4000 - y) / (edge - y) for edge in (2500, 2700))
        exact = exact_irradiance(lit(max(level, 0), 3000, None), element) if level < 3000 else mpf(0)
        rows.append([', '.join(f'{x:g}' for x in element[:3]), direction_words(element[3:]), figures(exact),
                     figures(value), f'{print_value:.2f}', off_exact(value, exact), off_printed(value, print_value)])
    page.table(['x, y, z (mm)', 'faces', 'exact (%)', 'Luxel (%)', 'printed (%)', 'off the exact', 'off the printed'],
               rows)


def closed_room(page):
    """Test 5.4, light conservation."""
    page.heading('CIE 171, test 5.4: no light is lost',
                 'An isotropic point source of 10 000 lm (10 000/4π cd) in a closed room of 4 m × 4 m × 3 m, off its '
                 'middle. What `luxel grid` finds on the six walls, each a grid of square cells. The flux that it '
                 'prints is that of the plane itself and knows no cells. The average of the cells times the area, '
                 'summed, has an error of order 2 in their size, as the midpoint of each cell stands for the cell.')
    rows = []
    for cells_per_metre in (5, 10, 20, 40):
        grids = []
        for axis, center, size in (([0, 0, 1], [0, 0, 0], [4, 4]), ([0, 0, -1], [0, 0, 3], [4, 4]),
                                   ([1, 0, 0], [-2, 0, 1.5], [4, 3]), ([-1, 0, 0], [2, 0, 1.5], [4, 3]),
                                   ([0, 1, 0], [0, -2, 1.5], [4, 3]), ([0, -1, 0], [0, 2, 1.5], [4, 3])):
            grids.append({'center': [1000 * x for x in center], 'size': [1000 * x for x in size], 'axis': axis,
                          'up': [0, 1, 0] if axis[2] else [0, 0, 1], 'n': [x * cells_per_metre for x in size]})
        scene = {**STAGE, 'units': 'photometric', 'grids': grids, 'observer': {'z': 20000},
                 'lights': [{'type': 'point', 'position': [500, -300, 1800], 'intensity': 10000 / (4 * math.pi)}]}
        found = page.luxel.run(['grid', '-'], scene)['grids']
        flux = math.fsum(grid['flux'] for grid in found)
        areas = [math.prod(grid['size']) / 1e6 for grid in grids]
        total = math.fsum(grid['average'] * area for grid, area in zip(found, areas, strict=True))
        cells = sum(grid['n'][0] * grid['n'][1] for grid in found)
        rows.append([f'{1000 / cells_per_metre:g}', f'{cells}', '10000', f'{flux:.4f}', off_exact(flux, mpf(10000)),
                     f'{total:.4f}', f'{total / 100 - 100:+.4f} %'])
    page.table(['cell (mm)', 'cells in all', 'exact (lm)', 'Luxel, flux of six walls (lm)', 'off the exact',
                'average × area (lm)', 'off the exact'], rows)


# Configuration factors.

def flat(shape, **keys):
    return {**STAGE, 'lights': [{'type': 'planar', shape: keys, 'radiance': UNIT_RADIANCE}]}


def factors(page):
    page.heading('Configuration factors',
                 'The part of the light of a Lambertian source of exitance 1 that an element receives: irradiance '
                 'for the radiance 1/π. Reference: J. R. Howell, *A Catalog of Radiation Heat Transfer Configuration '
                 'Factors* (the corner; its B-13 for tilted elements); R. Siegel, J. R. Howell, *Thermal Radiation '
                 'Heat Transfer*.')
    square = flat('rectangle', center=[500, 500, 1000], size=[1000, 1000])
    upright = flat('rectangle', center=[1000, 500, 500], size=[1000, 1000], axis=[-1, 0, 0])
    full = flat('disk', center=[0, 0, 1000], radius=1000)
    ball = {**STAGE, 'observer': {'z': 9000}, 'lights': [{
        'type': 'volume', 'sphere': {'center': [0, 0, 2000], 'radius': 1000}, 'radiance': UNIT_RADIANCE}]}
    rows = []

    def row(words, scene, element, printed):
        value = page.luxel.values_at(scene, elements=[element], options=['--quantity', 'irradiance'])[0]
        exact = exact_irradiance(scene, element)
        rows.append([words, figures(exact), figures(value), printed, off_exact(value, exact),
                     off_printed(value, float(printed)) if printed else ''])

    row('unit square at the distance 1, the element under a corner and parallel to it', square, [0, 0, 0, 0, 0, 1],
        '0.13853161')
    row('unit square at the distance 1, the element level with its lower edge, opposite a corner, and upright to it',
        upright, [0, 0, 0, 0, 0, 1], '')
    row('disk of radius 1 at the height 1, on its axis, parallel', full, [0, 0, 0, 0, 0, 1], '0.5')
    row('the same, 0.5 off the axis', full, [500, 0, 0, 0, 0, 1], '0.43798263')
    row('disk of radius 1 at the height 2, 1.5 off the axis, parallel', full, [1500, 0, -1000, 0, 0, 1], '0.10228414')
    for degrees, printed in ((30, '0.4330127'), (60, '0.25735206'), (90, '0.09084506')):
        normal = [math.sin(math.radians(degrees)), 0, math.cos(math.radians(degrees)) if degrees != 90 else 0]
        row(f'disk of radius 1 at the height 1, on its axis, the element tilted by {degrees}°', full,
            [0, 0, 0, *normal], printed)
    for degrees, printed in ((0, '0.25'), (30, '0.21650635'), (60, '0.125'), (75, '0.07041043'), (90, '0.02883444'),
                             (105, '0.00570567'), (115, '0.00039471')):
        normal = [math.sin(math.radians(degrees)), 0, math.cos(math.radians(degrees)) if degrees != 90 else 0]
        row(f'sphere of radius 1 whose centre is at the distance 2, {degrees}° off the normal', ball,
            [0, 0, 0, *normal], printed)
    page.table(['geometry (lengths in m)', 'exact (1)', 'Luxel (1)', 'reference (1)', 'off the exact',
                'off the reference'], rows)


def sphere_means(page):
    """The mean over a sphere, by Gauss between the polar angles at which the disk begins and ceases to be cut."""
    page.heading('The mean irradiance of a sphere under a coaxial disk',
                 'A disk of radius 1, coaxial with a sphere whose centre is 0.5 away from it. Averaged over the '
                 'whole sphere, the irradiance for the exitance 1 is the solid angle of the disk over 4π, (1 - '
                 '1/√5)/2, whatever the radius of the sphere. The manual of EES (Engineering Equation Solver) prints '
                 '0.2764. Luxel: 120 elements around the sphere, summed by a Gauss rule.')
    scene = flat('disk', center=[0, 0, 500], radius=1000)
    exact = (1 - 1 / mp.sqrt(5)) / 2
    nodes, weights = np.polynomial.legendre.leggauss(40)
    rows = []
    for radius in (50, 200, 400):
        tilt, half = math.atan2(1, 0.5), math.acos(radius / 1000 / math.hypot(1, 0.5))
        total = 0.0
        for low, high in ((0, half - tilt), (half - tilt, tilt + half), (tilt + half, math.pi)):
            # Quadratic at both ends, where the cut sets in with a power of 3/2.
            share = (1 + nodes) / 2
            angles = low + (high - low) * share ** 2 * (3 - 2 * share)
            spans = weights / 2 * (high - low) * 6 * share * (1 - share)
            elements = [[radius * math.sin(t), 0, radius * math.cos(t), math.sin(t), 0, math.cos(t)] for t in angles]
            values = page.luxel.values_at(scene, elements=elements, options=['--quantity', 'irradiance'])
            total += math.fsum(value * span * math.sin(t) / 2 for value, span, t in zip(values, spans, angles))
        rows.append([f'{radius / 1000:g}', figures(exact), figures(total), '0.2764', off_exact(total, exact),
                     off_printed(total, 0.2764)])
    page.table(['radius of the sphere (m)', 'exact (1)', 'Luxel, mean (1)', 'printed (1)', 'off the exact',
                'off the printed'], rows)


# Reflected light.

# Indirect illuminance in lx at points of a wall, in m from its middle, and its mean, for each reflectance: spectral
# collocation with 300 unknowns a face, whose rows sum to 1 within 1e-12; two meshes agree in all digits given.
CUBE_PLACES = ((0, 0), (1, 1), (1.9, 1.9))
CUBE = (
    (0.1, 11.6, (12.947919, 12.178366, 7.4707868)),
    (0.5, 104, (112.03836, 107.78338, 77.032300)),
    (0.9, 937, (954.38751, 945.69003, 866.30617)),
)


def enclosure(surface, reflectance, lumens):
    """A closed surface with a light that shines evenly in its middle."""
    material = {'model': 'lambert', 'diffuse': reflectance, 'over_pi': True}
    return {**STAGE, 'units': 'photometric', 'reflections': 'all', 'surfaces': [{**surface, 'material': material}],
            'lights': [{'type': 'point', 'position': [0, 0, 0], 'power': lumens}]}


def reflected_rows(page, scene, elements, places, exact):
    """A row for each element: what is reflected to it, and whether that is within the bound that is told."""
    found = page.luxel.probe(scene, elements=elements, options=['--quantity', 'irradiance'])['points']
    for where, told, right in zip(places, found, exact):
        value, error = told['reflected']['value'], told['reflected']['error']
        off = abs(value - right)
        yield [where, figures(right, 8), figures(value, 5), power_above(error / value), power_above(off / right),
               'yes' if off <= error else 'NO']


REFLECTED_COLUMNS = ['exact (lx)', 'Luxel (lx)', 'error told, relative', 'error, relative', 'within']


def reflected(page):
    page.heading('CIE 171, test 5.8: interreflection in a cube',
                 'A cube of 4 m has diffuse walls of one reflectance ρ and 10 000 lm from a point in its middle. The '
                 'printed number is the mean of the indirect illuminance, which is Φ ρ/(S (1 - ρ)) in any closed '
                 'enclosure. The points lie on a wall, in m from its middle; *exact* is another method there '
                 '(collocation by polynomials, 300 unknowns a face). Here and below both errors are rounded up to a '
                 'power of ten, and the values asked for to 0.001.')
    rows = []
    for reflectance, printed, exact in CUBE:
        scene = enclosure({'type': 'room', 'center': [0, 0, 0], 'size': [4000, 4000, 4000]}, reflectance, 10000)
        elements = [[1000 * x, 1000 * y, -2000, 0, 0, 1] for x, y in CUBE_PLACES]
        places = [f'{x:g}, {y:g}' for x, y in CUBE_PLACES]
        mean = 10000 * reflectance / (96 * (1 - reflectance))
        rows += [[f'{reflectance:g}', f'{printed:g}', figures(mean, 6), *row]
                 for row in reflected_rows(page, scene, elements, places, exact)]
    page.table(['ρ', 'printed mean (lx)', 'its closed form (lx)', 'x, y (m)', *REFLECTED_COLUMNS], rows)

    page.heading('An integrating sphere',
                 'Inside a sphere of 0.5 m with 1000 lm in its middle each point gets as much from any other: the '
                 'indirect illuminance is Φ ρ/(4 π R^2 (1 - ρ)).')
    rows = []
    for reflectance in (0.5, 0.9, 0.98):
        scene = enclosure({'type': 'sphere', 'center': [0, 0, 0], 'radius': 500, 'inside': True}, reflectance, 1000)
        exact = 1000 * reflectance / (4 * math.pi * 0.25 * (1 - reflectance))
        rows += [[f'{reflectance:g}', *row[1:]]
                 for row in reflected_rows(page, scene, [[0, 300, -400, 0, -0.6, 0.8]], [''], [exact])]
    page.table(['ρ', *REFLECTED_COLUMNS], rows)


# Highlights.

PHONG_MOMENTS = (
    ((0, 0, 1), ((0, '.80543168'), (1, '.75227469'), (2, '.70394207'), (10, '.44067944'), (50, '.12300602'))),
    ((1, 0, 2), ((1, '.67285494'), (10, '.25030005'), (50, '.06150973'))),
)
TINY = 1e-15  # stands for the exponent 0, which a material may not have


def gloss(model_name, shininess, **keys):
    return {'model': model_name, 'diffuse': 0, 'specular': 1, 'shininess': shininess, **keys}


def glossy_value(page, scene, element):
    # A sky that is ten million times larger than its distance may be known to less than the tolerance.
    return page.luxel.probe(scene, elements=[element], accept=(0, TOLERANCE))['points'][0]['value']


def highlights(page):
    page.heading('Phong highlights of a square: axial moments',
                 'A unit square, centred on +z at the distance 1 and seen from the origin, has the radiance 1. With '
                 'kd = 0, ks = 1 the highlight is ∫ max(0, w·u)^n dω over its directions u, w being the mirrored '
                 'view. J. Arvo, *Applications of irradiance tensors to the simulation of non-Lambertian phenomena* '
                 '(1995), gives it in closed form for whole n; here it comes from the cubature that serves every '
                 'exponent. For n = 0 the material has the exponent 10^-15, since it must be above 0.')
    rows = []
    for axis, moments in PHONG_MOMENTS:
        size = math.sqrt(sum(x * x for x in axis))
        # The view is +z; the normal halfway between makes the axis its mirror image.
        normal = [axis[0] / size, axis[1] / size, axis[2] / size + 1]
        for exponent, printed in moments:
            surface = {**STAGE['surfaces'][0], 'material': gloss('phong', exponent or TINY)}
            scene = {**flat('rectangle', center=[0, 0, 1000], size=[1000, 1000]), 'surfaces': [surface]}
            scene['lights'][0]['radiance'] = 1
            element = [0, 0, 0, *normal]
            exact = model.probe_element(scene, element).brightness
            value = glossy_value(page, scene, element)
            rows.append(['(0, 0, 1)' if axis[0] == 0 else '(1, 0, 2)/√5', f'{exponent}', figures(exact), figures(value),
                         '0' + printed, off_exact(value, exact), off_printed(value, float(printed))])
    page.table(['w', 'n', 'exact (sr)', 'Luxel (sr)', 'reference (sr)', 'off the exact',
                'off the reference'], rows)

    page.heading('Blinn-Phong: what a surface reflects of light from everywhere',
                 'At normal view, under a sky of radiance 1 over the whole hemisphere (a disk of 10^7 mm radius at 1 '
                 'mm), with kd = 0, ks = 1 and `highlight: cosine`: ∫ (N·H)^n (N·L) dω = 8π (2^(-n/2) + n) / ((n + '
                 '2)(n + 4)). The same closed form, times 1/π, is what `normalized` divides by. What the disk leaves '
                 'free at its rim, 10^-7 rad, holds 10^-14 of the integral.')
    rows = []
    for exponent in (1, 2, 10, 20, 50, 300, 1000, 10000):
        surface = {**STAGE['surfaces'][0], 'material': gloss('blinn-phong', exponent, highlight='cosine')}
        scene = {**flat('disk', center=[0, 0, 1], radius=1e7), 'surfaces': [surface]}
        scene['lights'][0]['radiance'] = 1
        n = mpf(exponent)
        exact = 8 * mp.pi * (mpf(2) ** (-n / 2) + n) / ((n + 2) * (n + 4))
        value = glossy_value(page, scene, [0, 0, 0, 0, 0, 1])
        rows.append([f'{exponent}', figures(exact), figures(value), off_exact(value, exact)])
    page.table(['n', 'exact (sr)', 'Luxel (sr)', 'off the exact'], rows)


def page_of(luxel):
    page = Page(luxel, HEAD)
    for part in (cie, daylight, lamps, reflected, factors, sphere_means, highlights, inverse):
        part(page)
    return page.text()


def check(luxel, path):
    """The page and a fresh one, line by line."""
    tap = Tap()
    fresh = page_of(luxel).splitlines()
    with open(path, encoding='utf-8') as stream:
        held = stream.read().splitlines()
    tap.equal(len(held), len(fresh), 'the page has as many lines as a fresh one')
    title = 'head'
    differing = []
    for old, new in zip(held + [''] * len(fresh), fresh):
        if new.startswith('## '):
            finish_part(tap, title, differing)
            title, differing = new[3:], []
        if old != new:
            differing += [f'held:  {old}', f'fresh: {new}']
    finish_part(tap, title, differing)
    tap.finish()


def finish_part(tap, title, differing):
    tap.ok(not differing, f'up to date: {title}', *differing, '`make validation` writes the page anew')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('luxel', type=Luxel, help='the luxel executable')
    parser.add_argument('--check', metavar='PAGE', help='compare this page with a fresh one')
    arguments = parser.parse_args()
    if arguments.check:
        check(arguments.luxel, arguments.check)
    else:
        print(page_of(arguments.luxel), end='')


main()
