// SPDX-License-Identifier: MIT
// The space view: lamps, aims, panels, surfaces, observer and screen drawn to scale, from any side, and grabbed.
// Lines on a canvas are enough for what it shows, so it needs no library and no WebGL.
import type { Probe } from './core';
import { fitted, h, lightColour, numberMark, styleColour } from './dom';
import { nextOf } from './choosing';
import { Drag, followPointer } from './drag';
import type { Model, Shape, Thing } from './model';
import { Reliefs } from './reliefs';
import { add, along, basis, circle, cornersOf, cross, edgesOf, unit, type Place } from './space_math';
import { t } from './words';

export type Side = 'orbit' | 'plan' | 'elevation';

const BEGIN = [-0.65, 1.05]; // turn and tilt
const NEAR = 18; // pixels within which a thing is grabbed

export class SpaceView {
    readonly canvas = h('canvas', { tabindex: 0, class: 'space', role: 'application' });
    selected: Thing | null = null;
    probe: Probe | null = null;
    /** What the screen shows. */
    image: () => HTMLCanvasElement | null = () => null;
    onSelect: (thing: Thing | null) => void = () => undefined;
    onSide: (side: Side) => void = () => undefined;
    side: Side = 'orbit';
    private turn = BEGIN[0]; // about the z axis, radians
    private tilt = BEGIN[1]; // from the z axis
    private zoom = 1;
    private center: Place = [0, 0, 0];
    private reach = 1000; // mm from the centre that must be seen
    private isFitted = false;
    private isDrawn = true;
    private readonly reliefs: Reliefs;

    constructor(private readonly model: Model) {
        this.reliefs = new Reliefs(model, () => this.draw());
        new ResizeObserver(() => this.draw()).observe(this.canvas);
        model.follow(this.canvas, () => model.whole);
        followPointer(
            this.canvas,
            (x, y, event) => this.begin(x, y, event),
            (factor, x, y, dx, dy) => this.pinch(factor, x, y, dx, dy),
        );
        this.canvas.addEventListener('keydown', (event) => this.key(event));
        this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    }

    relabel() {
        this.canvas.setAttribute(
            'aria-label',
            t('Space view. Space selects the next thing, arrow keys and Page Up, Page Down move it; 1, 2, 3 change the view.'),
        );
    }

    /** Turn and tilt of the view; null: as it begins. */
    get turned(): number[] | null {
        return this.turn === BEGIN[0] && this.tilt === BEGIN[1] ? null : [this.turn, this.tilt];
    }

    set turned(value: number[]) {
        this.turn = value[0];
        this.tilt = Math.max(0.02, Math.min(Math.PI - 0.02, value[1]));
    }

    setSide(side: Side) {
        this.side = side;
        this.onSide(side);
        this.draw();
    }

    /** Takes all of the scene into view anew. */
    fit() {
        this.isFitted = false;
        this.geometryChanged();
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.isFitted = false;
        this.probe = null;
        this.selected = null;
        this.draw();
    }

    geometryChanged() {
        if (!this.model.whole) return;
        if (!this.isFitted) this.fitNow();
        this.draw();
    }

    private fitNow() {
        const places = this.model.things.map(({ at }) => at);
        const [w, h] = this.model.screen;
        places.push([-w / 2, -h / 2, 0], [w / 2, h / 2, 0]);
        for (const { center, radius, size } of this.model.shapes) {
            // Floors and walls far beyond what is seen of them need not be in sight as a whole.
            const r = Math.min(Math.max(radius ?? 0, ...(size ?? []).map((each) => each / 2)), Math.max(w, h));
            places.push(
                center.map((c) => c - r),
                center.map((c) => c + r),
            );
        }
        const low = [0, 1, 2].map((axis) => Math.min(...places.map((place) => place[axis])));
        const high = [0, 1, 2].map((axis) => Math.max(...places.map((place) => place[axis])));
        this.center = low.map((least, axis) => (least + high[axis]) / 2) as Place;
        this.reach = Math.max(Math.hypot(...high.map((most, axis) => most - low[axis])) / 2, 1);
        this.zoom = 1;
        this.isFitted = true;
    }

    // Right, up and towards the eye, as the view has them in the scene.
    private axes(): [Place, Place, Place] {
        if (this.side === 'plan')
            return [
                [1, 0, 0],
                [0, 1, 0],
                [0, 0, 1],
            ];
        if (this.side === 'elevation')
            return [
                [1, 0, 0],
                [0, 0, 1],
                [0, -1, 0],
            ];
        const [s, c] = [Math.sin(this.turn), Math.cos(this.turn)];
        const [st, ct] = [Math.sin(this.tilt), Math.cos(this.tilt)];
        const eye: Place = [s * st, -c * st, ct];
        const right: Place = [c, s, 0];
        return [right, cross(eye, right), eye];
    }

    private factor(): number {
        const { width, height } = this.canvas.getBoundingClientRect();
        return (0.46 * this.zoom * Math.min(width, height)) / this.reach;
    }

    private seen(place: number[]): [number, number] {
        const { width, height } = this.canvas.getBoundingClientRect();
        const [right, up] = this.axes();
        const factor = this.factor();
        const off = place.map((coordinate, axis) => coordinate - this.center[axis]);
        const dot = (a: number[]) => a[0] * off[0] + a[1] * off[1] + a[2] * off[2];
        return [width / 2 + factor * dot(right), height / 2 - factor * dot(up)];
    }

    draw() {
        if (!this.isDrawn) return;
        this.isDrawn = false;
        requestAnimationFrame(() => {
            this.isDrawn = true;
            this.drawNow();
        });
    }

    private path(context: CanvasRenderingContext2D, places: number[][], closed: boolean) {
        context.beginPath();
        places.forEach((place, i) => (i ? context.lineTo(...this.seen(place)) : context.moveTo(...this.seen(place))));
        if (closed) context.closePath();
        context.stroke();
    }

    private drawNow() {
        const [, , context] = fitted(this.canvas);
        if (!this.model.scene) return;
        context.lineWidth = 1;
        this.drawAxes(context);
        this.drawScreen(context);
        for (const shape of this.model.shapes) this.drawShape(context, shape);
        this.drawObserver(context);
        this.drawProbe(context);
        for (const thing of this.model.things) this.drawThing(context, thing);
    }

    private drawAxes(context: CanvasRenderingContext2D) {
        const length = 0.35 * this.reach;
        context.font = '12px system-ui, sans-serif';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        (['x', 'y', 'z'] as const).forEach((name, axis) => {
            const end = [0, 0, 0];
            end[axis] = length;
            context.strokeStyle = context.fillStyle = styleColour('--dim');
            this.path(context, [[0, 0, 0], end], false);
            const [x, y] = this.seen(end.map((coordinate) => 1.1 * coordinate));
            context.fillText(name, x, y);
        });
    }

    private drawScreen(context: CanvasRenderingContext2D) {
        const corners = cornersOf(this.model.screen);
        const image = this.image();
        if (image) this.drawPicture(context, image);
        context.strokeStyle = styleColour('--accent');
        this.path(context, corners, true);
        context.globalAlpha = 0.08;
        context.fillStyle = styleColour('--accent');
        context.fill();
        context.globalAlpha = 1;
    }

    // The picture lies in the screen; a parallel view of a rectangle is an affine map of it.
    private drawPicture(context: CanvasRenderingContext2D, image: HTMLCanvasElement) {
        const [w, h] = this.model.screen;
        const [ox, oy] = this.seen([-w / 2, h / 2, 0]);
        const [rx, ry] = this.seen([w / 2, h / 2, 0]);
        const [dx, dy] = this.seen([-w / 2, -h / 2, 0]);
        context.save();
        context.transform(
            (rx - ox) / image.width,
            (ry - oy) / image.width,
            (dx - ox) / image.height,
            (dy - oy) / image.height,
            ox,
            oy,
        );
        context.drawImage(image, 0, 0);
        context.restore();
    }

    private drawShape(context: CanvasRenderingContext2D, shape: Shape) {
        context.strokeStyle = shape.kind === 'light' ? lightColour(shape.index) : styleColour('--text');
        context.lineWidth = 1.25;
        const { center, radius = 0, size, height = 0 } = shape;
        const [u, v, n] = basis(shape.axis ?? [0, 0, 1], shape.up);
        if (shape.outline) this.path(context, shape.outline, true);
        else if (shape.text !== undefined) this.drawRelief(context, shape);
        else if (shape.type === 'sphere') this.drawSphere(context, center, radius);
        else if (shape.type === 'rectangle' && size) {
            const corner = (a: number, b: number) => along(center, u, (a * size[0]) / 2, v, (b * size[1]) / 2);
            this.path(context, [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], true);
        } else if (shape.type === 'disk') this.path(context, circle(center, u, v, radius), true);
        else if (shape.type === 'cylinder') {
            const ends = [-height / 2, height / 2].map((off) => add(center, n, off));
            ends.forEach((end) => this.path(context, circle(end, u, v, radius), true));
            for (let i = 0; i < 4; i++) {
                const angle = (i * Math.PI) / 2;
                this.path(
                    context,
                    ends.map((end) => along(end, u, radius * Math.cos(angle), v, radius * Math.sin(angle))),
                    false,
                );
            }
        } else if ((shape.type === 'box' || shape.type === 'room') && size) this.drawBox(context, center, size);
        if (shape.opening && shape.axis) this.drawCone(context, shape, u, v, n);
    }

    // The outline of a sphere, its equator and two meridians.
    private drawSphere(context: CanvasRenderingContext2D, center: number[], radius: number) {
        const [right, up] = this.axes();
        this.path(context, circle(center, right, up, radius), true);
        context.globalAlpha = 0.07;
        context.fillStyle = context.strokeStyle as string;
        context.fill();
        context.globalAlpha = 0.35;
        this.path(context, circle(center, [1, 0, 0], [0, 1, 0], radius), true);
        this.path(context, circle(center, [1, 0, 0], [0, 0, 1], radius), true);
        this.path(context, circle(center, [0, 1, 0], [0, 0, 1], radius), true);
        context.globalAlpha = 1;
    }

    // A surface as it looks from this side; the ball around it until the core has told.
    private drawRelief(context: CanvasRenderingContext2D, { index, text, center, radius = 0 }: Shape) {
        const [right, up, eye] = this.axes();
        const of = [text, center, radius].join();
        const { image, lines } = this.reliefs.from(index, of, { right, up, eye }, styleColour('--text'));
        if (!image) {
            this.drawSphere(context, center, radius);
            return;
        }
        const side = this.reliefs.side(radius) * this.factor();
        const [x, y] = this.seen(center);
        context.drawImage(image, x - side / 2, y - side / 2, side, side);
        if (lines) this.drawSilhouette(context, lines, right, up);
    }

    // Lines in mm along the vectors of the view.
    private drawSilhouette(context: CanvasRenderingContext2D, lines: number[][], right: Place, up: Place) {
        const { width, height } = this.canvas.getBoundingClientRect();
        const factor = this.factor();
        const middle = (axis: Place) => axis.reduce((sum, each, k) => sum + each * this.center[k], 0);
        const [left, low] = [width / 2 - factor * middle(right), height / 2 + factor * middle(up)];
        context.beginPath();
        for (const line of lines) {
            for (let i = 0; i < line.length; i += 2) {
                const at: [number, number] = [left + factor * line[i], low - factor * line[i + 1]];
                if (i) context.lineTo(...at);
                else context.moveTo(...at);
            }
            context.closePath();
        }
        context.stroke();
    }

    private drawBox(context: CanvasRenderingContext2D, center: number[], size: number[]) {
        for (const edge of edgesOf(center, size)) this.path(context, edge, false);
    }

    private drawCone(context: CanvasRenderingContext2D, { center, opening }: Shape, u: Place, v: Place, n: Place) {
        const length = 0.4 * this.reach;
        const radius = length * Math.tan((Math.min(opening!, 80) * Math.PI) / 180);
        const rim = circle(add(center, n, length), u, v, radius);
        context.globalAlpha = 0.6;
        this.path(context, rim, true);
        for (let i = 0; i < rim.length; i += rim.length / 4) this.path(context, [center, rim[i]], false);
        context.globalAlpha = 1;
    }

    private drawObserver(context: CanvasRenderingContext2D) {
        const { observer, screen } = this.model;
        if (!observer) return;
        context.strokeStyle = styleColour('--accent');
        context.globalAlpha = 0.35;
        for (const corner of cornersOf(screen)) {
            const from = observer.perspective ? observer.position : [corner[0], corner[1], observer.position[2]];
            this.path(context, [from, corner], false);
        }
        context.globalAlpha = 1;
    }

    // The vectors of the formula at the probe: the normal N, V to the observer, L to each lamp and H between the two.
    private drawProbe(context: CanvasRenderingContext2D) {
        const { probe } = this;
        const { observer, scene } = this.model;
        if (!probe || probe.surface === null || !observer || !scene) return;
        const place = probe.position;
        const towards = (to: number[]) => unit(to.map((c, axis) => c - place[axis]));
        const view = observer.perspective ? towards(observer.position) : [0, 0, 1];
        const arrow = (name: string, direction: number[], colour: string, share: number) => {
            const end = add(place, direction, share * this.reach);
            context.strokeStyle = context.fillStyle = colour;
            context.lineWidth = 2;
            this.path(context, [place, end], false);
            context.fillText(name, ...this.seen(add(place, direction, (share + 0.04) * this.reach)));
        };
        context.font = 'italic bold 13px system-ui, sans-serif';
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        for (const [i, light] of scene.lights.entries()) {
            if (!light.enabled || !(light.place || light.direction)) continue;
            const to = light.type === 'distant' ? light.direction!.map((c) => -c) : light.place && towards(light.place);
            if (!to || to[0] * probe.normal[0] + to[1] * probe.normal[1] + to[2] * probe.normal[2] <= 0) continue;
            arrow('L', to, lightColour(i), 0.24);
            if (scene.lights.length <= 3)
                arrow('H', unit(to.map((c, axis) => c + view[axis])), styleColour('--dim'), 0.2);
        }
        arrow('N', probe.normal, styleColour('--text'), 0.28);
        arrow('V', view, styleColour('--accent'), 0.2);
        context.lineWidth = 1;
    }

    private drawThing(context: CanvasRenderingContext2D, thing: Thing) {
        const [x, y] = this.seen(thing.at);
        const chosen = this.selected?.key === thing.key;
        if (thing.from) {
            context.strokeStyle = lightColour(thing.index);
            context.setLineDash([4, 4]);
            this.path(context, [thing.from, thing.at], false);
            context.setLineDash([]);
        }
        if (thing.kind === 'light' || thing.kind === 'direction') {
            numberMark(context, x, y, thing.index, chosen);
            return;
        }
        context.beginPath();
        if (thing.kind === 'observer') context.rect(x - 6, y - 6, 12, 12);
        else if (thing.kind === 'aim') {
            context.moveTo(x - 7, y);
            context.lineTo(x + 7, y);
            context.moveTo(x, y - 7);
            context.lineTo(x, y + 7);
        } else context.arc(x, y, 4, 0, 2 * Math.PI);
        context.lineWidth = chosen ? 3 : 1.5;
        context.strokeStyle =
            thing.kind === 'aim' ? lightColour(thing.index) : styleColour(chosen ? '--accent' : '--text');
        context.stroke();
        context.lineWidth = 1;
    }

    private thingAt(x: number, y: number): Thing | null {
        let nearest: Thing | null = null;
        let least = NEAR;
        // Lamps and aims before the places that they aim at.
        const order = ['light', 'direction', 'aim', 'observer', 'surface'];
        for (const thing of [...this.model.things].sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind))) {
            const [tx, ty] = this.seen(thing.at);
            const distance = Math.hypot(tx - x, ty - y);
            if (distance < least - 2) {
                least = distance;
                nearest = thing;
            }
        }
        return nearest;
    }

    private begin(x: number, y: number, event: PointerEvent) {
        const thing = event.shiftKey ? null : this.thingAt(x, y);
        if (!thing) return this.beginOrbit(x, y);
        this.select(thing);
        const drag = new Drag(this.model, thing);
        const [right, up] = this.axes();
        const factor = this.factor();
        // What is grabbed moves in the plane of the view.
        const move = (nx: number, ny: number) =>
            void drag.to(thing.at.map((c, axis) => c + ((nx - x) * right[axis] - (ny - y) * up[axis]) / factor));
        return { move, end: () => drag.end() };
    }

    private beginOrbit(x: number, y: number) {
        const { turn, tilt, center } = this;
        const [right, up] = this.axes();
        const factor = this.factor();
        const move = (nx: number, ny: number) => {
            if (this.side === 'orbit') {
                this.turn = turn - (nx - x) * 0.008;
                this.tilt = Math.max(0.02, Math.min(Math.PI - 0.02, tilt - (ny - y) * 0.008));
            } else {
                this.center = center.map(
                    (c, axis) => c - ((nx - x) * right[axis] - (ny - y) * up[axis]) / factor,
                ) as Place;
            }
            this.draw();
        };
        return { move, end: (moved: boolean) => void (moved || this.select(null)) };
    }

    select(thing: Thing | null) {
        this.selected = thing;
        this.onSelect(thing);
        this.draw();
    }

    private wheel(event: WheelEvent) {
        event.preventDefault();
        this.zoomBy(Math.exp(-event.deltaY * 0.001));
    }

    // Two fingers zoom around the point between them, and move it.
    private pinch(factor: number, x: number, y: number, dx: number, dy: number) {
        const { width, height } = this.canvas.getBoundingClientRect();
        const [right, up] = this.axes();
        const before = this.factor();
        this.zoomBy(factor);
        const after = this.factor();
        // What was under the point comes to where the point is now.
        const [px, py] = [x - width / 2, y - height / 2];
        const along = px / before - (px + dx) / after;
        const upwards = -py / before + (py + dy) / after;
        this.center = this.center.map((c, axis) => c + along * right[axis] + upwards * up[axis]) as Place;
        this.draw();
    }

    zoomBy(factor: number) {
        if (!factor) return this.fit();
        this.zoom = Math.max(0.2, Math.min(40, this.zoom * factor));
        this.draw();
    }

    private key(event: KeyboardEvent) {
        const sides: Record<string, Side> = { 1: 'orbit', 2: 'plan', 3: 'elevation' };
        const steps: Record<string, number[]> = {
            ArrowLeft: [-1, 0, 0],
            ArrowRight: [1, 0, 0],
            ArrowUp: [0, 1, 0],
            ArrowDown: [0, -1, 0],
            PageUp: [0, 0, 1],
            PageDown: [0, 0, -1],
        };
        if (sides[event.key]) this.setSide(sides[event.key]);
        else if (event.key === '+' || event.key === '=') this.zoomBy(1.25);
        else if (event.key === '-') this.zoomBy(0.8);
        else if (event.key === '0') this.fit();
        else if (event.key === ' ') this.selectNext(event.shiftKey ? -1 : 1);
        else if (event.key === 'Escape') this.select(null);
        else if (steps[event.key] && this.selected) this.nudge(steps[event.key], event.shiftKey ? 100 : 10);
        else return;
        event.preventDefault();
    }

    private selectNext(step: number) {
        const { things } = this.model;
        const order = ['light', 'direction', 'aim', 'surface', 'observer'];
        const sorted = [...things].sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind));
        if (sorted.length) this.select(nextOf(sorted, this.selected, step));
    }

    private async nudge(step: number[], size: number) {
        const thing = this.model.things.find(
            ({ key, kind }) => key === this.selected?.key && kind === this.selected.kind,
        );
        if (!thing) return;
        await this.model.moveThing(
            thing,
            thing.at.map((c, axis) => c + step[axis] * size),
            `keys ${thing.key}`,
        );
    }
}
