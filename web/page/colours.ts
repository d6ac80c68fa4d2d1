// SPDX-License-Identifier: MIT
// From values to colours: the range of the colour bar, and the maps.

export interface Scale {
    map: 'tone' | 'grey' | 'viridis' | 'turbo' | 'difference';
    logarithmic: boolean;
    locked: boolean;
    low: number;
    high: number;
    exposure: number; // stops by which the range is below that of the picture
}

// Viridis at equal steps (van der Walt, Smith and Firing; public domain), between which colours are interpolated.
const VIRIDIS = [0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725];

function viridis(at: number): number[] {
    const place = at * (VIRIDIS.length - 1);
    const index = Math.min(VIRIDIS.length - 2, Math.floor(place));
    const share = place - index;
    return [16, 8, 0].map((shift) => {
        const from = (VIRIDIS[index] >> shift) & 255;
        const to = (VIRIDIS[index + 1] >> shift) & 255;
        return from + (to - from) * share;
    });
}

// Turbo as the polynomials that its authors published (Mikhailov 2019, Apache-2.0).
function turbo(x: number): number[] {
    const powers = [1, x, x * x, x ** 3, x ** 4, x ** 5];
    const sum = (factors: number[]) => 255 * factors.reduce((total, factor, i) => total + factor * powers[i], 0);
    return [
        sum([0.13572138, 4.6153926, -42.66032258, 132.13108234, -152.94239396, 59.28637943]),
        sum([0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604]),
        sum([0.1066733, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973]),
    ].map((value) => Math.max(0, Math.min(255, value)));
}

// Below zero blue, above it red, white between: for differences.
function diverging(at: number): number[] {
    const from = at < 0.5 ? [33, 102, 172] : [178, 24, 43];
    const share = Math.min(1, Math.abs(2 * at - 1)) ** 0.8;
    return from.map((part) => 247 + (part - 247) * share);
}

// As the eye and screens have it: even steps of lightness, a little warm at the top.
function tone(at: number): number[] {
    const share = at ** (1 / 2.2);
    return [9 + 246 * share, 10 + 239 * share, 14 + 223 * share];
}

const MAPS: Record<Scale['map'], (at: number) => number[]> = {
    tone,
    grey: (at) => [255 * at, 255 * at, 255 * at],
    viridis,
    turbo,
    difference: diverging,
};

const STEPS = 1024;

const tables = new Map<Scale['map'], Uint32Array>();

/** The colours of a map in equal steps, as the pixels of an image. */
export function colourTable(map: Scale['map']): Uint32Array {
    const known = tables.get(map);
    if (known) return known;
    const table = new Uint32Array(STEPS);
    for (let i = 0; i < STEPS; i++) {
        const at = i / (STEPS - 1);
        const [r, g, b] = MAPS[map](at);
        table[i] = (255 << 24) | (Math.round(b) << 16) | (Math.round(g) << 8) | Math.round(r);
    }
    tables.set(map, table);
    return table;
}

/** Where a value stands in the range, 0 to 1. */
export function placeInRange(value: number, { logarithmic, low, high }: Scale): number {
    if (!(high > low)) return value >= high && high > 0 ? 1 : 0;
    const at = logarithmic
        ? value > 0 && low > 0
            ? Math.log(value / low) / Math.log(high / low)
            : 0
        : (value - low) / (high - low);
    return Math.max(0, Math.min(1, at));
}

/** Pixels of the values in the colours of the scale; off the surfaces they are transparent. */
export function paint(values: Float32Array, mask: Uint8Array, scale: Scale): Uint8ClampedArray<ArrayBuffer> {
    const pixels = new Uint32Array(values.length);
    const table = colourTable(scale.map);
    const { logarithmic, low, high } = scale;
    const factor = high > low ? (STEPS - 1) / (high - low) : 0;
    for (let i = 0; i < values.length; i++) {
        if (!mask[i]) continue;
        const at = logarithmic ? placeInRange(values[i], scale) * (STEPS - 1) : (values[i] - low) * factor;
        pixels[i] = table[at <= 0 ? 0 : at >= STEPS - 1 ? STEPS - 1 : Math.round(at)];
    }
    return new Uint8ClampedArray(pixels.buffer);
}
