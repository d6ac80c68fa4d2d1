// SPDX-License-Identifier: MIT
// Handles: places of a body or a lamp by which its size is taken: corners and edges of rectangles, sides of boxes, radii,
// heights, angles of cones, corners of outlines; and the observer's target and screen.
import type { Change } from './core';
import type { Geometry, Shape } from './geometry';
import { add, along, basis, cross, dot, turnedAxes, unit, type Place } from './space_math';
import type { View } from './stage';
import { number, t } from './words';

export interface Handle {
    at: Place;
    /** What it changes, in words. */
    name: string;
    /** The line that it keeps to, or the axis of the plane; neither: the plane of the view. */
    line?: Place;
    axis?: Place;
    /** What is changed as it comes to a place, and what is told beside the hand. */
    moved(to: number[]): { changes: Change[]; told: string };
}

const LEAST = 1; // mm, of a size
const STEEPEST = 75; // degrees to which cones are drawn
const WIDEST = 89; // degrees to which a hand opens one

/** A size in whole mm, small ones in three digits. */
function size(value: number): number {
    return value >= 20 ? Math.round(value) : Number(Math.max(value, LEAST).toPrecision(3));
}

const written = (numbers: number[]) => `[${numbers.map((n) => Number(n.toFixed(2))).join(', ')}]`;
const between = (from: number[], to: number[]) => to.map((c, axis) => c - from[axis]);
const told = (sizes: number[]) => `${sizes.map((each) => number(each, 5)).join(' × ')} ${t('mm')}`;

// The side, edge or corner that is taken goes with the hand, the opposite one stays; around an aim both go.
function resized(shape: Shape, axes: Place[], signs: number[]): Handle['moved'] {
    const { base, center, size: before = [], isAimed = false } = shape;
    return (to) => {
        const off = between(center, to);
        const sizes = before.map((each, i) => {
            const out = signs[i] * dot(off, axes[i]);
            return signs[i] ? size(isAimed ? 2 * out : out + each / 2) : each;
        });
        const changes: Change[] = [{ set: `${base}.size=${written(sizes)}` }];
        const middle = signs.reduce<Place>((place, sign, i) => add(place, axes[i], (sign * (sizes[i] - before[i])) / 2), center as Place);
        if (!isAimed) changes.push({ set: `${base}.center=${written(middle)}` });
        return { changes, told: told(sizes) };
    };
}

function ofRectangle(shape: Shape): Handle[] {
    const [u, v, n] = basis(shape.axis ?? [0, 0, 1], shape.up);
    const [w, h] = shape.size!;
    const places = [-1, 0, 1].flatMap((a) => [-1, 0, 1].flatMap((b) => (a || b ? [[a, b]] : [])));
    return places.map(([a, b]) => ({
        at: along(shape.center, u, (a * w) / 2, v, (b * h) / 2),
        name: t('size'),
        ...(a && b ? { axis: n } : { line: a ? u : v }),
        moved: resized(shape, [u, v], [a, b]),
    }));
}

function ofBox(shape: Shape): Handle[] {
    const axes = turnedAxes(shape.turn);
    return [0, 1, 2].flatMap((axis) =>
        [-1, 1].map((sign) => ({
            at: add(shape.center, axes[axis], (sign * shape.size![axis]) / 2),
            name: t('size'),
            line: axes[axis],
            moved: resized(shape, axes, [0, 1, 2].map((each) => (each === axis ? sign : 0))),
        })),
    );
}

// The radius is taken where it is seen from the side; that of a disk or a cylinder across its axis.
function ofRadius(shape: Shape, view: View): Handle {
    const { base, center, radius = 0, axis } = shape;
    const n = shape.type === 'sphere' ? null : unit(axis ?? [0, 0, 1]);
    const out = n ? acrossOf(n, view) : view.right;
    return {
        at: add(center, out, radius),
        name: t('radius'),
        ...(n ? { axis: n } : {}),
        moved: (to) => {
            const found = size(Math.hypot(...between(center, to)));
            return { changes: [{ set: `${base}.radius=${found}` }], told: `r = ${told([found])}` };
        },
    };
}

// A direction across an axis that is to the right in the view, as far as there is one.
function acrossOf(axis: Place, view: View): Place {
    const across = cross(axis, view.back);
    return Math.hypot(...across) > 0.05 ? unit(across) : unit(add(view.right, axis, -dot(view.right, axis)));
}

function ofHeight({ base, center, height = 0, axis }: Shape): Handle {
    const n = unit(axis ?? [0, 0, 1]);
    return {
        at: add(center, n, height / 2),
        name: t('height'),
        line: n,
        moved: (to) => {
            const found = size(2 * Math.abs(dot(between(center, to), n)));
            return { changes: [{ set: `${base}.height=${found}` }], told: told([found]) };
        },
    };
}

// Of two angles that say where the light begins to fall and where it ends one drags the other along.
function ofCone(shape: Shape, view: View, length: number): Handle[] {
    const { base, center, axis, opening = 0, inner } = shape;
    const n = unit(axis!);
    const out = acrossOf(n, view);
    const handle = (key: 'inner' | 'outer', degrees: number, side: number): Handle => ({
        at: along(center, n, length, out, side * length * Math.tan((Math.min(degrees, STEEPEST) * Math.PI) / 180)),
        name: t(key === 'inner' ? 'inner angle' : 'outer angle'),
        axis: cross(n, out),
        moved: (to) => {
            const off = between(center, to);
            const ahead = dot(off, n);
            const angle = (Math.atan2(Math.hypot(...add(off, n, -ahead)), ahead) * 180) / Math.PI;
            const found = Number(Math.max(0.5, Math.min(WIDEST, angle)).toFixed(1));
            const changes: Change[] = [{ set: `${base}.${key}=${found}` }];
            const other = key === 'inner' ? opening : inner;
            const isPast = other !== undefined && (key === 'inner' ? found > other : found < other);
            const drawnAlong = { set: `${base}.${key === 'inner' ? 'outer' : 'inner'}=${found}` };
            return { changes: isPast ? [...changes, drawnAlong] : changes, told: `${number(found, 3)}°` };
        },
    });
    return [handle('outer', opening, 1), ...(inner === undefined || inner > STEEPEST ? [] : [handle('inner', inner, -1)])];
}

function ofOutline({ base, outline = [], axis }: Shape): Handle[] {
    const isList = outline.every((corner) => corner.length === 3);
    const n = axis ?? (outline.length > 2 ? cross(between(outline[0], outline[1]), between(outline[0], outline[2])) : undefined);
    if (!isList || !n) return [];
    return outline.map((corner, i) => ({
        at: corner as Place,
        name: t('corner'),
        axis: unit(n),
        moved: (to) => {
            const corners = outline.map((each, k) => written(k === i ? to : each));
            return { changes: [{ set: `${base}.vertices=[${corners.join(', ')}]` }], told: `(${to.map((c) => number(c, 5)).join('; ')}) ${t('mm')}` };
        },
    }));
}

const COARSEST = 40; // mm by which whole sizes of a screen may go up

// Sizes of a screen whose pixels stay square: whole ones, where these are near enough to each other.
function screenOf([w, h]: number[], factor: number): number[] {
    const divisor = (a: number, b: number): number => (b ? divisor(b, a % b) : a);
    const step = Number.isInteger(w) && Number.isInteger(h) ? w / divisor(w, h) : Infinity;
    if (step > COARSEST) return [w, h].map((each) => Number((each * factor).toPrecision(9)));
    const count = Math.max(1, Math.round((w * factor) / step));
    return [count * step, (count * step * h) / w];
}

/** The handles of the observer: what it looks at, and the corners of its screen. */
export function handlesOfObserver({ frame, screen, things }: Pick<Geometry, 'frame' | 'screen' | 'things'>): Handle[] {
    const { middle, corners, axis } = frame;
    const target: Handle = {
        at: middle as Place,
        name: t('what the observer looks at'),
        moved: (to) => {
            const place = to.map((c) => Math.round(c));
            return { changes: [{ set: `observer.target=${written(place)}` }], told: `(${place.map((c) => number(c, 6)).join('; ')}) ${t('mm')}` };
        },
    };
    const half = Math.hypot(...screen) / 2;
    const ends = corners.map((corner): Handle => ({
        at: corner as Place,
        name: t('size of the screen'),
        axis: unit(axis),
        moved: (to) => {
            const sizes = screenOf(screen, Math.max(Math.hypot(...between(middle, to)) / half, 0.01));
            return { changes: ['width', 'height'].map((key, i) => ({ set: `screen.${key}=${sizes[i]}` })), told: told(sizes) };
        },
    }));
    const isAimed = things.some(({ key }) => key === 'observer.position');
    return isAimed ? [target, ...ends] : ends;
}

/** The handles of a shape, seen through a camera; `length`: of its cone, as it is drawn. */
export function handlesOf(shape: Shape, view: View, length: number): Handle[] {
    const { type, size: sizes, radius, height, outline, opening, axis } = shape;
    if (outline) return ofOutline(shape);
    if (opening && axis) return ofCone(shape, view, length);
    if (type === 'rectangle' && sizes?.length === 2) return ofRectangle(shape);
    if ((type === 'box' || type === 'room') && sizes?.length === 3) return ofBox(shape);
    if ((type === 'sphere' || type === 'disk') && radius) return [ofRadius(shape, view)];
    if (type === 'cylinder' && radius) return [ofRadius(shape, view), ...(height ? [ofHeight(shape)] : [])];
    return [];
}

/** Where a hand at a point of the canvas takes a handle. */
export function handleAt({ at, line, axis }: Handle, view: View, x: number, y: number): Place {
    const target = along(view.target, view.right, (x - view.width / 2) / view.factor, view.up, (view.height / 2 - y) / view.factor);
    const eye = add(view.target, view.back, view.distance);
    const ray = unit(between(eye, target));
    const toPlane = (normal: number[]) => add(eye, ray, dot(between(eye, at), normal) / dot(ray, normal));
    if (line) {
        // The place of the line nearest to the ray, unless the two run alike.
        const alike = dot(ray, line);
        if (1 - alike * alike < 0.02) return at;
        const off = between(at, eye);
        return add(at, line, (dot(off, line) - dot(off, ray) * alike) / (1 - alike * alike));
    }
    return axis && Math.abs(dot(ray, axis)) > 0.12 ? toPlane(axis) : toPlane(view.back);
}
