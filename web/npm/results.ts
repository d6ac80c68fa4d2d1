// SPDX-License-Identifier: MIT
// What the package answers with, under the names of Luxel's Python package.  Lengths are in mm, values in the unit that
// stands beside them; null: there is none.
import type { SceneDocument, BuiltinName } from '#scene';

export type { SceneDocument, BuiltinName };

export type Vector = [number, number, number];
/** A place on the screen in mm: x to the right, y up, from its middle. */
export type Point = [number, number];

/** A number and the bound of its error: |value - truth| is at most that. */
export interface Amount {
    value: number;
    error: number;
}

/** What is wrong with a scene, or odd about it, and where it stands in the text. */
export interface Diagnostic {
    severity: 'error' | 'advice';
    message: string;
    /** How to mend it; "" where that goes without saying. */
    hint: string;
    /** The key that it is about, such as "lights[0].type". */
    key: string | null;
    /** From 1; 0: of no line. */
    line: number;
    column: number;
    mark_length: number;
}

/** How to compute. */
export interface Options {
    /** "brightness" unless it is given. */
    quantity?: 'brightness' | 'irradiance';
    /** Of exact values, relative; 1e-9 where there is no closed form. */
    tolerance?: number;
    /** So far may points be off that are taken together, as a share of the value. */
    light_error?: number;
    /** The bound wanted of light that surfaces send each other. */
    reflected_error?: number;
    /** Told the share done, 0 to 1, now and then. */
    progress?: (done: number) => void;
}

export interface PictureOptions extends Options {
    /** n: a quick look at each n-th column and row. */
    stride?: number;
}

/** Colour of a value in a scene with `channels: rgb`. */
export interface Color {
    /** Linear sRGB, whose luminance is the value. */
    rgb: Vector;
    error: Vector;
    /** Chromaticity of 1931; null where the luminance is 0. */
    xy: Point | null;
    /** The temperature of the nearest black body, in K. */
    cct: number | null;
    duv: number | null;
    uv: Point | null;
}

/** What one light gives to a probe. */
export interface Share {
    /** Index in the scene's list. */
    light: number;
    type: string;
    name: string | null;
    irradiance: number;
    diffuse: number;
    specular: number;
    error: number;
    /** Points that an extended source was split into; 0: there is a closed form. */
    parts: number;
    color: Color | null;
}

/** The exact value at one place. */
export interface Probe {
    screen_mm: Point | null;
    /** Column and row of the pixel that the place falls in. */
    pixel: [number, number] | null;
    on_surface: boolean;
    value: number | null;
    /** Bounds |value - truth|. */
    error: number | null;
    tolerance_reached: boolean;
    /** What the picture shows there. */
    pixel_value: number | null;
    position_mm: Vector | null;
    normal: Vector | null;
    /** The unit vector to the observer. */
    view: Vector | null;
    albedo: number | null;
    surface: number | null;
    surface_name: string | null;
    /** Of a room or box, such as "floor". */
    wall: string | null;
    lies_on_surface: boolean;
    enclosing_surface: number | null;
    /** The light that lies on the element, which then has no value. */
    blocking_light: number | null;
    /** What other surfaces send. */
    reflected: { irradiance: number; value: number; error: number } | null;
    color: Color | null;
    shares: Share[];
    unit: string;
}

/** A free surface element, wherever it is. */
export interface Element {
    position_mm: readonly number[];
    /** Of any length. */
    normal: readonly number[];
    /** The direction to the observer, else the scene's. */
    view?: readonly number[];
    /** Index of the surface whose material it has where it lies on none. */
    surface?: number;
}

/** The greatest or least pixel. */
export interface Extremum {
    value: number;
    column: number;
    row: number;
    x_mm: number;
    y_mm: number;
}

export interface Statistics {
    maximum: Extremum | null;
    /** Of the values from 1.2e-38 up. */
    minimum: Extremum | null;
    mean: number | null;
    /** Share of the pixels from 1.2e-38 up. */
    lit: number | null;
    /** How many show a surface. */
    pixels: number;
    /** Bounds what reflected light may be off, as a share of the maximum. */
    reflected_error: number | null;
}

/** A picture: rows from the top. */
export interface Field {
    columns: number;
    rows: number;
    channels: number;
    unit: string;
    quantity_word: string;
    /** The value of each pixel, 0 off the surfaces; of a picture in colour, the luminance. */
    values: Float32Array;
    /** Red, green and blue of each pixel in linear sRGB; null of a grey picture. */
    rgb: Float32Array | null;
    /** 1 where a surface is seen. */
    mask: Uint8Array;
    x_mm: number[] | null;
    y_mm: number[] | null;
    statistics: Statistics;
}

/** A true extremum of the exact function, between the pixels. */
export interface Peak {
    value: number;
    error: number;
    x_mm: number;
    y_mm: number;
    surface: number;
    wall: string | null;
    position_mm: Vector;
    normal: Vector;
    place: 'inside' | 'limb' | 'border' | 'jump' | 'plateau';
}

export interface Extrema {
    maximum: Peak | null;
    minimum: Peak | null;
}

export interface GridExtremum {
    value: number;
    column: number;
    row: number;
    position_mm: Vector;
}

/** A limit of a grid or of the areas around it, and whether it is kept. */
export interface Limit {
    /** The key, such as "average". */
    name: string;
    /** What it is of, in words. */
    word: string;
    wanted: number;
    /** The greatest value that is good, rather than the least. */
    is_most: boolean;
    /** Whether it has the unit of the values. */
    has_unit: boolean;
    /** The value that the cells of a share have at least. */
    above?: number;
    value: number | null;
    error: number | null;
    /** "undecided" where the bound of the value spans the limit. */
    verdict: 'pass' | 'fail' | 'undecided';
}

/** A measuring grid: the irradiance in its cells; row 0 is farthest along `up`. */
export interface Grid {
    name: string | null;
    measure: string;
    columns: number;
    rows: number;
    center_mm: Vector;
    size_mm: Point;
    axis: Vector;
    up: Vector;
    across: Vector;
    unit: string;
    /** Row by row; null where a cell has no value. */
    values: (number | null)[][];
    errors: (number | null)[][];
    measured: number;
    enclosed: number;
    error: number;
    average: number | null;
    average_error: number | null;
    minimum: GridExtremum | null;
    maximum: GridExtremum | null;
    /** minimum / average */
    u0: number | null;
    /** minimum / maximum */
    ud: number | null;
    /** Of the whole plane, its integral by its area. */
    mean: number | null;
    mean_error: number | null;
    flux: number | null;
    flux_error: number | null;
    flux_unit: string | null;
    sampling_error: number | null;
    sampling_is_bound: boolean;
    is_coarse: boolean;
    limits: Limit[];
    tolerance_reached: boolean;
}

export interface LitSide {
    surface: number;
    surface_name: string | null;
    wall: string | null;
    side: 'front' | 'back' | 'outside' | 'inside';
    area_m2: number;
    reflectance: number;
    direct: Amount;
    irradiance: Amount;
}

/** Where the light of a scene stays whose surfaces reflect it. */
export interface Balance {
    unit: string;
    flux_unit: string;
    sides: LitSide[];
    emitted: Amount | null;
    missed: Amount | null;
    arrives: Amount;
    absorbed: Amount;
    escaped: Amount;
    pending: Amount;
    difference: Amount;
    closes: boolean;
    reached: boolean;
}

export interface Light {
    type: string;
    name: string | null;
    enabled: boolean;
    flux: number | null;
    position_mm: Vector | null;
    direction: Vector | null;
}

/** A built-in scene. */
export interface Builtin {
    name: BuiltinName;
    title: string;
    text: string;
}

/** How a scene is opened. */
export interface OpenOptions {
    /** Stands in messages. */
    name?: string;
    /** What the scene names: photometry of lamps, meshes, clouds of points, by their names. */
    files?: Record<string, Uint8Array>;
}

export type Document = 'html' | 'markdown' | 'latex' | 'text';

/** What a Scene can do, here or in a worker. */
export interface SceneMethods {
    /** The scene as text, comments and layout kept, with what was changed since it was opened. */
    readonly text: string;
    /** Sets keys by the paths of `luxel -s`, `{'lights[0].intensity': 20}`, and checks the scene when all are set. */
    set(values: Readonly<Record<string, unknown>>): Promise<void>;
    /** The value of a key; null where there is neither a value nor a default. */
    get(key: string): Promise<unknown>;
    /** Puts an element into a list such as "lights", at its end unless a place is given. */
    insert(list: string, value: unknown, index?: number): Promise<void>;
    /** Takes out an element of a list or a key with its value. */
    remove(key: string): Promise<void>;
    /** Gives a file that the scene names, in place of an older one. */
    give(name: string, bytes: Uint8Array): Promise<void>;
    /** Computes the picture. */
    render(options?: PictureOptions): Promise<Field>;
    /** The bytes of the file that `luxel render -o` writes: .png, .exr, .npy, .pfm or .csv. */
    file(name: string, options?: Options): Promise<Uint8Array>;
    /** The exact values of the scene's points. */
    probe(places?: undefined, options?: Options): Promise<Probe[]>;
    /** The exact value at a point of the screen, or on a free element. */
    probe(place: Point | Element, options?: Options): Promise<Probe>;
    /** The exact values at points of the screen. */
    probe(places: readonly Point[], options?: Options): Promise<Probe[]>;
    /** The whole calculation of the value at a point, and what each other convention would give. */
    explain(point?: Point, options?: Options & { format?: Document }): Promise<string>;
    /** The true greatest and least value, between the pixels. */
    extrema(options?: Options): Promise<Extrema>;
    /** The measuring grids of the scene. */
    grids(options?: Options): Promise<Grid[]>;
    /** One of them, by its name or index. */
    grid(name?: string | number, options?: Options): Promise<Grid>;
    /** Mean irradiance of the sides of surfaces and the balance of the flux; null where surfaces reflect no light. */
    balance(options?: Options): Promise<Balance | null>;
    /** The lights with their flux, place and direction. */
    lights(): Promise<Light[]>;
    /** The conventions that decide the numbers, such as {sampling: "nodes"}. */
    conventions(): Promise<Record<string, string>>;
    /** What is legal but odd about the scene. */
    advice(): Promise<Diagnostic[]>;
    /** Lets go of the memory of the core; another question starts a new one. */
    close(): Promise<void>;
}

function shown(diagnostic: Diagnostic, name: string): string {
    const { line, column, message, hint } = diagnostic;
    return `${line ? `${name}:${line}:${column}: ` : ''}${message}${hint ? `\n  ${hint}` : ''}`;
}

/** What was asked for cannot be done; `message` shows every diagnostic with its place. */
export class LuxelError extends Error {
    override readonly name = 'LuxelError';

    constructor(
        readonly diagnostics: Diagnostic[],
        readonly scene = 'scene',
    ) {
        super(diagnostics.map((each) => shown(each, scene)).join('\n') || 'it cannot be done');
    }
}
