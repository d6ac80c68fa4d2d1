// SPDX-License-Identifier: MIT
// Elements of the page made in one expression, and small helpers for canvases.

type Child = Node | string | null | undefined | false;

/** Makes an element: properties as attributes, on… as listeners. */
export function h<Name extends keyof HTMLElementTagNameMap>(
    name: Name,
    properties: Record<string, unknown> = {},
    ...children: Child[]
): HTMLElementTagNameMap[Name] {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(properties)) {
        if (value === undefined || value === false || value === null) continue;
        if (key.startsWith('on')) element.addEventListener(key.slice(2), value as EventListener);
        else if (key === 'value' || key === 'checked' || key === 'disabled' || key === 'selected')
            (element as unknown as Record<string, unknown>)[key] = value;
        else element.setAttribute(key, value === true ? '' : String(value));
    }
    for (const child of children) if (child) element.append(child);
    return element;
}

// What fields show, as far as their users have not typed over it.
const shown = new WeakMap<Element, string>();

/** Whether something else is being typed into a field than what it shows of the scene. */
export function isTypedOver(input: HTMLInputElement): boolean {
    return input.value !== (shown.get(input) ?? '');
}

/** Takes what was typed into a field as what it shows. */
export function takeIn(input: HTMLInputElement) {
    shown.set(input, input.value);
}

/** Writes into a field what it shows of the scene; what is being typed into it stays. */
export function showIn(input: HTMLInputElement, text: string) {
    const stays = document.activeElement === input && isTypedOver(input);
    shown.set(input, text);
    if (!stays) input.value = text;
}

/** A select with its options: value and label of each. */
export function choice(label: string, options: [string, string][], value: string, onchange: (value: string) => void) {
    const select = h('select', { 'aria-label': label });
    for (const [key, text] of options) select.append(h('option', { value: key, selected: key === value }, text));
    select.addEventListener('change', () => onchange(select.value));
    return select;
}

const sizes = new WeakMap<Element, { width: number; height: number }>();
const observer = new ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) sizes.set(target, { width: contentRect.width, height: contentRect.height });
});

/** The size of an element without a border on the page, kept so that asking for it in each frame does not lay the page out. */
export function sizeOf(element: Element): { width: number; height: number } {
    const known = sizes.get(element);
    if (known?.width) return known; // what was hidden may have just been shown
    observer.observe(element);
    const { width, height } = element.getBoundingClientRect();
    sizes.set(element, { width, height });
    return { width, height };
}

/** Fits a canvas to its place on the screen; its width and height in CSS pixels and the context for those. */
export function fitted(canvas: HTMLCanvasElement): [number, number, CanvasRenderingContext2D] {
    const { width, height } = sizeOf(canvas);
    const ratio = window.devicePixelRatio || 1;
    const [columns, rows] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (canvas.width !== columns) canvas.width = columns;
    if (canvas.height !== rows) canvas.height = rows;
    const context = canvas.getContext('2d')!;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    return [width, height, context];
}

/** A colour of the page's style. */
export function styleColour(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

const LAMP_COLOURS = 10; // told apart by people with deficient colour vision, too; the style has them

/** The name of a light's colour in the style. */
export function lightStyle(index: number): string {
    return `var(--lamp-${index % LAMP_COLOURS})`;
}

/** A light's colour, for canvases. */
export function lightColour(index: number): string {
    return styleColour(`--lamp-${index % LAMP_COLOURS}`);
}

/** A colour of six digits, in part transparent. */
export function faded(colour: string, alpha: number): string {
    const [r, g, b] = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
    return `rgb(${r} ${g} ${b} / ${alpha})`;
}

/** A light's number in its colour, as lists have it; colours that come again are in squares. */
export function chip(index: number, isOn = true): HTMLElement {
    const shape = index >= LAMP_COLOURS ? ' square' : '';
    const element = h('span', { class: `chip${shape}${isOn ? '' : ' off'}` }, String(index + 1));
    element.style.background = lightStyle(index);
    return element;
}

const RADIUS = 10.5; // of the marks of lights, pixels

/** The same on a canvas; what is chosen has a double ring. */
export function numberMark(context: CanvasRenderingContext2D, x: number, y: number, index: number, chosen: boolean) {
    const radius = chosen ? RADIUS + 1.5 : RADIUS;
    const outline = (r: number) => {
        context.beginPath();
        if (index >= LAMP_COLOURS) context.rect(x - r, y - r, 2 * r, 2 * r);
        else context.arc(x, y, r, 0, 2 * Math.PI);
    };
    for (const [off, style] of chosen ? [[6.5, '#fff'], [5, '#202226']] as const : []) {
        outline(radius + off);
        context.strokeStyle = style;
        context.lineWidth = 1.5;
        context.stroke();
    }
    outline(radius);
    context.fillStyle = lightColour(index);
    context.fill();
    context.lineWidth = 2;
    context.strokeStyle = '#fff';
    context.stroke();
    context.font = '600 12px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.lineWidth = 2.5;
    context.strokeStyle = styleColour('--chip-edge');
    context.strokeText(String(index + 1), x, y + 0.5);
    context.fillStyle = styleColour('--chip-text');
    context.fillText(String(index + 1), x, y + 0.5);
}
