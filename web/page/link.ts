// SPDX-License-Identifier: MIT
// Scenes in links: #s= holds the text, compressed; #scene= the name of a built-in one.  What stands behind # is sent to
// no server.

async function through(
    bytes: Uint8Array<ArrayBuffer>,
    stream: GenericTransformStream,
): Promise<Uint8Array<ArrayBuffer>> {
    const piped = new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array>);
    return new Uint8Array(await new Response(piped as ReadableStream<Uint8Array<ArrayBuffer>>).arrayBuffer());
}

/** Bytes in fewer, as zlib packs them. */
export function deflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
    return through(bytes, new CompressionStream('deflate'));
}

export async function packed(text: string): Promise<string> {
    const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
    let binary = '';
    for (const byte of bytes) binary += String.fromCharCode(byte);
    return `#s=${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

const MOST = 1 << 22; // bytes of a text; a few of a link could unpack to very many

/** The text or the name in a link; null: there is none.  Throws where it is damaged. */
export async function unpacked(fragment: string): Promise<{ text?: string; name?: string } | null> {
    const found = /^#(?:.*&)?(s|scene)=([^&]*)/.exec(fragment);
    if (!found) return null;
    if (found[1] === 'scene') return { name: decodeURIComponent(found[2]) };
    const binary = atob(found[2].replaceAll('-', '+').replaceAll('_', '/'));
    const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
    if (bytes.length > MOST) throw new Error('too long');
    const text = await through(bytes, new DecompressionStream('deflate-raw'));
    if (text.length > MOST) throw new Error('too long');
    return { text: new TextDecoder('utf-8', { fatal: true }).decode(text) };
}

export function download(name: string, content: BlobPart, type: string) {
    const url = URL.createObjectURL(new Blob([content], { type }));
    const anchor = document.createElement('a');
    anchor.href = url;
    anchor.download = name;
    document.body.append(anchor);
    anchor.click();
    anchor.remove();
    setTimeout(() => URL.revokeObjectURL(url), 10000);
}
