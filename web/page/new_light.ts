// SPDX-License-Identifier: MIT
// A light that joins a scene, made as the desktop app makes it: it takes the law of a chosen one (how it becomes weaker, its
// pattern), stands on the other side of the first surface, where no other light stands, is aimed at it, and gives it about
// as much light.  It is put together in copies of the text, which the core is asked about.
import type { Change, Core } from './core';
import { bodyOf, Values } from './geometry';

const OF_LAW = ['attenuation', 'k', 'coefficients', 'pattern', 'exponent'];
const STRENGTHS = ['intensity', 'radiance', 'power', 'irradiance'];
const EXAMPLE_CENTER = [0, 0, 1000]; // mm: what examples shine at
const NEAR = 1; // mm within which two lights stand on each other
const PLACES = 8; // around the surface
const LOOK = 48; // pixels across of the pictures that tell how strong lights are

/** The other side of the surface than the chosen light's; above it, beside it. */
function opposite(center: number[], chosen: number[]): number[] {
    const [x, y, height] = chosen.map((c, i) => c - center[i]);
    const place = chosen.slice();
    if (Math.hypot(x, y) < 0.1 * Math.abs(height)) place[0] = center[0] - Math.round(Math.abs(height) / 20) * 10;
    else if (Math.abs(x) >= Math.abs(y)) place[0] = center[0] - x;
    else place[1] = center[1] - y;
    return place;
}

/** The place, or one some eighths of a turn further around the surface where nothing stands yet. */
function free(place: number[], center: number[], taken: number[][]): number[] {
    const isTaken = (at: number[]) => taken.some((other) => Math.hypot(...other.map((c, i) => c - at[i])) < NEAR);
    const [x, y] = [place[0] - center[0], place[1] - center[1]];
    for (let i = 0; i < PLACES; i++) {
        const turn = (2 * Math.PI * i) / PLACES;
        const turned = [
            Math.round(center[0] + x * Math.cos(turn) - y * Math.sin(turn)),
            Math.round(center[1] + x * Math.sin(turn) + y * Math.cos(turn)),
            place[2],
        ];
        const at = i === 0 ? place : turned;
        if (!isTaken(at)) return at;
    }
    return place;
}

class Trial {
    readonly changes: Change[];

    constructor(
        private readonly core: Core,
        private text: string,
        readonly light: string,
        insert: Change,
    ) {
        this.changes = [];
        this.take(insert);
    }

    /** Makes changes and opens what they make; false: it does not go. */
    take(...changes: Change[]): boolean {
        const text = this.core.edit(this.text, changes);
        if (text === null || !this.core.open(text)) {
            this.core.open(this.text);
            return false;
        }
        this.text = text;
        this.changes.push(...changes);
        return true;
    }

    /** Sets a key of the new light. */
    set(key: string, value: string) {
        this.take({ set: `${this.light}.${key}=${value}` });
    }

    has(key: string): boolean {
        return this.core.isWritten(`${this.light}.${key}`);
    }

    /** The greatest direct irradiance that one of the lights alone gives in view. */
    irradianceBy(alone: number, count: number): number {
        const others = Array.from({ length: count }, (_, i) => i);
        const text = this.core.edit(
            this.text,
            others.map((i) => ({ set: `lights[${i}].enabled=${i === alone}` })),
        );
        this.core.quantity(true);
        this.core.direct(true);
        const { columns, rows } = this.core.scene()!;
        const stride = Math.max(Math.floor(Math.max(columns, rows) / LOOK), 1);
        const isDrawn = text !== null && this.core.open(text) && this.core.render(stride);
        const greatest = isDrawn ? this.core.picture().maximum : null;
        this.core.open(this.text);
        return greatest?.exists ? greatest.value : 0;
    }
}

function takeLaw(trial: Trial, core: Core, chosen: string) {
    const types = [chosen, trial.light].map((light) => core.get(`${light}.type`));
    const known = core.parameters().keys;
    const bothHave = (key: string) =>
        types.every((type) => known.some(({ path, variant }) => path === `lights[].${key}` && variant === type));
    for (const key of OF_LAW) {
        // An exponent is of a pattern, or, of spots, of the cone.
        if (!bothHave(key) || (key === 'exponent' && !bothHave('pattern'))) continue;
        const value = core.get(`${chosen}.${key}`);
        if (core.isWritten(`${chosen}.${key}`) && value !== null) trial.set(key, value);
        else if (trial.has(key)) trial.take({ remove: `${trial.light}.${key}` });
    }
}

function stand(trial: Trial, core: Core, index: number, chosen: number) {
    const values = new Values((key) => core.get(key));
    const at = (i: number) => bodyOf(`lights[${i}]`, values).at ?? null;
    const center = values.numbers('surfaces[0].center');
    const body = bodyOf(trial.light, values);
    const old = chosen < index ? at(chosen) : null;
    if (!center) return;
    const taken = Array.from({ length: index }, (_, i) => at(i)).filter((place) => place !== null);
    if (body.key && body.at) {
        const moved = body.at.map((c, i) => c + center[i] - EXAMPLE_CENTER[i]);
        const place = free(old ? opposite(center, old) : moved, center, taken);
        trial.take({ set: `${body.key}=[${place.join(', ')}]` });
    }
    for (const part of ['', 'rectangle.', 'disk.']) if (trial.has(`${part}aim`)) trial.set(`${part}aim`, `[${center}]`);
    const pattern = core.get(`${trial.light}.pattern`);
    if (trial.has('pattern') && pattern !== 'isotropic' && !trial.has('axis') && !trial.has('aim'))
        trial.set('aim', `[${center}]`);
}

function becomeAsStrong(trial: Trial, core: Core, index: number, chosen: number) {
    const [wanted, given] = [chosen, index].map((light) => trial.irradianceBy(light, index + 1));
    if (!(wanted > 0 && given > 0)) return;
    for (const key of STRENGTHS) {
        const strength = (Number(core.get(`${trial.light}.${key}`)) * wanted) / given;
        if (trial.has(key) && strength > 0 && isFinite(strength))
            trial.set(key, String(Number(strength.toPrecision(2))));
    }
}

/** The changes by which a light joins a text, made from the example of its kind; the core is left with another scene. */
export function newLight(core: Core, text: string, example: string, chosen: number): Change[] {
    if (!core.open(text)) return [];
    const index = core.scene()?.lights.length ?? 0;
    const trial = new Trial(core, text, `lights[${index}]`, { list: 'lights', index, insert: example });
    if (trial.changes.length === 0) return [{ list: 'lights', index, insert: example }];
    if (chosen < index) takeLaw(trial, core, `lights[${chosen}]`);
    stand(trial, core, index, chosen);
    if (chosen < index) becomeAsStrong(trial, core, index, chosen);
    return trial.changes;
}
