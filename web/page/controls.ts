// SPDX-License-Identifier: MIT
// The controls of the colour bar, of the side from which the space view looks, and of the zoom.
import type { Dial } from './dial';
import { choice, h, takeIn } from './dom';
import type { PictureView } from './picture';
import type { Side, SpaceView } from './space';
import { COLOUR_VIEWS, type ColourView } from './srgb';
import { t, typedNumber } from './words';

function box(label: string, checked: boolean, onchange: (checked: boolean) => void) {
    const input = h('input', { type: 'checkbox', checked, onchange: () => onchange(input.checked) });
    return h('label', {}, input, t(label));
}

/** The colour bar's: map, range and how it is divided; and isophotes.  `ends` are the fields of the range. */
export function scaleControls(picture: PictureView, dial: Dial, changed: () => void) {
    const { scale } = picture;
    const end = (label: string, which: 'low' | 'high') => {
        const input = h('input', { type: 'text', inputmode: 'decimal', class: 'end', 'aria-label': t(label) });
        input.addEventListener('change', () => {
            const value = typedNumber(input.value);
            takeIn(input);
            input.setAttribute('aria-invalid', String(value === null));
            if (value === null) return;
            scale[which] = value;
            scale.locked = true;
            scale.exposure = 0;
            changed();
        });
        return input;
    };
    const ends: [HTMLInputElement, HTMLInputElement] = [end('From', 'low'), end('To', 'high')];
    const locked = box('Lock range', scale.locked, (checked) => {
        scale.locked = checked;
        changed();
    });
    const names: [string, string][] = ['tone', 'grey', 'viridis', 'turbo'].map((map) => [map, t(map)]);
    const maps = choice(t('Colours'), names, scale.map, (map) => {
        scale.map = map as typeof scale.map;
        changed();
    });
    const logarithmic = box('Logarithmic', scale.logarithmic, (checked) => {
        scale.logarithmic = checked;
        changed();
    });
    const isophotes = box('Isophotes', picture.showsIsophotes, (checked) => {
        picture.showsIsophotes = checked;
        changed();
    });
    const exposure = h('label', {}, t('Exposure'), dial.exposure, dial.told);
    const element = h('div', { class: 'controls' }, maps, ...ends, locked, logarithmic, isophotes, exposure);
    return { element, ends, locked: locked.firstChild as HTMLInputElement };
}

/** Which view of pictures in colour is shown; not to be seen where they are grey. */
export function viewControl(view: ColourView, changed: (view: ColourView) => void): HTMLSelectElement {
    const names: Record<ColourView, string> = { luminance: t('its colours, or its luminance'), red: t('red'), green: t('green'), blue: t('blue'), cct: t('colour temperature, K') };
    const options = COLOUR_VIEWS.map((each): [string, string] => [each, names[each]]);
    return choice(t('Channel'), options, view, (chosen) => changed(chosen as ColourView));
}

/** From which side the space view looks. */
export function sideControls(space: SpaceView): HTMLElement {
    const names: [Side, string][] = [
        ['orbit', 'Orbit'],
        ['plan', 'Plan'],
        ['elevation', 'Elevation'],
    ];
    const buttons = names.map(([side, label]) =>
        h('button', { type: 'button', onclick: () => space.setSide(side) }, t(label)),
    );
    space.onSide = (side) =>
        buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(names[i][0] === side)));
    space.onSide(space.side);
    return h('div', { class: 'sides floating' }, ...buttons);
}

/** Buttons that zoom a view by a factor; 0: all of it is seen. */
export function zoomButtons(zoom: (factor: number) => void): HTMLElement {
    const button = (sign: string, label: string, factor: number) =>
        h('button', { type: 'button', 'aria-label': t(label), title: t(label), onclick: () => zoom(factor) }, sign);
    const all = h('button', { type: 'button', onclick: () => zoom(0), title: `${t('Show all')} (F)`, 'aria-label': t('Show all') }, t('Fit'));
    return h('span', { class: 'zoom floating' }, button('−', 'Zoom out', 0.8), button('+', 'Zoom in', 1.25), all);
}
