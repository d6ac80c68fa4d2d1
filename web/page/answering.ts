// SPDX-License-Identifier: MIT
// A field for an answer and what the core finds it to be, in lessons and in tasks.
import type { Judgement } from './core';
import { h } from './dom';
import { number, t } from './words';

/** The tolerance of an answer, as luxel grade has it. */
export const TOLERANCE = 1e-3;

interface Answering {
    /** Has the core judge what was typed; null: it is no number. */
    judge: (typed: string) => Promise<Judgement | null>;
    unit: () => Promise<string>;
    /** What is said beside the verdict. */
    onRight?: Node[];
    onWrong?: Node[];
}

/** The form, and below it the verdict. */
export function answering({ judge, unit, onRight = [], onWrong = [] }: Answering): HTMLElement[] {
    const verdict = h('p', { class: 'verdict', role: 'status', hidden: true });
    const input = h('input', { type: 'text', inputmode: 'decimal', autocomplete: 'off', 'aria-label': t('Your answer') });
    const of = h('span', { class: 'unit' });
    const button = h('button', { type: 'submit', class: 'prime' }, t('Check'));
    const form = h('form', { class: 'answer' }, input, of, button);
    void unit().then((text) => (of.textContent = text)).catch(() => undefined);
    const say = (isRight: boolean, words: string, ...rest: (string | Node)[]) => {
        verdict.hidden = false;
        verdict.className = `verdict ${isRight ? 'right' : 'wrong'}`;
        verdict.replaceChildren(h('b', {}, words), ...rest.flatMap((each) => [' ', each]));
    };
    const tell = ({ verdict, value, explanations }: Judgement) => {
        if (verdict === 'right' && value === null) say(true, t('Right.'), ...onRight);
        else if (verdict === 'right') say(true, t('Right.'), `${t('The core has')} ${number(value, 5)} ${of.textContent}.`, ...onRight);
        else if (verdict === 'coarse') say(false, t('Right as far as it goes: give three digits.'));
        else if (verdict === 'convention') say(false, `${t('This is another convention:')} ${explanations.join('; ')}.`);
        else say(false, t('Not yet.'), ...onWrong);
    };
    form.addEventListener('submit', async (event) => {
        event.preventDefault();
        button.disabled = true;
        try {
            const found = await judge(input.value);
            if (found) tell(found);
            else say(false, t('Type a number, such as 12.3.'));
        } catch (error) {
            say(false, String(error));
        }
        button.disabled = false;
    });
    return [form, verdict];
}
