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

function levelsIn(rgb: Float32Array, scale: Scale): Uint8ClampedArray {
    return Uint8ClampedArray.from(rgb, (channel) => Math.round(255 * curve(placeInRange(channel, scale))));
}

/**
 * Samples in the colours of the scale; off the surfaces they are transparent.  `isWhole`: the range is the picture's
 * own, in which channels have the very levels of its file.
 */
export function paintSamples(samples: Samples, scale: Scale, isWhole: boolean): Uint8ClampedArray<ArrayBuffer> {
    const { values, mask, rgb } = samples;
    if (!rgb || !showsColours(samples, scale)) return paint(values, mask, scale);
    const levels = isWhole && samples.levels ? samples.levels : levelsIn(rgb, scale);
    const pixels = new Uint8ClampedArray(4 * mask.length);
    for (let i = 0; i < mask.length; i++) {
        if (!mask[i]) continue;
        for (let c = 0; c < 3; c++) pixels[4 * i + c] = levels[3 * i + c];
        pixels[4 * i + 3] = 255;
    }
    return pixels;
}
