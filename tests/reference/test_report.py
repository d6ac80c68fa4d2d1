# SPDX-License-Identifier: MIT
"""The lab report's experiment, the built-in scene: its printed table and the exact values at its points; and a
lopsided scene that shows which way up pictures, files and the pixel look-up are."""
import os
import tempfile

import numpy as np

import vector_model
from luxel import arguments, read_pfm, read_png
from tap import Tap

PIXEL_VALUES = ('2.7488e+00', '1.1024e+01', '1.1835e-07')
EXACT = (2.7275906525546927, 11.038015039262981, 1.1299660232888e-07)

LOPSIDED = {
    'luxel': 1,
    'screen': {'width': 610, 'height': 470, 'resolution': [61, 47], 'sampling': 'centers'},
    'observer': {'z': 2000},
    'surfaces': [{'type': 'sphere', 'center': [60, 40, 500], 'radius': 180}],
    'lights': [{'type': 'point', 'position': [400, 2500, 1500], 'intensity': 10, 'attenuation': 'none'}],
}


def test_table(tap, luxel):
    for arguments_ in (['render'], ['render', 'report']):
        said = luxel.run(arguments_)
        name = ' '.join(arguments_)
        tap.equal(f'{said["max"]["value"]:.4f}', '11.7475', f'{name}: maximum')
        tap.equal((said['unit'], said['quantity'], said['resolution']), ('W/sr', 'brightness', [360, 360]),
                  f'{name}: unit, quantity, resolution')
        tap.equal([point['screen'] for point in said['points']], [[0, 0], [150, 0], [-150, 0]], f'{name}: points')
        for point, printed, exact in zip(said['points'], PIXEL_VALUES, EXACT):
            tap.equal(f'{point["pixel_value"]:.4e}', printed, f'{name}: pixel value at {point["screen"]}')
            tap.near(point['value'], exact, 1e-12, f'{name}: exact value at {point["screen"]}')


def test_way_up(tap, luxel):
    """Row 0 is the largest y and column 0 the smallest x, in the array, in every file and in the look-up."""
    x, y = vector_model.samples(LOPSIDED)
    truth = vector_model.evaluate(LOPSIDED, x, y).value.reshape(47, 61).astype(float)
    bound = 1e-5 * truth.max()
    upside_down = abs(truth - truth[::-1]).max() > 0.1 * truth.max()
    mirrored = abs(truth - truth[:, ::-1]).max() > 0.1 * truth.max()
    tap.ok(upside_down and mirrored, 'the scene is lopsided')
    with tempfile.TemporaryDirectory() as folder:
        npy, pfm, png = (os.path.join(folder, 'picture' + ending) for ending in ('.npy', '.pfm', '.png'))
        said = luxel.render(LOPSIDED, npy, pfm, png)
        picture = np.load(npy)
        tap.ok(abs(picture - truth).max() <= bound, 'npy runs from the top left')
        tap.ok((read_pfm(pfm) == picture).all(), 'pfm runs from the bottom left, as its format says')
        tap.ok(abs(read_png(png) / 255 - truth / truth.max()).max() <= 1 / 255 + 1e-5, 'png runs from the top left')
    row, column = np.unravel_index(truth.argmax(), truth.shape)
    tap.equal(said['max']['pixel'], [column, row], 'the brightest pixel')
    tap.ok(said['max']['screen'][1] > 100, 'the brightest place is high up', said['max'])
    for column, row in ((20, 12), (50, 11), (33, 30)):
        place = [float(x[row * 61 + column]), float(y[row * 61 + column])]
        point = luxel.probe(LOPSIDED, points=[place])['points'][0]
        tap.equal(point['pixel'], [column, row], f'look-up of {place}')
        tap.equal(point['pixel_value'], float(picture[row, column]), f'pixel value at {place}')
        tap.near(point['value'], truth[row, column], 1e-11, f'value at {place}')


def main():
    luxel = arguments(__doc__).luxel
    tap = Tap()
    tap.run(test_table, tap, luxel)
    tap.run(test_way_up, tap, luxel)
    tap.finish()


main()
