// SPDX-License-Identifier: MIT
// Reliefs: surfaces as they look from the present side of the space view, which the core finds: a coarse one while the view
// is turned, a fine one with its silhouette in lines when it rests.  Until the core has answered, the last one stays.
import type { Model } from './model';

const COARSE = 36; // pixels across: some 10 ms of the core's time
const FINE = 128;
const REST = 250; // milliseconds after which the view rests
const SIDE = 2.04; // of its square, in reaches of the surface, as page_relief() has it

interface Relief {
    of: string; // the surface, the side and the colour
    pixels: number;
    image: HTMLCanvasElement | null; // null: the core has none
    lines: number[][] | null; // null: not yet
}

/** From where a surface is looked at: unit vectors to the right, upwards and to the eye. */
interface Side {
    right: number[];
    up: number[];
    eye: number[];
}

export class Reliefs {
    private readonly made = new Map<number, Relief>();
    private readonly asking = new Set<number>();
    private readonly timers = new Map<number, number>();

    constructor(
        private readonly model: Model,
        private readonly onMade: () => void,
    ) {}

    /** The side of a relief's square in mm. */
    side(reach: number): number {
        return SIDE * reach;
    }

    /** The relief of a surface from here, in a colour; `what` tells it from what it was.  Null: not yet, or never. */
    from(surface: number, what: string, side: Side, colour: string): Pick<Relief, 'image' | 'lines'> {
        const of = [what, ...side.eye, ...side.up, colour].join();
        const present = this.made.get(surface);
        if (present?.of !== of) void this.ask(surface, of, side, colour, COARSE);
        else if (present.image && present.pixels < FINE) {
            clearTimeout(this.timers.get(surface));
            const refine = () => {
                if (this.made.get(surface)?.of === of) void this.ask(surface, of, side, colour, FINE);
            };
            this.timers.set(surface, window.setTimeout(refine, REST));
        }
        return { image: present?.image ?? null, lines: present?.of === of ? present.lines : null };
    }

    private async ask(surface: number, of: string, { right, up, eye }: Side, colour: string, pixels: number) {
        if (this.asking.has(surface)) return;
        const whole = this.model.asWhole();
        if (!whole) return;
        this.asking.add(surface);
        const { client } = this.model;
        const shades = await client.ask('relief', whole, surface, eye, up, pixels).catch(() => null);
        const lines =
            pixels === FINE ? await client.ask('silhouette', whole, surface, right, up).catch(() => null) : null;
        this.asking.delete(surface);
        if (whole.scene !== this.model.version.scene) return this.onMade();
        this.made.set(surface, { of, pixels, image: shades && painted(shades, pixels, colour, !lines), lines });
        this.onMade(); // which asks anew where the view has been turned since
    }
}

// The more a place is turned away, the more of the colour it has; the outline, if wanted, is nearly all of it.
function painted(shades: Uint8Array, size: number, colour: string, isOutlined: boolean): HTMLCanvasElement {
    const image = document.createElement('canvas');
    image.width = image.height = size;
    const context = image.getContext('2d')!;
    context.fillStyle = colour;
    context.fillRect(0, 0, size, size);
    const pixels = context.getImageData(0, 0, size, size);
    shades.forEach((shade, i) => {
        const isEdge = isOutlined && [i - 1, i + 1, i - size, i + size].some((next) => !shades[next]);
        pixels.data[4 * i + 3] = shade === 0 ? 0 : isEdge ? 230 : 40 + 0.6 * (255 - shade);
    });
    context.putImageData(pixels, 0, 0);
    return image;
}
