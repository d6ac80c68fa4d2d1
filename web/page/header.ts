// SPDX-License-Identifier: MIT
// The row at the top, two on phones: scenes, quantity, undo and redo, files in and out, link, language.
import { choice, h } from './dom';
import { ACCEPTED } from './files';
import type { Model } from './model';
import { currentLanguage, t, type Language } from './words';

const FILES: [string, string][] = [
    ['.png', 'PNG'],
    ['.npy', 'NPY'],
    ['.csv', 'CSV'],
    ['.pfm', 'PFM'],
    ['.yaml', 'YAML'],
    ['.html', 'HTML'],
];

export interface Actions {
    gallery(): void;
    take(files: File[]): Promise<void>;
    save(ending: string): void;
    copyLink(): void;
    changeLanguage(code: Language): void;
}

/** The header, and the two buttons whose state follows the history. */
export function header(model: Model, actions: Actions) {
    // On phones a button may show a shorter text; its name stays.
    const button = (label: string, onclick: () => void, brief = label) =>
        h(
            'button',
            { type: 'button', onclick, 'aria-label': t(label), title: brief !== label && t(label) },
            h('span', { class: 'long' }, t(label)),
            h('span', { class: 'brief' }, t(brief)),
        );
    const undo = button('Undo', () => model.undo(), '↶');
    const redo = button('Redo', () => model.redo(), '↷');
    const file = h('input', { type: 'file', accept: ACCEPTED, multiple: true, hidden: true, id: 'file' });
    file.addEventListener('change', async () => {
        await actions.take([...(file.files ?? [])]);
        file.value = '';
    });
    const quantities = choice(
        t('Quantity'),
        [
            ['brightness', t('brightness')],
            ['irradiance', t('irradiance')],
        ],
        model.irradiance ? 'irradiance' : 'brightness',
        (value) => model.setIrradiance(value === 'irradiance'),
    );
    const named = FILES.map(([ending, name]): [string, string] => [
        ending,
        ending === '.html' ? `${t('Report')} (${name})` : name,
    ]);
    const files = choice(t('Download'), [['', `${t('Download')}…`], ...named], '', (ending) => {
        files.value = '';
        if (ending) actions.save(ending);
    });
    const languages = choice(
        t('Language'),
        [
            ['en', 'English'],
            ['ru', 'Русский'],
        ],
        currentLanguage(),
        (code) => actions.changeLanguage(code as Language),
    );
    const element = h(
        'header',
        {},
        h(
            'div',
            { class: 'row' },
            h('h1', {}, 'Luxel'),
            h('span', { class: 'dim motto' }, t('Light in space')),
            button('Built-in scenes…', () => actions.gallery(), 'Scenes…'),
            quantities,
            undo,
            redo,
        ),
        h(
            'div',
            { class: 'row' },
            button('Open…', () => file.click()),
            file,
            files,
            button('Copy link', () => actions.copyLink(), 'Link'),
            languages,
        ),
    );
    return { element, undo, redo };
}
