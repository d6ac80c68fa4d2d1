// SPDX-License-Identifier: MIT
// What the chapters of the lessons show and ask, in any language: scenes of their figures, guesses and checks.  What they
// say stands in en.ts and ru.ts.
import type { FigureData } from './figure';
import type { Names } from './expression';

/** A question about two values of a figure, the second as a multiple of the first; the core tells which answer is right. */
export interface Guess {
    figure: string;
    before: Names;
    after: Names;
    times: number[]; // what may be chosen
    afterAt?: (number | string)[]; // where the second value is; without it where the first is
}

/** A number that is asked for: the value of a figure with these names, which the core computes and judges by. */
export interface Check {
    figure: string;
    set: Names;
}

export interface Chapter {
    figures: Record<string, FigureData>;
    guess: Guess;
    check: Check;
}

const PAPER = '{diffuse: 0.7, specular: 0, over_pi: true}';

// A table before a wall; a ball and a block, which throw shadows.
const BARE_TABLE = `units: photometric
surfaces:
  - {type: rectangle, name: table, center: [0, 0, 0], size: [2600, 1600], axis: [0, 0, 1], material: ${PAPER}}
  - {type: rectangle, name: wall, center: [0, 800, 650], size: [2600, 1300], axis: [0, -1, 0], up: [0, 0, 1], material: ${PAPER}}
`;
const TABLE = `${BARE_TABLE}  - {type: sphere, name: ball, center: [520, 320, 130], radius: 130, material: ${PAPER}}
  - {type: box, name: block, center: [-560, 220, 110], size: [220, 220, 220], rotate: [0, 0, 25], up: z, material: ${PAPER}}
`;
const CAMERA: FigureData['camera'] = { from: [500, -2600, 1250], to: [0, 150, 420], width: 2300 };

// The exercise's sphere, seen along the axis.
const SPHERE = `surfaces:
  - {type: sphere, center: [0, 0, 1000], radius: 300, material: {diffuse: <kd>, specular: <ks>, shininess: <n>, highlight: plain}}
lights:
  - {type: point, position: [<x>, <y>, 2000], intensity: 10, attenuation: none}
`;
const BALL_CAMERA: FigureData['camera'] = { z: 1500, width: 1200 };

const control = (key: string, low: number, high: number, step: number, value: number, unit = 'mm') =>
    ({ key, low, high, step, value, unit });
const height = (value: number, low = 200, high = 1400) => control('h', low, high, 10, value);
const aside = (value: number, reach = 1000) => control('x', -reach, reach, 10, value);

const radians = (degrees: number) => (degrees * Math.PI) / 180;
const distance = ({ x, h }: Record<string, number>) => Math.hypot(x, h) / 1000;
const cosine = ({ x, h }: Record<string, number>) => h / Math.hypot(x, h);

const POINT = { at: [0, 0, 0], mark: ['x', 0, 'h'], quantity: 'irradiance' as const, camera: CAMERA };
const FLOOR: [number[], number[]] = [[-1200, 0, 0], [1200, 0, 0]];

const square = (z: string, half: string) =>
    [[`-${half}`, `-${half}`, z], [half, `-${half}`, z], [half, half, z], [`-${half}`, half, z], [`-${half}`, `-${half}`, z]];

export const CHAPTERS: Record<string, Chapter> = {
    ambient: {
        figures: {
            alone: {
                ...POINT,
                mark: undefined,
                scene: `${TABLE}lights:\n  - {type: ambient, irradiance: <a>}\n`,
                controls: [control('a', 0, 200, 5, 100, 'lx')],
                formula: 'E = E_a',
            },
            relief: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: ambient, irradiance: <a>}\n  - {type: point, position: [<x>, 0, <h>], intensity: 60}\n`,
                controls: [control('a', 0, 200, 5, 20, 'lx'), aside(-300), height(900)],
                curve: { along: FLOOR },
            },
        },
        guess: { figure: 'alone', before: {}, after: {}, afterAt: [0, 800, 500], times: [0, 0.5, 0.7071, 1] },
        check: { figure: 'relief', set: { a: 40, x: 0, h: 1000 } },
    },
    point: {
        figures: {
            bulb: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: point, position: [<x>, 0, <h>], intensity: 60}\n`,
                controls: [aside(360), height(620)],
                derived: { r: distance, c: cosine },
                formula: 'E = \\frac{I}{r^2} (\\v{N}·\\v{L}) = \\frac{60}{<r>^2} · <c>',
            },
            lift: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: point, position: [0, 0, <h>], intensity: 60}\n`,
                mark: [0, 0, 'h'],
                controls: [height(1000)],
                curve: { over: 'h', from: 200, to: 1400, most: 320 },
                derived: { r: ({ h }) => h / 1000 },
                formula: 'E = \\frac{I}{r^2} = \\frac{60}{<r>^2}',
            },
        },
        guess: { figure: 'lift', before: { h: 500 }, after: { h: 1000 }, times: [0.5, 0.25, 0.125, 1] },
        check: { figure: 'bulb', set: { x: 600, h: 800 } },
    },
    practical: {
        figures: {
            laws: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: point, position: [0, 0, <h>], intensity: 60, attenuation: <law>, k: <k>}\n`,
                mark: [0, 0, 'h'],
                controls: [height(500, 50), control('k', 50, 1000, 10, 500)],
                set: { law: 'practical' },
                curve: { over: 'h', from: 50, to: 1400, most: 300, lines: [{ law: 'practical' }, { law: 'inverse-square' }] },
                derived: { r: ({ h }) => h / 1000, km: ({ k }) => k / 1000 },
                formula: 'E = \\frac{I}{k + r} (\\v{N}·\\v{L}) = \\frac{60}{<km> + <r>} · 1',
            },
            near: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: point, position: [<x>, 0, 150], intensity: 60, attenuation: <law>, k: <k>}\n`,
                mark: ['x', 0, 150],
                controls: [aside(300), control('k', 50, 1000, 10, 200)],
                set: { law: 'practical' },
                curve: { along: FLOOR, most: 300, lines: [{ law: 'practical' }, { law: 'inverse-square' }] },
            },
        },
        guess: { figure: 'laws', before: { h: 500, k: 500 }, after: { h: 100, k: 500 }, times: [25, 5, 1.667, 1] },
        check: { figure: 'laws', set: { h: 700, k: 500 } },
    },
    distant: {
        figures: {
            sun: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: distant, direction: [<dx>, 0, <dz>], irradiance: 800}\n`,
                mark: ['sx', 0, 'sz'],
                controls: [control('s', 5, 175, 1, 50, '°')],
                derived: {
                    dx: ({ s }) => -Math.cos(radians(s)),
                    dz: ({ s }) => -Math.sin(radians(s)),
                    sx: ({ s }) => 1000 * Math.cos(radians(s)),
                    sz: ({ s }) => 1000 * Math.sin(radians(s)),
                },
                curve: { over: 's', from: 5, to: 175 },
                formula: 'E = E_0 (\\v{N}·\\v{L}) = 800 · \\t{sin }<s>°',
            },
            far: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: point, position: [0, 0, <d>], intensity: <i>}\n`,
                mark: [0, 0, 'd'],
                controls: [control('d', 400, 8000, 50, 600)],
                derived: { i: ({ d }) => (800 * d * d) / 1e6 },
                curve: { along: FLOOR },
            },
        },
        guess: { figure: 'sun', before: { s: 90 }, after: { s: 30 }, times: [1, 0.87, 0.5, 0.33] },
        check: { figure: 'sun', set: { s: 45 } },
    },
    cone: {
        figures: {
            aim: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: spot, position: [-500, -100, 1000], aim: [<x>, 0, 0], intensity: 400, inner: <b>, outer: <o>}\n`,
                mark: ['x', 0, 0],
                outlines: [[[-500, -100, 1000], ['x', 0, 0]]],
                controls: [aside(200, 900), control('o', 4, 40, 1, 16, '°')],
                derived: { b: ({ o }) => o / 2 },
            },
            edge: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: spot, position: [<x>, 0, 1000], aim: [<x>, 0, 0], intensity: 400, inner: <b>, outer: 30}\n`,
                mark: ['x', 0, 1000],
                controls: [aside(200), control('b', 0, 30, 1, 10, '°')],
                curve: { along: FLOOR },
                derived: { r: ({ x }) => Math.hypot(x, 1000) / 1000, c: ({ x }) => 1000 / Math.hypot(x, 1000) },
                formula: 'E = \\frac{I(α)}{r^2} (\\v{N}·\\v{L}) = \\frac{I(α)}{<r>^2} · <c>',
            },
        },
        guess: { figure: 'aim', before: { x: 0, o: 30 }, after: { x: 0, o: 15 }, times: [0.5, 1, 2, 4] },
        check: { figure: 'edge', set: { x: 200, b: 20 } },
    },
    area: {
        figures: {
            panel: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: planar, rectangle: {center: [<x>, 0, <h>], size: [<w>, <w>], axis: [0, 0, -1]}, intensity: 60, parts: <parts>}\n`,
                controls: [aside(500), height(800), control('w', 20, 1000, 20, 400)],
                set: { parts: 'converged' },
                outlines: [square('h', 'w/2').map(([a, b, z]) => [a[0] === '-' ? `x${a}` : `x+${a}`, b, z])],
                derived: { r: distance, c: cosine },
                formula: 'E ≈ \\frac{I}{r^2} (\\v{N}·\\v{L}) (\\v{M}·(-\\v{L})) \\\\ ≈ \\frac{60}{<r>^2} · <c> · <c>',
            },
            near: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: planar, rectangle: {center: [0, 0, <h>], size: [<w>, <w>], axis: [0, 0, -1]}, intensity: 60, parts: <parts>}\n`,
                mark: [0, 0, 'h'],
                controls: [height(500), control('w', 20, 1000, 20, 1000)],
                set: { parts: 'converged' },
                outlines: [square('h', 'w/2')],
                curve: { over: 'h', from: 200, to: 1400, most: 400, lines: [{}, { parts: 1 }] },
            },
            parts: {
                ...POINT,
                scene: `${BARE_TABLE}lights:\n  - {type: planar, rectangle: {center: [0, 0, 200], size: [1000, 1000], axis: [0, 0, -1]}, intensity: 60, parts: <p>}\n`,
                mark: undefined,
                controls: [control('p', 1, 20, 1, 2, '')],
                outlines: [square('200', '500')],
                curve: { along: FLOOR, lines: [{}, { p: 'converged' }] },
            },
        },
        guess: {
            figure: 'near',
            before: { h: 200, w: 1000, parts: 1 },
            after: { h: 200, w: 1000, parts: 'converged' },
            times: [2, 1, 0.5, 0.11],
        },
        check: { figure: 'panel', set: { x: 1000, h: 1000, w: 20 } },
    },
    volume: {
        figures: {
            globe: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: volume, sphere: {center: [<x>, 0, <h>], radius: <R>}, power: 754}\n`,
                controls: [aside(-300), height(800, 350), control('R', 10, 300, 10, 100)],
                derived: { r: distance, c: cosine, i: () => 754 / (4 * Math.PI) },
                outlines: [
                    Array.from({ length: 33 }, (_, i) => {
                        const [a, b] = [Math.cos((i * Math.PI) / 16), Math.sin((i * Math.PI) / 16)].map((c) => Number(c.toFixed(6)));
                        return [`x${a < 0 ? '-' : '+'}R*${Math.abs(a)}`, 0, `h${b < 0 ? '-' : '+'}R*${Math.abs(b)}`];
                    }),
                ],
                formula: 'E = \\frac{Φ}{4 π r^2} (\\v{N}·\\v{L}) = \\frac{<i>}{<r>^2} · <c>',
            },
            box: {
                ...POINT,
                scene: `${TABLE}lights:\n  - {type: volume, box: {center: [<x>, 0, <h>], size: [<w>, <w>, <w>]}, radiance: 500}\n`,
                controls: [aside(300), height(700, 350), control('w', 40, 400, 20, 240)],
                outlines: ['h-w/2', 'h+w/2'].map((z) =>
                    [['-', '-'], ['+', '-'], ['+', '+'], ['-', '+'], ['-', '-']].map(([a, b]) => [`x${a}w/2`, `${b}w/2`, z]),
                ),
                curve: { along: FLOOR },
            },
        },
        guess: { figure: 'globe', before: { x: 0, h: 800, R: 50 }, after: { x: 0, h: 800, R: 200 }, times: [0.25, 1, 4, 16] },
        check: { figure: 'globe', set: { x: 0, h: 1200, R: 100 } },
    },
    reflection: {
        figures: {
            ball: {
                scene: SPHERE,
                camera: BALL_CAMERA,
                quantity: 'brightness',
                at: [0, 0, 1300],
                mark: ['x', 'y', 2000],
                controls: [control('x', -560, 560, 10, 300), control('y', -300, 300, 10, 180), control('n', 1, 200, 1, 20, '')],
                set: { kd: 0.8, ks: 0.5 },
                derived: {
                    c: ({ x, y }) => 700 / Math.hypot(x, y, 700),
                    s: ({ x, y }) => Math.cos(Math.acos(700 / Math.hypot(x, y, 700)) / 2),
                },
                formula: 'B = I (k_d (\\v{N}·\\v{L}) + k_s (\\v{N}·\\v{H})^n) \\\\ = 10 · (0.8 · <c> + 0.5 · <s>^{<n>})',
            },
            peak: {
                scene: SPHERE,
                camera: BALL_CAMERA,
                quantity: 'brightness',
                at: [0, 0, 1300],
                mark: ['x', 'y', 2000],
                controls: [control('x', -560, 560, 10, 400), control('ks', 0, 1, 0.05, 0.5, ''), control('n', 1, 200, 1, 20, '')],
                set: { kd: 0.8, y: 0 },
                curve: { along: [[-300, 0, 0], [300, 0, 0]], lines: [{}, { ks: 0 }] },
            },
        },
        guess: { figure: 'ball', before: { x: 0, y: 0, n: 20 }, after: { x: 0, y: 0, n: 80 }, times: [0.5, 1, 2, 4] },
        check: { figure: 'ball', set: { x: 560, y: 300, n: 20 } },
    },
};
