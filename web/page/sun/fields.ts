// SPDX-License-Identifier: MIT
// The form's fields of a sun: sliders for the day of the year and the hour beside its date, and the change from altitude and
// azimuth to date and place and back.  Suns that stand together go together.
import type { Change } from '../core';
import { h } from '../dom';
import type { Model } from '../model';
import { clock, dateOf, momentOf, setting, stand, sunsWith, type Moment, type Sun } from './sun';
import { t } from '../words';

const KEY = /^(lights\[\d+\](?:\.sun)?)\.(altitude|date)$/;
const STEP = 5; // minutes
const NOON = 12 * 60;
const LATITUDE = 50; // where nothing tells the place
const DAY = 864e5; // milliseconds

/** The group of keys of a sun that a key tells where it stands: its altitude or its date; null: it is another key. */
export function sunOf(path: string): string | null {
    return KEY.exec(path)?.[1] ?? null;
}

const firstDay = (year: number) => Date.UTC(year, 0, 1);
const yearOf = (day: string) => Number(day.slice(0, 4));
const dayOfYear = (day: string) => Math.round((Date.parse(`${day}T00:00Z`) - firstDay(yearOf(day))) / DAY);
const dayAt = (year: number, day: number) => new Date(firstDay(year) + day * DAY).toISOString().slice(0, 10);

function sunAt(model: Model, base: string): Sun | undefined {
    return model.things.find(({ sun }) => sun?.base === base)?.sun;
}

/** Sliders of the day and the hour of a date, and what shows a date of the scene in them. */
export function dateSliders(model: Model, path: string) {
    const base = sunOf(path)!;
    let present: Moment | null = null;
    let isSliding = false; // what the scene had before does not move a slider that a hand holds
    const slider = (label: string, most: number, step: number, change: (moment: Moment, at: number) => Moment) => {
        const told = h('output', { class: 'dim' });
        const input = h('input', { type: 'range', min: 0, max: most, step, 'aria-label': t(label) });
        input.addEventListener('input', () => {
            if (!present) return;
            isSliding = true;
            present = change(present, Number(input.value));
            tell();
            void take(`"${dateOf(present)}"`);
        });
        input.addEventListener('change', () => {
            isSliding = false;
            model.endStep();
        });
        return { input, told, row: h('span', { class: 'slid' }, input, told) };
    };
    const day = slider('Day of the year', 364, 1, (moment, at) => ({ ...moment, day: dayAt(yearOf(moment.day), at) }));
    const hour = slider('Time of day', 24 * 60 - STEP, STEP, (moment, minutes) => ({ ...moment, minutes }));
    const tell = () => {
        day.told.textContent = present?.day.slice(5) ?? '';
        hour.told.textContent = present ? clock(present.minutes) : '';
    };
    const take = model.newest((value) => {
        const sun = sunAt(model, base);
        const bases = sun ? sunsWith(model.things, sun).filter(({ date }) => date) : [];
        return model.change((bases.length ? bases : [{ base }]).flatMap((each) => setting(each, [['date', value]])), `slide ${path}`);
    });
    const update = (text: string | null) => {
        if (isSliding) return;
        present = text === null ? null : momentOf(text);
        for (const { row } of [day, hour]) row.hidden = !present;
        if (!present) return;
        day.input.value = String(dayOfYear(present.day));
        hour.input.value = String(Math.round(present.minutes));
        tell();
    };
    return { rows: [day.row, hour.row], update };
}

/** The button that has a sun stand by date and place rather than by altitude and azimuth, or the other way round. */
export function sunSwitch(model: Model, base: string): HTMLElement {
    const isDated = !!sunAt(model, base)?.date;
    const words = isDated ? 'By altitude and azimuth' : 'By date and place';
    return h('button', { type: 'button', class: 'link', onclick: () => void switched(model, base) }, t(words));
}

function switched(model: Model, base: string) {
    const sun = sunAt(model, base);
    if (!sun) return Promise.resolve(false);
    const removed = (keys: string[]): Change[] => keys.map((key) => ({ remove: `${base}.${key}` }));
    if (sun.date) {
        const [altitude, azimuth] = stand(sun, sun.towards).map((angle) => angle.toFixed(2));
        return model.change([...removed(['date', 'latitude', 'longitude']), ...setting(sun, [['altitude', altitude], ['azimuth', azimuth]])]);
    }
    return model.change([...removed(['altitude', 'azimuth']), ...setting(sun, Object.entries(placeAndDate(model)))]);
}

// Those of another sun of the scene, or noon of this day where the clock of this computer goes.
function placeAndDate(model: Model): Record<string, string> {
    const other = model.things.find(({ sun }) => sun?.date)?.sun;
    const now = new Date();
    const before = -now.getTimezoneOffset(); // minutes before UTC
    const zone = `${before < 0 ? '-' : '+'}${clock(Math.abs(before))}`;
    const day = `${now.getFullYear()}-${String(now.getMonth() + 1).padStart(2, '0')}-${String(now.getDate()).padStart(2, '0')}`;
    const longitude = Math.max(-180, Math.min(180, before / 4));
    if (other) return { date: `"${other.date}"`, latitude: String(other.latitude), longitude: String(other.longitude) };
    return { date: `"${dateOf({ day, minutes: NOON, zone })}"`, latitude: String(LATITUDE), longitude: String(longitude) };
}
