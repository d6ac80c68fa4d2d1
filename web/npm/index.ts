// SPDX-License-Identifier: MIT
// Luxel for programs: scenes that are opened, changed, rendered and probed, each by a core of its own.  A core begins
// with its first part; what that lacks fetches the second one, and is asked again of a core that has both.
import { CoreFailure, PartMissing, type Change } from '../page/core';
import { PackageCore } from './core';
import { exr, tagsOf } from './exr';
import { load } from './flow';
import { LuxelError } from './results';
import type {
    Balance, Builtin, BuiltinName, Diagnostic, Document, Element, Extrema, Field, Grid, Light, OpenOptions, Options,
    PictureOptions, Point, Probe, SceneDocument, SceneMethods, Vector,
} from './results'; // prettier-ignore
import { readFrom, readPart } from '#read';

export * from './results';

const FORMATS: Document[] = ['text', 'markdown', 'latex', 'html'];

let first: Promise<WebAssembly.Module> | null = null;
let second: Promise<WebAssembly.Module> | null = null;
let addresses: (string | URL)[] = [];

/** Says where the two parts of the core lie, where a bundler put them elsewhere than beside the package's code. */
export function parts(firstPart: string | URL, secondPart: string | URL): void {
    addresses = [firstPart, secondPart];
    first = second = null;
}

// One that could not be had is asked for again the next time.
function part(number: 1 | 2): Promise<WebAssembly.Module> {
    const address = addresses[number - 1];
    const coming = (number === 1 ? first : second) ?? (address ? readFrom(address) : readPart(number));
    if (number === 1) first = coming;
    else second = coming;
    coming.catch(() => (number === 1 ? (first = null) : (second = null)));
    return coming;
}

async function startCore(isWhole: boolean): Promise<PackageCore> {
    return PackageCore.start(await part(1), isWhole ? await part(2) : null);
}

/** Asks a core of nobody; that it has both parts from the start costs no second try. */
async function asked<T>(question: (core: PackageCore) => T): Promise<T> {
    return question(await startCore(true));
}

/** The built-in scenes. */
export async function builtinScenes(): Promise<Builtin[]> {
    return (await startCore(false)).builtins() as Builtin[];
}

/** The JSON Schema of scenes: every key with type, range, default and meaning. */
export function schema(): Promise<object> {
    return asked((core) => core.schema());
}

/** The version of Luxel. */
export async function version(): Promise<string> {
    return (await startCore(false)).version();
}

/** Says what a key of a scene is set to: JSON is YAML, too. */
function assignment(key: string, value: unknown): Change {
    return { set: `${key}=${JSON.stringify(value ?? null)}` };
}

export class Scene implements SceneMethods {
    private core: PackageCore | null = null;
    private last: Promise<unknown> = Promise.resolve();
    private readonly files: Map<string, Uint8Array>;

    private constructor(
        private written: string | Uint8Array,
        private readonly name: string,
        files: Record<string, Uint8Array> = {},
    ) {
        this.files = new Map(Object.entries(files));
    }

    /** Opens a scene: YAML or JSON as text, an object, or a PNG or EXR picture of Luxel that carries its scene. */
    static async open(
        source: string | SceneDocument | Uint8Array,
        { name = 'scene', files }: OpenOptions = {},
    ): Promise<Scene> {
        const isText = typeof source === 'string' || source instanceof Uint8Array;
        const scene = new Scene(isText ? source : JSON.stringify(source), name, files);
        await scene.ask((core) => {
            // Editing nothing gives the text, of pictures too.
            scene.written = core.edit(scene.written, []) ?? scene.written;
        });
        return scene;
    }

    /** Opens a built-in scene. */
    static async builtin(name: BuiltinName = 'report'): Promise<Scene> {
        const found = (await builtinScenes()).find((each) => each.name === name);
        if (!found) throw new RangeError(`there is no built-in scene ${JSON.stringify(name)}`);
        return Scene.open(found.text, { name });
    }

    get text(): string {
        return this.written as string;
    }

    private failed(core: PackageCore): LuxelError {
        return new LuxelError(diagnosticsOf(core), this.name);
    }

    private async begin(isWhole: boolean): Promise<PackageCore> {
        const core = await startCore(isWhole);
        for (const [name, bytes] of this.files) core.folder.put(name, bytes);
        core.settings({});
        if (!core.open(this.written, this.name)) throw this.failed(core);
        return core;
    }

    /** Answers, one question after the other.  A core whose second part is missing, or that failed, is given up. */
    private ask<T>(question: (core: PackageCore) => T): Promise<T> {
        const answered = async (isWhole: boolean) => question((this.core ??= await this.begin(isWhole)));
        const answer = this.last.then(async () => {
            try {
                return await answered(second !== null);
            } catch (error) {
                if (!(error instanceof LuxelError || error instanceof RangeError)) this.core = null;
                if (error instanceof WebAssembly.RuntimeError) throw new CoreFailure(error.message);
                if (!(error instanceof PartMissing)) throw error;
            }
            return answered(true);
        });
        this.last = answer.catch(() => undefined);
        return answer;
    }

    /** The same for what computes; null is a failure, whose reasons the core tells. */
    private compute<T>(options: Options, question: (core: PackageCore) => T | null): Promise<T> {
        return this.ask((core) => {
            core.settings(options);
            const answer = question(core);
            if (answer === null) throw this.failed(core);
            return answer;
        });
    }

    private change(changes: Change[]): Promise<void> {
        return this.ask((core) => {
            const text = core.edit(this.written, changes);
            if (text === null || !core.open(text, this.name)) throw this.failed(core);
            this.written = text;
        });
    }

    set(values: Readonly<Record<string, unknown>>): Promise<void> {
        return this.change(Object.entries(values).map(([key, value]) => assignment(key, value)));
    }

    get(key: string): Promise<unknown> {
        return this.ask((core) => {
            const value = core.get(key);
            return value === null ? null : load(value);
        });
    }

    insert(list: string, value: unknown, index?: number): Promise<void> {
        if (index === undefined)
            return this.get(list).then((all) => this.insert(list, value, Array.isArray(all) ? all.length : 0));
        return this.change([{ list, index, insert: JSON.stringify(value) }]);
    }

    remove(key: string): Promise<void> {
        return this.change([{ remove: key }]);
    }

    give(name: string, bytes: Uint8Array): Promise<void> {
        return this.ask((core) => {
            this.files.set(name, bytes);
            core.folder.put(name, bytes);
            if (!core.open(this.written, this.name)) throw this.failed(core);
        });
    }

    render(options: PictureOptions = {}): Promise<Field> {
        return this.compute(options, (core) => (core.render(options.stride ?? 1) ? core.field() : null));
    }

    file(name: string, options: Options = {}): Promise<Uint8Array> {
        return this.compute(options, (core) => {
            if (!name.toLowerCase().endsWith('.exr')) return core.file(name);
            const png = core.file('scene.png');
            return png && core.render(1) ? exr(core.field(), tagsOf(png)) : null;
        });
    }

    probe(places?: undefined, options?: Options): Promise<Probe[]>;
    probe(place: Point | Element, options?: Options): Promise<Probe>;
    probe(places: readonly Point[], options?: Options): Promise<Probe[]>;
    async probe(places?: Point | Element | readonly Point[], options: Options = {}): Promise<Probe | Probe[]> {
        const list = Array.isArray(places) ? (places as readonly unknown[]) : null;
        const isOne = places !== undefined && (!list || typeof list[0] === 'number');
        const found = await this.compute(options, (core) => {
            const facts = core.scene()!;
            const all = places ?? (facts.points as Point[]);
            const probes = Array.isArray(all)
                ? core.probePoints((isOne ? [all] : all) as Point[])
                : core.probeElement(all as Element);
            return probes?.map((probe) => ({ ...probe, unit: facts.unit })) ?? null;
        });
        return isOne ? found[0] : found;
    }

    explain(point: Point = [0, 0], options: Options & { format?: Document } = {}): Promise<string> {
        const format = FORMATS.indexOf(options.format ?? 'text');
        return this.compute(options, (core) => core.explain(point[0], point[1], format, 'en'));
    }

    extrema(options: Options = {}): Promise<Extrema> {
        return this.compute(options, (core) => core.peaks());
    }

    grids(options: Options = {}): Promise<Grid[]> {
        return this.compute(options, (core) => {
            const found: Grid[] = [];
            for (let i = 0; i < core.scene()!.grids; i++) {
                const grid = core.measured(i);
                if (!grid) return null;
                found.push(grid);
            }
            return found;
        });
    }

    grid(name: string | number = 0, options: Options = {}): Promise<Grid> {
        return this.compute(options, (core) => {
            const count = core.scene()!.grids;
            const nameOf = (_: unknown, i: number) => load(core.get(`grids[${i}].name`) ?? 'null') ?? `grid ${i + 1}`;
            const names = Array.from({ length: count }, nameOf);
            const i = typeof name === 'number' ? name : names.indexOf(name);
            if (!names[i]) throw new RangeError(`there is no grid ${JSON.stringify(name)}, but ${JSON.stringify(names)}`);
            return core.measured(i);
        });
    }

    async balance(options: Options = {}): Promise<Balance | null> {
        return (await this.compute(options, (core) => core.fluxes()))[0];
    }

    lights(): Promise<Light[]> {
        return this.ask((core) =>
            core.scene()!.lights.map(({ type, name, enabled, flux, place, direction }) => ({
                type,
                name,
                enabled,
                flux: flux !== null && flux >= 0 ? flux : null,
                position_mm: place as Vector | null,
                direction: direction as Vector | null,
            })),
        );
    }

    conventions(): Promise<Record<string, string>> {
        return this.ask((core) => core.conventions());
    }

    advice(): Promise<Diagnostic[]> {
        return this.ask((core) => {
            core.advise();
            return diagnosticsOf(core);
        });
    }

    async close(): Promise<void> {
        await this.last;
        this.core = null;
    }
}

function diagnosticsOf(core: PackageCore): Diagnostic[] {
    return core.messages().map(({ error, message, hint, key, line, column, length }) => ({
        severity: error ? 'error' : 'advice',
        message,
        hint,
        key,
        line,
        column,
        mark_length: length,
    }));
}
