// SPDX-License-Identifier: MIT
// The colour bar as a dial: its ends are dragged or moved by keys, a drag between them changes the exposure, which
// counts in stops: one more shows half the value in the same colour.  It stands beside the stage, and lies below it on
// phones; a mark shows where the probe's value is.
import { colourTable, placeInRange, type Scale } from './colours';
import { fitted, h, styleColour } from './dom';
import { followPointer } from './drag';
import { number, t } from './words';

const PIXELS_OF_A_STOP = 45;
const MOST_STOPS = 8;
const BAR = 16; // pixels
const LYING = matchMedia('(max-width: 700px)');

type End = 'low' | 'high';

export class Dial {
    readonly canvas = h('canvas', { class: 'colour-bar', role: 'img' });
    private readonly handles: Record<End, HTMLElement> = { low: this.handle('low'), high: this.handle('high') };
    private readonly unit = h('span', { class: 'dim unit-of-dial' });
    private readonly ends: Record<End, HTMLElement> = { low: h('span', { class: 'dim told' }), high: h('span', { class: 'dim told' }) };
    private readonly pointer = h('span', { class: 'pointer', hidden: true });
    private value: number | null = null;
    private drawn: Scale | null = null;
    readonly element = h(
        'div',
        { class: 'dial floating' },
        this.ends.low,
        h('div', { class: 'inner' }, this.canvas, this.pointer, this.handles.high, this.handles.low),
        this.ends.high,
        this.unit,
    );
    readonly exposure = h('input', { type: 'range', min: -MOST_STOPS, max: MOST_STOPS, step: 0.25 });
    readonly told = h('output', { class: 'stops' });
    onChange: () => void = () => undefined;

    constructor(readonly scale: Scale) {
        new ResizeObserver(() => this.onChange()).observe(this.canvas);
        LYING.addEventListener('change', () => this.onChange());
        followPointer(this.canvas, (x, y) => {
            const { exposure } = scale;
            return {
                move: (nx: number, ny: number) => this.expose(exposure - this.upwards(nx - x, ny - y) / PIXELS_OF_A_STOP),
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

    /** The probe's value; null: it has none. */
    mark(value: number | null) {
        this.value = value;
        this.point();
    }

    private point() {
        const { value, scale } = this;
        this.pointer.hidden = value === null || this.drawn !== scale;
        if (value !== null) this.pointer.style.setProperty('--at', `${100 * Math.max(0, Math.min(1, placeInRange(value, scale)))}%`);
    }

    // How far a hand has gone towards the upper end of the bar.
    private upwards(dx: number, dy: number): number {
        return LYING.matches ? dx : -dy;
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
        });
        followPointer(handle, (x, y) => {
            const { low, high } = this.scale;
            const length = (LYING.matches ? this.canvas.clientWidth : this.canvas.clientHeight) || 1;
            handle.focus();
            let shift = 0; // places are told from the handle, which goes along
            return {
                move: (nx: number, ny: number) => {
                    shift += this.upwards(nx - x, ny - y);
                    handle.style.translate = LYING.matches ? `${shift}px 0` : `0 ${-shift}px`;
                    this.moveEnd(which, shift / length, low, high);
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

    /** From its lower end to the upper one, with values between; of differences there is nothing to turn. */
    draw(scale: Scale = this.scale) {
        const [width, height, context] = fitted(this.canvas);
        const table = colourTable(scale.map);
        const isLying = LYING.matches;
        const length = isLying ? width : height;
        this.drawn = scale;
        for (let i = 0; i < length; i++) {
            const colour = table[Math.round((i / (length - 1)) * (table.length - 1))];
            context.fillStyle = `rgb(${colour & 255} ${(colour >> 8) & 255} ${(colour >> 16) & 255})`;
            if (isLying) context.fillRect(i, height - BAR, 1.5, BAR);
            else context.fillRect(0, height - 1 - i, BAR, 1.5);
        }
        context.fillStyle = styleColour('--text');
        context.font = '11px system-ui, sans-serif';
        context.textBaseline = 'middle';
        const steps = 4;
        for (let i = 0; i <= steps && !isLying; i++) {
            const share = i / steps;
            const value =
                scale.logarithmic && scale.low > 0
                    ? scale.low * (scale.high / scale.low) ** share
                    : scale.low + share * (scale.high - scale.low);
            const y = height - placeInRange(value, scale) * height;
            context.fillText(number(value, 3), BAR + 9, Math.max(7, Math.min(height - 7, y)), width - BAR - 9);
        }
        this.point();
        for (const which of ['low', 'high'] as const) {
            const handle = this.handles[which];
            handle.hidden = scale !== this.scale;
            handle.setAttribute('aria-orientation', isLying ? 'horizontal' : 'vertical');
            handle.setAttribute('aria-valuenow', String(scale[which]));
            handle.setAttribute('aria-valuetext', number(scale[which], 4));
            this.ends[which].textContent = number(scale[which], 3);
        }
        this.exposure.disabled = scale !== this.scale;
        if (document.activeElement !== this.exposure) this.exposure.value = String(scale.exposure);
        this.told.textContent = `${scale.exposure > 0 ? '+' : ''}${number(scale.exposure, 3)} ${t('EV')}`;
    }
}
