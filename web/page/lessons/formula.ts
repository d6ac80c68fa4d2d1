// SPDX-License-Identifier: MIT
// Formulas of lessons as MathML.  They are written in a small part of TeX: letters, numbers and signs as they are, ^ and _
// with one sign or {…}, \frac{…}{…}, \v{N} for a vector, \t{…} for words; <…> is a number of the figure.
import { number } from '../words';
import { valueOf, type Names } from './expression';

const MATHML = 'http://www.w3.org/1998/Math/MathML';

function element(name: string, ...children: (Element | string)[]): Element {
    const made = document.createElementNS(MATHML, name);
    made.append(...children);
    return made;
}

class Reader {
    private at = 0;

    constructor(
        private readonly text: string,
        private readonly names: Names,
    ) {}

    row(end = ''): Element {
        const parts: Element[] = [];
        while (this.at < this.text.length && this.text[this.at] !== end) {
            if (/\s/.test(this.text[this.at])) this.at++;
            else parts.push(this.withMarks(this.single()));
        }
        this.at++;
        return parts.length === 1 ? parts[0] : element('mrow', ...parts);
    }

    private withMarks(base: Element): Element {
        let marked = base;
        while (this.text[this.at] === '^' || this.text[this.at] === '_') {
            const name = this.text[this.at++] === '^' ? 'msup' : 'msub';
            marked = element(name, marked, this.single());
        }
        return marked;
    }

    private group(): string {
        const from = this.text.indexOf('{', this.at) + 1;
        this.at = this.text.indexOf('}', from) + 1;
        return this.text.slice(from, this.at - 1);
    }

    private single(): Element {
        const rest = this.text.slice(this.at);
        const take = (pattern: RegExp) => {
            const found = pattern.exec(rest)?.[0] ?? '';
            this.at += found.length;
            return found;
        };
        if (rest[0] === '{') {
            this.at++;
            return this.row('}');
        }
        if (take(/^\\frac/)) return element('mfrac', this.single(), this.single());
        if (take(/^\\v/)) {
            const vector = element('mi', this.group());
            vector.setAttribute('mathvariant', 'bold-italic');
            return vector;
        }
        if (take(/^\\t/)) return element('mtext', this.group().replaceAll(' ', '\u00a0')); // plain blanks at its ends would go
        const live = take(/^<[^<>]+>/);
        if (live) return element('mn', number(valueOf(live.slice(1, -1), this.names), 4));
        const digits = take(/^\d+(\.\d+)?/);
        if (digits) return element('mn', number(Number(digits), 6));
        const letter = take(/^[A-Za-zα-ω]/);
        if (letter) return element('mi', letter);
        const sign = element('mo', take(/^./u));
        if ('()|'.includes(sign.textContent!)) sign.setAttribute('stretchy', 'false');
        return sign;
    }
}

/** The formula, with the numbers of its figure. */
export function formula(text: string, names: Names, isAlone: boolean): Element {
    const math = element('math', new Reader(text, names).row());
    if (isAlone) math.setAttribute('display', 'block');
    return math;
}
