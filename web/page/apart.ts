// SPDX-License-Identifier: MIT
// What takes long and is looked at in the strip alone: asked when the hand rests, apart from what follows it, and given up as
// soon as the scene changes.
import type { Client } from './client';
import type { Model } from './model';
import type { Of } from './version';

const REST = 300; // milliseconds without a change after which it is asked for

export class Apart<Told> {
    private wanted = ''; // what was asked for last
    private timer = 0;
    private own: Client | null = null;
    /** Whether somebody looks at it. */
    isShown = false;

    constructor(
        private readonly model: Model,
        private readonly ask: (client: Client, of: Of) => Promise<Told | null>,
        private readonly show: (told: Told | null, of: Of) => void,
    ) {
        model.listen(() => this.refresh());
    }

    /** Asks for it where it is looked at, and is not there yet. */
    refresh() {
        const source = this.model.source();
        const name = source ? [source.of.number, source.of.direct].join() : '';
        if (name === this.wanted && name) return;
        this.own?.stop();
        this.own = null;
        this.wanted = '';
        clearTimeout(this.timer);
        if (!this.isShown || !name) return;
        this.timer = window.setTimeout(() => {
            this.wanted = name;
            void this.find(name).catch(() => this.wanted === name && (this.wanted = ''));
        }, REST);
    }

    // By a worker of its own, or by the one that knows reflected light.
    private async find(name: string) {
        const source = this.model.source();
        if (!source) return;
        const { client, of } = source;
        const own = client === this.model.client ? await client.twin() : null;
        if (this.wanted !== name) return own?.stop();
        this.own = own;
        try {
            const told = await this.ask(own ?? client, of);
            if (this.wanted === name && this.model.isCurrent(of)) this.show(told, of);
        } finally {
            own?.stop();
        }
    }

    /** Asks anew, as in other words. */
    again() {
        this.wanted = '';
        this.refresh();
    }
}
