# SPDX-License-Identifier: MIT
"""The page docs/VALIDATION.md as it is put together: headings, tables, and how numbers and deviations are printed."""
import textwrap

from mpmath import mp, mpf

STAGE = {
    'luxel': 1,
    'screen': {'width': 100, 'height': 100, 'resolution': [10, 10]},
    'observer': {'z': 2000},
    'surfaces': [{'type': 'sphere', 'center': [0, 0, -9000], 'radius': 100}],
}
WIDTH = 118       # of the page's text
LEAST = -14       # nearer to float64's own resolution, compilers may differ


class Page:
    def __init__(self, luxel, head):
        self.luxel = luxel
        self.lines = head.splitlines()

    def heading(self, title, *paragraphs):
        self.lines += ['', '## ' + title]
        for paragraph in paragraphs:
            self.lines += ['', *textwrap.wrap(paragraph, WIDTH, break_long_words=False, break_on_hyphens=False)]

    def table(self, columns, rows):
        self.lines += ['', '| ' + ' | '.join(columns) + ' |', '|' + '---|' * len(columns)]
        self.lines += ['| ' + ' | '.join(row) + ' |' for row in rows]

    def text(self):
        return '\n'.join(self.lines) + '\n'


def off_exact(value, exact, least=LEAST):
    if exact == 0:
        return '0' if value == 0 else power_above(abs(mpf(value)), least) + ' (absolute)'
    return power_above(abs(mpf(value) / exact - 1), least)


def power_above(number, least=LEAST):
    if number == 0:
        return f'1e{least}'
    return f'1e{max(least, int(mp.ceil(mp.log10(number))))}'


def off_printed(value, printed):
    if not printed:
        return ''
    text = f'{100 * (value / printed - 1):+.3f}'
    return ('0.000' if float(text) == 0 else text) + ' %'


def figures(number, digits=10):
    return f'{float(number):.{digits}g}' if abs(number) > 1e-14 else '0'
