// SPDX-License-Identifier: MIT
// The histogram of the picture's pixels in the strip, and the extrema of the exact function between them, to which the probe
// goes at a press.
import { Apart } from './apart';
import type { Peak } from './core';
import { fitted, h, styleColour } from './dom';
import type { Model } from './model';
import type { Version } from './version';
import { number, t } from './words';

const MARGIN = { left: 44, right: 8, bottom: 18, top: 8 };
const BIN = 6; // pixels across

export class Histogram {
    private readonly canvas = h('canvas', { class: 'bars', role: 'img' });
    private readonly facts = h('div', { class: 'facts' });
    readonly element = h('div', { class: 'histogram' }, this.canvas, this.facts);
    /** Shows a point in the views. */
    onChoose: (x: number, y: number) => void = () => undefined;
    private of: Version | null = null; // what is shown
    private peaks: Peak[] = [];
    private peaksOf: Version | null = null;
    private readonly extrema: Apart<Peak[]>;

    constructor(private readonly model: Model) {
        model.follow(this.canvas, () => this.of);
        model.follow(this.facts, () => this.peaksOf);
        this.extrema = new Apart(
            model,
            (client, of) => client.ask('extrema', of),
            (peaks, of) => {
                [this.peaks, this.peaksOf] = [peaks ?? [], of];
                this.tell();
            },
        );
        new ResizeObserver(() => this.draw()).observe(this.canvas);
    }

    clear() {
        this.of = this.peaksOf = null;
        this.peaks = [];
        this.facts.replaceChildren();
        this.draw();
    }

    /** Whether the strip shows it. */
    set isShown(isShown: boolean) {
        this.extrema.isShown = isShown;
        this.extrema.refresh();
        this.draw();
    }

    /** After a new picture, or in other words. */
    show() {
        this.draw();
        if (this.peaksOf) this.tell();
    }

    private tell() {
        const { scene } = this.model;
        if (!scene) return;
        const unit = scene.unit === 'relative' ? t('relative') : scene.unit;
        const rows = this.peaks.map(({ value, x, y }, i) => {
            const place = `x = ${number(Math.abs(x) < 1e-9 ? 0 : x, 5)}, y = ${number(Math.abs(y) < 1e-9 ? 0 : y, 5)} ${t('mm')}`;
            return h(
                'button',
                { type: 'button', class: 'link', onclick: () => this.onChoose(x, y), title: t('Move the probe there') },
                `${t(i ? 'true minimum' : 'true maximum')} ${number(value, 6)} ${unit}`,
                h('span', { class: 'dim' }, ` ${place}`),
            );
        });
        this.facts.replaceChildren(...(rows.length ? rows : [h('p', { class: 'dim' }, t('off every surface'))]));
        this.model.dim();
    }

    // Each bar is as high as the share of pixels whose values are in it.
    draw() {
        const [width, height, context] = fitted(this.canvas);
        const { picture } = this.model;
        if (!picture || width < 80 || height < 30) return;
        this.of = picture.of;
        const { values, mask, facts } = picture;
        const most = facts.maximum.exists ? facts.maximum.value || 1 : 1;
        const least = Math.min(0, facts.minimum.exists ? facts.minimum.value : 0);
        const count = Math.max(8, Math.floor((width - MARGIN.left - MARGIN.right) / BIN));
        const bins = new Uint32Array(count);
        let all = 0;
        for (let i = 0; i < values.length; i++) {
            if (!mask[i]) continue;
            bins[Math.min(count - 1, Math.floor(((values[i] - least) / (most - least)) * count))]++;
            all++;
        }
        if (!all) return;
        const highest = bins.reduce((a, b) => Math.max(a, b), 0) / all;
        const [left, low] = [MARGIN.left, height - MARGIN.bottom];
        const across = (width - left - MARGIN.right) / count;
        const rise = (low - MARGIN.top) / highest;
        context.fillStyle = styleColour('--dim');
        bins.forEach((bin, i) => bin && context.fillRect(left + i * across + 0.5, low - (bin / all) * rise, across - 1, (bin / all) * rise));
        context.strokeStyle = styleColour('--line');
        context.beginPath();
        context.moveTo(left, low + 0.5);
        context.lineTo(width - MARGIN.right, low + 0.5);
        context.stroke();
        context.font = '11px system-ui, sans-serif';
        context.textBaseline = 'middle';
        context.textAlign = 'right';
        context.fillText(`${number(100 * highest, 2)} %`, left - 4, MARGIN.top + 4);
        context.textBaseline = 'top';
        for (const share of [0, 0.5, 1]) {
            context.textAlign = share === 0 ? 'left' : share === 1 ? 'right' : 'center';
            context.fillText(number(Number((least + share * (most - least)).toPrecision(3)), 3), left + share * count * across, low + 4);
        }
        this.canvas.setAttribute('aria-label', `${t('Histogram')}: ${number(least)} … ${number(most)}, ${all} ${t('pixels')}`);
        this.model.dim();
    }
}
