// SPDX-License-Identifier: MIT
// What a tab keeps of its scene, so that after a reload, or a crash, it goes on where it was, with all that can be undone.
import type { History, Model } from './model';

const KEY = 'luxel-kept';
const MOST = 2_000_000; // letters; what is older is forgotten

interface Kept extends History {
    address: string; // that showed it: another one wants another scene
}

/** Keeps the scene and its history in the tab. */
export function keep(model: Model) {
    try {
        const history: Kept = { address: location.hash, ...model.history() };
        for (let text = JSON.stringify(history); ; text = JSON.stringify(history)) {
            if (text.length <= MOST) return sessionStorage.setItem(KEY, text);
            const older = history.past.length > history.future.length ? history.past : history.future;
            if (!older.length) return sessionStorage.removeItem(KEY);
            older.splice(0, Math.ceil(older.length / 4));
        }
    } catch {
        // A frame may be without storage; the address has the scene, too.
    }
}

/** What the tab kept, where it was loaded again rather than sent to another address; null: nothing. */
export function kept(): History | null {
    const [entry] = performance.getEntriesByType('navigation') as PerformanceNavigationTiming[];
    if (entry?.type !== 'reload') return null;
    try {
        const found = JSON.parse(sessionStorage.getItem(KEY) ?? 'null') as Kept | null;
        const isText = (step: unknown) => typeof (step as { text?: unknown } | null)?.text === 'string';
        return found?.address === location.hash && isText(found.present) && [...found.past, ...found.future].every(isText) ? found : null;
    } catch {
        return null;
    }
}
