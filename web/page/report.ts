// SPDX-License-Identifier: MIT
// The report as one page of HTML: aim, task, parameters, pictures, results, conclusions, the calculation of the first point, and
// how to repeat it, in the sentences of the tool's report; each stands only where the numbers make it true.
import type { Client } from './client';
import { paint, type Scale } from './colours';
import type { Extremum, Isophote, Key, Peak, Probe, Summary } from './core';
import { NUMBER, NUMBERS, sceneKeys, WHOLE } from './keys';
import { placeOn, rowOn, type Section } from './line';
import { localized } from './local';
import type { Model } from './model';
import type { PictureView } from './picture';
import { Outdated } from './version';
import { bound, currentLanguage, number, t } from './words';

const INSIDE = 0,
    PLATEAU = 4; // places of extrema
const WIDTH = 640; // of pictures, in pixels

interface Facts {
    model: Model;
    word: (english: string) => string;
    quantity: string;
    unit: string;
    summary: Summary;
    maximum: Peak | null;
    minimum: Peak | null;
    probes: (Probe | null)[];
    atMaximum: Probe | null;
    sections: Section[]; // along x and y through the maximum
    isophotes: Isophote[];
    explanation: string;
}

function escaped(text: string): string {
    return text.replace(/[&<>"]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[sign]!);
}

function place(numbers: number[]): string {
    return `(${numbers.map((value) => number(Math.abs(value) < 1e-9 ? 0 : value, 6)).join('; ')})`;
}

const SAMPLES = 401; // of a section

async function gather(model: Model, view: PictureView, client: Client): Promise<Facts | null> {
    const { picture, scene } = model;
    const source = model.source();
    if (!scene || !picture || !source || !model.isSettled) return null;
    const { of } = source;
    const [summary, peaks] = [await client.ask('summary', of), await client.ask('extrema', of)];
    if (!summary) return null;
    const points = scene.points.length ? scene.points : [[0, 0]];
    const [maximum, minimum] = peaks ?? [null, null];
    const through = maximum ?? { x: 0, y: 0 };
    const valuesAt = async (places: number[][]) => {
        const told = await model.valuesAt(places);
        if (!told) throw new Outdated('the scene has changed');
        return told.probes;
    };
    const sections: Section[] = [];
    for (const degrees of [0, 90]) {
        const ends = await client.ask('line', of, through.x, through.y, degrees);
        if (!ends) continue;
        const [from, to] = ends;
        const probes = await valuesAt(Array.from({ length: SAMPLES }, (_, i) => placeOn(from, to, SAMPLES, i)));
        sections.push({ of, from, to, rows: probes.map((probe, i) => rowOn(from, to, SAMPLES, i, probe)) });
    }
    return {
        model,
        word: (english) => model.client.word(english),
        quantity: t(scene.word),
        unit: scene.unit === 'relative' ? t('relative') : scene.unit,
        summary,
        maximum,
        minimum,
        probes: await valuesAt(scene.points),
        atMaximum: maximum && (await client.ask('probe', of, maximum.x, maximum.y)),
        sections,
        isophotes: await model.isophotes(picture, view.scale.logarithmic),
        explanation: localized((await client.ask('explain', of, points[0][0], points[0][1], 3, currentLanguage())) ?? ''),
    };
}

/** A sentence of the tool in the present language, with its gaps filled. */
function sentence({ word }: Facts, english: string, ...gaps: string[]): string {
    return escaped(word(english)).replace(/\{(\d)\}/g, (_, i) => escaped(gaps[Number(i)] ?? ''));
}

function table(head: string[], rows: string[][]): string {
    const cells = (row: string[], tag: string) => row.map((cell) => `<${tag}>${escaped(cell)}</${tag}>`).join('');
    return `<div class="table"><table><thead><tr>${cells(head, 'th')}</tr></thead><tbody>${rows
        .map((row) => `<tr>${cells(row, 'td')}</tr>`)
        .join('')}</tbody></table></div>`;
}

// What the scene says of its screen and observer, and of each surface and light.
async function parameters({ model, word }: Facts): Promise<string> {
    const { keys } = await model.client.ask('parameters');
    const { lists, paths, values } = await sceneKeys(model, keys);
    const written = (value: string) => value.replace(/-?\d+(\.\d+)?(e[-+]?\d+)?/gi, (n) => number(Number(n), 12));
    const isNumber = ({ type }: Key) => type === NUMBER || type === NUMBERS || type === WHOLE;
    const rows = (matches: (path: string) => boolean) =>
        paths.flatMap(([path, key], i) => {
            const value = values[i];
            // What a room or box says of its walls one by one stands in the scene at the end.
            if (value === null || !matches(path) || path.includes('.materials.') || path.endsWith('.type')) return [];
            const unit = model.photometric ? key.photometric : key.unit;
            return [[path, key.label, isNumber(key) ? written(value) : value, unit === '1' ? '' : unit]];
        });
    const heads = [word('key'), word('meaning'), word('value'), ''];
    const part = (title: string, matches: (path: string) => boolean) =>
        `<h3>${escaped(title)}</h3>${table(heads, rows(matches))}`;
    const parts = [part(t('Scene'), (path) => !/^(surfaces|lights)\[/.test(path))];
    for (const [list, types] of lists)
        types.forEach((type, i) =>
            parts.push(
                part(`${t(list === 'surfaces' ? 'surface' : 'light')} ${i + 1}: ${type}`, (path) =>
                    path.startsWith(`${list}[${i}].`),
                ),
            ),
        );
    return parts.join('\n');
}

// The picture in the colours of a map; in false colour with lines of equal value and the points.
function drawn({ model, isophotes, summary }: Facts, map: Scale['map']): string {
    const { facts, values, mask } = model.picture!;
    const scale: Scale = { map, logarithmic: false, locked: true, low: 0, high: summary.maximum.value, exposure: 0 };
    const small = document.createElement('canvas');
    [small.width, small.height] = [facts.columns, facts.rows];
    const pixels = new ImageData(paint(values, mask, scale), facts.columns, facts.rows);
    small.getContext('2d')!.putImageData(pixels, 0, 0);
    if (map === 'grey') return small.toDataURL();
    const [width, height] = model.screen;
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [WIDTH, Math.round((WIDTH * height) / width)];
    const context = canvas.getContext('2d')!;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.drawImage(small, 0, 0, canvas.width, canvas.height);
    const at = (x: number, y: number): [number, number] => [
        (x / width + 0.5) * canvas.width,
        (0.5 - y / height) * canvas.height,
    ];
    context.strokeStyle = '#fff';
    for (const line of isophotes) {
        context.beginPath();
        line.x.forEach((x, i) => (i ? context.lineTo(...at(x, line.y[i])) : context.moveTo(...at(x, line.y[i]))));
        if (line.closed) context.closePath();
        context.stroke();
    }
    context.font = 'bold 14px sans-serif';
    (model.scene?.points ?? []).forEach(([x, y], i) => {
        const [cx, cy] = at(x, y);
        context.fillStyle = '#ff5db1';
        context.fillRect(cx - 3, cy - 3, 6, 6);
        context.fillText(`P${i + 1}`, cx + 6, cy - 4);
    });
    return canvas.toDataURL();
}

// The sections through the maximum as a drawing of two curves.
function curves({ sections, model }: Facts): string {
    const most = Math.max(...sections.flatMap(({ rows }) => rows.map((row) => row[1] ?? 0)), 1e-300);
    const longest = Math.max(...model.screen);
    const path = ({ rows }: Section) => {
        const length = rows[rows.length - 1][0] ?? 1;
        let drawing = false;
        return rows
            .map(([s, value]) => {
                const command = drawing ? 'L' : 'M';
                drawing = value !== null;
                if (value === null) return '';
                const x = 320 + (600 * ((s ?? 0) - length / 2)) / longest;
                return `${command}${x.toFixed(1)} ${(180 - (160 * value) / most).toFixed(1)}`;
            })
            .join('');
    };
    const lines = sections.map(
        (section, i) =>
            `<path d="${path(section)}" fill="none" stroke="${i ? '#d55e00' : '#0072b2'}" stroke-width="2"/>`,
    );
    const grid = [0, 0.5, 1]
        .map((share) => {
            const y = 180 - 160 * share;
            return `<path d="M20 ${y}H620" stroke="#999" stroke-width="0.5"/><text x="22" y="${y - 3}">${number(share * most, 3)}</text>`;
        })
        .join('');
    const ends = [-1, 0, 1]
        .map(
            (end) =>
                `<text x="${320 + 300 * end}" y="196" text-anchor="${['start', 'middle', 'end'][end + 1]}">${number((end * longest) / 2, 4)}</text>`,
        )
        .join('');
    const names = sections.map(
        (_, i) => `<text x="${560 + 30 * i}" y="14" fill="${i ? '#d55e00' : '#0072b2'}">${i ? 'y' : 'x'}</text>`,
    );
    return `<svg viewBox="0 0 640 200" width="640" font-size="11" fill="currentColor" role="img" aria-label="${t('Section')}">${grid}${lines.join('')}${ends}${names.join('')}</svg>`;
}

function results(facts: Facts): string {
    const { model, probes, summary, maximum, minimum, word, unit } = facts;
    const points = (model.scene?.points ?? []).map(([x, y], i) => {
        const probe = probes[i];
        const value = probe?.value ?? null;
        const none = probe?.surface === null ? word('off the surface') : word('a source lies on it');
        return [
            `P${i + 1}`,
            place([x, y]),
            value === null ? none : number(value, 12),
            value === null ? '' : bound(probe!.error + Math.abs(Number(value.toPrecision(12)) - value)),
        ];
    });
    const heads = ['point', '', 'exact value', 'error at most'].map((head) => (head ? word(head) : '(x; y)'));
    const peak = (name: string, found: Peak | null) =>
        found ? [[word(name), number(found.value, 6), found.place === PLATEAU ? '' : place([found.x, found.y])]] : [];
    const pixel = (name: string, found: Extremum) =>
        found.exists ? [[word(name), number(found.value, 6), place([found.x, found.y])]] : [];
    const statistics = [
        ...peak('true maximum', maximum),
        ...peak('true minimum', minimum),
        ...pixel('maximum of the pixels', summary.maximum),
        ...pixel('minimum of the pixels', summary.minimum),
        [word('mean'), number(summary.mean, 6), ''],
        [word('median'), number(summary.median, 6), ''],
        [word('standard deviation'), number(summary.deviation, 6), ''],
        ...(summary.u0 === null
            ? []
            : [[word('uniformity U0 = minimum of the pixels / mean'), number(summary.u0, 6), '']]),
    ];
    return [
        `<h3>${escaped(word('Points'))}</h3>`,
        points.length ? table(heads, points) : `<p>${sentence(facts, 'The scene asks for no points.')}</p>`,
        `<h3>${escaped(word('Extrema and means'))}</h3>`,
        `<p>${sentence(facts, 'True extrema are those of the exact function between the pixels; everything else is read off the {0} pixels that show a surface. Values in {1}.', String(summary.pixels), unit)}</p>`,
        table(['', word('value'), word('at x, y in mm')], statistics),
    ].join('\n');
}

// Within how many mm on each side a section falls to half of its greatest value.
function halfWidths({ rows }: Section, peak: number): [number, number] | null {
    const top = rows.reduce((best, row, i) => ((row[1] ?? 0) > (rows[best][1] ?? 0) ? i : best), 0);
    const fall = (step: number): number | null => {
        for (let i = top; i + step >= 0 && i + step < rows.length; i += step) {
            const [s0, v0] = rows[i];
            const [s1, v1] = rows[i + step];
            if (v0 === null || v1 === null) return null;
            if (v1 <= peak / 2) return Math.abs(s0! + ((s1! - s0!) * (v0 - peak / 2)) / (v0 - v1) - rows[top][0]!);
        }
        return null;
    };
    const [before, behind] = [fall(-1), fall(1)];
    return before === null || behind === null ? null : [before, behind];
}

const PEAKS = [
    'The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm of the surface.',
    'The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is on the edge of what is seen of the surface.',
    'The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm: that is on the edge of the screen; outside the picture it may be greater.',
    'The {0} is greatest, {1} {2}, at {3} mm on the screen, the point {4} mm, where it jumps or has a kink.',
];
const WIDTHS = [
    'Along x the value falls to half of the maximum within {0} mm to the left and {1} mm to the right.',
    'Along y the value falls to half of the maximum within {0} mm downwards and {1} mm upwards.',
];

function conclusions(facts: Facts): string[] {
    const { summary, maximum, quantity, unit, atMaximum, model, sections } = facts;
    const found: string[] = [];
    if (maximum && maximum.place === PLATEAU)
        found.push(
            maximum.value > 0
                ? sentence(
                      facts,
                      'The {0} has no peak: it is {1} {2} in a whole part of the surface.',
                      quantity,
                      number(maximum.value, 6),
                      unit,
                  )
                : sentence(facts, 'The {0} is 0 everywhere: the surface is dark.', quantity),
        );
    else if (maximum) {
        const english = PEAKS[maximum.place] ?? PEAKS[INSIDE];
        found.push(
            sentence(
                facts,
                english,
                quantity,
                number(maximum.value, 6),
                unit,
                place([maximum.x, maximum.y]),
                place(maximum.position),
            ),
        );
        const shares = atMaximum?.shares ?? [];
        const most = Math.max(...shares, 0);
        const first = shares.indexOf(most);
        if (shares.filter((share) => share > 0).length > 1 && maximum.value > 0) {
            const name = model.scene!.lights[first].name ?? `lights[${first}]`;
            found.push(
                sentence(
                    facts,
                    'Of the lights, {0} has the greatest share there: {1} % of the value.',
                    name,
                    number((100 * most) / maximum.value, 3),
                ),
            );
        }
        sections.forEach((section, i) => {
            const widths = halfWidths(section, maximum.value);
            if (widths) found.push(sentence(facts, WIDTHS[i], number(widths[0], 3), number(widths[1], 3)));
        });
    }
    if (summary.maximum.value > 0)
        found.push(
            sentence(
                facts,
                'The mean is {0} {1}, {2} % of the greatest value of a pixel.',
                number(summary.mean, 6),
                unit,
                number((100 * summary.mean) / summary.maximum.value, 3),
            ),
        );
    return found;
}

// Style and calculation are those of the core's explanation, which is a page of its own.
function calculation(html: string): { style: string; body: string } {
    // The policy of this page takes no styles, not even of a text that it only reads.
    const style = /<style>([^]*?)<\/style>/.exec(html)?.[1] ?? '';
    const bare = html.replace(/<style>[^]*?<\/style>/g, '').replace(/ style="[^"]*"/g, '');
    const page = new DOMParser().parseFromString(bare, 'text/html');
    page.querySelector('h1')?.remove();
    for (let level = 5; level >= 2; level--)
        for (const heading of page.querySelectorAll(`h${level}`)) {
            const lower = page.createElement(`h${level + 1}`);
            lower.append(...heading.childNodes);
            heading.replaceWith(lower);
        }
    return { style, body: page.body.innerHTML };
}

function kindOf({ model }: Facts): number {
    return ['brightness', 'luminance', 'irradiance', 'illuminance'].indexOf(model.scene!.word);
}

/** The whole page, or null where there is no picture without errors. */
export async function report(model: Model, view: PictureView, client: Client): Promise<string | null> {
    const facts = await gather(model, view, client);
    if (!facts) return null;
    const { word } = facts;
    const kind = ['brightness', 'luminance', 'irradiance', 'illuminance'][Math.max(0, kindOf(facts))];
    const { style, body } = calculation(facts.explanation);
    const title = sentence(facts, `Distribution of the ${kind} over lit surfaces`);
    let chapters = 0;
    const chapter = (english: string, ...parts: string[]) =>
        `<h2>${++chapters}. ${escaped(word(english))}</h2>\n${parts.join('\n')}`;
    const paragraph = (english: string, ...gaps: string[]) => `<p>${sentence(facts, english, ...gaps)}</p>`;
    const picture = (map: Scale['map'], english: string) =>
        `<figure><img src="${drawn(facts, map)}" alt="">` +
        `<figcaption>${sentence(facts, english)}</figcaption></figure>`;
    return `<!doctype html>
<html lang="${currentLanguage()}">
<head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${title}</title>
<style>${style} figure img { min-width: min(320px, 100%); image-rendering: auto; }</style></head>
<body>
<h1>${title}</h1>
${chapter('Aim of the work', paragraph(`To learn to compute how sources of light distribute the ${kind} over surfaces, and to show the distribution as a picture.`))}
${chapter('Task', paragraph(`Compute how the ${kind} is distributed over the surfaces below, seen on a screen, and show it as a picture of grey levels 0 to 255.`), paragraph(facts.probes.length ? 'Give its values in the points asked for, and the greatest and the least value.' : 'Give the greatest and the least value.'))}
${chapter('Parameters', await parameters(facts))}
${chapter('Pictures', picture('grey', 'The picture in grey levels.'), picture('viridis', 'False colour with lines of equal value.'), `<figure>${curves(facts)}<figcaption>${escaped(t('Sections along x and y through the maximum.'))}</figcaption></figure>`)}
${chapter('Results', results(facts))}
${chapter(
    'Conclusions',
    `<ul>${conclusions(facts)
        .map((each) => `<li>${each}</li>`)
        .join('\n')}</ul>`,
)}
${chapter('Method', body)}
${chapter('Repetition', paragraph('Computed by Luxel {0} from the scene below. Saved as {1}, it gives the same numbers by {2}, the same picture by {3}, and the calculation of each point step by step by {4}.', await model.client.ask('version'), 'scene.yaml', `luxel render scene.yaml${model.irradiance ? ' --quantity irradiance' : ''}`, `luxel render scene.yaml -o scene.png`, 'luxel explain scene.yaml'), ...(model.files.length ? [paragraph('The files that it names are looked for from its own folder.')] : []), `<pre>${escaped(model.wholeText)}</pre>`)}
</body>
</html>
`;
}
