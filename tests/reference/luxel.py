# SPDX-License-Identifier: MIT
"""Runs the luxel command for the tests and reads back what it says and writes."""
import argparse
import json
import os
import random
import struct
import subprocess
import zlib

import numpy as np

INSTRUCTION_SETS = ('x86-64', 'x86-64-v3', 'x86-64-v4') if os.uname().machine == 'x86_64' else ('generic',)
TOLERANCE = 5  # exit code of values that miss the tolerance; they are printed all the same
USAGE = 2  # exit code of a wrong usage, also of an instruction set that this machine lacks


def arguments(description):
    """The command line of a test that draws random scenes: luxel, --campaign, --seed."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument('luxel', type=Luxel, help='the luxel executable')
    parser.add_argument('--campaign', type=int, metavar='N', help='scenes of each kind, instead of the usual few')
    parser.add_argument('--seed', default='luxel', help='another seed draws other scenes')
    parser.add_argument('--kind', action='append', help='only scenes of this kind')
    return parser.parse_args()


def generator(*seed):
    """A random generator that depends on nothing but the words and numbers given."""
    return random.Random(' '.join(map(str, seed)))


class Failed(Exception):
    """luxel ended with another exit code than 0."""

    def __init__(self, result, scene):
        self.code = result.returncode
        self.message = result.stderr
        super().__init__(f'exit code {self.code}: {self.message.strip()}\nscene: {json.dumps(scene)}')


class Luxel:
    timeout_s = 120

    def __init__(self, path):
        self.path = os.path.abspath(path)

    def run(self, arguments, scene=None, instruction_set=None, accept=(0,)):
        """Runs a command with the scene, if any, on standard input and returns the JSON object that it prints."""
        environment = dict(os.environ)
        environment.pop('LUXEL_ISA', None)
        if instruction_set:
            environment['LUXEL_ISA'] = instruction_set
        result = subprocess.run([self.path, *arguments, '--json'], input=json.dumps(scene), env=environment,
                                capture_output=True, encoding='utf-8', timeout=self.timeout_s)
        if result.returncode not in accept:
            raise Failed(result, scene)
        return json.loads(result.stdout)

    def probe(self, scene, points=(), elements=(), options=(), accept=(0,)):
        """The JSON object of `luxel probe` for screen points x, y or for free elements."""
        arguments = ['probe', '-', *options]
        for point in points:
            arguments += ['-p', _numbers(point)]
        for element in elements:
            arguments += ['--at', _numbers(element)]
        return self.run(arguments, scene, accept=accept)

    def values_at(self, scene, points=(), elements=(), options=()):
        """Only the values, None where there is none."""
        return [point['value'] for point in self.probe(scene, points, elements, options)['points']]

    def render(self, scene, *outputs, options=(), instruction_set=None):
        """The JSON object of `luxel render`, after it wrote the outputs."""
        arguments = ['render', '-', *options]
        for output in outputs:
            arguments += ['-o', output]
        return self.run(arguments, scene, instruction_set)

    def instruction_sets(self, scene):
        """Those that this machine can run, and those that luxel refuses here."""
        runs, lacks = [], []
        for name in INSTRUCTION_SETS:
            try:
                self.render(scene, instruction_set=name)
                runs.append(name)
            except Failed as failure:
                if failure.code != USAGE:
                    raise
                lacks.append(name)
        return runs, lacks


def _numbers(numbers):
    return ','.join(repr(float(number)) for number in numbers)


def read_png(path):
    """The grey levels of an 8-bit or 16-bit grey PNG without interlacing, as an array of rows."""
    data = open(path, 'rb').read()
    if data[:8] != b'\x89PNG\r\n\x1a\n':
        raise ValueError('no PNG')
    place, pixels = 8, b''
    while place < len(data):
        size, kind = struct.unpack('>I4s', data[place:place + 8])
        body = data[place + 8:place + 8 + size]
        if kind == b'IHDR':
            columns, rows, *form = struct.unpack('>IIBBBBB', body)
            if form not in ([8, 0, 0, 0, 0], [16, 0, 0, 0, 0]):
                raise ValueError(f'PNG of another form: {form}')
        elif kind == b'IDAT':
            pixels += body
        place += 12 + size
    lines, width = zlib.decompress(pixels), form[0] // 8
    length = columns * width
    picture = np.zeros((rows + 1, length + width), dtype=np.uint8)
    for row in range(rows):
        line = lines[row * (length + 1):(row + 1) * (length + 1)]
        _unfilter(line[0], line[1:], width, picture[row], picture[row + 1])
    return np.ascontiguousarray(picture[1:, width:]).view('>u%d' % width)


def _unfilter(kind, line, width, above, out):
    """Undoes one line's filter; `above` and `out` have the `width` zero bytes of a pixel on the left."""
    for i, byte in enumerate(line, width):
        left, up, corner = int(out[i - width]), int(above[i]), int(above[i - width])
        nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
        out[i] = (byte + (0, left, up, (left + up) // 2, nearest)[kind]) & 255


def read_pfm(path):
    """The values of a grey PFM with the top row first."""
    with open(path, 'rb') as stream:
        kind, size, factor = (stream.readline().strip() for _ in range(3))
        columns, rows = map(int, size.split())
        if kind != b'Pf':
            raise ValueError('no grey PFM')
        order = '<' if float(factor) < 0 else '>'
        return np.frombuffer(stream.read(), dtype=order + 'f4').reshape(rows, columns)[::-1]
