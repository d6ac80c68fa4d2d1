// SPDX-License-Identifier: MIT
// Numbers of a lesson's figure written with its names: "h", "-w/2", "h-100", "x*0.5+200".

/** What the names of a figure stand for. */
export type Names = Record<string, number | string>;

const TERM = /([+-]?)\s*([A-Za-z]\w*|\d+(?:\.\d+)?)(?:\s*([*/])\s*(\d+(?:\.\d+)?))?\s*/y;

/** The value of an expression; throws where it is none, or a name is not known. */
export function valueOf(expression: number | string, names: Names): number {
    if (typeof expression === 'number') return expression;
    let sum = 0;
    TERM.lastIndex = 0;
    do {
        const [, sign, word, operation, factor] = TERM.exec(expression) ?? [];
        const term = word === undefined ? NaN : /^\d/.test(word) ? Number(word) : Number(names[word]);
        if (Number.isNaN(term)) throw new Error(`"${expression}" is no number here`);
        const scaled = operation === '*' ? term * Number(factor) : operation === '/' ? term / Number(factor) : term;
        sum += sign === '-' ? -scaled : scaled;
    } while (TERM.lastIndex < expression.length);
    return sum;
}

/** A text with what stands in <…> worked out: a word where it names one, else a number. */
export function filled(text: string, names: Names): string {
    return text.replace(/<([^<>]+)>/g, (_, expression: string) => {
        const name = names[expression];
        return typeof name === 'string' ? name : String(valueOf(expression, names));
    });
}
