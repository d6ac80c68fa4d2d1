// SPDX-License-Identifier: MIT
// The keys that a scene has or could have: those of its head, then those of each surface and light by its type.
import type { Key } from './core';
import type { Model } from './model';

// Types of keys, as luxel/parameter.h numbers them.
export const NUMBER = 0,
    WHOLE = 1,
    YES_OR_NO = 2,
    CHOICE = 3,
    TEXT = 4,
    NUMBERS = 5,
    WHOLE_NUMBERS = 6,
    CHOICE_OR_PAIR = 7,
    CHOICE_OR_WHOLE = 11;
const SIMPLE = [NUMBER, WHOLE, YES_OR_NO, CHOICE, TEXT, NUMBERS, WHOLE_NUMBERS, CHOICE_OR_PAIR, CHOICE_OR_WHOLE];

export interface SceneKeys {
    /** The types of what is in each list. */
    lists: ['surfaces' | 'lights', string[]][];
    paths: [string, Key][];
    values: (string | null)[]; // null: the scene has no such key
}

export async function sceneKeys(model: Model, keys: Key[]): Promise<SceneKeys> {
    const { client, whole } = model;
    const of = model.asWhole()!;
    const scene = whole!.facts;
    const surfaces = await client.ask(
        'keys',
        of,
        scene.surfaces.map((_, i) => `surfaces[${i}].type`),
    );
    const lists: SceneKeys['lists'] = [
        ['surfaces', surfaces.map((type) => type ?? '')],
        ['lights', scene.lights.map(({ type }) => type)],
    ];
    const simple = keys.filter(({ type }) => SIMPLE.includes(type));
    const paths: [string, Key][] = simple
        .filter(({ path }) => !/^(surfaces|lights|grids|luxel)/.test(path))
        .map((key) => [key.path, key]);
    for (const [list, types] of lists)
        types.forEach((type, i) => {
            for (const key of simple)
                if (key.path.startsWith(`${list}[].`) && (!key.variant || key.variant === type))
                    paths.push([key.path.replace('[]', `[${i}]`), key]);
        });
    const values = await client.ask(
        'keys',
        of,
        paths.map(([path]) => path),
    );
    return { lists, paths, values };
}
