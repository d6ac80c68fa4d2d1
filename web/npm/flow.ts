// SPDX-License-Identifier: MIT
// Values of keys: YAML on one line, as the core gives it, read into JavaScript's values.

const WORDS: Record<string, unknown> = {
    true: true, True: true, TRUE: true, false: false, False: false, FALSE: false,
    null: null, Null: null, NULL: null, '~': null, '': null,
}; // prettier-ignore
const NUMBER = /^[-+]?(\.\d+|\d+(\.\d*)?)([eE][-+]?\d+)?$/;
const ESCAPES: Record<string, string> = {
    '0': '\0', a: '\x07', b: '\b', t: '\t', n: '\n', v: '\v', f: '\f', r: '\r', e: '\x1b',
    N: '\x85', _: '\xa0', L: '\u2028', P: '\u2029',
}; // prettier-ignore
const CODES: Record<string, number> = { x: 2, u: 4, U: 8 };

class Reader {
    private at = 0;

    constructor(private readonly text: string) {}

    private peek(): string {
        while (/\s/.test(this.text[this.at] ?? '')) this.at++;
        return this.text[this.at] ?? '';
    }

    private singleQuoted(): string {
        let found = '';
        for (;;) {
            const end = this.text.indexOf("'", this.at);
            found += this.text.slice(this.at, end);
            this.at = end + 1;
            if (this.text[this.at] !== "'") return found;
            found += "'";
            this.at++;
        }
    }

    private escape(): string {
        const sign = this.text[this.at++];
        const digits = CODES[sign];
        if (!digits) return ESCAPES[sign] ?? sign;
        this.at += digits;
        return String.fromCodePoint(parseInt(this.text.slice(this.at - digits, this.at), 16));
    }

    private doubleQuoted(): string {
        let found = '';
        while (this.text[this.at] !== '"') {
            const sign = this.text[this.at++];
            found += sign === '\\' ? this.escape() : sign;
        }
        this.at++;
        return found;
    }

    private plain(isInside: boolean): unknown {
        const start = this.at;
        const ends = isInside ? /[,[\]{}]|:(?=$|[ ,\]}])/g : /$/g;
        ends.lastIndex = start;
        this.at = ends.exec(this.text)?.index ?? this.text.length;
        const word = this.text.slice(start, this.at).trim();
        if (word in WORDS) return WORDS[word];
        return NUMBER.test(word) ? Number(word) : word;
    }

    private sequence(): unknown[] {
        const found: unknown[] = [];
        while (this.peek() !== ']') {
            found.push(this.value(true));
            if (this.peek() === ',') this.at++;
        }
        this.at++;
        return found;
    }

    private mapping(): Record<string, unknown> {
        const found: Record<string, unknown> = {};
        while (this.peek() !== '}') {
            const key = String(this.value(true));
            if (this.peek() === ':') this.at++;
            found[key] = this.value(true);
            if (this.peek() === ',') this.at++;
        }
        this.at++;
        return found;
    }

    value(isInside = false): unknown {
        const sign = this.peek();
        if (!sign || !'[{\'"'.includes(sign)) return this.plain(isInside);
        this.at++;
        if (sign === '[') return this.sequence();
        if (sign === '{') return this.mapping();
        return sign === "'" ? this.singleQuoted() : this.doubleQuoted();
    }
}

export function load(text: string): unknown {
    return new Reader(text).value();
}
