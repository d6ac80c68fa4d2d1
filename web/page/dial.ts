// SPDX-License-Identifier: MIT
// The colour bar as a dial: its ends are dragged or moved by keys, a drag between them changes the exposure, which
// counts in stops: one more shows half the value in the same colour.
import { colourTable, placeInRange, type Scale } from './colours';
import { fitted, h, styleColour } from './dom';
import { followPointer } from './drag';
import { number, t } from './words';

const PIXELS_OF_A_STOP = 45;
const MOST_STOPS = 8;
const BAR = 16; // pixels

type End = 'low' | 'high';

export class Dial {
    readonly canvas = h('canvas', { class: 'colour-bar', role: 'img' });
    private readonly handles: Record<End, HTMLElement> = { low: this.handle('low'), high: this.handle('high') };
    private readonly unit = h('span', { class: 'dim unit-of-dial' });
    readonly element = h(
        'div',
        { class: 'dial floating' },
        this.unit,
        h('div', { class: 'inner' }, this.canvas, this.handles.high, this.handles.low),
    );
    readonly exposure = h('input', { type: 'range', min: -MOST_STOPS, max: MOST_STOPS, step: 0.25 });
    readonly told = h('output', { class: 'stops' });
    onChange: () => void = () => undefined;

    constructor(readonly scale: Scale) {
        new ResizeObserver(() => this.onChange()).observe(this.canvas);
        followPointer(this.canvas, (_x, y) => {
            const { exposure } = scale;
            return {
                move: (_x: number, ny: number) => this.expose(exposure + (ny - y) / PIXELS_OF_A_STOP),
                end: () => undefined,
            };
        });
        this.exposure.addEventListener('input', () => this.expose(Number(this.exposure.value)));
        this.exposure.addEventListener('dblclick', () => this.expose(0));
    }

    relabel() {
        this.canvas.setAttribute('aria-label', t('Scale'));
        this.exposure.setAttribute('aria-label', t('Exposure'));
        this.handles.low.setAttribute('aria-label', t('Lower end of the scale'));
        this.handles.high.setAttribute('aria-label', t('Upper end of the scale'));
    }

    /** The unit of the values. */
    tellUnit(unit: string) {
        this.unit.textContent = unit;
    }

    /** Changes the exposure by so many stops. */
    turn(stops: number) {
        this.expose(this.scale.exposure + stops);
    }

    private expose(stops: number) {
        const { scale } = this;
        const next = Math.max(-MOST_STOPS, Math.min(MOST_STOPS, Math.round(4 * stops) / 4));
        const factor = 2 ** (scale.exposure - next);
        scale.low *= factor;
        scale.high *= factor;
        scale.exposure = next;
        this.onChange();
    }

    private handle(which: End): HTMLElement {
        const handle = h('span', {
            class: `end-handle ${which}`,
            role: 'slider',
            tabindex: 0,
            'aria-orientation': 'vertical',
        });
        followPointer(handle, (_x, y) => {
            const { low, high } = this.scale;
            const height = this.canvas.clientHeight || 1;
            handle.focus();
            let shift = 0; // places are told from the handle, which goes along
            return {
                move: (_x: number, ny: number) => {
                    shift += ny - y;
                    handle.style.translate = `0 ${shift}px`;
                    this.moveEnd(which, -shift / height, low, high);
                },
                end: () => handle.style.removeProperty('translate'),
            };
        });
        handle.addEventListener('keydown', (event) => {
            const sign = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
            if (!sign) return;
            event.preventDefault();
            this.moveEnd(which, sign * (event.shiftKey ? 0.2 : 0.05), this.scale.low, this.scale.high);
        });
        return handle;
    }

    // An end goes to the value that stood so much farther up the bar, in parts of its length; the range is locked then.
    private moveEnd(which: End, off: number, low: number, high: number) {
        const { scale } = this;
        const at = (which === 'high' ? 1 : 0) + off;
        const value = scale.logarithmic && low > 0 ? low * (high / low) ** at : low + at * (high - low);
        const least = 1e-3 * (high - low);
        if (which === 'high') scale.high = Math.max(value, scale.low + least);
        else scale.low = Math.min(Math.max(value, scale.logarithmic ? least * 1e-3 : 0), scale.high - least);
        scale.locked = true;
        this.onChange();
    }

    /** From below to above, with the ends of the range and values between; of differences there is nothing to turn. */
    draw(scale: Scale = this.scale) {
        const [width, height, context] = fitted(this.canvas);
        const table = colourTable(scale.map);
        for (let y = 0; y < height; y++) {
            const colour = table[Math.round(((height - 1 - y) / (height - 1)) * (table.length - 1))];
            context.fillStyle = `rgb(${colour & 255} ${(colour >> 8) & 255} ${(colour >> 16) & 255})`;
            context.fillRect(0, y, BAR, 1.5);
        }
        context.fillStyle = styleColour('--text');
        context.font = '11px system-ui, sans-serif';
        context.textBaseline = 'middle';
        const steps = 4;
        for (let i = 0; i <= steps; i++) {
            const share = i / steps;
            const value =
                scale.logarithmic && scale.low > 0
                    ? scale.low * (scale.high / scale.low) ** share
                    : scale.low + share * (scale.high - scale.low);
            const y = height - placeInRange(value, scale) * height;
            context.fillText(number(value, 3), BAR + 9, Math.max(7, Math.min(height - 7, y)), width - BAR - 9);
        }
        for (const which of ['low', 'high'] as const) {
            const handle = this.handles[which];
            handle.hidden = scale !== this.scale;
            handle.setAttribute('aria-valuenow', String(scale[which]));
            handle.setAttribute('aria-valuetext', number(scale[which], 4));
        }
        this.exposure.disabled = scale !== this.scale;
        if (document.activeElement !== this.exposure) this.exposure.value = String(scale.exposure);
        this.told.textContent = `${scale.exposure > 0 ? '+' : ''}${number(scale.exposure, 3)} ${t('EV')}`;
    }
}
