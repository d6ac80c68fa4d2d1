// SPDX-License-Identifier: MIT
// Dragging: things follow the hand, the newest place wins, and one drag is one step of the history, as all of its
// changes have one mark, those too that come after the hand has let go.
import type { Change } from './core';
import type { Model, Thing } from './model';
import type { Version } from './version';

let drags = 0;

/** What is changed as something is brought to a place. */
export type Moves = (place: number[]) => Change[];

/** What brings a thing to a place, and others as far with it. */
export function movesOf(model: Model, thing: Thing, others: Thing[] = []): Moves {
    const present = (wanted: Thing) => model.things.find(({ key, kind }) => key === wanted.key && kind === wanted.kind) ?? wanted;
    return (place) => {
        const by = place.map((c, axis) => Math.round(c - present(thing).at[axis]));
        const along = others.map(present).flatMap((other) => model.moves(other, other.at.map((c, axis) => c + by[axis])));
        return [...model.moves(present(thing), place), ...along];
    };
}

export class Drag {
    private readonly mark = `drag ${++drags}`;
    private next: number[] | null = null;
    private busy = false;
    private isOver = false;
    private readonly of: Version; // whose scene it is that is changed, and no other

    constructor(
        private readonly model: Model,
        private readonly moves: Moves,
    ) {
        this.of = model.version;
    }

    /** The scene that it changes. */
    get scene() {
        return this.of.scene;
    }

    async to(place: number[]) {
        if (this.of.scene !== this.model.version.scene) return;
        this.next = place;
        if (this.busy) return;
        this.busy = true;
        this.model.drags++;
        while (this.next) {
            const changes = this.moves(this.next);
            this.next = null;
            const went = changes.length > 0 && (await this.model.change(changes, this.mark, this.of).catch(() => false));
            // What was undone while the last movement was on its way stays undone.
            if (!went && this.isOver) this.next = null;
            if (went && !this.isOver) await this.model.pictured();
        }
        this.busy = false;
        this.model.drags--;
    }

    end() {
        this.isOver = true;
    }
}

/** What a movement of a pointer does, and its end. */
export interface Action {
    move(x: number, y: number): void;
    end(moved: boolean): void;
}

/** What two fingers do: spread by a factor around a point, which moves by dx and dy. */
export type Pinch = (factor: number, x: number, y: number, dx: number, dy: number) => void;

const STILL = 3; // pixels that a hand moves without meaning it

type Spot = readonly [x: number, y: number];

/** Follows the pointers over an element: one does what `begin` returns, two fingers pinch. */
export function followPointer(
    element: HTMLElement,
    begin: (x: number, y: number, event: PointerEvent) => Action | null,
    pinch: Pinch | null = null,
    takesRight = false, // the right button, too
) {
    const spots = new Map<number, Spot>(); // of the pointers that are down
    let action: Action | null = null;
    let start: Spot = [0, 0];
    let moved = false;
    let corner: Spot = [0, 0]; // of the element in the window, as it was taken: asking anew would lay the page out each time
    const place = (event: PointerEvent): Spot => [event.clientX - corner[0], event.clientY - corner[1]];
    if (takesRight) element.addEventListener('contextmenu', (event) => event.preventDefault());
    const finish = () => {
        action?.end(moved);
        action = null;
    };
    element.addEventListener('pointerdown', (event) => {
        if (event.button !== 0 && !(takesRight && event.button === 2)) return;
        if (!spots.size) {
            const { left, top } = element.getBoundingClientRect();
            corner = [left, top];
        }
        const at = place(event);
        const isSecond = spots.size === 1 && pinch !== null && event.pointerType === 'touch';
        if (spots.size && !isSecond) return;
        if (isSecond) finish();
        else {
            [start, moved] = [at, false];
            action = begin(...at, event);
            if (!action) return;
        }
        spots.set(event.pointerId, at);
        element.setPointerCapture(event.pointerId);
    });
    const pinched = (id: number, at: Spot) => {
        const [[, still]] = [...spots].filter(([other]) => other !== id);
        const before = spots.get(id)!;
        const distance = ([x, y]: Spot) => Math.max(Math.hypot(x - still[0], y - still[1]), 1);
        const middle = ([x, y]: Spot) => [(x + still[0]) / 2, (y + still[1]) / 2];
        const [[x0, y0], [x1, y1]] = [middle(before), middle(at)];
        pinch!(distance(at) / distance(before), x0, y0, x1 - x0, y1 - y0);
    };
    element.addEventListener('pointermove', (event) => {
        if (!spots.has(event.pointerId)) return;
        const at = place(event);
        if (spots.size === 2) pinched(event.pointerId, at);
        else {
            moved ||= Math.hypot(at[0] - start[0], at[1] - start[1]) > STILL;
            if (moved) action?.move(...at);
        }
        spots.set(event.pointerId, at);
    });
    const up = (event: PointerEvent) => {
        if (spots.delete(event.pointerId)) finish();
    };
    element.addEventListener('pointerup', up);
    element.addEventListener('pointercancel', up);
}
