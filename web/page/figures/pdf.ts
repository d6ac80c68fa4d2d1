// SPDX-License-Identifier: MIT
// Drawings as PDF: what an SVG of svg.ts has, lines, areas, words and pictures, on one page of its size.  Words are set in a font
// of outlines that is made of the letters that the drawing has, and tell what they are, so that they are found and copied.
import { deflated } from '../link';
import { letterOf, type Letter } from './outlines';

const POINTS = 0.75; // for one unit of a drawing
const MOST_LETTERS = 255; // of a font: one byte tells which
const MOST_OF_LIST = 100; // entries of a list that says what letters are

/** What stands at a letter's place in its font. */
interface Known extends Letter {
    sign: string;
    font: number;
    code: number;
}

const digits = (value: number) => String(Number(value.toFixed(3)));
const list = (...values: number[]) => values.map(digits).join(' ');
const hex = (value: number, length: number) => value.toString(16).toUpperCase().padStart(length, '0');
const inUtf16 = (text: string) => Array.from({ length: text.length }, (_, i) => hex(text.charCodeAt(i), 4)).join('');

/** A path along places; closed ones end where they began. */
function path(places: [number, number][], isClosed: boolean): string {
    return places.map(([x, y], i) => `${list(x, y)} ${i ? 'l' : 'm'}`).join(' ') + (isClosed ? ' h' : '');
}

const ARC = 0.5523; // of a quarter of a circle

function circle(x: number, y: number, r: number): string {
    const quarters = [0, 1, 2, 3].map((i) => {
        const turned = (a: number, b: number) => {
            const [s, c] = [[0, 1], [1, 0], [0, -1], [-1, 0]][i];
            return [x + r * (a * c - b * s), y + r * (a * s + b * c)];
        };
        return `${list(...turned(1, ARC), ...turned(ARC, 1), ...turned(0, 1))} c`;
    });
    return [`${list(x + r, y)} m`, ...quarters, 'h'].join(' ');
}

class Writer {
    private readonly objects: Uint8Array[] = [];

    /** Takes a place in the file, to be filled now or later; its number. */
    add(...parts: (string | Uint8Array)[]): number {
        this.objects.push(new Uint8Array());
        this.fill(this.objects.length, ...parts);
        return this.objects.length;
    }

    fill(number: number, ...parts: (string | Uint8Array)[]) {
        this.objects[number - 1] = joined(parts);
    }

    async stream(about: string, content: string | Uint8Array): Promise<number> {
        const packed = await deflated(joined([content]));
        return this.add(`<< ${about} /Filter /FlateDecode /Length ${packed.length} >>\nstream\n`, packed, '\nendstream');
    }

    whole(root: number, info: number): Uint8Array<ArrayBuffer> {
        const parts: Uint8Array[] = [joined(['%PDF-1.4\n%\u00e2\u00e3\n'])];
        let length = parts[0].length;
        const places = this.objects.map((object, i) => {
            const at = length;
            const whole = joined([`${i + 1} 0 obj\n`, object, '\nendobj\n']);
            parts.push(whole);
            length += whole.length;
            return at;
        });
        const count = places.length + 1;
        const rows = places.map((at) => `${String(at).padStart(10, '0')} 00000 n \n`);
        const end = `xref\n0 ${count}\n0000000000 65535 f \n${rows.join('')}trailer\n<< /Size ${count} /Root ${root} 0 R /Info ${info} 0 R >>\nstartxref\n${length}\n%%EOF\n`;
        return joined([...parts, end]);
    }
}

function joined(parts: (string | Uint8Array)[]): Uint8Array<ArrayBuffer> {
    const bytes = parts.map((part) => (typeof part === 'string' ? new TextEncoder().encode(part) : part));
    const whole = new Uint8Array(bytes.reduce((sum, { length }) => sum + length, 0));
    bytes.reduce((at, part) => {
        whole.set(part, at);
        return at + part.length;
    }, 0);
    return whole;
}

class Drawing {
    private readonly said: string[] = []; // the page's content
    private readonly letters = new Map<string, Known>(); // by weight and sign
    private readonly pictures: { name: string; object: number }[] = [];

    constructor(private readonly writer: Writer) {}

    async take(element: Element): Promise<void> {
        if (element instanceof SVGTextElement) this.words(element);
        else if (element instanceof SVGImageElement) await this.picture(element);
        else this.shape(element);
        for (const child of element.children) await this.take(child);
    }

    // What an element or what is around it says of itself.
    private told(element: Element, name: string): string | null {
        return element.closest(`[${name}]`)?.getAttribute(name) ?? null;
    }

    private paint(colour: string, isLine: boolean): string {
        const [, r, g, b] = /^#(..)(..)(..)$/.exec(colour.length === 4 ? colour.replace(/\w/g, '$&$&') : colour) ?? ['', '0', '0', '0'];
        return `${list(...[r, g, b].map((part) => parseInt(part, 16) / 255))} ${isLine ? 'RG' : 'rg'}`;
    }

    private shape(element: Element) {
        const number = (name: string) => Number(element.getAttribute(name) ?? 0);
        const outline = this.outline(element, number);
        if (!outline) return;
        const fill = this.told(element, 'fill')!;
        const stroke = element.getAttribute('stroke') ?? 'none';
        const isFilled = fill !== 'none' && element.tagName !== 'line';
        const width = Number(element.getAttribute('stroke-width') ?? 1);
        const dashes = element.getAttribute('stroke-dasharray') ?? '';
        const how = isFilled ? (stroke === 'none' ? 'f' : 'B') : stroke === 'none' ? 'n' : 'S';
        const line = stroke === 'none' ? '' : `${this.paint(stroke, true)} ${digits(width)} w [${dashes}] 0 d 1 j`;
        this.said.push(`q ${isFilled ? this.paint(fill, false) : ''} ${line} ${outline} ${how} Q`);
    }

    private outline(element: Element, number: (name: string) => number): string | null {
        switch (element.tagName) {
            case 'line':
                return path([[number('x1'), number('y1')], [number('x2'), number('y2')]], false);
            case 'rect':
                return `${list(number('x'), number('y'), number('width'), number('height'))} re`;
            case 'circle':
                return circle(number('cx'), number('cy'), number('r'));
            case 'path':
                return (element.getAttribute('d') ?? '').replace(/([ML])([^ML]*)/g, (_, kind: string, place: string) => `${place} ${kind === 'M' ? 'm' : 'l'} `);
            default:
                return null;
        }
    }

    private letter(sign: string, weight: string, family: string): Known {
        const key = `${weight} ${sign}`;
        const known = this.letters.get(key);
        if (known) return known;
        const count = this.letters.size;
        const made = { ...letterOf(sign, weight, family), sign, font: Math.floor(count / MOST_LETTERS), code: (count % MOST_LETTERS) + 1 };
        this.letters.set(key, made);
        return made;
    }

    private words(element: SVGTextElement) {
        const size = Number(this.told(element, 'font-size'));
        const [weight, family] = [this.told(element, 'font-weight') ?? '400', this.told(element, 'font-family')!];
        const letters = [...(element.textContent ?? '')].map((sign) => this.letter(sign, weight, family));
        const length = letters.reduce((sum, { advance }) => sum + advance, 0) * size;
        const share = { middle: 0.5, end: 1 }[this.told(element, 'text-anchor') ?? ''] ?? 0;
        const x = Number(element.getAttribute('x')) - share * length;
        const y = Number(element.getAttribute('y'));
        const turned = element.transform.baseVal.consolidate()?.matrix;
        const placed = turned ? `${list(turned.a, turned.b, turned.c, turned.d, turned.e, turned.f)} cm` : '';
        this.said.push('q', placed, ...this.casing(element, letters, size, x, y));
        this.said.push(this.paint(this.told(element, 'fill')!, false), `BT ${list(size, 0, 0, -size, x, y)} Tm`);
        for (const { font, code } of letters) this.said.push(`/L${font} 1 Tf <${hex(code, 2)}> Tj`);
        this.said.push('ET Q');
    }

    // The seam around words that stand on a picture, below them.
    private casing(element: SVGTextElement, letters: Known[], size: number, x: number, y: number): string[] {
        const stroke = element.getAttribute('stroke');
        if (!stroke) return [];
        let at = x;
        const lines = letters.map(({ outlines, advance }) => {
            const moved = outlines.map((outline) => path(outline.map(([a, b]) => [at + a * size, y - b * size]), true));
            at += advance * size;
            return `${moved.join(' ')} S`;
        });
        return [`${this.paint(stroke, true)} ${element.getAttribute('stroke-width')} w 1 j`, ...lines];
    }

    // Where pixels are transparent, beyond bodies, the ground below the picture is seen.
    private async picture(element: SVGImageElement) {
        const image = new Image();
        image.src = element.getAttribute('href')!;
        await image.decode();
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
        const context = canvas.getContext('2d')!;
        context.fillStyle = this.told(element, 'fill')!;
        context.fillRect(0, 0, canvas.width, canvas.height);
        context.drawImage(image, 0, 0);
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        const levels = data.filter((_, i) => i % 4 !== 3);
        const about = `/Type /XObject /Subtype /Image /Width ${canvas.width} /Height ${canvas.height} /ColorSpace /DeviceRGB /BitsPerComponent 8`;
        const name = `P${this.pictures.length}`;
        this.pictures.push({ name, object: await this.writer.stream(about, new Uint8Array(levels.buffer)) });
        const [x, y, width, height] = ['x', 'y', 'width', 'height'].map((key) => Number(element.getAttribute(key)));
        this.said.push(`q ${list(width, 0, 0, -height, x, y + height)} cm /${name} Do Q`);
    }

    private async font(letters: Known[]): Promise<number> {
        const { writer } = this;
        const places: string[] = [];
        for (const { code, advance, outlines } of letters) {
            const thousandth = (outline: [number, number][]) => outline.map(([a, b]): [number, number] => [Math.round(a * 1e4) / 10, Math.round(b * 1e4) / 10]);
            const drawn = outlines.map((outline) => path(thousandth(outline), true));
            const box = list(advance * 1000, 0, -250, -300, 1500, 1200);
            places.push(`/l${code} ${await writer.stream('', `${box} d1 ${drawn.join('\n')} f*`)} 0 R`);
        }
        const names = letters.map(({ code }) => `/l${code}`).join(' ');
        const widths = letters.map(({ advance }) => digits(advance * 1000)).join(' ');
        return writer.add(
            `<< /Type /Font /Subtype /Type3 /FontBBox [-250 -300 1500 1200] /FontMatrix [0.001 0 0 0.001 0 0] /CharProcs << ${places.join(' ')} >> ` +
                `/Encoding << /Type /Encoding /Differences [1 ${names}] >> /FirstChar 1 /LastChar ${letters.length} /Widths [${widths}] ` +
                `/Resources << >> /ToUnicode ${await this.meanings(letters)} 0 R >>`,
        );
    }

    private meanings(letters: Known[]): Promise<number> {
        const entries = letters.map(({ code, sign }) => `<${hex(code, 2)}> <${inUtf16(sign)}>`);
        const parts: string[] = [];
        for (let i = 0; i < entries.length; i += MOST_OF_LIST) {
            const some = entries.slice(i, i + MOST_OF_LIST);
            parts.push(`${some.length} beginbfchar\n${some.join('\n')}\nendbfchar`);
        }
        return this.writer.stream(
            '',
            `/CIDInit /ProcSet findresource begin 12 dict begin begincmap /CMapName /Luxel def /CMapType 2 def\n1 begincodespacerange <00> <FF> endcodespacerange\n${parts.join('\n')}\nendcmap CMapName currentdict /CMap defineresource pop end end`,
        );
    }

    /** The page's content and what it names. */
    async end(scale: string): Promise<{ content: number; resources: string }> {
        const content = await this.writer.stream('', [scale, ...this.said].join('\n'));
        const all = [...this.letters.values()];
        const fonts: string[] = [];
        for (let i = 0; i * MOST_LETTERS < all.length; i++) fonts.push(`/L${i} ${await this.font(all.filter(({ font }) => font === i))} 0 R`);
        const pictures = this.pictures.map(({ name, object }) => `/${name} ${object} 0 R`);
        return { content, resources: `<< /Font << ${fonts.join(' ')} >> /XObject << ${pictures.join(' ')} >> >>` };
    }
}

/** A drawing of svg.ts as a PDF. */
export async function pdfOf(text: string, width: number, height: number): Promise<Uint8Array<ArrayBuffer>> {
    const svg = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
    const writer = new Writer();
    const drawing = new Drawing(writer);
    for (const child of svg.children) await drawing.take(child);
    const { content, resources } = await drawing.end(`${list(POINTS, 0, 0, -POINTS, 0, POINTS * height)} cm`);
    const pages = writer.add();
    const page = writer.add(`<< /Type /Page /Parent ${pages} 0 R /MediaBox [0 0 ${list(POINTS * width, POINTS * height)}] /Contents ${content} 0 R /Resources ${resources} >>`);
    writer.fill(pages, `<< /Type /Pages /Kids [${page} 0 R] /Count 1 >>`);
    const root = writer.add(`<< /Type /Catalog /Pages ${pages} 0 R >>`);
    const title = svg.querySelector('title')?.textContent ?? '';
    return writer.whole(root, writer.add(`<< /Title <FEFF${inUtf16(title)}> /Creator (Luxel) >>`));
}
