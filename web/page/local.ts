// SPDX-License-Identifier: MIT
// Calculations as readers of a language write them: the core's documents have decimal points and the units' international
// signs in formulas, since they are also files that programs read; on the page they follow its language.
import { currentLanguage, t } from './words';

const WIDE = 1; // em: a space that parts formulas of one line, behind whose comma no list goes on

function isListComma(comma: Element): boolean {
    const next = comma.nextElementSibling;
    const space = next?.localName === 'mspace' ? parseFloat(next.getAttribute('width') ?? '0') : 0;
    return comma.textContent === ',' && space < WIDE;
}

/** Numbers in words and cells; keys, commands and scenes stay as they are typed. */
function writeNumbers(text: Text) {
    if (text.parentElement?.closest('code, pre, math, script, style')) return;
    const { data } = text;
    const written = data
        .replace(/(\d)\.(\d)/g, '$1,$2')
        .replace(/(\d)e-(\d)/g, '$1e−$2')
        .replace(/(^|[\s(=])-(\d)/g, '$1−$2');
    if (written !== data) text.data = written;
}

/** A page of the core as the present language writes numbers and units. */
export function localized(html: string): string {
    if (currentLanguage() !== 'ru') return html;
    // The policy of this page takes no style of others, not even while they are read.
    const styles: string[] = [];
    const bare = html
        .replace(/<style>[^]*?<\/style>/g, (style) => `<meta name="style-${styles.push(style) - 1}">`)
        .replace(/ style="/g, ' data-style="');
    const page = new DOMParser().parseFromString(bare, 'text/html');
    for (const number of page.querySelectorAll('mn')) number.textContent = number.textContent!.replace('.', ',');
    for (const sign of page.querySelectorAll('mo')) if (isListComma(sign)) sign.textContent = ';';
    for (const unit of page.querySelectorAll('mi[mathvariant=normal]'))
        if (unit.textContent === 'mm' || unit.textContent === 'm') unit.textContent = t(unit.textContent);
    const texts = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) writeNumbers(texts.currentNode as Text);
    return `<!DOCTYPE html>\n${page.documentElement.outerHTML}`
        .replace(/<meta name="style-(\d+)">/g, (_, i) => styles[Number(i)])
        .replace(/ data-style="/g, ' style="');
}
