// SPDX-License-Identifier: MIT
// Drawings as SVG: text that files hold and the page shows, axes with round steps, curves, and the same as pixels.

type Attributes = Record<string, string | number>;

const escaped = (text: string) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/** An element of SVG, as text. */
export function svg(name: string, attributes: Attributes, ...children: string[]): string {
    const told = Object.entries(attributes).map(([key, value]) => ` ${key}="${escaped(typeof value === 'number' ? String(Number(value.toFixed(2))) : value)}"`);
    return `<${name}${told.join('')}>${children.join('')}</${name}>`;
}

export function words(text: string, x: number, y: number, attributes: Attributes = {}): string {
    return svg('text', { x, y, ...attributes }, escaped(text));
}

/** A line through places, interrupted where there is none. */
export function curve(places: ([number, number] | null)[], attributes: Attributes): string {
    const path = places.map((place, i) => place && `${i && places[i - 1] ? 'L' : 'M'}${place.map((c) => c.toFixed(2)).join(' ')}`);
    return svg('path', { d: path.filter(Boolean).join(''), fill: 'none', 'stroke-linejoin': 'round', ...attributes });
}

/** Round steps between two values, some four of them. */
export function steps(low: number, high: number, wanted = 4): number[] {
    const rough = (high - low) / wanted || 1;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 2.5, 5, 10].map((each) => each * power).find((each) => each >= rough * 0.999)!;
    const first = Math.ceil(low / step - 1e-9);
    const count = Math.floor(high / step + 1e-9) - first + 1;
    return Array.from({ length: Math.max(0, count) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** A whole drawing on white paper. */
export function drawing(width: number, height: number, title: string, ...children: string[]): string {
    const whole = { xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height, role: 'img' };
    const face = { 'font-family': 'system-ui, "DejaVu Sans", sans-serif', 'font-size': 13, fill: '#1b1d21' };
    return svg('svg', whole, svg('title', {}, escaped(title)), svg('rect', { width, height, fill: '#fff' }), svg('g', face, ...children));
}

/** A drawing as a PNG, enlarged by a factor. */
export async function pixelsOf(text: string, width: number, height: number, factor: number): Promise<Blob> {
    const url = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
    try {
        const image = new Image(width, height);
        image.src = url;
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [width * factor, height * factor];
        canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
        return await new Promise<Blob>((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no picture'))), 'image/png'));
    } finally {
        URL.revokeObjectURL(url);
    }
}
