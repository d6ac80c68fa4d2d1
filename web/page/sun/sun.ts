// SPDX-License-Identifier: MIT
// The sun of a light, its own or that of a sky: where it stands by altitude and azimuth, or by date and place, and what is
// changed as a hand takes it along its dome.  Where it stands is the core's answer; what is found here is by how much the hour
// differs.
import type { Change } from '../core';
import type { Thing } from '../geometry';
import { add, along, cross, dot, unit, type Place } from '../space_math';
import { number, t } from '../words';

/** A sun: the group of its keys, the ways that are up, north and east, and the way to it. */
export interface Sun {
    base: string; // "lights[0]", "lights[1].sun"
    up: Place;
    north: Place;
    east: Place;
    towards: Place;
    date?: string; // without it altitude and azimuth count
    latitude?: number; // degrees
    longitude?: number;
}

const DAY = 24 * 60; // minutes
const LOWEST = 0.3; // degrees above the horizon that a hand brings it down to
const SAME = 1e-4; // between ways to suns that are one
const degrees = (radians: number) => (radians * 180) / Math.PI;
const radians = (angle: number) => (angle * Math.PI) / 180;

/** A scene whose only light is the sun of a group of keys, as the core is asked where it stands. */
export function sunAlone(keys: [string, string][]): string {
    return `luxel: 1\nscreen: {width: 1, height: 1, resolution: [1, 1]}\nobserver: {z: 1}\nsurfaces: []\nlights: [{type: sun, irradiance: 1, ${keys.map(([key, value]) => `${key}: ${value}`).join(', ')}}]\n`;
}

/** Ways that are up, north and east, as scenes have them; north that runs along up was not given. */
export function ground(up: number[] | null, north: number[] | null): Pick<Sun, 'up' | 'north' | 'east'> {
    const u = unit(up ?? [0, 0, 1]);
    const wanted = north && Math.hypot(...cross(u, unit(north))) > 1e-6 ? north : [0, 0, -1];
    const n = unit(add(wanted, u, -dot(wanted, u)));
    return { up: u, north: n, east: cross(n, u) };
}

/** Altitude and azimuth of a way, in degrees. */
export function stand({ up, north, east }: Sun, way: number[]): [number, number] {
    const azimuth = degrees(Math.atan2(dot(way, east), dot(way, north)));
    return [degrees(Math.asin(Math.max(-1, Math.min(1, dot(way, up))))), (azimuth + 360) % 360];
}

/** A date of a scene: the day, the minutes of its clock, and how the clock stands to UTC, as it is written. */
export interface Moment {
    day: string; // "2026-06-21"
    minutes: number;
    zone: string;
}

export function momentOf(date: string): Moment | null {
    const found = /^(\d{4}-\d\d-\d\d)T(\d\d):(\d\d)(?::(\d\d(?:\.\d+)?))?(Z|[+-]\d\d:\d\d)?$/.exec(date);
    if (!found) return null;
    return { day: found[1], minutes: 60 * Number(found[2]) + Number(found[3]) + Number(found[4] ?? 0) / 60, zone: found[5] ?? '' };
}

const two = (value: number) => String(Math.floor(value)).padStart(2, '0');

/** The time of a clock. */
export function clock(minutes: number): string {
    return `${two(minutes / 60)}:${two(minutes % 60)}`;
}

export function dateOf({ day, minutes, zone }: Moment): string {
    return `${day}T${clock(minutes)}${zone}`;
}

// A way as the turning sky has it: towards where the equator culminates, towards west, towards the pole; 1: all of it.
function turning({ up, north, east, latitude = 0 }: Sun, way: number[]): [number, number, number] {
    const [u, n] = [dot(way, up), dot(way, north)];
    const [s, c] = [Math.sin(radians(latitude)), Math.cos(radians(latitude))];
    return [u * c - n * s, -dot(way, east), u * s + n * c];
}

// The hour angle up to which the sun of the day is above the horizon, in radians.
function longest(sun: Sun): number {
    const declination = Math.asin(Math.max(-1, Math.min(1, turning(sun, sun.towards)[2])));
    const lowest = Math.sin(radians(LOWEST));
    const [s, c] = [Math.sin(radians(sun.latitude ?? 0)), Math.cos(radians(sun.latitude ?? 0))];
    const cosine = (lowest - s * Math.sin(declination)) / (c * Math.cos(declination));
    return Math.acos(Math.max(-1, Math.min(1, cosine)));
}

/** The way of the sun over its day, from rise to set; of a sun without a date, up from the horizon. */
export function wayOf(sun: Sun): Place[] {
    const steps = Array.from({ length: 49 }, (_, i) => i / 48);
    const { up, north, east, towards } = sun;
    if (!sun.date) {
        const flat = unit(add(towards, up, -dot(towards, up)));
        return steps.map((share) => along([0, 0, 0], flat, Math.cos((share * Math.PI) / 2), up, Math.sin((share * Math.PI) / 2)));
    }
    const most = longest(sun);
    const [, , z] = turning(sun, towards);
    const round = Math.sqrt(Math.max(0, 1 - z * z));
    const [s, c] = [Math.sin(radians(sun.latitude ?? 0)), Math.cos(radians(sun.latitude ?? 0))];
    return steps.map((share) => {
        const hour = most * (2 * share - 1);
        const x = round * Math.cos(hour);
        return add(along([0, 0, 0], up, x * c + z * s, north, z * c - x * s), east, -round * Math.sin(hour));
    });
}

/** What brings a sun to a way that a hand wants: the hour of its day, or altitude and azimuth; and what is told of it. */
function movedTo(sun: Sun, way: Place): { set: [string, string][]; told: string } {
    const moment = sun.date ? momentOf(sun.date) : null;
    if (moment) {
        const hourOf = (each: number[]) => Math.atan2(turning(sun, each)[1], turning(sun, each)[0]);
        const most = longest(sun);
        const by = Math.max(-most, Math.min(most, hourOf(way))) - hourOf(sun.towards);
        const minutes = Math.max(0, Math.min(DAY - 1, Math.round(moment.minutes + (by * DAY) / (2 * Math.PI))));
        return { set: [['date', `"${dateOf({ ...moment, minutes })}"`]], told: `${moment.day} ${clock(minutes)}` };
    }
    const [altitude, azimuth] = stand(sun, way).map((angle) => Number(angle.toFixed(1)));
    const high = Math.max(LOWEST, altitude);
    return { set: [['altitude', String(high)], ['azimuth', String(azimuth)]], told: angles(high, azimuth) };
}

const angles = (altitude: number, azimuth: number) => `${t('altitude')} ${number(altitude, 4)}°, ${t('azimuth')} ${number(azimuth, 4)}°`;

/** Where a sun stands, in words. */
export function standWords(sun: Sun): string {
    const [altitude, azimuth] = stand(sun, sun.towards).map((angle) => Number(angle.toFixed(1)));
    return angles(altitude, azimuth);
}

/** The changes by which a sun comes to where its handle is dragged, with all that stand where it stands, and what is told of it. */
export function sunMoves(things: Thing[], thing: Thing, to: number[]): { changes: Change[]; told: string } {
    const way = unit(to.map((c, axis) => c - thing.from![axis]));
    return { changes: sunsWith(things, thing.sun!).flatMap((sun) => setting(sun, movedTo(sun, way).set)), told: movedTo(thing.sun!, way).told };
}

/** The changes that set keys of a sun. */
export function setting({ base }: Pick<Sun, 'base'>, keys: [string, string][]): Change[] {
    return keys.map(([key, value]) => ({ set: `${base}.${key}=${value}` }));
}

/** A sun and those that are the same one: a sky's sun and that which shines. */
export function sunsWith(things: Thing[], { towards }: Sun): Sun[] {
    return things.flatMap(({ sun }) => (sun && sun.towards.every((c, axis) => Math.abs(c - towards[axis]) < SAME) ? [sun] : []));
}

/** Where a sun's handle stands, seen from a place. */
export function sunThing(index: number, sun: Sun, from: number[], far: number): Thing {
    return { kind: 'direction', index, key: `${sun.base}.sun`, at: add(from, sun.towards, far), from, sun };
}
