// SPDX-License-Identifier: MIT
// The line below the picture: quantity and unit, extremes and mean of its pixels, and how well reflected light is known.
import type { PictureFacts } from './core';
import { h } from './dom';
import type { Model } from './model';
import type { Version } from './version';
import { isRough } from './work';
import { bound, number, t } from './words';

/** What a picture is, in one line. */
function told(facts: PictureFacts, unit: string): string {
    const extremes = `${t('maximum')} ${number(facts.maximum.value, 5)}, ${t('mean')} ${number(facts.mean, 5)}`;
    const reflected =
        facts.reflected === null ? '' : `; ${t('reflected light within')} ${bound(100 * facts.reflected)} %`;
    const missed = facts.reached ? '' : ` (${t('less exact than it should be')})`;
    const deeper =
        facts.mirrored === 0 ? '' : `; ${t('light over more mirrors')} ${facts.mirrored === null ? t('not bounded') : `≤ ${bound(100 * facts.mirrored)} %`}`;
    return `${t(facts.word)}, ${unit}: ${extremes}${reflected}${missed}${deeper}`;
}

export class Statistics {
    readonly element = h('p', { class: 'dim statistics' });
    private of: Version | null = null; // what is shown

    constructor(private readonly model: Model) {
        model.follow(this.element, () => this.of);
    }

    clear() {
        this.of = null;
        this.element.textContent = '';
    }

    /** After a new picture; the extremes of a coarse one are not those of the whole one. */
    show() {
        const { picture, scene } = this.model;
        if (!picture || !scene || picture.stride !== 1) return;
        const unit = scene.unit === 'relative' ? t('relative') : scene.unit;
        const missing = this.model.isPartial(picture.of) ? t('direct light alone') : isRough(picture) ? t('reflected light roughly') : '';
        this.element.textContent = told(picture.facts, unit) + (missing && ` (${missing})`);
        this.of = picture.of;
        this.model.dim();
    }
}
