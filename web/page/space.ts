// SPDX-License-Identifier: MIT
// The space view: bodies in their light, which the core computes as a camera sees them from any side; lamps, panels, cones,
// aims, observer and screen over them, hidden where bodies stand before them; and all of it grabbed.
import type { Probe } from './core';
import { faded, fitted, h, lightColour, numberMark, sizeOf, styleColour } from './dom';
import { nextOf } from './choosing';
import { Drag, followPointer, movesOf, type Action } from './drag';
import type { Model, Shape, Thing } from './model';
import { Drawing } from './drawing';
import { drawMeasured, NOTHING_MEASURED, type InSpace } from './grids/in_space';
import { handleAt, handlesOf, handlesOfObserver, type Handle } from './handles';
import type { Several } from './several';
import { cameraOf, observerView, seenBy, Stage, type View } from './stage';
import { add, along, basis, circle, cross, edgesOf, unit, type Place } from './space_math';
import type { Scale } from './colours';
import { drawDome } from './sun/dome';
import { sunMoves, sunsWith } from './sun/sun';
import { drawVectors, vectorsAt } from './vectors';
import { number, t } from './words';

const SIDES = ['orbit', 'plan', 'elevation'] as const;
export type Side = (typeof SIDES)[number];

const TURNED = -0.65; // radians that the view begins with
const TILTS = [0.92, 0.7, 0.5, 0.35]; // from what is up: the first that goes
const NEAR = 20; // pixels within which a thing is grabbed
const FAR = 3.2; // of the camera, in reaches of the scene
const FILLED = 12; // lights of which panels and cones are filled
const GLOWING = 60; // lights that have a glow
const NAMED = 8; // lights that are called by their names
const ROOM = 18; // pixels between the edge and a lamp that is beyond it
const FLIGHT = 420; // milliseconds
const HANDLE = 9; // pixels across of a handle's square
const REACH = 13; // pixels within which a handle is grabbed
const CLEAR = 84; // pixels at the right of the stage that the colour bar takes
const LOW = 420; // pixels of the stage's height below which a lying one has no room for hints
const TURN = 0.008; // radians by a pixel of a hand's way

export class SpaceView {
    readonly canvas = h('canvas', { tabindex: 0, class: 'space', role: 'application' });
    selected: Thing | null = null;
    probe: Probe | null = null;
    /** The place that a task asks about. */
    asked: number[] | null = null;
    /** What of measuring grids and their observers is shown. */
    measured: InSpace = NOTHING_MEASURED;
    onSelect: (thing: Thing | null) => void = () => undefined;
    onSide: (side: Side) => void = () => undefined;
    /** Told a place on a body that the hand points at, and where that is on the canvas; null: on no body. */
    onPlace: (place: Place | null, x: number, y: number) => void = () => undefined;
    /** Tells something beside the hand; null: nothing more. */
    onTell: (text: string | null, x: number, y: number) => void = () => undefined;
    /** Told the thing that the hand is on; null: on none. */
    onHover: (thing: Thing | null) => void = () => undefined;
    /** Told that a thing or a handle was taken. */
    onDrag: () => void = () => undefined;
    /** Told that bodies are shown as they are seen from somewhere else, or in another light. */
    onMade: () => void = () => undefined;
    /** What is said beside the first lamp; empty: nothing. */
    hint = '';
    /** The thing that the hand is on, here or in a list. */
    hovered: Thing | null = null;
    /** The vector that is pointed at elsewhere: "N", "V", or "L" or "H" with the number of its light. */
    lit: string | null = null;
    side: Side = 'orbit';
    readonly stage: Stage;
    private turn = TURNED; // about the axis that is up, radians
    private tilt = TILTS[0]; // from that axis
    private firstOf = TILTS[0]; // the tilt that the scene began with
    private zoom = 1;
    private scale = 1; // by which the whole scene fills the stage
    private center: Place = [0, 0, 0];
    private reach = 1000; // mm from the centre that must be seen
    private flight: View | null = null; // on the way to the observer
    private isFitted = false;
    private isOwn = false; // somebody has turned, moved or zoomed the view
    private isDrawn = true;

    private isHeld = false; // something is being dragged

    /** `scale` tells what the colours of values mean; `several`, which lamps are chosen together. */
    constructor(
        private readonly model: Model,
        scale: () => Scale,
        private readonly several: Several,
    ) {
        this.stage = new Stage(model, scale, () => {
            this.onMade();
            this.draw();
        });
        new ResizeObserver(() => this.resized()).observe(this.canvas);
        model.follow(this.canvas, () => this.stage.made?.of ?? model.whole);
        followPointer(
            this.canvas,
            (x, y, event) => this.begin(x, y, event),
            (factor, x, y, dx, dy) => this.twoFingers(factor, x, y, dx, dy),
            true,
        );
        this.canvas.addEventListener('keydown', (event) => this.key(event));
        this.canvas.addEventListener('pointermove', (event) => this.hover(event));
        this.canvas.addEventListener('pointerleave', () => {
            this.hoverOn(null);
            this.onPlace(null, 0, 0);
        });
        this.canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    }

    relabel() {
        this.canvas.setAttribute(
            'aria-label',
            t('Space view. Space selects the next thing, arrow keys and Page Up, Page Down move it; digits select lamps, V changes the view.'),
        );
    }

    /** Turn and tilt of the view; null: as it begins. */
    get turned(): number[] | null {
        return this.turn === TURNED && this.tilt === this.firstOf ? null : [this.turn, this.tilt];
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

    /** From orbit to plan to elevation and round again. */
    nextSide() {
        this.setSide(SIDES[(SIDES.indexOf(this.side) + 1) % SIDES.length]);
    }

    // As long as nobody has chosen another view, the scene fills whatever room there is.
    private resized() {
        if (!this.isOwn && !this.turned && sizeOf(this.canvas).width) this.isFitted = false;
        this.geometryChanged();
        this.draw();
    }

    /** Takes all of the scene into view anew. */
    fit() {
        this.isFitted = this.isOwn = false;
        this.geometryChanged();
    }

    /** Shows nothing: another scene was opened. */
    clear() {
        this.isFitted = this.isOwn = false;
        this.flight = null;
        this.stage.clear();
        this.probe = null;
        this.selected = this.hovered = null;
        this.isHeld = false;
        this.measured = NOTHING_MEASURED;
        this.draw();
    }

    geometryChanged() {
        if (!this.model.whole) return;
        if (!this.isFitted) this.fitNow();
        this.draw();
    }

    // Lamps and bodies are taken into view; of a scene without bodies the observer's screen, too.
    private fitNow() {
        const places = this.model.things.filter(({ kind }) => kind !== 'observer').map(({ at }) => at);
        const [w, h] = this.model.screen;
        if (!this.model.shapes.some(({ kind }) => kind === 'surface')) places.push(...this.model.whole!.frame.corners);
        if (!this.turned) this.tilt = this.firstOf = this.firstTilt();
        const isPlate = ({ kind, type }: Shape) => kind === 'surface' && (type === 'rectangle' || type === 'disk');
        const hasOthers = this.model.shapes.some((shape) => shape.kind === 'surface' && !isPlate(shape));
        for (const shape of this.model.shapes) {
            const { center, radius, size } = shape;
            // Floors and walls far beyond what is seen of them need not be in sight as a whole, and those under bodies even less.
            const most = (hasOthers && isPlate(shape) ? 0.45 : 1.5) * Math.max(w, h);
            const flat = Math.max(radius ?? 0, ...(size ?? []).map((each) => each / 2));
            const half = [0, 1, 2].map((axis) => Math.min(size?.length === 3 ? size[axis] / 2 : flat, most));
            for (const corner of [0, 1, 2, 3, 4, 5, 6, 7])
                places.push(center.map((c, axis) => c + (corner & (1 << axis) ? half[axis] : -half[axis])));
        }
        const low = [0, 1, 2].map((axis) => Math.min(...places.map((place) => place[axis])));
        const high = [0, 1, 2].map((axis) => Math.max(...places.map((place) => place[axis])));
        this.center = low.map((least, axis) => (least + high[axis]) / 2) as Place;
        this.reach = Math.max(Math.hypot(...high.map((most, axis) => most - low[axis])) / 2, 1);
        this.zoom = this.scale = 1;
        this.isFitted = true;
        this.fill(places);
    }

    // The tilt to begin with: less where plates whose fronts the observer sees would turn their backs.
    private firstTilt(): number {
        const observer = this.model.whole!.frame.axis;
        const dot = (a: number[], b: number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const plates = this.model.shapes.flatMap(({ kind, type, axis = [0, 0, 1] }) =>
            kind === 'surface' && (type === 'rectangle' || type === 'disk') && dot(axis, observer) > 0 ? [axis] : [],
        );
        const before = this.tilt;
        const isGood = (tilt: number) => {
            this.tilt = tilt;
            const [, , eye] = this.axes();
            return plates.every((axis) => dot(axis, eye) > 0.15);
        };
        const found = TILTS.find(isGood) ?? TILTS[0];
        this.tilt = before;
        return found;
    }

    // Takes as much of the stage as there is for places, clear of what stands on it.
    private fill(places: number[][]) {
        const { width, height } = sizeOf(this.canvas);
        if (width < 200 || height < 150) return;
        const isNarrow = width < 700;
        const room = { left: 24, right: isNarrow ? 84 : 88, top: isNarrow ? 84 : 64, low: isNarrow ? 64 : 56 };
        for (let i = 0; i < 3; i++) {
            const view = this.wanted();
            const points = places.map((place) => seenBy(view, place));
            const [left, right] = [Math.min, Math.max].map((pick) => pick(...points.map(([x]) => x)));
            const [top, low] = [Math.min, Math.max].map((pick) => pick(...points.map(([, y]) => y)));
            const [dx, dy] = [(left + right - width - room.left + room.right) / 2, (top + low - height - room.top + room.low) / 2];
            const { factor } = view;
            this.center = along(this.center, view.right, dx / factor, view.up, -dy / factor);
            this.scale *= Math.min((width - room.left - room.right) / Math.max(right - left, 1), (height - room.top - room.low) / Math.max(low - top, 1));
        }
    }

    // Right, up and towards the eye, as the view has them in the scene.
    private axes(): [Place, Place, Place] {
        const upright = (x: number, y: number, z: number): Place => (this.isUpright ? [x, z, -y] : [x, y, z]);
        if (this.side === 'plan') return [[1, 0, 0], upright(0, 1, 0), upright(0, 0, 1)];
        if (this.side === 'elevation') return [[1, 0, 0], upright(0, 0, 1), upright(0, -1, 0)];
        const [s, c] = [Math.sin(this.turn), Math.cos(this.turn)];
        const [st, ct] = [Math.sin(this.tilt), Math.cos(this.tilt)];
        const eye = upright(s * st, -c * st, ct);
        const right = upright(c, s, 0);
        return [right, cross(eye, right), eye];
    }

    // Whether y is up in the scene, as in rooms, rather than z.
    private get isUpright(): boolean {
        return this.model.whole?.up === 'y';
    }

    private factor(): number {
        const { width, height } = sizeOf(this.canvas);
        return (0.45 * this.scale * this.zoom * Math.min(width, height)) / this.reach;
    }

    /** The camera: that of the side and zoom that were chosen, or on its way. */
    private wanted(): View {
        if (this.flight) return this.flight;
        const { width, height } = sizeOf(this.canvas);
        const [right, up, back] = this.axes();
        const distance = FAR * this.reach;
        const eye = add(this.center, back, distance);
        return { eye, target: this.center, right, up, back, distance, factor: this.factor(), width, height };
    }

    // What is drawn over the bodies goes with their picture, until that has come too late.
    private get view(): View {
        const wanted = this.wanted();
        const { made } = this.stage;
        const fits = made && made.view.width === wanted.width && made.view.height === wanted.height;
        return fits && !this.stage.isLate ? made.view : wanted;
    }

    private seen(place: number[]): [number, number] {
        const [x, y] = seenBy(this.view, place);
        return [x, y];
    }

    draw() {
        if (!this.isDrawn) return;
        this.isDrawn = false;
        requestAnimationFrame(() => {
            this.isDrawn = true;
            this.drawNow();
        });
    }

    private drawNow() {
        const [width, height, context] = fitted(this.canvas);
        if (!this.model.scene || width < 8 || height < 8) return;
        this.stage.want(this.wanted());
        const { view } = this;
        const drawing = new Drawing(context, this.stage, view, window.devicePixelRatio || 1);
        this.drawBodies(context, width, height, drawing);
        context.lineWidth = 1;
        this.drawScreen(drawing);
        const lights = this.model.shapes.filter(({ kind }) => kind === 'light');
        for (const shape of lights) this.drawLight(drawing, shape, lights.length <= FILLED);
        this.drawProbe(drawing);
        this.drawAsked(drawing);
        drawMeasured(drawing, this.measured);
        for (const thing of this.model.things) if (thing.kind !== 'light') this.drawThing(drawing, thing);
        const lamps = this.model.things.filter(({ kind }) => kind === 'light');
        for (const lamp of lamps) this.drawLamp(drawing, lamp, lamps.length <= NAMED);
        this.drawHandles(drawing);
        if (this.hint && lamps.length) this.drawHint(context, ...this.markPlace(lamps[0]));
    }

    private drawHint(context: CanvasRenderingContext2D, x: number, y: number) {
        const { width, height } = this.view;
        if (height < LOW && width > height) return; // the value needs the room
        context.font = '600 13px system-ui, sans-serif';
        const half = context.measureText(this.hint).width / 2 + 12;
        const [middle, below] = [Math.max(half + 8, Math.min(width - half - 8, x)), y < 110 ? 44 : -44];
        context.beginPath();
        context.roundRect(middle - half, y + below - 15, 2 * half, 30, 10);
        context.fillStyle = styleColour('--paper');
        context.fill();
        context.strokeStyle = styleColour('--line');
        context.stroke();
        context.textAlign = 'center';
        context.textBaseline = 'middle';
        context.fillStyle = styleColour('--text');
        context.fillText(this.hint, middle, y + below + 0.5);
    }

    // The handles of what is chosen.
    private handles(view: View): Handle[] {
        const { selected } = this;
        if (!selected || this.model.isFixed(selected)) return [];
        if (selected.kind === 'observer') return handlesOfObserver(this.model.whole!);
        if (this.several.has(selected.index)) return [];
        const kind = selected.kind === 'surface' ? 'surface' : 'light';
        const shape = this.model.shapes.find((each) => each.kind === kind && each.index === selected.index);
        return shape ? handlesOf(shape, view, this.coneLength(shape)) : [];
    }

    private drawHandles(drawing: Drawing) {
        const { context } = drawing;
        for (const { at } of this.handles(drawing.view)) {
            const [x, y, depth] = drawing.seen(at);
            if (depth <= 0) continue;
            context.beginPath();
            context.rect(x - HANDLE / 2, y - HANDLE / 2, HANDLE, HANDLE);
            context.fillStyle = '#fff';
            context.fill();
            context.lineWidth = 1.5;
            context.strokeStyle = '#202226';
            context.stroke();
        }
        context.lineWidth = 1;
    }

    private handleAt(x: number, y: number): Handle | null {
        const found = this.handles(this.view).map((handle) => {
            const [hx, hy] = this.seen(handle.at);
            return { handle, off: Math.hypot(hx - x, hy - y) };
        });
        const best = found.sort((a, b) => a.off - b.off)[0];
        return best && best.off <= REACH ? best.handle : null;
    }

    // Their picture, or, until it has come and where there is none, what is known of them at once, as lines.
    private drawBodies(context: CanvasRenderingContext2D, width: number, height: number, drawing: Drawing) {
        const image = this.stage.picture();
        if (image) {
            const pixel = (this.stage.pixel() * width) / this.stage.made!.view.width;
            context.imageSmoothingEnabled = true;
            context.globalAlpha = this.stage.isLate ? 0.45 : 1;
            context.drawImage(image, 0, height / 2 - (image.height * pixel) / 2, image.width * pixel, image.height * pixel);
            context.globalAlpha = 1;
        }
        context.strokeStyle = styleColour('--dim');
        context.lineWidth = 1;
        const isBare = !image || this.stage.isLate;
        for (const shape of this.model.shapes)
            if (shape.kind === 'surface' && (isBare || this.showsBack(shape))) this.drawOutline(drawing, shape);
    }

    // Whether it is a plate that turns its back to the camera, which is not to be seen.
    private showsBack({ type, center, axis = [0, 0, 1] }: Shape): boolean {
        const { eye } = this.view;
        return (type === 'rectangle' || type === 'disk') && axis.reduce((sum, c, i) => sum + c * (eye[i] - center[i]), 0) < 0;
    }

    private drawScreen(drawing: Drawing) {
        const { observer } = this.model;
        const { corners } = this.model.whole!.frame;
        const { context } = drawing;
        context.strokeStyle = styleColour('--accent');
        context.globalAlpha = 0.5;
        drawing.line(corners, true);
        context.globalAlpha = 0.22;
        if (observer?.perspective) for (const corner of corners) drawing.line([observer.position, corner]);
        context.globalAlpha = 1;
    }

    private drawOutline(drawing: Drawing, shape: Shape) {
        const { center, radius = 0, size, height = 0 } = shape;
        const [u, v, n] = basis(shape.axis ?? [0, 0, 1], shape.up);
        if (shape.outline) drawing.line(shape.outline, true);
        else if (shape.type === 'rectangle' && size) drawing.line(rectangle(shape), true);
        else if (shape.type === 'disk') drawing.line(circle(center, u, v, radius), true);
        else if (shape.type === 'cylinder')
            for (const off of [-height / 2, height / 2]) drawing.line(circle(add(center, n, off), u, v, radius), true);
        else if ((shape.type === 'box' || shape.type === 'room') && size)
            for (const edge of edgesOf(center, size, shape.turn)) drawing.line(edge);
        else if (radius) drawing.line(circle(center, this.view.right, this.view.up, radius), true);
    }

    // Panels are filled, cones fade away from the lamp.
    private drawLight(drawing: Drawing, shape: Shape, isFilled: boolean) {
        const { context } = drawing;
        const colour = lightColour(shape.index);
        const isChosen = this.selected?.index === shape.index && this.selected.kind !== 'surface';
        context.strokeStyle = colour;
        context.lineWidth = isChosen ? 2.5 : 1.25;
        const [u, v] = basis(shape.axis ?? [0, 0, 1], shape.up);
        const flat =
            shape.outline ??
            (shape.type === 'rectangle' && shape.size
                ? rectangle(shape)
                : shape.type === 'disk'
                  ? circle(shape.center, u, v, shape.radius ?? 0)
                  : null);
        if (flat && isFilled) drawing.fill(flat, [flat[0], flat[Math.floor(flat.length / 3)], flat[Math.floor((2 * flat.length) / 3)]], () => faded(colour, 0.35));
        this.drawOutline(drawing, shape);
        if (flat && shape.axis) {
            context.setLineDash([4, 4]);
            drawing.line([shape.center, add(shape.center, unit(shape.axis), 0.22 * this.reach)]);
            context.setLineDash([]);
        }
        if (shape.opening && shape.axis) this.drawCone(drawing, shape, colour, isFilled);
    }

    private coneLength({ center, index }: Shape): number {
        const aim = this.model.things.find((thing) => thing.kind === 'aim' && thing.index === index)?.at;
        return aim ? Math.hypot(...aim.map((c, i) => c - center[i])) : 0.6 * this.reach;
    }

    private drawCone(drawing: Drawing, shape: Shape, colour: string, isFilled: boolean) {
        const { center, opening = 0 } = shape;
        const { context } = drawing;
        const axis = unit(shape.axis!);
        const [u, v] = basis(axis);
        const length = this.coneLength(shape);
        const rim = circle(add(center, axis, length), u, v, length * Math.tan((Math.min(opening, 75) * Math.PI) / 180));
        context.lineWidth = 1;
        const [tip, ends] = [drawing.seen(center), rim.map((place) => drawing.seen(place))];
        // Its outline on the page: the two places of the rim that are farthest to the sides.
        const foot = drawing.seen(add(center, axis, length));
        const along = Math.atan2(foot[1] - tip[1], foot[0] - tip[0]);
        const sideways = ends.map(([x, y]) => {
            const off = Math.atan2(y - tip[1], x - tip[0]) - along;
            return Math.atan2(Math.sin(off), Math.cos(off));
        });
        const [left, right] = [Math.min, Math.max].map((pick) => sideways.indexOf(pick(...sideways)));
        const isAside = Math.hypot(foot[0] - tip[0], foot[1] - tip[1]) > 12;
        if (isFilled) {
            const across = cross(axis, drawing.view.back);
            const plane = [center, add(center, axis, length), add(center, across, length)];
            const shade = (on: CanvasRenderingContext2D) => {
                const gradient = on.createLinearGradient(tip[0], tip[1], foot[0], foot[1]);
                gradient.addColorStop(0, faded(colour, 0.5));
                gradient.addColorStop(1, faded(colour, 0.07));
                return gradient;
            };
            const far = sideways.length;
            const arc = Array.from({ length: far }, (_, i) => rim[(left + i) % far]);
            const until = (right - left + far) % far;
            const outline = isAside ? [center, ...arc.slice(0, until + 1)] : rim;
            drawing.fill(outline, plane, shade);
        }
        drawing.line(rim, true);
        if (isAside) for (const i of [left, right]) drawing.line([center, rim[i]]);
    }

    // The vectors of the formula at the probe, and its mark.
    private drawProbe(drawing: Drawing) {
        const { probe } = this;
        if (!probe || probe.surface === null || !this.model.scene) return;
        const { context } = drawing;
        const place = probe.position;
        const most = Math.min(70, 0.17 * Math.min(drawing.view.width, drawing.view.height));
        const length = (most * drawing.seen(place)[2]) / (drawing.view.factor * drawing.view.distance);
        drawVectors(drawing, vectorsAt(this.model, probe, this.lit), place, length, this.lit);
        const [x, y] = drawing.seen(place);
        for (const [radius, colour, width] of [[8, '#202226', 3.5], [8, '#fff', 2], [2.5, '#fff', 2]] as const) {
            context.beginPath();
            context.arc(x, y, radius, 0, 2 * Math.PI);
            context.strokeStyle = colour;
            context.lineWidth = width;
            context.stroke();
        }
        context.lineWidth = 1;
    }

    private drawAsked(drawing: Drawing) {
        if (!this.asked) return;
        const { context } = drawing;
        const [x, y] = drawing.seen(this.asked);
        context.beginPath();
        context.arc(x, y, 4, 0, 2 * Math.PI);
        context.fillStyle = '#fff';
        context.fill();
        context.lineWidth = 1.5;
        context.strokeStyle = '#202226';
        context.stroke();
        context.font = '600 13px system-ui, sans-serif';
        context.textAlign = 'left';
        context.textBaseline = 'bottom';
        drawing.words('P', x + 6, y - 4);
    }

    // A lamp glows; beyond the edge it stands at the edge, and a plumb line tells how high it is.
    private drawLamp(drawing: Drawing, thing: Thing, isNamed: boolean) {
        const { context, view } = drawing;
        const light = this.model.scene!.lights[thing.index];
        const chosen = this.selected?.key === thing.key || this.several.has(thing.index);
        const [x, y] = this.markPlace(thing);
        const colour = lightColour(thing.index);
        const hidden = drawing.isHidden(thing.at);
        if (light?.enabled && this.model.scene!.lights.length <= GLOWING) drawing.glow(x, y, colour, hidden ? 0.25 : 0.75);
        if (chosen) this.drawPlumb(drawing, thing.at, colour);
        context.globalAlpha = hidden && !chosen ? 0.45 : light?.enabled ? 1 : 0.55;
        numberMark(context, x, y, thing.index, chosen);
        if (this.hovered?.key === thing.key && this.hovered.kind === thing.kind) drawing.ring(x, y, chosen ? 20 : 15);
        if (isNamed) {
            context.font = '600 12px system-ui, sans-serif';
            const name = light?.name ?? light?.label ?? '';
            const length = context.measureText(name).width + 24;
            const isLeft = x + length > view.width - CLEAR;
            context.textAlign = isLeft ? 'right' : 'left';
            context.textBaseline = 'middle';
            // Where there is no room for a name, the number tells which lamp it is.
            if (!isLeft || x > length) drawing.words(name, x + (isLeft ? -1 : 1) * (chosen ? 24 : 20), y);
        }
        context.globalAlpha = 1;
    }

    private drawPlumb(drawing: Drawing, at: number[], colour: string) {
        const axis = this.isUpright ? 1 : 2;
        const foot = at.slice();
        const floors = this.model.shapes.filter(({ kind }) => kind === 'surface').map(({ center, size, type }) =>
            type === 'room' && size ? center[axis] - size[axis] / 2 : center[axis],
        );
        foot[axis] = Math.min(0, ...floors);
        const { context } = drawing;
        context.strokeStyle = colour;
        context.lineWidth = 1.25;
        context.setLineDash([1.5, 4]);
        drawing.line([at, foot]);
        context.setLineDash([]);
        const across: Place[] = this.isUpright ? [[1, 0, 0], [0, 0, 1]] : [[1, 0, 0], [0, 1, 0]];
        drawing.line(circle(foot, across[0], across[1], 0.018 * this.reach), true);
    }

    // Where a lamp's mark stands: where it is seen, or at the edge.
    private markPlace(thing: Thing): [number, number] {
        const { width, height } = this.view;
        const [x, y] = this.seen(thing.at);
        return [Math.max(ROOM, Math.min(width - ROOM, x)), Math.max(ROOM, Math.min(height - ROOM, y))];
    }

    private drawThing(drawing: Drawing, thing: Thing) {
        const { context } = drawing;
        const [x, y] = thing.kind === 'direction' ? this.markPlace(thing) : this.seen(thing.at);
        const chosen = this.selected?.key === thing.key && this.selected.kind === thing.kind;
        if (thing.sun && !chosen && this.isBehindSun(thing)) return;
        if (thing.from) {
            context.strokeStyle = lightColour(thing.index);
            context.setLineDash([4, 4]);
            drawing.line([thing.from, thing.at]);
            context.setLineDash([]);
        }
        if (thing.sun && (chosen || this.hovered?.key === thing.key)) drawDome(drawing, thing, thing.sun);
        if (thing.kind === 'direction') return numberMark(context, x, y, thing.index, chosen);
        if (thing.kind === 'surface' && !chosen) return;
        context.beginPath();
        if (thing.kind === 'observer') context.rect(x - 6, y - 6, 12, 12);
        else if (thing.kind === 'aim') {
            context.arc(x, y, 5, 0, 2 * Math.PI);
            context.moveTo(x - 8, y);
            context.lineTo(x + 8, y);
            context.moveTo(x, y - 8);
            context.lineTo(x, y + 8);
        } else context.arc(x, y, 6, 0, 2 * Math.PI);
        for (const [style, width] of [['rgb(0 0 0 / 45%)', chosen ? 5 : 3.5], [thing.kind === 'aim' ? lightColour(thing.index) : chosen ? styleColour('--accent') : '#fff', chosen ? 2.5 : 1.75]] as const) {
            context.strokeStyle = style;
            context.lineWidth = width;
            context.stroke();
        }
        context.lineWidth = 1;
    }

    // Whether another sun that stands there is shown, of those that go together: the chosen one, or the first.
    private isBehindSun({ sun, key }: Thing): boolean {
        const together = sunsWith(this.model.things, sun!);
        const bases = together.map(({ base }) => `${base}.sun`);
        return (bases.find((each) => each === this.selected?.key) ?? bases[0]) !== key;
    }

    private thingAt(x: number, y: number): Thing | null {
        let nearest: Thing | null = null;
        let least = NEAR;
        // Lamps and aims before the places that they aim at.
        const order = ['light', 'direction', 'aim', 'observer', 'surface'];
        for (const thing of this.model.things.filter((each) => !this.model.isFixed(each)).sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind))) {
            const [tx, ty] = thing.kind === 'light' || thing.kind === 'direction' ? this.markPlace(thing) : this.seen(thing.at);
            const distance = Math.hypot(tx - x, ty - y);
            // A body is dragged at its middle where it was chosen before.
            const isFixed = thing.kind === 'surface' && this.selected?.key !== thing.key;
            if (!isFixed && distance < least - 2) {
                least = distance;
                nearest = thing;
            }
        }
        return nearest;
    }

    private begin(x: number, y: number, event: PointerEvent): Action {
        const isTaking = !event.shiftKey && event.button !== 2;
        const handle = isTaking ? this.handleAt(x, y) : null;
        if (handle) return this.beginHandle(handle, x, y);
        const thing = isTaking ? this.thingAt(x, y) : null;
        if (thing && (event.ctrlKey || event.metaKey) && thing.kind !== 'surface' && thing.kind !== 'observer') {
            this.several.toggle(thing.index, this.selected);
            return { move: () => undefined, end: () => undefined };
        }
        if (!thing && event.button === 2) return this.beginPan(x, y);
        if (!thing) return event.pointerType === 'touch' && this.placeAt(x, y) ? this.beginPointing(x, y) : this.beginOrbit(x, y);
        if (!(thing.kind === 'light' && this.several.has(thing.index))) this.several.clear();
        this.select(thing);
        const drag = new Drag(this.model, movesOf(this.model, thing, this.several.besides(thing)));
        const { view } = this;
        this.isHeld = true;
        const [, , depth] = seenBy(view, thing.at);
        // From its place at the edge it goes by as much as the hand does.
        const factor = (view.factor * view.distance) / Math.max(depth, 0.02 * view.distance);
        // What is grabbed moves in the plane of the view.
        const move = (nx: number, ny: number) => {
            const to = thing.at.map((c, axis) => c + ((nx - x) * view.right[axis] - (ny - y) * view.up[axis]) / factor);
            void drag.to(to);
            this.onDrag();
            if (thing.sun) this.onTell(sunMoves(this.model.things, this.present(thing), to).told, nx, ny);
            else if (thing.kind !== 'direction') this.onTell(placeWords(to), nx, ny);
        };
        return { move, end: () => this.letGo(drag) };
    }

    // A thing as it stands now.
    private present(thing: Thing): Thing {
        return this.model.things.find(({ key, kind }) => key === thing.key && kind === thing.kind) ?? thing;
    }

    private letGo(drag: Drag) {
        drag.end();
        this.isHeld = false;
        this.onTell(null, 0, 0);
    }

    // What is told beside the hand while it changes a size is the size.
    private beginHandle(handle: Handle, x: number, y: number): Action {
        const { view } = this;
        const start = handleAt(handle, view, x, y);
        const off = handle.at.map((c, axis) => c - start[axis]); // the hand took it a little aside
        const drag = new Drag(this.model, (place) => handle.moved(place).changes);
        this.isHeld = true;
        const move = (nx: number, ny: number) => {
            const to = handleAt(handle, view, nx, ny).map((c, axis) => c + off[axis]);
            void drag.to(to);
            this.onDrag();
            this.onTell(handle.moved(to).told, nx, ny);
        };
        return { move, end: () => this.letGo(drag) };
    }

    private beginPan(x: number, y: number): Action {
        let last: [number, number] = [x, y];
        const move = (nx: number, ny: number) => {
            this.pinch(1, last[0], last[1], nx - last[0], ny - last[1]);
            last = [nx, ny];
        };
        return { move, end: () => undefined };
    }

    // A finger on a body asks for the value under it; elsewhere it turns the view.
    private beginPointing(x: number, y: number): Action {
        const move = (nx: number, ny: number) => {
            const place = this.placeAt(nx, ny);
            if (place) this.onPlace(place, nx, ny);
        };
        move(x, y);
        return { move, end: (moved) => void (moved || this.press(x, y)) };
    }

    private beginOrbit(x: number, y: number): Action {
        if (this.side !== 'orbit') {
            const pan = this.beginPan(x, y);
            return { move: pan.move, end: (moved) => void (moved || this.press(x, y)) };
        }
        let last: [number, number] = [x, y];
        const move = (nx: number, ny: number) => {
            this.turnBy(nx - last[0], ny - last[1]);
            last = [nx, ny];
        };
        return { move, end: (moved: boolean) => void (moved || this.press(x, y)) };
    }

    private turnBy(dx: number, dy: number) {
        this.turned = [this.turn - dx * TURN, this.tilt - dy * TURN];
        this.draw();
    }

    // A press on a body tells its place and chooses the body, on nothing it selects nothing.
    private press(x: number, y: number) {
        const place = this.placeAt(x, y);
        if (place) this.onPlace(place, x, y);
        this.several.clear();
        this.select(null);
        if (place) void this.chooseBody(x, y).catch(() => undefined);
    }

    private async chooseBody(x: number, y: number) {
        const before = this.model.version;
        const probe = await this.valueAt(x, y);
        if (!probe || this.model.version !== before || this.selected) return;
        const body = this.model.things.find(({ kind, index }) => kind === 'surface' && index === probe.surface);
        if (body && !this.model.isFixed(body)) this.select(body);
    }

    /** The place of the body that is seen at a point of the canvas; null: there is none. */
    placeAt(x: number, y: number): Place | null {
        const { made } = this.stage;
        const depth = this.stage.depthAt(x, y);
        if (!made || !(depth > 0)) return null;
        const { view } = made;
        const factor = (view.factor * view.distance) / depth;
        const across = along(view.target, view.right, (x - view.width / 2) / factor, view.up, (view.height / 2 - y) / factor);
        return add(across, view.back, view.distance - depth);
    }

    /** The exact value that is seen from here at a point of the canvas. */
    async valueAt(x: number, y: number): Promise<Probe | null> {
        const { made } = this.stage;
        const source = this.model.source();
        if (!made || !source || !this.model.isCurrent(made.of)) return null;
        const { view, stride } = made;
        const { camera, columns, rows } = cameraOf(view, stride);
        const at = [(x - view.width / 2) / view.factor, (view.height / 2 - y) / view.factor];
        return source.client.ask('stageProbe', source.of, camera, columns, rows, at[0], at[1]);
    }

    private hover(event: PointerEvent) {
        if (event.pointerType !== 'mouse' || event.buttons !== 0 || this.isHeld) return;
        const { left, top } = this.canvas.getBoundingClientRect();
        const [x, y] = [event.clientX - left, event.clientY - top];
        const handle = this.handleAt(x, y);
        const thing = handle ? null : this.thingAt(x, y);
        const place = thing || handle ? null : this.placeAt(x, y);
        this.canvas.style.cursor = thing || handle ? 'grab' : place ? 'crosshair' : 'default';
        this.hoverOn(thing);
        this.onPlace(place, x, y);
        if (thing || handle) this.onTell(handle ? handle.name : this.nameOf(thing!), x, y);
    }

    private hoverOn(thing: Thing | null) {
        if (this.hovered?.key === thing?.key && this.hovered?.kind === thing?.kind) return;
        this.hovered = thing;
        this.onHover(thing);
        this.draw();
    }

    /** What a thing is called. */
    nameOf({ kind, index }: Thing): string {
        const light = this.model.scene?.lights[index];
        if (kind === 'observer') return t('observer');
        if (kind === 'surface') return `${t('body')} ${index + 1}`;
        const name = `${index + 1} ${light?.name ?? light?.label ?? ''}`;
        return kind === 'light' ? name : `${name}: ${t(kind === 'aim' ? 'aim of light' : 'direction of light')}`;
    }

    select(thing: Thing | null) {
        this.selected = thing;
        this.onSelect(thing);
        this.draw();
    }

    private wheel(event: WheelEvent) {
        event.preventDefault();
        const { left, top } = this.canvas.getBoundingClientRect();
        this.pinch(Math.exp(-event.deltaY * 0.001), event.clientX - left, event.clientY - top, 0, 0);
    }

    // Two fingers zoom around the point between them, and turn the view; a plan they move.
    private twoFingers(factor: number, x: number, y: number, dx: number, dy: number) {
        if (this.side !== 'orbit') return this.pinch(factor, x, y, dx, dy);
        this.pinch(factor, x, y, 0, 0);
        this.turnBy(dx, dy);
    }

    // Zooms around a point, and moves it.
    private pinch(factor: number, x: number, y: number, dx: number, dy: number) {
        this.isOwn = true;
        const { width, height } = sizeOf(this.canvas);
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
        this.isOwn = true;
        this.zoom = Math.max(0.2, Math.min(40, this.zoom * factor));
        this.draw();
    }

    private key(event: KeyboardEvent) {
        const steps: Record<string, number[]> = {
            ArrowLeft: [-1, 0, 0],
            ArrowRight: [1, 0, 0],
            ArrowUp: [0, 1, 0],
            ArrowDown: [0, -1, 0],
            PageUp: [0, 0, 1],
            PageDown: [0, 0, -1],
        };
        if (event.key === '+' || event.key === '=') this.zoomBy(1.25);
        else if (event.key === '-') this.zoomBy(0.8);
        else if (event.key === '0' || event.key === 'f' || event.key === 'F') this.fit();
        else if (event.key === 'Home') this.lookFromFront();
        else if (event.key === ' ') this.selectNext(event.shiftKey ? -1 : 1);
        else if (event.key === 'Escape') {
            this.several.clear();
            this.select(null);
        } else if (event.key.toLowerCase() === 'a' && (event.ctrlKey || event.metaKey)) this.several.everything();
        else if (steps[event.key] && this.selected) this.nudge(steps[event.key], event.shiftKey ? 100 : 10);
        else return;
        event.preventDefault();
    }

    private lookFromFront() {
        [this.turn, this.tilt] = [0, Math.PI / 2 - 0.12];
        this.setSide('orbit');
    }

    /** The camera of the observer, whose screen has so many pixels for a mm, its middle so many beside and above that of the canvas. */
    observerView(factor: number, aside: number[]): View | null {
        const { width, height } = sizeOf(this.canvas);
        return observerView(this.model, factor, aside, width, height);
    }

    /** Flies to a camera, or from it back to the view's own; then `arrived` is called. */
    fly(to: View, isBack: boolean, arrived: () => void) {
        const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
        this.flight = null;
        const own = this.wanted();
        const start = performance.now();
        const step = () => {
            const share = isStill ? 1 : Math.min(1, (performance.now() - start) / FLIGHT);
            const eased = share * share * (3 - 2 * share);
            this.flight = share < 1 ? between(own, to, isBack ? 1 - eased : eased) : null;
            this.draw();
            if (share < 1) requestAnimationFrame(step);
            else arrived();
        };
        step();
    }

    private selectNext(step: number) {
        const { things } = this.model;
        const order = ['light', 'direction', 'aim', 'surface', 'observer'];
        const sorted = [...things].sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind));
        if (sorted.length) this.select(nextOf(sorted, this.selected, step));
    }

    private async nudge(step: number[], size: number) {
        const thing = this.selected && this.present(this.selected);
        if (!thing) return;
        const degree = thing.from && thing.sun ? Math.hypot(...thing.at.map((c, axis) => c - thing.from![axis])) / 573 : 1; // a sun by a degree
        const to = thing.at.map((c, axis) => c + step[axis] * size * degree);
        const changes = movesOf(this.model, thing, this.several.besides(thing))(to);
        if (changes.length) await this.model.change(changes, `keys ${thing.key}`);
    }
}

/** A place in whole mm. */
export function placeWords(place: number[]): string {
    return `(${place.map((c) => number(Math.round(c), 6)).join('; ')}) ${t('mm')}`;
}

/** The corners of a rectangle. */
function rectangle({ center, size = [0, 0], axis, up }: Shape): Place[] {
    const [u, v] = basis(axis ?? [0, 0, 1], up);
    const corner = (a: number, b: number) => along(center, u, (a * size[0]) / 2, v, (b * size[1]) / 2);
    return [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
}

/** A camera on the way from one to another. */
function between(a: View, b: View, share: number): View {
    const mixed = (from: number[], to: number[]) => from.map((c, i) => c + share * (to[i] - c)) as Place;
    const back = unit(mixed(a.back, b.back));
    const right = unit(cross(mixed(a.up, b.up), back));
    const up = cross(back, right);
    const target = mixed(a.target, b.target);
    const distance = a.distance * (b.distance / a.distance) ** share;
    const factor = a.factor * (b.factor / a.factor) ** share;
    return { ...a, eye: add(target, back, distance), target, right, up, back, distance, factor };
}
