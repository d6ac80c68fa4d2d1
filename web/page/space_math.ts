// SPDX-License-Identifier: MIT
// Places and directions in space, as far as the space view draws with them.

export type Place = [number, number, number];

export function cross(a: number[], b: number[]): Place {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function unit(a: number[]): Place {
    const length = Math.hypot(...a) || 1;
    return [a[0] / length, a[1] / length, a[2] / length];
}

export function add(place: number[], direction: number[], distance: number): Place {
    return [0, 1, 2].map((axis) => place[axis] + distance * direction[axis]) as Place;
}

export function along(place: number[], u: number[], a: number, v: number[], b: number): Place {
    return add(add(place, u, a), v, b);
}

/** Two directions across an axis and the axis itself; the second lies with `up`, or with y (z along y), as scenes have it. */
export function basis(axis: number[], up?: number[]): [Place, Place, Place] {
    const n = unit(axis);
    let wanted = up ?? [0, 1, 0];
    if (Math.hypot(...cross(wanted, n)) < 1e-6) wanted = [0, 0, n[1] > 0 ? -1 : 1];
    const u = unit(cross(wanted, n));
    return [u, cross(n, u), n];
}

const STEPS = 64;

export function circle(center: number[], u: number[], v: number[], radius: number): Place[] {
    return Array.from({ length: STEPS }, (_, i) => {
        const angle = (2 * Math.PI * i) / STEPS;
        return along(center, u, radius * Math.cos(angle), v, radius * Math.sin(angle));
    });
}

export function dot(a: number[], b: number[]): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The axes of a body that is turned by degrees about x, then about y, then about z. */
export function turnedAxes(degrees: number[] = [0, 0, 0]): Place[] {
    const [[sx, cx], [sy, cy], [sz, cz]] = degrees.map((each) => [Math.sin((each * Math.PI) / 180), Math.cos((each * Math.PI) / 180)]);
    return [
        [cy * cz, cy * sz, -sy],
        [sx * sy * cz - cx * sz, sx * sy * sz + cx * cz, sx * cy],
        [cx * sy * cz + sx * sz, cx * sy * sz - sx * cz, cx * cy],
    ];
}

/** The twelve edges of a box, turned by degrees. */
export function edgesOf(center: number[], size: number[], turn?: number[]): [Place, Place][] {
    const axes = turnedAxes(turn);
    const half = (bits: number, axis: number) => (bits & (1 << axis) ? 0.5 : -0.5) * size[axis];
    const corner = (bits: number) => axes.reduce<Place>((place, along, axis) => add(place, along, half(bits, axis)), center as Place);
    const ends = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((bits) => [1, 2, 4].map((axis) => [bits, bits | axis]));
    return ends.filter(([from, to]) => from !== to).map(([from, to]) => [corner(from), corner(to)]);
}
