// SPDX-License-Identifier: MIT
// Files that the user gives, by a button or by drop: scenes, pictures that carry one, and what scenes name.  A mesh,
// a lamp's photometry or a cloud that the scene does not name joins it as a surface or a light.
import type { Change } from './core';
import { lastPart } from './folder';
import { h } from './dom';
import type { Model } from './model';
import { placing } from './new_surface';
import { t } from './words';

const SCENE = /\.(ya?ml|json)$/i;
const PICTURE = /\.(png|exr)$/i;
const MESH = /\.(obj|ply|stl|off|gltf|glb)$/i;
const LAMP = /\.(ies|ldt)$/i;
const CLOUD = /\.(csv|npy|lp)$/i;

const NAMED = new RegExp([MESH, LAMP, CLOUD, /\.(mtl|bin)$/].map(({ source }) => source).join('|'), 'i');

/** What the button for files offers. */
export const ACCEPTED = '.yaml,.yml,.json,.png,.exr,.obj,.mtl,.ply,.stl,.off,.gltf,.glb,.bin,.ies,.ldt,.csv,.npy,.lp';

function written(numbers: number[]): string {
    return `[${numbers.map((value) => Number(value.toPrecision(4))).join(', ')}]`;
}

export class Files {
    readonly element = h('ul', { class: 'files' });
    /** Takes the text of a scene that was given. */
    onScene: (text: string, name: string) => void = () => undefined;
    onTrouble: (text: string) => void = () => undefined;

    constructor(private readonly model: Model) {
        model.followJudgement(this.element);
    }

    /** Takes all files of one choice: those that scenes name first, so that the scene finds them. */
    async take(files: File[]) {
        const isScene = ({ name }: File) =>
            SCENE.test(name) || PICTURE.test(name) || (files.length === 1 && !NAMED.test(name));
        const scenes = files.filter(isScene);
        const others = files.filter((file) => !isScene(file));
        const wanted = new Set(this.model.files.map(([name]) => lastPart(name)));
        const of = this.model.version;
        for (const file of others) await this.model.give(file.name, new Uint8Array(await file.arrayBuffer()));
        if (scenes.length) return this.openScene(scenes[0]);
        await this.model.judge();
        for (const { name } of others) if (!wanted.has(name) && of.scene === this.model.version.scene) await this.join(name);
    }

    private async openScene(file: File) {
        const bytes = new Uint8Array(await file.arrayBuffer());
        const name = lastPart(file.name).replace(/\.[^.]*$/, '');
        const isPicture = bytes[0] === 0x89 || bytes[0] === 0x76;
        if (!isPicture) {
            this.onScene(new TextDecoder().decode(bytes), name);
            return;
        }
        const { text, messages } = await this.model.client.ask('edit', bytes, []);
        if (text !== null) this.onScene(text, name);
        else this.onTrouble(messages.map(({ message }) => message).join('; '));
    }

    // What no scene names becomes a part of the present one.
    private async join(name: string) {
        const aimed = `position: ${written(this.freePlace())}, aim: ${written(this.target())}`;
        if (MESH.test(name)) await this.joinMesh(name);
        else if (LAMP.test(name)) await this.joinLight(name, 'luminaire', aimed);
        else if (CLOUD.test(name)) await this.joinLight(name, 'points', 'attenuation: inverse-square');
    }

    private target(): number[] {
        return this.model.scene?.surfaces[0]?.center ?? [0, 0, 0];
    }

    // Where a lamp is likely to shine well: opposite the first one, or above the screen's corner.
    private freePlace(): number[] {
        const first = this.model.scene?.lights.find(({ place }) => place)?.place;
        const [x, y, z] = this.target();
        const size = Math.max(...this.model.screen);
        return first ? [2 * x - first[0], first[1], first[2]] : [x + 0.6 * size, y + 0.4 * size, z + size];
    }

    private joinLight(name: string, type: string, rest: string) {
        const insert = `{type: ${type}, file: ${JSON.stringify(name)}, ${rest}}`;
        return this.model.change([{ list: 'lights', index: this.model.scene?.lights.length ?? 0, insert }]);
    }

    // A mesh is measured first, so that it stands whole before what is there, whatever its unit.
    private async joinMesh(name: string) {
        const { scene, client, text, version } = this.model;
        const index = scene?.surfaces.length ?? 0;
        const insertion = (rest: string): Change => ({
            list: 'surfaces',
            index,
            insert: `{type: mesh, file: ${JSON.stringify(name)}${rest}}`,
        });
        const trial = await client.ask('edit', text, [insertion(', scale: 1')]);
        const found =
            trial.text && (await client.ask('judge', { ...version, text: trial.text, direct: true })).facts?.surfaces[index];
        if (!found || !(found.reach > 0)) return this.model.change([insertion('')], '', version);
        const { scale, center } = placing(this.model, found.reach);
        const position = center.map((coordinate, axis) => Math.round(coordinate - scale * found.center[axis]));
        return this.model.change([insertion(`, scale: ${scale}, position: ${written(position)}`)], '', version);
    }

    /** Which files the scene names, and buttons that give those that are not there. */
    show() {
        this.element.setAttribute('aria-label', t('Files of the scene'));
        this.element.hidden = this.model.files.length === 0;
        this.element.replaceChildren(...this.model.files.map(([name, found]) => this.item(name, found)));
    }

    private item(name: string, found: boolean): HTMLElement {
        const label = t(found ? 'Replace…' : 'Choose file…');
        const input = h('input', { type: 'file', hidden: true, 'aria-label': `${label} ${name}` });
        input.addEventListener('change', async () => {
            const file = input.files?.[0];
            if (!file) return;
            // Whatever it is called on the disk, it is the one that the scene names.
            await this.model.give(name, new Uint8Array(await file.arrayBuffer()));
        });
        const button = h(
            'button',
            { type: 'button', class: 'small', 'aria-label': `${label} ${name}`, onclick: () => input.click() },
            label,
        );
        const state = found ? '' : ` — ${t('the page does not have it')} `;
        return h('li', { class: found ? '' : 'error' }, h('span', {}, `${name}${state} `), button, input);
    }
}
