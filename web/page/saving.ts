// SPDX-License-Identifier: MIT
// Files out: of the present scene only, and with all its light; what was begun for a scene that has changed is not
// handed over.
import { download } from './link';
import type { Model } from './model';
import type { PictureView } from './picture';
import { report } from './report';
import { t } from './words';

const TYPES: Record<string, string> = {
    '.png': 'image/png',
    '.csv': 'text/csv',
    '.yaml': 'application/yaml',
    '.html': 'text/html',
};

/** Says something to the user, for so many milliseconds. */
type Say = (text: string, milliseconds?: number) => void;

export class Saving {
    constructor(
        private readonly model: Model,
        private readonly view: PictureView,
        private readonly say: Say,
    ) {}

    /** Hands over a file by its ending. */
    async save(ending: string) {
        const { version } = this.model;
        const { name } = version;
        if (ending === '.yaml') return download(`${name}.yaml`, version.text, TYPES[ending]);
        const source = this.model.source();
        if (!source && this.model.stale) return this.say(t('There is no file of a scene with errors.'));
        if (!source) return this.say(t('The scene has changed: the file was not made.'));
        if (this.model.isPartial(source.of))
            return this.say(t('Reflected light is not known yet: there is no file without it.'));
        this.say(t('The file is being made.'), Infinity);
        const made = await this.fileOf(ending, source).catch(() => null);
        if (!this.model.isCurrent(version) || !made) return this.say(t('The scene has changed: the file was not made.'));
        this.say('');
        const { content, messages } = made;
        if (content) download(`${name}${ending}`, content, TYPES[ending] ?? 'application/octet-stream');
        else this.say(messages.map(({ message }) => message).join('; '));
    }

    // By a worker of its own, so that the hand need not wait; by the one that knows reflected light, where there is some.
    private async fileOf(ending: string, { client, of }: NonNullable<ReturnType<Model['source']>>) {
        const own = client === this.model.client ? await client.twin() : null;
        try {
            if (ending === '.html')
                return { content: await report(this.model, this.view, own ?? client), messages: [] };
            const { bytes, messages } = await (own ?? client).ask('file', of, `scene${ending}`);
            return { content: bytes, messages };
        } finally {
            own?.stop();
        }
    }
}
