// SPDX-License-Identifier: MIT
// How the page shows a scene, as links carry it behind the scene's text: quantity, probe, colours and range, zoom, side of
// the space view, language.  What is as a page begins is left out.
import type { Scale } from './colours';
import type { Model } from './model';
import type { PictureView } from './picture';
import type { SpaceView } from './space';
import { COLOUR_VIEWS } from './srgb';
import { currentLanguage } from './words';

const MAPS: Scale['map'][] = ['tone', 'grey', 'viridis', 'turbo'];
const SIDES: SpaceView['side'][] = ['orbit', 'plan', 'elevation'];

export class Looks {
    constructor(
        private readonly model: Model,
        private readonly picture: PictureView,
        private readonly space: SpaceView,
    ) {}

    /** The end of a link, from its first & on. */
    told(): string {
        const { scale, probe, view } = this.picture;
        const { side, turned } = this.space;
        const parts: [string, string | number[] | null][] = [
            ['quantity', this.model.irradiance ? 'irradiance' : null],
            ['channel', this.model.version.view && this.model.version.view !== 'luminance' ? this.model.version.view : null],
            ['probe', probe],
            ['colours', scale.map === MAPS[0] ? null : scale.map],
            ['range', scale.locked ? [scale.low, scale.high] : null],
            ['log', scale.logarithmic ? '1' : null],
            ['stops', scale.exposure ? [scale.exposure] : null],
            ['isophotes', this.picture.showsIsophotes ? '1' : null],
            ['zoom', view[0] === 1 ? null : view],
            ['side', side === SIDES[0] ? null : side],
            ['turned', turned],
            ['lang', currentLanguage()],
        ];
        const written = (value: string | number[]) =>
            typeof value === 'string' ? value : value.map((n) => Number(n.toPrecision(7))).join();
        return parts.map(([key, value]) => (value === null ? '' : `&${key}=${written(value)}`)).join('');
    }

    /** Takes over what a link tells; what it does not tell stays. */
    take(fragment: string) {
        const found = new URLSearchParams(fragment.replace(/^#/, ''));
        const { scale } = this.picture;
        const numbers = (key: string, count: number): number[] | null => {
            const values = (found.get(key) ?? '').split(',').map((part) => (part.trim() ? Number(part) : NaN));
            return values.length === count && values.every(isFinite) ? values : null;
        };
        const map = MAPS.find((each) => each === found.get('colours'));
        const side = SIDES.find((each) => each === found.get('side'));
        const [probe, range, stops] = [numbers('probe', 2), numbers('range', 2), numbers('stops', 1)];
        const [zoom, turned] = [numbers('zoom', 3), numbers('turned', 2)];
        if (found.has('quantity')) this.model.setIrradiance(found.get('quantity') === 'irradiance');
        const view = COLOUR_VIEWS.find((each) => each === found.get('channel'));
        if (view) this.model.setView(view);
        if (probe) this.picture.probe = [probe[0], probe[1]];
        if (map) scale.map = map;
        if (found.has('log')) scale.logarithmic = found.get('log') === '1';
        if (stops) scale.exposure = Math.max(-8, Math.min(8, stops[0]));
        if (range && range[0] < range[1]) Object.assign(scale, { low: range[0], high: range[1], locked: true });
        if (found.has('isophotes')) this.picture.showsIsophotes = found.get('isophotes') === '1';
        if (zoom) this.picture.view = zoom;
        if (turned) this.space.turned = turned;
        if (side) this.space.setSide(side);
    }
}
