// SPDX-License-Identifier: MIT
// What a lamp sends into each direction: its intensity, as a small plate far away finds it that is turned to the lamp alone, so
// that a pattern, a cone, a photometry file and a panel are all measured by the same sums.
import type { Client } from '../client';
import type { Model } from '../model';
import { add, along, basis, type Place } from '../space_math';
import type { Of } from '../version';

const FAR = 1e6; // mm to the plate: as far as lamps of some metres are points within 1e-5
const STEP = 2.5; // degrees between two directions

export interface Polar {
    of: Of;
    /** Degrees from the axis, and the intensity there in the planes C0–C180 and C90–C270; negative: in the second half. */
    degrees: number[];
    planes: number[][];
}

/** The intensities of a light; null: it has none, as ambient and distant ones, or the scene has changed. */
export async function polarOf(model: Model, index: number): Promise<Polar | null> {
    const of = model.asWhole();
    const light = model.scene?.lights[index];
    if (!of || !model.isCurrent(of) || !light?.place) return null;
    const worker = await model.client.twin();
    try {
        return await measured(worker, of, index, light.place, light.direction ?? [0, 0, -1], model.photometric);
    } finally {
        worker.stop();
    }
}

async function measured(worker: Client, of: Of, index: number, place: number[], axis: number[], isPhotometric: boolean): Promise<Polar | null> {
    const base = `lights[${index}]`;
    const [own, aside, law] = await worker.ask('keys', of, [base, `${base}.c0`, `${base}.attenuation`]);
    if (own === null) return null;
    const plate = (direction: Place) => {
        const at = add(place, direction, FAR).map((c) => c.toPrecision(12)).join(', ');
        const before = add(place, direction, FAR - 1000).map((c) => c.toPrecision(12)).join(', ');
        const back = direction.map((c) => (-c).toPrecision(12)).join(', ');
        const up = basis(direction)[1].map((c) => c.toPrecision(12)).join(', ');
        return `surfaces: [{type: rectangle, center: [${at}], size: [100, 100], axis: [${back}], material: {model: lambert, diffuse: 1}}]\nobserver: {position: [${before}], target: [${at}], up: [${up}], projection: perspective}\n`;
    };
    const head = `luxel: 1\n${isPhotometric ? 'units: photometric\n' : ''}screen: {width: 10, height: 10, resolution: [2, 2]}\nlights: []\n`;
    const changes = [
        { list: 'lights', index: 0, insert: own },
        { set: 'lights[0].enabled=true' },
        ...(law === null || law === 'inverse-square' ? [] : [{ set: 'lights[0].attenuation=inverse-square' }]),
    ];
    const [u, v, n] = basis(axis);
    const across = aside ? acrossOf(JSON.parse(aside) as number[], n) : null;
    const planes: Place[] = across ? [across, basis(n, across)[0]] : [u, v];
    const degrees = Array.from({ length: Math.round(360 / STEP) + 1 }, (_, i) => i * STEP - 180);
    const found: number[][] = [];
    for (const plane of planes) {
        const scenes: Of[] = [];
        for (const each of degrees) {
            const angle = (each * Math.PI) / 180;
            const direction = along([0, 0, 0], n, Math.cos(angle), plane, Math.sin(angle));
            const { text } = await worker.ask('edit', head + plate(direction), changes);
            if (text === null) return null;
            scenes.push({ ...of, text, irradiance: true, direct: true });
        }
        const values = await worker.ask('sweep', scenes, 0, 0);
        found.push(values.map((value) => (value ?? 0) * (FAR / 1000) ** 2));
    }
    return { of, degrees, planes: found };
}

// As much of a direction as is across an axis.
function acrossOf(direction: number[], axis: Place): Place {
    const share = direction.reduce((sum, c, i) => sum + c * axis[i], 0);
    const across = add(direction, axis, -share);
    const length = Math.hypot(...across) || 1;
    return across.map((c) => c / length) as Place;
}
