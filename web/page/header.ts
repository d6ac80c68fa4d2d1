// SPDX-License-Identifier: MIT
// The bar at the top: scenes, quantity, undo and redo, files in and out, language, link.  On phones all but the scene and the
// link is in a menu.
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
    ['figure', 'Figure'],
];

export interface Actions {
    gallery(): void;
    take(files: File[]): Promise<void>;
    save(ending: string): void;
    share(): void;
    keys(): void;
    changeLanguage(code: Language): void;
}

/** The header, and what of it follows the model. */
export function header(model: Model, actions: Actions) {
    const button = (label: string, onclick: () => void, style: string, sign = '') =>
        h('button', { type: 'button', onclick, class: style, 'aria-label': sign && t(label), title: sign && t(label) }, sign || t(label));
    const undo = button('Undo', () => model.undo(), 'icon', '↶');
    const redo = button('Redo', () => model.redo(), 'icon', '↷');
    const scene = h('button', { type: 'button', class: 'scene', title: t('Built-in scenes…'), onclick: () => actions.gallery() });
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
        ending === '.html' ? `${t('Report')} (${name})` : ending === 'figure' ? `${t(name)} (SVG, PDF, PNG)…` : name,
    ]);
    const files = choice(t('Download'), [['', `${t('Save')}…`], ...named], '', (ending) => {
        files.value = '';
        if (ending) actions.save(ending);
    });
    files.className = 'files-out';
    const languages = choice(
        t('Language'),
        [
            ['en', 'English'],
            ['ru', 'Русский'],
        ],
        currentLanguage(),
        (code) => actions.changeLanguage(code as Language),
    );
    languages.className = 'language';
    const rest = h(
        'div',
        { class: 'rest' },
        h('label', {}, h('span', {}, t('shows')), quantities),
        h('span', { class: 'space-between' }),
        undo,
        redo,
        h('span', { class: 'rule' }),
        button('Open…', () => file.click(), ''),
        files,
        h('a', { class: 'lessons', href: `#lesson=ambient&lang=${currentLanguage()}` }, t('Lessons')),
        languages,
        button('Keys', () => actions.keys(), 'icon keys-list', '?'),
    );
    const menu = button('More', () => open(!rest.classList.contains('is-open')), 'icon menu', '⋯');
    const open = (isOpen: boolean) => {
        rest.classList.toggle('is-open', isOpen);
        menu.setAttribute('aria-expanded', String(isOpen));
    };
    menu.setAttribute('aria-expanded', 'false');
    rest.addEventListener('change', () => open(false));
    const element = h(
        'header',
        {},
        h('h1', {}, 'Luxel'),
        h('span', { class: 'rule' }),
        scene,
        rest,
        file,
        button('Share', () => actions.share(), 'share'),
        menu,
    );
    element.addEventListener('keydown', (event) => {
        if (event.key !== 'Escape' || !rest.classList.contains('is-open')) return;
        open(false);
        menu.focus();
    });
    /** Tells the name of the scene, and what the history has. */
    const show = (title: string) => {
        scene.textContent = title;
        scene.setAttribute('aria-label', `${t('Built-in scenes…')} ${title}`);
        undo.disabled = !model.canUndo;
        redo.disabled = !model.canRedo;
    };
    return { element, show };
}
