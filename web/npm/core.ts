// SPDX-License-Identifier: MIT
// The core of the package: what it answers beyond the core of the page.
import { Core } from '../page/core';
import type { Balance, Extrema, Field, Grid, Options, Point, Probe, Element } from './results';

const PLACE = { screen: 2, element: 11 }; // numbers for each

function elementNumbers({ position_mm, normal, view, surface = 0 }: Element): number[] {
    const three = (numbers: readonly number[], name: string) => {
        if (numbers.length !== 3) throw new RangeError(`${name}: three numbers are expected, x, y and z`);
        return numbers;
    };
    const seen = view ? [1, ...three(view, 'view')] : [0, 0, 0, 0];
    return [...three(position_mm, 'position_mm'), ...three(normal, 'normal'), ...seen, surface];
}

export class PackageCore extends Core {
    /** How all is computed from now on. */
    settings({ quantity = 'brightness', tolerance = 0, light_error = 0, reflected_error = 0, progress }: Options): void {
        this.call.package_settings(tolerance, light_error, reflected_error);
        this.quantity(quantity === 'irradiance');
        this.onProgress = progress ?? (() => undefined);
    }

    private probes(numbers: number[], width: number): Probe[] | null {
        return this.json(
            this.withNumbers(numbers, (place) => this.call.package_probe(place, width, numbers.length / width)),
        );
    }

    probePoints(points: readonly Point[]): Probe[] | null {
        return this.probes(points.flat(), PLACE.screen);
    }

    probeElement(element: Element): Probe[] | null {
        return this.probes(elementNumbers(element), PLACE.element);
    }

    field(): Field {
        const about = this.json<Omit<Field, 'values' | 'rgb' | 'mask'>>(this.call.package_field())!;
        const [values, mask, rgb] = [this.call.page_values(), this.call.page_mask(), this.call.package_rgb()];
        const buffer = this.memory.buffer as ArrayBuffer;
        const count = about.columns * about.rows;
        return {
            ...about,
            values: new Float32Array(buffer, values, count).slice(),
            rgb: rgb ? new Float32Array(buffer, rgb, 3 * count).slice() : null,
            mask: new Uint8Array(buffer, mask, count).slice(),
        };
    }

    peaks(): Extrema | null {
        return this.json(this.call.package_extrema());
    }

    /** The i-th measuring grid; null where messages() tell why there is none. */
    measured(i: number): Grid | null {
        return this.json(this.call.package_grid(i));
    }

    /** The balance, in a list; without reflected light, null in it. */
    fluxes(): [Balance | null] | null {
        const place = this.call.package_balance();
        return place ? [this.json<Balance>(place)] : null;
    }

    conventions(): Record<string, string> {
        return this.json(this.call.package_conventions()) ?? {};
    }

    advise(): void {
        this.call.package_advise();
    }

    schema(): object {
        return this.json(this.call.package_schema()) ?? {};
    }
}
