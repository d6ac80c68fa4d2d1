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

/** Fits a canvas to its place on the screen; its width and height in CSS pixels and the context for those. */
export function fitted(canvas: HTMLCanvasElement): [number, number, CanvasRenderingContext2D] {
    const { width, height } = canvas.getBoundingClientRect();
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

// Hues that are told apart by people with deficient colour vision, too (Okabe and Ito).
const LIGHT_COLOURS = ['#e69f00', '#56b4e9', '#009e73', '#cc79a7', '#d55e00', '#0072b2', '#b8a800', '#8a8a8a'];

export function lightColour(index: number): string {
    return LIGHT_COLOURS[index % LIGHT_COLOURS.length];
}

/** A light's number in its colour, as marks, lists and curves show it. */
export function numberMark(context: CanvasRenderingContext2D, x: number, y: number, index: number, chosen: boolean) {
    context.beginPath();
    context.arc(x, y, 9, 0, 2 * Math.PI);
    context.fillStyle = lightColour(index);
    context.fill();
    context.lineWidth = chosen ? 3 : 1.5;
    context.strokeStyle = chosen ? styleColour('--accent') : '#fff';
    context.stroke();
    context.fillStyle = '#000';
    context.font = 'bold 11px system-ui, sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(String(index + 1), x, y + 0.5);
}
