// SPDX-License-Identifier: MIT
// The core: starts the WebAssembly of web/core and hands texts, numbers and bytes to and fro.  It runs in the worker
// of the page, and in Node for the tests.
import { Folder } from './folder';
import { COLOUR_VIEWS, type ColourView } from './srgb';

export interface Message {
    error: boolean;
    line: number;
    column: number;
    length: number;
    key: string | null;
    message: string;
    hint: string;
}

export interface Extremum {
    exists: boolean;
    value: number;
    x: number;
    y: number;
}

export interface PictureFacts {
    columns: number;
    rows: number;
    unit: string;
    word: string;
    maximum: Extremum;
    minimum: Extremum;
    mean: number;
    lit: number;
    reflected: number | null; // bounds the error of light between surfaces, as a share of the maximum; null: there is none
    reached: boolean; // whether that is as small as it should be
    colour: boolean; // whether the scene is computed in colour
    mirrored: number | null; // the same of light over more mirrors than are counted; null: no bound is known
}

/** The values of pixels, and whether each has one. */
export interface Samples {
    values: Float32Array<ArrayBuffer>;
    mask: Uint8Array<ArrayBuffer>;
    rgb?: Float32Array<ArrayBuffer>; // of a picture in colour, 3 channels for each pixel
    levels?: Uint8Array<ArrayBuffer>; // likewise, as its PNG file has them
}

/** The colour of a value: channels in linear sRGB with their bounds, and what they mean. */
export interface Colour {
    rgb: number[];
    error: number[];
    xy: number[] | null;
    cct: number | null; // K; null: there is none
    duv: number | null;
}

export interface Probe {
    surface: number | null;
    part: string | null;
    value: number | null;
    error: number;
    position: number[];
    normal: number[];
    shares: number[];
}

/** What an answer is found to be, as `luxel grade` finds it. */
export interface Judgement {
    verdict: 'right' | 'convention' | 'wrong' | 'coarse'; // coarse: right, but of fewer than three digits
    value: number | null;
    error: number;
    explanations: string[]; // of a convention that gives the answer
}

/** A number and the bound of its error. */
export type Amount = [number, number];

export interface LitSide {
    surface: number;
    name: string | null;
    part: string | null;
    side: string | null; // null: goes without saying
    irradiance: Amount;
}

/** Where the light of a scene stays whose surfaces reflect it. */
export interface Balance {
    unit: string;
    flux_unit: string;
    sides: LitSide[];
    emitted?: Amount;
    missed?: Amount;
    arrives: Amount;
    absorbed: Amount;
    escaped: Amount;
    pending?: Amount;
    difference: Amount;
    closes: boolean;
}

export interface GridExtremum {
    value: number;
    position: number[];
}

/** A limit of a grid or an observer, and whether it is kept. */
export interface Limit {
    name: string; // the key, such as "average"
    word: string; // what it is of, as people read it
    wanted: number;
    is_most: boolean; // the greatest value that is good, rather than the least
    has_unit: boolean; // that of the values
    above?: number; // of a share of cells: the value that these have at least
    value: number | null;
    error: number | null;
    verdict: 'pass' | 'fail' | 'undecided';
}

/** A strip around a grid, as the rectangle that it fills with it. */
export interface Area {
    center: number[];
    size: number[];
    average: Amount;
}

/** A measuring grid: the irradiance in its cells, rows from the top. */
export interface Grid {
    name: string | null;
    columns: number;
    rows: number;
    center: number[];
    size: number[]; // along across, and along up
    across: number[];
    up: number[];
    unit: string;
    values: (number | null)[];
    measured: number; // cells that have a value
    average: Amount;
    minimum: GridExtremum;
    maximum: GridExtremum;
    u0?: number;
    ud?: number;
    surround: Area | null;
    background: Area | null;
    limits: Limit[];
}

/** Daylight factors of measuring grids, in percent of what falls on a horizontal plane under the open sky. */
export interface Daylight {
    horizontal: Amount;
    levels: number[]; // in lx, of EN 17037
    grids: {
        values: (number | null)[];
        measured: number;
        mean: Amount;
        median: Amount;
        shares: (number | null)[]; // of the cells that reach each level, 0 to 1; null: units are radiometric
    }[];
}

/** Observers that are one entry of a scene, and how much the lights dazzle them at most. */
export interface Rated {
    name: string | null;
    eye: number[]; // of the first of them
    view: number[];
    places: number;
    ugr?: Amount; // none where nothing dazzles, or the background is dark
    limits: Limit[];
}

/** What a scene measures, and whether it keeps its limits. */
export interface Measured {
    grids: Grid[];
    observers: Rated[];
}

export interface LightFacts {
    type: string;
    label: string; // the type as people read it
    name: string | null;
    enabled: boolean;
    place: number[] | null;
    direction: number[] | null;
    flux: number | null; // null or negative: it has none
}

export interface SceneFacts {
    columns: number;
    rows: number;
    unit: string;
    word: string;
    irradiance_unit: string;
    grids: number;
    observers: number; // whom lights may dazzle
    lights: LightFacts[];
    surfaces: ({ center: number[]; reach: number } | null)[];
    points: number[][];
}

export interface Key {
    path: string;
    variant: string | null;
    type: number;
    count: number;
    choices: string | null;
    labels: string[]; // of the choices, as people read them
    unit: string;
    photometric: string;
    label: string;
    meaning: string;
    legal: string | null;
    advised: [number | null, number | null] | null;
}

export interface Kind {
    list: string;
    name: string;
    label: string; // the name as people read it
    meaning: string;
    example: string | null;
}

export interface Builtin {
    name: string;
    title: string;
    text: string;
}

export interface Isophote {
    level: number;
    closed: boolean;
    x: number[];
    y: number[];
}

export interface Summary {
    pixels: number;
    maximum: Extremum;
    minimum: Extremum;
    mean: number;
    median: number;
    deviation: number;
    u0: number | null;
}

export interface Peak {
    value: number;
    x: number;
    y: number;
    position: number[];
    place: number; // as luxel/extrema.h numbers them: inside, limb, border, jump, plateau
}

/** What went wrong in the core itself, not in a scene: it is to be started anew. */
export class CoreFailure extends Error {}

/** Why a call of a core without its second part was given up halfway: it needs that part, and a new core. */
export class PartMissing extends Error {}

// The names by which web/split.mjs has the two parts take functions from each other, and that of their identity.
const PLACEHOLDER = 'placeholder';
const FIRST_PART = 'first';
const IDENTITY = 'luxel-core';

/** Whether two parts are of one core: those of different builds would call wrong functions. */
export function belongTogether(first: WebAssembly.Module, second: WebAssembly.Module): boolean {
    const [a, b] = [first, second].map((part) =>
        WebAssembly.Module.customSections(part, IDENTITY).map((section) => new Uint8Array(section).join()),
    );
    return a.length === 1 && a[0] === b[0];
}

type Exports = Record<string, (...numbers: number[]) => number>;

// What WASI calls a file that is not there, what a call of the system that there is not.
const BAD_FILE = 8;
const NO_SUCH_CALL = -52; // ENOSYS

export class Core {
    protected call!: Exports;
    protected memory!: WebAssembly.Memory;
    private table!: WebAssembly.Table;
    private words: Record<string, string> = {};
    private places = new Map<string, number>();
    private highBits = 0;
    /** The files that scenes name. */
    readonly folder = new Folder(() => this.memory.buffer as ArrayBuffer);

    /** Whether the second part is there. */
    isWhole = false;
    /** Told the share done, 0 to 1, while the core is busy; thousands of times a second. */
    onProgress: (done: number) => void = () => undefined;

    /** Starts the first part; the second one can be given now or later. */
    static async start<T extends Core>(
        this: new () => T,
        first: WebAssembly.Module,
        second: WebAssembly.Module | null = null,
    ): Promise<T> {
        const core = new this();
        const imports: WebAssembly.Imports = {};
        for (const { module: from, name, kind } of WebAssembly.Module.imports(first)) {
            if (kind !== 'function') throw new CoreFailure(`the core wants a ${kind}, ${from}.${name}`);
            (imports[from] ??= {})[name] = from === PLACEHOLDER ? core.missing(name) : core.imported(name);
        }
        const { exports } = await WebAssembly.instantiate(first, imports);
        core.memory = exports.memory as WebAssembly.Memory;
        core.table = exports.__indirect_function_table as WebAssembly.Table;
        core.call = exports as unknown as Exports;
        if (second) core.complete(second);
        core.call._initialize();
        return core;
    }

    /** Takes the second part, which puts its functions into the first one's table, in place of the placeholders. */
    complete(second: WebAssembly.Module) {
        new WebAssembly.Instance(second, { [FIRST_PART]: this.call });
        this.isWhole = true;
    }

    // What stands in the table for a function of the second part until that is there.
    private missing(name: string): () => never {
        return () => {
            if (this.isWhole) throw new CoreFailure(`the core's second part lacks function ${name}`);
            throw new PartMissing("the core's second part has not been loaded");
        };
    }

    /** The texts that the core translates, by the English ones; those asked for before stay. */
    translate(words: Record<string, string>): void {
        this.words = words;
        this.places.clear();
    }

    // What the core imports: the clock, texts, long jumps, and the calls that read the files of the folder.
    private imported(name: string): (...numbers: any[]) => any {
        if (name.startsWith('invoke_')) return this.invoke.bind(this);
        switch (name) {
            case 'page_translation':
                return (place: number) => this.translation(place);
            case '_emscripten_throw_longjmp':
                return () => {
                    throw Infinity;
                };
            case 'setTempRet0':
                return (bits: number) => void (this.highBits = bits);
            case 'getTempRet0':
                return () => this.highBits;
            case 'clock_time_get':
                // Clock 0 tells the time of day: by it files of the folder, which have no date, are old from the start.
                return (clock: number, _precision: bigint, at: number) => {
                    const milliseconds = clock === 0 ? Date.now() : performance.now();
                    this.data().setBigUint64(at, BigInt(Math.round(milliseconds * 1000)) * 1000n, true);
                    return 0;
                };
            case 'environ_sizes_get':
                return (count: number, size: number) => {
                    this.data().setUint32(count, 0, true);
                    this.data().setUint32(size, 0, true);
                    return 0;
                };
            case 'environ_get':
                return () => 0;
            case 'emscripten_notify_memory_growth':
                return () => undefined;
            case 'proc_exit':
                return (code: number) => {
                    throw new CoreFailure(`the core ended with ${code}`);
                };
            case 'page_progress':
                return (done: number) => this.onProgress(done);
            case 'page_opened':
                return (path: number) => this.folder.open(this.text(path) ?? '');
            case '__syscall_stat64':
                return (path: number, at: number) => this.folder.state(this.text(path) ?? '', at);
            case '__syscall_fstat64':
                return (file: number, at: number) => this.folder.stateOfOpen(file, at);
            case 'fd_read':
                return (file: number, places: number, count: number, done: number) =>
                    this.folder.read(file, places, count, null, done);
            case 'fd_pread':
                return (file: number, places: number, count: number, from: bigint, done: number) =>
                    this.folder.read(file, places, count, from, done);
            case 'fd_close':
                return (file: number) => this.folder.close(file);
            default:
                if (name.startsWith('fd_')) return () => BAD_FILE;
                return () => NO_SUCH_CALL;
        }
    }

    // A function that may end with a long jump: libpng's way to report a failure.
    private invoke(index: number, ...rest: number[]): number | undefined {
        const stack = this.call.stackSave();
        try {
            return this.table.get(index)(...rest);
        } catch (thrown) {
            this.call.stackRestore(stack);
            if (thrown !== Infinity) throw thrown;
            this.call.setThrew(1, 0);
            return undefined;
        }
    }

    private translation(place: number): number {
        const english = this.text(place) ?? '';
        const known = this.places.get(english);
        if (known !== undefined) return known;
        const word = this.words[english];
        const made = word ? this.put(word)[0] : 0;
        this.places.set(english, made);
        return made;
    }

    private data(): DataView {
        return new DataView(this.memory.buffer);
    }

    protected text(place: number): string | null {
        if (!place) return null;
        const bytes = new Uint8Array(this.memory.buffer);
        return new TextDecoder().decode(bytes.subarray(place, bytes.indexOf(0, place)));
    }

    // Copies a text with a 0 behind it into memory that the caller frees; its place and length in bytes.
    private put(text: string): [number, number] {
        const bytes = new TextEncoder().encode(text);
        return this.putBytes(bytes);
    }

    private putBytes(bytes: Uint8Array): [number, number] {
        const place = this.call.page_memory(bytes.length + 1);
        if (!place) throw new CoreFailure('memory is short');
        const memory = new Uint8Array(this.memory.buffer);
        memory.set(bytes, place);
        memory[place + bytes.length] = 0;
        return [place, bytes.length];
    }

    protected withTexts<T>(texts: string[], use: (...places: number[]) => T): T {
        const places = texts.map((text) => this.put(text)[0]);
        try {
            return use(...places);
        } finally {
            places.forEach((place) => this.call.page_free(place));
        }
    }

    protected withNumbers(numbers: number[], use: (place: number) => number): number {
        const place = this.call.page_memory(8 * numbers.length);
        if (!place) throw new CoreFailure('memory is short');
        new Float64Array(this.memory.buffer, place, numbers.length).set(numbers);
        const answer = use(place);
        this.call.page_free(place);
        return answer;
    }

    protected json<T>(place: number): T | null {
        const text = this.text(place);
        return text === null ? null : (JSON.parse(text) as T);
    }

    /** Judges a text or a picture that carries its scene; true: it is the present scene now. */
    open(scene: string | Uint8Array, name = 'scene.yaml'): boolean {
        const [place, length] = typeof scene === 'string' ? this.put(scene) : this.putBytes(scene);
        try {
            return this.withTexts([name], (at) => this.call.page_open(place, length, at) === 0);
        } finally {
            this.call.page_free(place);
        }
    }

    messages(): Message[] {
        return this.json<Message[]>(this.call.page_messages()) ?? [];
    }

    quantity(irradiance: boolean): void {
        this.call.page_quantity(irradiance ? 1 : 0);
    }

    /** Whether only direct light is computed, whatever the scene says. */
    direct(isDirect: boolean): void {
        this.call.page_direct(isDirect ? 1 : 0);
    }

    /** In how many seconds reflected light is solved for, as well as goes; 0: as exactly as it should be. */
    within(seconds: number): void {
        this.call.page_within(seconds);
    }

    /** Changes a text: assignments KEY=VALUE, elements put into lists, keys taken out.  Null: it does not go. */
    edit(text: string | Uint8Array, changes: Change[]): string | null {
        const [place, length] = typeof text === 'string' ? this.put(text) : this.putBytes(text);
        try {
            if (this.call.page_edit(place, length) !== 0) return null;
            for (const change of changes) if (!this.change(change)) return null;
            return this.text(this.call.page_edited());
        } finally {
            this.call.page_free(place);
        }
    }

    /** A light of a kind, or one in YAML, that fits a text and is like a chosen one, or stands in its place; null: it does not go. */
    newLight(text: string, wanted: string, like: number, replaces: boolean): { index: number; light: string } | null {
        if (this.edit(text, []) === null) return null;
        return this.json(this.withTexts([wanted], (kind) => this.call.page_new_light(kind, like, replaces ? 1 : 0)));
    }

    private change(change: Change): boolean {
        if ('set' in change) return this.withTexts([change.set], (at) => this.call.page_set(at)) === 0;
        if ('remove' in change) return this.withTexts([change.remove], (at) => this.call.page_remove(at)) === 0;
        const { list, index, insert } = change;
        return this.withTexts([list, insert], (at, value) => this.call.page_insert(at, index, value)) === 0;
    }

    get(key: string): string | null {
        return this.text(this.withTexts([key], (at) => this.call.page_get(at)));
    }

    render(stride: number): boolean {
        return this.call.page_render(stride) === 0;
    }

    picture(): PictureFacts {
        const facts = this.json<PictureFacts>(this.call.page_picture());
        if (!facts) throw new CoreFailure('there is no picture');
        return facts;
    }

    /** Copies of the samples and of the mask of the last picture. */
    samples(): Samples {
        const { columns, rows } = this.picture();
        const pixels = columns * rows;
        const samples = this.copies(this.call.page_values(), this.call.page_mask(), this.call.page_rgb(), pixels);
        return samples.rgb ? { ...samples, levels: this.levels(pixels) } : samples;
    }

    private copies(values: number, mask: number, rgb: number, pixels: number): Samples {
        const memory = this.memory.buffer as ArrayBuffer;
        return {
            values: new Float32Array(memory, values, pixels).slice(),
            mask: new Uint8Array(memory, mask, pixels).slice(),
            ...(rgb ? { rgb: new Float32Array(memory, rgb, 3 * pixels).slice() } : {}),
        };
    }

    private levels(pixels: number): Uint8Array<ArrayBuffer> {
        const place = this.call.page_memory(3 * pixels);
        if (!place) throw new CoreFailure('memory is short');
        this.call.page_srgb(place);
        const levels = new Uint8Array(this.memory.buffer as ArrayBuffer, place, 3 * pixels).slice();
        this.call.page_free(place);
        return levels;
    }

    /** Which view of pictures in colour is shown. */
    view(view: ColourView = 'luminance'): void {
        this.call.page_view(COLOUR_VIEWS.indexOf(view));
    }

    /** The colour of the value at a point; null: the scene is grey, or nothing is there. */
    color(x: number, y: number): Colour | null {
        return this.json<Colour>(this.call.page_color(x, y));
    }

    /** The channels of each light at luminance 1. */
    lightColors(): number[][] {
        return this.json<number[][]>(this.call.page_light_colors()) ?? [];
    }

    /** The channels of a black body at luminance 1. */
    blackBody(kelvin: number): number[] {
        return this.json<number[]>(this.call.page_black_body(kelvin)) ?? [1, 1, 1];
    }

    /** The bytes of a file that the tool would write, or null where messages() tell why not. */
    file(name: string): Uint8Array<ArrayBuffer> | null {
        const length = this.call.page_memory(4);
        const place = this.withTexts([name], (at) => this.call.page_file(at, length));
        const count = this.data().getUint32(length, true);
        const bytes = place ? new Uint8Array(this.memory.buffer as ArrayBuffer, place, count).slice() : null;
        this.call.page_free(place);
        this.call.page_free(length);
        return bytes;
    }

    probe(x: number, y: number): Probe | null {
        return this.json<Probe>(this.call.page_probe(x, y));
    }

    /** The irradiance at the place of a probe, with each light's part of it. */
    lit(x: number, y: number): Probe | null {
        return this.json<Probe>(this.call.page_lit(x, y));
    }

    /** The text of the exercise's variant with a number; null: there is none. */
    variant(number: number): string | null {
        return this.text(this.call.page_variant(number));
    }

    /** Judges what was typed for a point of the screen; null: it is no number. */
    answer(typed: string, x: number, y: number, tolerance: number): Judgement | null {
        return this.json<Judgement>(this.withTexts([typed], (at) => this.call.page_judge(at, x, y, tolerance)));
    }

    explain(x: number, y: number, format: number, language: string): string | null {
        return this.text(this.withTexts([language], (code) => this.call.page_explain(x, y, format, code)));
    }

    /** The greatest and the least value of the exact function. */
    extrema(): Peak[] | null {
        return this.json(this.call.page_extrema());
    }

    version(): string {
        return this.text(this.call.page_version()) ?? '';
    }

    summary(): Summary | null {
        return this.json(this.call.page_summary());
    }

    /** The balance of the flux; null: the scene has no reflected light. */
    balance(): Balance | null {
        return this.json(this.call.page_balance());
    }

    /** The way to the sun of a text whose only light is one; null: it has errors, or the sun has set. */
    sun(text: string): number[] | null {
        const [place, length] = this.put(text);
        try {
            return this.json<number[]>(this.call.page_sun(place, length));
        } finally {
            this.call.page_free(place);
        }
    }

    /** The measuring grids and the observers; null: one cannot be measured. */
    grids(): Measured | null {
        return this.json(this.call.page_grids());
    }

    /** The daylight factors of the measuring grids; null: no sky shines, or they cannot be found. */
    daylight(): Daylight | null {
        return this.json(this.call.page_daylight());
    }

    /** The ends of the line across the whole screen, through a point at an angle. */
    line(x: number, y: number, degrees: number): [number[], number[]] | null {
        return this.json(this.call.page_line(x, y, degrees));
    }

    isophotes(wanted: number, logarithmic: boolean): Isophote[] {
        return this.json<Isophote[]>(this.call.page_isophotes(wanted, logarithmic ? 1 : 0)) ?? [];
    }

    scene(): SceneFacts | null {
        return this.json<SceneFacts>(this.call.page_scene());
    }

    /** What another camera sees of the scene in so many pixels, in rows from the top; null: it sees nothing. */
    stage(camera: number[], columns: number, rows: number): Samples | null {
        if (this.withNumbers(camera, (place) => this.call.page_stage(place, columns, rows)) !== 0) return null;
        const { page_stage_values: values, page_stage_mask: mask, page_stage_rgb: rgb } = this.call;
        return this.copies(values(), mask(), rgb(), columns * rows);
    }

    /** How far it is from a camera, in mm along its line of view, to what each of so many pixels shows; 0: nothing. */
    stageDepth(camera: number[], columns: number, rows: number): Float32Array<ArrayBuffer> | null {
        const place = this.withNumbers(camera, (at) => this.call.page_stage_depth(at, columns, rows));
        return place ? new Float32Array(this.memory.buffer as ArrayBuffer, place, columns * rows).slice() : null;
    }

    /** The exact value that a camera of so many pixels sees through a point of its screen. */
    stageProbe(camera: number[], columns: number, rows: number, x: number, y: number): Probe | null {
        return this.json<Probe>(
            this.withNumbers(camera, (place) => this.call.page_stage_probe(place, columns, rows, x, y)),
        );
    }

    /** Where a place is seen on the screen, and its height above it. */
    project(place: number[]): number[] | null {
        return this.json<number[]>(this.call.page_project(place[0], place[1], place[2]));
    }

    unproject(x: number, y: number, height: number): number[] | null {
        return this.json<number[]>(this.call.page_unproject(x, y, height));
    }

    parameters(): { keys: Key[]; kinds: Kind[] } {
        return this.json<{ keys: Key[]; kinds: Kind[] }>(this.call.page_parameters()) ?? { keys: [], kinds: [] };
    }

    builtins(): Builtin[] {
        return this.json<Builtin[]>(this.call.page_builtins()) ?? [];
    }
}

export type Change = { set: string } | { remove: string } | { list: string; index: number; insert: string };
