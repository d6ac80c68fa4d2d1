// SPDX-License-Identifier: MIT
// Pictures in colour: their views, and channels as a display shows them, by the curve of sRGB.
import { paint, placeInRange, type Scale } from './colours';
import type { Samples } from './core';

/** Views of a picture in colour, as the core counts them. */
export const COLOUR_VIEWS = ['luminance', 'red', 'green', 'blue', 'cct'] as const;
export type ColourView = (typeof COLOUR_VIEWS)[number];

/** The curve of sRGB, from 0 to 1. */
export function curve(channel: number): number {
    return channel <= 0.0031308 ? 12.92 * channel : 1.055 * channel ** (1 / 2.4) - 0.055;
}

/** The other way. */
export function uncurve(level: number): number {
    return level <= 0.04045 ? level / 12.92 : ((level + 0.055) / 1.055) ** 2.4;
}

/** A colour of the page that shows channels with the greatest of them full; what is below 0 is clipped. */
export function swatch(rgb: number[]): string {
    const most = Math.max(...rgb);
    const level = (channel: number) => Math.round(255 * curve(Math.max(0, most > 0 ? channel / most : 0)));
    return `rgb(${rgb.map(level).join(' ')})`;
}

/** Whether samples are shown in their own colours: false colours are of their luminance. */
export function showsColours({ rgb }: Samples, { map }: Scale): boolean {
    return !!rgb && (map === 'tone' || map === 'grey');
}

/** The greatest channel of a picture, which is white in its file. */
export function greatestChannel(rgb: Float32Array): number {
    let most = 0;
    for (const channel of rgb) if (channel > most) most = channel;
    return most;
}

const STEPS = 65535; // of the table of levels: fine enough for the darkest ones
let levelOf: Uint8Array | null = null; // which takes a moment to make, and most pages never need

function levelsIn(rgb: Float32Array, scale: Scale): Uint8Array {
    levelOf ??= Uint8Array.from({ length: STEPS + 1 }, (_, i) => Math.round(255 * curve(i / STEPS)));
    const { logarithmic, low, high } = scale;
    const isPlain = !logarithmic && high > low;
    const factor = isPlain ? 1 / (high - low) : 0;
    const levels = new Uint8Array(rgb.length);
    for (let i = 0; i < rgb.length; i++) {
        const at = isPlain ? (rgb[i] - low) * factor : placeInRange(rgb[i], scale);
        levels[i] = levelOf[at <= 0 ? 0 : at >= 1 ? STEPS : Math.round(at * STEPS)];
    }
    return levels;
}

/**
 * Samples in the colours of the scale; off the surfaces they are transparent.  `isWhole`: the range is the picture's
 * own, in which channels have the very levels of its file.
 */
export function paintSamples(samples: Samples, scale: Scale, isWhole: boolean): Uint8ClampedArray<ArrayBuffer> {
    const { values, mask, rgb } = samples;
    if (!rgb || !showsColours(samples, scale)) return paint(values, mask, scale);
    const levels = isWhole && samples.levels ? samples.levels : levelsIn(rgb, scale);
    const pixels = new Uint32Array(mask.length);
    for (let i = 0; i < mask.length; i++) if (mask[i]) pixels[i] = (255 << 24) | (levels[3 * i + 2] << 16) | (levels[3 * i + 1] << 8) | levels[3 * i];
    return new Uint8ClampedArray(pixels.buffer);
}
