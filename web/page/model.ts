// SPDX-License-Identifier: MIT
// What the page shows: the text of the scene with its history, what the core says to it, and the picture.  A change is
// judged at once; pictures follow, the newest wins, and a coarse one comes first where a whole one takes long.
import type { Change, Message, SceneFacts } from './core';
import { Client } from './client';
import type { Picture } from './worker';

const OFTEN = 24; // milliseconds that a picture may take to follow the hand
const SLOW = 200; // milliseconds from which on a second worker makes a picture
const UNKNOWN = 8; // the stride of a scene's first picture
const STRIDES = [1, 2, 4, 8, 16];
const MOST_STEPS = 200; // of the history

export type Topic = 'text' | 'scene' | 'picture' | 'geometry' | 'failure';

/** Objects of the scene that can be grabbed, by the key that moves them. */
export interface Thing {
    kind: 'light' | 'aim' | 'direction' | 'surface' | 'observer';
    index: number;
    key: string; // "lights[0].position"
    at: number[];
    from?: number[]; // of an aim: the light
}

/** A body or outline, as the space view draws it. */
export interface Shape {
    kind: 'surface' | 'light';
    index: number;
    type: string;
    center: number[];
    radius?: number;
    size?: number[];
    height?: number;
    axis?: number[];
    up?: number[];
    outline?: number[][];
    opening?: number; // of a spot, degrees from its axis
    text?: string; // of a mesh: its mapping in the scene
}

export class Model {
    readonly client = new Client();
    text = '';
    wholeText = '';
    messages: Message[] = [];
    scene: SceneFacts | null = null;
    picture: Picture | null = null;
    irradiance = false;
    stale = false;
    things: Thing[] = [];
    shapes: Shape[] = [];
    screen: number[] = [1, 1]; // width and height in mm
    observer: { position: number[]; perspective: boolean } | null = null;
    photometric = false;
    /** The files that the text names, and whether they were given. */
    files: [string, boolean][] = [];
    private past: string[] = [];
    private future: string[] = [];
    private listeners: ((topic: Topic) => void)[] = [];
    private judging = false;
    private rendering = false;
    private wantsJudging = false;
    private wantsPicture = false;
    private coarse = 1; // the stride at which a picture follows the hand
    private lastMark = '';
    private wholeTime = 0; // milliseconds that a whole picture takes, by the last one
    private slow: Client | null = null;
    private pictureClient = this.client;
    private failing = ''; // the text with which the core failed last

    listen(listener: (topic: Topic) => void) {
        this.listeners.push(listener);
    }

    private tell(topic: Topic) {
        for (const listener of this.listeners) listener(topic);
    }

    /** Takes a new text; changes with one mark that follow one another are one step of the history. */
    setText(text: string, mark = '') {
        if (text === this.text) return;
        if (this.text && !(mark && mark === this.lastMark)) {
            this.past.push(this.text);
            if (this.past.length > MOST_STEPS) this.past.shift();
        }
        this.lastMark = mark;
        this.future = [];
        this.text = text;
        this.tell('text');
        this.judge();
    }

    /** Takes another scene, of which a coarse picture comes first, as nobody knows how long it takes. */
    begin(text: string) {
        this.coarse = UNKNOWN;
        this.setText(text);
    }

    /** Ends a step of the history, so that the next change begins one. */
    endStep() {
        this.lastMark = '';
    }

    get canUndo() {
        return this.past.length > 0;
    }

    get canRedo() {
        return this.future.length > 0;
    }

    undo() {
        const text = this.past.pop();
        if (text === undefined) return;
        this.future.push(this.text);
        this.restore(text);
    }

    redo() {
        const text = this.future.pop();
        if (text === undefined) return;
        this.past.push(this.text);
        this.restore(text);
    }

    private restore(text: string) {
        this.lastMark = '';
        this.text = text;
        this.tell('text');
        this.judge();
    }

    setIrradiance(irradiance: boolean) {
        this.irradiance = irradiance;
        this.judge();
    }

    /** Changes values by assignments and the like; false: it does not go, and messages tell why. */
    async change(changes: Change[], mark = ''): Promise<boolean> {
        const before = this.text;
        const { interruptions } = this.client;
        const { text, messages } = await this.client.urgent('edit', before, changes);
        if (this.client.interruptions !== interruptions) void this.judge(); // a picture was given up
        if (this.text !== before) return false; // somebody was faster
        if (text === null) {
            this.messages = messages;
            this.tell('scene');
            return false;
        }
        this.setText(text, mark);
        return true;
    }

    async judge() {
        this.wantsJudging = true;
        if (this.judging) return;
        this.judging = true;
        while (this.wantsJudging) {
            this.wantsJudging = false;
            await this.judgeOnce().catch(() => undefined);
        }
        this.judging = false;
    }

    private async judgeOnce() {
        const text = this.text;
        const { whole, messages, scene, files } = await this.client.urgent('judge', text, this.irradiance);
        if (text !== this.text) return;
        this.messages = messages;
        this.files = files;
        this.stale = !whole;
        if (whole) {
            this.wholeText = text;
            this.scene = scene;
            await this.measure();
            this.tell('geometry');
            this.render();
        }
        this.tell('scene');
    }

    private async render() {
        this.wantsPicture = true;
        this.slow?.stop();
        this.slow = null;
        if (this.rendering) return;
        this.rendering = true;
        while (this.wantsPicture) {
            this.wantsPicture = false;
            const stride = this.coarse;
            await this.renderOnce(stride, this.client).catch(() => undefined);
            if (this.wantsPicture || this.picture?.stride === 1) continue;
            await new Promise((resolve) => setTimeout(resolve, 120)); // the hand may still be moving
            if (!this.wantsPicture) await this.renderWhole().catch(() => undefined);
        }
        this.rendering = false;
    }

    /** A whole picture that takes long is made by a second worker, which is stopped when another one is wanted. */
    private async renderWhole() {
        if (this.wholeTime < SLOW) return this.renderOnce(1, this.client);
        const slow = await this.client.twin();
        if (this.wantsPicture) return slow.stop();
        this.slow = slow;
        await this.renderOnce(1, slow);
    }

    private async renderOnce(stride: number, client: Client) {
        const text = this.wholeText;
        const picture = await client.ask('render', text, this.irradiance, stride);
        if ('messages' in picture) {
            this.messages = picture.messages;
            this.stale = true;
            this.tell('scene');
            return;
        }
        this.failing = '';
        this.wholeTime = picture.milliseconds * stride * stride;
        this.coarse = STRIDES.find((each) => this.wholeTime / (each * each) <= OFTEN) ?? STRIDES[STRIDES.length - 1];
        this.picture = picture;
        this.pictureClient = client;
        this.tell('picture');
    }

    /** Lines of equal value of the picture that is shown. */
    isophotes(logarithmic: boolean) {
        return this.pictureClient.ask('isophotes', 8, logarithmic).catch(() => []);
    }

    /** After a failure of the core: begins anew, but not with a text that made it fail twice. */
    recover(message: string) {
        const isHopeless = this.failing === this.text;
        this.failing = this.text;
        if (!isHopeless) {
            void this.judge();
            return;
        }
        this.stale = true;
        this.messages = [{ error: true, line: 0, column: 0, length: 0, key: null, message, hint: '' }];
        this.tell('scene');
    }

    private async numbersOf(keys: string[]): Promise<(number[] | null)[]> {
        const values = await this.client.ask('values', keys);
        return values.map((value) => {
            try {
                const numbers: unknown = JSON.parse(value ?? 'null');
                if (typeof numbers === 'number') return [numbers];
                return Array.isArray(numbers) &&
                    numbers.length > 0 &&
                    !numbers.flat().some((n) => typeof n !== 'number')
                    ? numbers
                    : null;
            } catch {
                return null;
            }
        });
    }

    /** Reads off the scene where its things stand. */
    private async measure() {
        const scene = this.scene!;
        const [width, height, z, position] = await this.numbersOf([
            'screen.width',
            'screen.height',
            'observer.z',
            'observer.position',
        ]);
        const [projection, units] = await this.client.ask('values', ['observer.projection', 'units']);
        this.photometric = units === 'photometric';
        this.screen = [width?.[0] ?? 1, height?.[0] ?? 1];
        const things: Thing[] = [];
        const shapes: Shape[] = [];
        const at = position ?? [0, 0, z?.[0] ?? 0];
        this.observer = { position: at, perspective: projection === 'perspective' };
        things.push({ kind: 'observer', index: 0, key: position ? 'observer.position' : 'observer.z', at });
        for (let i = 0; i < scene.surfaces.length; i++) await this.measureSurface(i, things, shapes);
        for (let i = 0; i < scene.lights.length; i++) await this.measureLight(i, things, shapes);
        this.things = things;
        this.shapes = shapes;
    }

    private async measureSurface(index: number, things: Thing[], shapes: Shape[]) {
        const base = `surfaces[${index}]`;
        const [type] = await this.client.ask('values', [`${base}.type`]);
        const [center, radius, size, height, axis, up, position] = await this.numbersOf(
            ['center', 'radius', 'size', 'height', 'axis', 'up', 'position'].map((key) => `${base}.${key}`),
        );
        if (type === 'mesh') await this.measureMesh(index, position ?? [0, 0, 0], things, shapes);
        if (!center) return;
        things.push({ kind: 'surface', index, key: `${base}.center`, at: center });
        shapes.push({
            kind: 'surface',
            index,
            type: type ?? '',
            center,
            radius: radius?.[0],
            size: size ?? undefined,
            height: height?.[0],
            axis: axis ?? undefined,
            up: up ?? undefined,
        });
    }

    // Of a mesh the page knows the ball around it; its form the space view asks for.
    private async measureMesh(index: number, position: number[], things: Thing[], shapes: Shape[]) {
        const ball = this.scene!.surfaces[index];
        things.push({ kind: 'surface', index, key: `surfaces[${index}].position`, at: position });
        const [text] = await this.client.ask('values', [`surfaces[${index}]`]);
        const [center, radius] = [ball?.center, ball?.reach];
        if (center) shapes.push({ kind: 'surface', index, type: 'mesh', center, radius, text: text ?? '' });
    }

    private async measureLight(index: number, things: Thing[], shapes: Shape[]) {
        const light = this.scene!.lights[index];
        const base = `lights[${index}]`;
        const [position, rectangle, disk, box, sphere, cylinder, vertices] = await this.numbersOf(
            [
                'position',
                'rectangle.center',
                'disk.center',
                'box.center',
                'sphere.center',
                'cylinder.center',
                'vertices',
            ].map((key) => `${base}.${key}`),
        );
        const bodies: [string, number[] | null][] = [
            ['rectangle', rectangle],
            ['disk', disk],
            ['box', box],
            ['sphere', sphere],
            ['cylinder', cylinder],
        ];
        const body = bodies.find(([, center]) => center);
        if (position) things.push({ kind: 'light', index, key: `${base}.position`, at: position });
        else if (body) things.push({ kind: 'light', index, key: `${base}.${body[0]}.center`, at: body[1]! });
        else if (vertices && light.place)
            things.push({ kind: 'light', index, key: `${base}.vertices`, at: light.place });
        else if (light.type === 'distant' && light.direction) this.measureDistant(index, light.direction, things);
        const aimBase = body && !position ? `${base}.${body[0]}` : base;
        const [aim, opening, radius, size, height] = await this.numbersOf(
            ['aim', 'outer', 'radius', 'size', 'height'].map((key) => `${aimBase}.${key}`),
        );
        if (aim && light.place) things.push({ kind: 'aim', index, key: `${aimBase}.aim`, at: aim, from: light.place });
        const center = light.place;
        if (!center) return;
        shapes.push({
            kind: 'light',
            index,
            type: position ? light.type : (body?.[0] ?? 'polygon'),
            center,
            radius: radius?.[0],
            size: size ?? undefined,
            height: height?.[0],
            axis: light.direction ?? undefined,
            opening: opening?.[0],
            outline: vertices ? (vertices as unknown as number[][]) : undefined,
        });
    }

    // Distant light comes from infinitely far; its handle stands a screen away from the first surface.
    private measureDistant(index: number, direction: number[], things: Thing[]) {
        const target = this.scene!.surfaces[0]?.center ?? [0, 0, 0];
        const far = 1.2 * Math.max(...this.screen);
        const at = target.map((coordinate, axis) => coordinate - far * direction[axis]);
        things.push({ kind: 'direction', index, key: `lights[${index}].direction`, at, from: target });
    }

    /** Moves a thing to a place of the scene. */
    moveThing(thing: Thing, to: number[], mark: string) {
        const whole = to.map((coordinate) => Math.round(coordinate));
        const written = `[${whole.join(', ')}]`;
        if (thing.key === 'observer.z') return this.change([{ set: `observer.z=${Math.max(1, whole[2])}` }], mark);
        if (thing.kind === 'direction') {
            const along = thing.from!.map((coordinate, axis) => Number((coordinate - to[axis]).toPrecision(4)));
            return this.change([{ set: `${thing.key}=[${along.join(', ')}]` }], mark);
        }
        if (thing.key.endsWith('.vertices')) return this.moveVertices(thing, whole, mark);
        return this.change([{ set: `${thing.key}=${written}` }], mark);
    }

    private moveVertices(thing: Thing, to: number[], mark: string) {
        const shape = this.shapes.find((each) => each.kind === 'light' && each.index === thing.index);
        const by = to.map((coordinate, axis) => Math.round(coordinate - thing.at[axis]));
        const moved = (shape?.outline ?? []).map((corner) => `[${corner.map((c, axis) => c + by[axis]).join(', ')}]`);
        return this.change([{ set: `${thing.key}=[${moved.join(', ')}]` }], mark);
    }
}
