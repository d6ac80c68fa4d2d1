// SPDX-License-Identifier: MIT
// A chapter of the lessons as an article: its text, with live figures, a guess before one looks, a number to find, which the
// core judges, and a variant of the exercise at the end.
import { answering, TOLERANCE } from '../answering';
import type { Client } from '../client';
import { h } from '../dom';
import { packed } from '../link';
import { LoadingNotice } from '../loading';
import { currentLanguage, number, setLanguage, t, type Language } from '../words';
import { CHAPTERS, type Chapter } from './chapters';
import { ENGLISH } from './en';
import { Figure } from './figure';
import { formula } from './formula';
import { RUSSIAN } from './ru';

/** What a language says: the names of what is slid, and the text of each chapter. */
export interface LessonWords {
    labels: Record<string, string>;
    chapters: Record<string, string>;
}

const LAST_VARIANT = 1000000;

/** The chapter that a link asks for; null: it asks for none. */
export function lessonIn(fragment: string): string | null {
    const wanted = new URLSearchParams(fragment.replace(/^#/, '')).get('lesson');
    return wanted === null ? null : wanted in CHAPTERS ? wanted : Object.keys(CHAPTERS)[0];
}

const addressOf = (chapter: string) => `#lesson=${chapter}&lang=${currentLanguage()}`;

/** A line of text with *names*, **vectors** and $formulas$. */
function inline(text: string): Node[] {
    return text.split(/(\*\*[^*]+\*\*|\*[^*]+\*|\$[^$]+\$)/).map((part) => {
        if (part.startsWith('**')) return h('b', { class: 'vector' }, part.slice(2, -2));
        if (part.startsWith('*')) return h('i', {}, part.slice(1, -1));
        if (part.startsWith('$')) return formula(part.slice(1, -1), {}, false);
        return document.createTextNode(part);
    });
}

function paragraph(name: 'h1' | 'h2' | 'h3' | 'p' | 'figcaption', text: string, style?: string): HTMLElement {
    const made = h(name, { class: style });
    made.append(...inline(text));
    return made;
}

export class Lesson {
    /** The figures of the chapter by their names. */
    readonly figures = new Map<string, Figure>();
    private readonly order = Object.keys(CHAPTERS);
    private readonly chapter: Chapter;
    private readonly words: LessonWords;
    private readonly blocks: string[];

    constructor(
        private readonly client: Client,
        private readonly root: HTMLElement,
        readonly name: string,
    ) {
        this.chapter = CHAPTERS[name];
        this.words = currentLanguage() === 'ru' ? RUSSIAN : ENGLISH;
        this.blocks = this.words.chapters[name].trim().split(/\n\s*\n/).map((block) => block.replace(/\s*\n\s*/g, ' '));
    }

    show() {
        const article = h('article', {});
        article.append(
            h('p', { class: 'kick' }, `${t('Chapter')} ${this.order.indexOf(this.name) + 1}`),
            ...this.blocks.map((block) => this.block(block)),
            this.end(),
        );
        this.root.replaceChildren(this.bar(), h('main', { class: 'lesson' }, article));
        document.title = `${this.titleOf(this.name)} – Luxel`;
        window.scrollTo(0, 0);
    }

    private titleOf(chapter: string): string {
        return /^#\s+(.*)/.exec(this.words.chapters[chapter].trim())![1];
    }

    private bar(): HTMLElement {
        const present = this.order.indexOf(this.name);
        const dots = this.order.map((chapter, i) =>
            h('a', {
                href: addressOf(chapter),
                'aria-label': `${i + 1}. ${this.titleOf(chapter)}`,
                title: this.titleOf(chapter),
                'aria-current': i === present ? 'page' : undefined,
            }),
        );
        const other: Language = currentLanguage() === 'ru' ? 'en' : 'ru';
        return h(
            'header',
            { class: 'lesson-bar' },
            h('a', { href: `#scene=sphere&lang=${currentLanguage()}`, class: 'home' }, 'Luxel'),
            h('nav', { class: 'dots', 'aria-label': t('Lessons') }, ...dots),
            h('span', { class: 'dim' }, `${present + 1} / ${this.order.length}`),
            h('span', { class: 'space-between' }),
            h('a', { href: `#lesson=${this.name}&lang=${other}`, lang: other }, other === 'ru' ? 'Русский' : 'English'),
        );
    }

    private block(block: string): HTMLElement {
        const [, sign, rest] = /^(#{1,2}|>|@\w+)?\s*(.*)$/s.exec(block)!;
        const parts = rest.split(/\s+\|\s+/);
        switch (sign) {
            case '#':
                return paragraph('h1', rest);
            case '##':
                return paragraph('h2', rest);
            case '>':
                return paragraph('p', rest, 'lead');
            case '@figure':
                return this.figure(parts[0], parts[1]);
            case '@formula':
                return this.formula(parts[0]);
            case '@guess':
                return this.guess(parts);
            case '@check':
                return this.check(parts);
            default:
                return paragraph('p', rest);
        }
    }

    private figure(name: string, caption: string): HTMLElement {
        const figure = new Figure(this.client, this.chapter.figures[name], this.words.labels, caption.replace(/[*$]/g, ''));
        this.figures.set(name, figure);
        const told = paragraph('figcaption', caption);
        told.prepend(h('b', {}, `${t('Figure')} ${this.figures.size}. `));
        const link = h('button', { type: 'button', class: 'link' }, t('Open in the full page'));
        link.addEventListener('click', async () => (location.hash = await figure.link()));
        told.append(' ', link);
        return h('figure', {}, figure.element, told);
    }

    // The formula of a figure: signs, its numbers, the core's result.
    private formula(name: string): HTMLElement {
        const figure = this.figures.get(name)!;
        const { formula: text = '' } = figure.data;
        const element = h('div', { class: 'formula' });
        const show = () => {
            const shown = figure.value === null ? text : `${text} ${text.includes('≈') ? '≈' : '='} <value> \\t{ ${figure.unit}}`;
            const names = { ...figure.all(), value: figure.value ?? 0 };
            element.replaceChildren(...shown.split(' \\\\ ').map((line) => formula(line, names, true)));
        };
        const before = figure.onValue;
        figure.onValue = () => {
            before();
            show();
        };
        show();
        return element;
    }

    private panel(tag: string, style: string, parts: string[]): HTMLElement {
        const element = h('section', { class: `ask ${style}`, 'aria-label': t(tag) }, h('p', { class: 'tag' }, t(tag)));
        element.append(paragraph('h3', parts[0]), paragraph('p', parts[1]));
        return element;
    }

    private figureOf(name: string): Figure {
        return this.figures.get(name) ?? new Figure(this.client, this.chapter.figures[name], this.words.labels, '');
    }

    // What may be chosen is told as numbers, multiples of what the core finds before; right is what it finds after.
    private guess(parts: string[]): HTMLElement {
        const { figure: name, before, after, times, afterAt } = this.chapter.guess;
        const element = this.panel('Guess before you look', 'guess', parts);
        const verdict = h('p', { class: 'verdict', role: 'status', hidden: true });
        const figure = this.figureOf(name);
        const options = h('div', { class: 'options', role: 'group', 'aria-label': parts[1] });
        element.append(options, verdict);
        const build = async () => {
            const [first, second] = [await figure.valueWith(before), await figure.valueWith(after, afterAt)];
            const unit = await figure.unitOf();
            if (first === null || second === null) return;
            const off = (factor: number) => Math.abs(second - factor * first);
            const right = times.reduce((best, factor) => (off(factor) < off(best) ? factor : best));
            for (const factor of times) {
                const button = h('button', { type: 'button', 'aria-pressed': 'false' }, `${number(first * factor, 3)} ${unit}`);
                button.addEventListener('click', () => {
                    for (const each of options.children) each.setAttribute('aria-pressed', String(each === button));
                    verdict.hidden = false;
                    verdict.className = `verdict ${factor === right ? 'right' : 'wrong'}`;
                    const words = factor === right ? t('Right.') : t('Not so.');
                    verdict.replaceChildren(h('b', {}, words), ` ${t('It is')} ${number(second, 4)} ${unit}. `, ...inline(parts[2] ?? ''));
                });
                button.dataset.right = String(factor === right);
                options.append(button);
            }
        };
        void build().catch((error) => {
            verdict.hidden = false;
            verdict.textContent = String(error);
        });
        return element;
    }

    private check(parts: string[]): HTMLElement {
        const { figure: name, set } = this.chapter.check;
        const element = this.panel('Check yourself', 'check', parts);
        const figure = this.figureOf(name);
        element.append(
            ...answering({
                judge: (typed) => figure.judged(typed, set, TOLERANCE),
                unit: () => figure.unitOf(),
                onRight: inline(parts[2] ?? ''),
                onWrong: inline(parts[3] ?? ''),
            }),
        );
        return element;
    }

    private end(): HTMLElement {
        const at = this.order.indexOf(this.name);
        const to = (chapter: string | undefined, sign: (title: string) => string) =>
            chapter === undefined ? h('span', {}) : h('a', { href: addressOf(chapter) }, sign(this.titleOf(chapter)));
        const input = h('input', { type: 'number', min: 1, max: LAST_VARIANT, value: '7', id: 'variant' });
        const form = h(
            'form',
            { class: 'variant' },
            h('label', { for: 'variant' }, t('Variant of the exercise')),
            input,
            h('button', { type: 'submit' }, t('Open')),
        );
        const trouble = h('p', { class: 'verdict wrong', role: 'status', hidden: true });
        form.addEventListener('submit', async (event) => {
            event.preventDefault();
            const wanted = Number(input.value);
            const isNumber = Number.isInteger(wanted) && wanted >= 1 && wanted <= LAST_VARIANT;
            const text = isNumber ? await this.client.ask('variant', wanted) : null;
            trouble.hidden = text !== null;
            if (text === null) trouble.textContent = `${t('Variants are numbered from 1 to')} ${LAST_VARIANT}.`;
            else location.hash = `${await packed(text)}&lang=${currentLanguage()}`;
        });
        return h(
            'div',
            { class: 'lesson-end' },
            form,
            trouble,
            h(
                'nav',
                { 'aria-label': t('Chapters') },
                to(this.order[at - 1], (title) => `← ${title}`),
                to(this.order[at + 1], (title) => `${title} →`),
            ),
        );
    }
}

/** Shows the lessons that links ask for, until one asks for something else. */
export async function startLessons(client: Client, root: HTMLElement): Promise<{ lesson: Lesson; client: Client }> {
    document.documentElement.dataset.lesson = '';
    const language = () =>
        new URLSearchParams(location.hash.replace(/^#/, '')).get('lang') ?? document.documentElement.lang;
    const inside = { client } as { lesson: Lesson; client: Client };
    const notice = new LoadingNotice(client);
    const show = () => {
        const wanted = lessonIn(location.hash);
        if (wanted === null) return;
        setLanguage(language().startsWith('ru') ? 'ru' : 'en');
        inside.lesson = new Lesson(client, root, wanted);
        inside.lesson.show();
        notice.relabel();
        root.append(notice.element);
    };
    await client.start(language().startsWith('ru') ? 'ru' : 'en');
    client.onRestart = show;
    window.addEventListener('hashchange', async () => {
        await client.translate(language().startsWith('ru') ? 'ru' : 'en').catch(() => undefined);
        show();
    });
    show();
    return inside;
}
