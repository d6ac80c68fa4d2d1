// SPDX-License-Identifier: MIT
// Where the things of a scene stand, read off it by its keys: what the views draw, and what of it can be grabbed.
import type { SceneFacts } from './core';
import { ground, sunAlone, sunThing, type Sun } from './sun/sun';

/** Objects of the scene that can be grabbed, by the key that moves them. */
export interface Thing {
    kind: 'light' | 'aim' | 'direction' | 'surface' | 'observer';
    index: number;
    key: string; // "lights[0].position"
    at: number[];
    from?: number[]; // of an aim: the light
    sun?: Sun; // of a direction along which the sun shines
    seen?: number[] | null; // of lights and aims: x and y on the screen, height above it; null: seen nowhere
}

/** A body or outline, as the space view draws it. */
export interface Shape {
    kind: 'surface' | 'light';
    index: number;
    base: string; // of the keys of its place and size: "surfaces[0]", "lights[0].disk"
    type: string;
    center: number[];
    radius?: number;
    size?: number[];
    height?: number;
    axis?: number[];
    up?: number[];
    outline?: number[][];
    turn?: number[]; // of a box, degrees about x, then y, then z
    opening?: number; // of a spot, degrees from its axis
    inner?: number; // of a spot, degrees within which it is as bright as on its axis
    isAimed?: boolean; // at a place, so that its axis changes as it is moved
}

/** Where the screen stands, which an observer with a position carries along. */
export interface ScreenFrame {
    middle: number[];
    corners: number[][];
    axis: number[]; // towards the observer
}

export interface Geometry {
    things: Thing[];
    shapes: Shape[];
    screen: number[]; // width and height in mm
    observer: { position: number[]; perspective: boolean };
    /** The frame of the screen in the scene. */
    frame: ScreenFrame;
    /** The axis that is up in space. */
    up: 'y' | 'z';
    photometric: boolean;
    /** Whether surfaces light each other. */
    reflects: boolean;
}

const BODIES = ['rectangle', 'disk', 'box', 'sphere', 'cylinder'];

// Surfaces whose outlines the page knows by their keys; of all others it knows the ball around them.
const AT_ONCE = ['sphere', 'rectangle', 'disk', 'cylinder', 'room'];

/** Values of keys as the scene has them. */
export class Values {
    constructor(readonly text: (key: string) => string | null) {}

    /** The numbers of a value, or lists of them; null: it is something else. */
    numbers(key: string): number[] | null {
        try {
            const numbers: unknown = JSON.parse(this.text(key) ?? 'null');
            if (typeof numbers === 'number') return [numbers];
            const isList = Array.isArray(numbers) && numbers.length > 0;
            return isList && !numbers.flat().some((n) => typeof n !== 'number') ? (numbers as number[]) : null;
        } catch {
            return null;
        }
    }

    sizes(base: string): Pick<Shape, 'radius' | 'size' | 'height' | 'axis' | 'up'> {
        const numbers = (key: string) => this.numbers(`${base}.${key}`) ?? undefined;
        return {
            radius: numbers('radius')?.[0],
            size: numbers('size'),
            height: numbers('height')?.[0],
            axis: numbers('axis'),
            up: numbers('up'),
        };
    }
}

/** Where a light's place and size are written. */
interface Body {
    base: string; // of the group of keys: "lights[0]", "lights[0].disk"
    key?: string; // of its place
    at?: number[];
    type?: string; // as it is drawn, where that is not the light's own
    outline?: number[][];
}

export function bodyOf(base: string, values: Values): Body {
    const position = values.numbers(`${base}.position`);
    const outline = (values.numbers(`${base}.vertices`) as unknown as number[][] | null) ?? undefined;
    if (position) return { base, key: `${base}.position`, at: position, outline };
    for (const type of BODIES) {
        const center = values.numbers(`${base}.${type}.center`);
        const group = `${base}.${type}`;
        if (center) return { base: group, key: `${group}.center`, at: center, type, outline };
    }
    return { base, type: 'polygon', outline };
}

class Measuring {
    readonly things: Thing[] = [];
    readonly shapes: Shape[] = [];
    readonly screen: number[];

    constructor(
        private readonly scene: SceneFacts,
        private readonly values: Values,
        private readonly toSun: (text: string) => number[] | null,
    ) {
        this.screen = ['width', 'height'].map((key) => values.numbers(`screen.${key}`)?.[0] ?? 1);
    }

    observer(): Geometry['observer'] {
        const { values } = this;
        const position = values.numbers('observer.position');
        const at = position ?? [0, 0, values.numbers('observer.z')?.[0] ?? 0];
        this.things.push({ kind: 'observer', index: 0, key: position ? 'observer.position' : 'observer.z', at });
        return { position: at, perspective: values.text('observer.projection') === 'perspective' };
    }

    frame(unproject: (x: number, y: number, height: number) => number[] | null): ScreenFrame {
        const [w, h] = this.screen.map((size) => size / 2);
        const at = (x: number, y: number, height = 0) => unproject(x, y, height) ?? [x, y, height];
        const middle = at(0, 0);
        const corners = [at(-w, -h), at(w, -h), at(w, h), at(-w, h)];
        return { middle, corners, axis: at(0, 0, 1).map((c, i) => c - middle[i]) };
    }

    // A room tells it; else the screen of most scenes lies on a table, and an observer may say otherwise.
    up(): 'y' | 'z' {
        const rooms = this.scene.surfaces.map((_, i) => `surfaces[${i}]`);
        const room = rooms.find((base) => this.values.text(`${base}.type`) === 'room');
        return room && this.values.text(`${room}.up`) !== 'z' ? 'y' : 'z';
    }

    surface(index: number) {
        const base = `surfaces[${index}]`;
        const type = this.values.text(`${base}.type`) ?? '';
        const center = this.values.numbers(`${base}.center`);
        if (!AT_ONCE.includes(type)) this.seen(index, type);
        else if (center) this.known(index, type, center);
    }

    private known(index: number, type: string, center: number[]) {
        const base = `surfaces[${index}]`;
        this.things.push({ kind: 'surface', index, key: `${base}.center`, at: center });
        this.shapes.push({ kind: 'surface', index, base, type, center, ...this.values.sizes(base) });
    }

    // The page knows the ball around it.
    private seen(index: number, type: string) {
        const base = `surfaces[${index}]`;
        const ball = this.scene.surfaces[index];
        const center = this.values.numbers(`${base}.center`);
        const at = center ?? this.values.numbers(`${base}.position`) ?? [0, 0, 0];
        this.things.push({ kind: 'surface', index, key: `${base}.${center ? 'center' : 'position'}`, at });
        if (!ball) return;
        const box = type === 'box' ? { size: this.values.sizes(base).size, turn: this.values.numbers(`${base}.rotate`) ?? undefined } : {};
        this.shapes.push({ kind: 'surface', index, base, type, center: ball.center, radius: ball.reach, ...box });
    }

    light(index: number) {
        const light = this.scene.lights[index];
        const { base, key, at, type, outline } = bodyOf(`lights[${index}]`, this.values);
        if (key && at) this.things.push({ kind: 'light', index, key, at });
        else if (outline && light.place)
            this.things.push({ kind: 'light', index, key: `${base}.vertices`, at: light.place });
        else if (light.type === 'distant' && light.direction) this.distant(index, light.direction);
        else if (light.type === 'sun' || light.type === 'sky') this.sun(index, light.type === 'sun' ? base : `${base}.sun`);
        if (!light.place) return;
        const aim = this.values.numbers(`${base}.aim`);
        if (aim) this.things.push({ kind: 'aim', index, key: `${base}.aim`, at: aim, from: light.place });
        const sizes = this.values.sizes(base);
        this.shapes.push({
            kind: 'light',
            index,
            base,
            type: type ?? light.type,
            center: light.place,
            ...sizes,
            axis: light.direction ?? sizes.axis,
            opening: this.values.numbers(`${base}.outer`)?.[0],
            inner: this.values.numbers(`${base}.inner`)?.[0],
            isAimed: !!aim,
            outline,
        });
    }

    // Distant light comes from infinitely far; its handle stands a screen away from the first surface.
    private get target() {
        return this.scene.surfaces[0]?.center ?? [0, 0, 0];
    }

    private get far() {
        return 1.2 * Math.max(...this.screen);
    }

    private distant(index: number, direction: number[]) {
        const at = this.target.map((coordinate, axis) => coordinate - this.far * direction[axis]);
        this.things.push({ kind: 'direction', index, key: `lights[${index}].direction`, at, from: this.target });
    }

    // A sky may have no sun; it has one by altitude and azimuth, or by date and place.
    private sun(index: number, base: string) {
        const { values } = this;
        const ways = ground(values.numbers(`lights[${index}].up`), values.numbers(`lights[${index}].north`));
        const given = ['altitude', 'azimuth', 'date', 'latitude', 'longitude'].flatMap((key): [string, string][] => {
            const value = values.text(`${base}.${key}`);
            return value === null ? [] : [[key, value]];
        });
        const towards = given.length ? this.toSun(sunAlone([...given, ['up', `[${ways.up}]`], ['north', `[${ways.north}]`]])) : null;
        if (!towards) return;
        const date = values.text(`${base}.date`);
        const [latitude, longitude] = ['latitude', 'longitude'].map((key) => values.numbers(`${base}.${key}`)?.[0]);
        const dated = date === null ? {} : { date: JSON.parse(date) as string, latitude, longitude };
        const sun: Sun = { base, ...ways, towards: towards as Sun['towards'], ...dated };
        this.things.push(sunThing(index, sun, this.target, this.far));
    }
}

/**
 * Reads off a scene, whose keys have the values in YAML that `get` tells; `project` tells where places are seen, `unproject`
 * where a point of the screen is at a height above it, `toSun` the way to the sun of a scene that has nothing else.
 */
export function geometryOf(
    scene: SceneFacts,
    get: (key: string) => string | null,
    project: (place: number[]) => number[] | null,
    unproject: (x: number, y: number, height: number) => number[] | null,
    toSun: (text: string) => number[] | null,
): Geometry {
    const values = new Values(get);
    const measuring = new Measuring(scene, values, toSun);
    const observer = measuring.observer();
    scene.surfaces.forEach((_, i) => measuring.surface(i));
    scene.lights.forEach((_, i) => measuring.light(i));
    for (const thing of measuring.things)
        if (thing.kind === 'light' || thing.kind === 'aim') thing.seen = project(thing.at);
    return {
        things: measuring.things,
        shapes: measuring.shapes,
        screen: measuring.screen,
        observer,
        frame: measuring.frame(unproject),
        up: measuring.up(),
        photometric: values.text('units') === 'photometric',
        reflects: (values.text('reflections') ?? 'none') !== 'none',
    };
}
