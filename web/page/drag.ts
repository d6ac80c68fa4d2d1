// SPDX-License-Identifier: MIT
// Dragging: things follow the hand, the newest place wins, and one drag is one step of the history, as all of its
// changes have one mark, those too that come after the hand has let go.
import type { Model, Thing } from './model';

let drags = 0;

export class Drag {
    private readonly mark = `drag ${++drags}`;
    private next: number[] | null = null;
    private busy = false;
    private isOver = false;

    constructor(
        private readonly model: Model,
        readonly thing: Thing,
    ) {}

    async to(place: number[]) {
        this.next = place;
        if (this.busy) return;
        this.busy = true;
        this.model.drags++;
        while (this.next) {
            const place = this.next;
            this.next = null;
            const present = this.model.things.find(
                ({ key, kind }) => key === this.thing.key && kind === this.thing.kind,
            );
            const went = await this.model.moveThing(present ?? this.thing, place, this.mark).catch(() => false);
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

/** Follows one pointer over an element; `begin` returns what a movement does, or null. */
export function followPointer(
    element: HTMLElement,
    begin: (
        x: number,
        y: number,
        event: PointerEvent,
    ) => { move(x: number, y: number): void; end(moved: boolean): void } | null,
) {
    element.addEventListener('pointerdown', (event) => {
        if (event.button !== 0) return;
        const place = (e: PointerEvent) => {
            const { left, top } = element.getBoundingClientRect();
            return [e.clientX - left, e.clientY - top] as const;
        };
        const start = place(event);
        const action = begin(...start, event);
        if (!action) return;
        element.setPointerCapture(event.pointerId);
        let moved = false;
        const move = (e: PointerEvent) => {
            if (e.pointerId !== event.pointerId) return;
            const [x, y] = place(e);
            moved ||= Math.hypot(x - start[0], y - start[1]) > 3;
            if (moved) action.move(x, y);
        };
        const end = (e: PointerEvent) => {
            if (e.pointerId !== event.pointerId) return;
            element.removeEventListener('pointermove', move);
            element.removeEventListener('pointerup', end);
            element.removeEventListener('pointercancel', end);
            action.end(moved);
        };
        element.addEventListener('pointermove', move);
        element.addEventListener('pointerup', end);
        element.addEventListener('pointercancel', end);
    });
}
