// SPDX-License-Identifier: MIT
// The page in Firefox, where there is one: it starts, its numbers are those of Chromium, a lamp moves, and nothing is
// reported.  Firefox is driven by its own protocol, Marionette: texts of JSON with their length before them.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import net from 'node:net';
import os from 'node:os';
import path from 'node:path';
import { check, equal } from './tap.mjs';

export const FIREFOX = process.env.LUXEL_FIREFOX ?? '/usr/bin/firefox-esr';
const PATIENCE = 40000; // milliseconds until it must listen

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

async function freePort() {
    const server = net.createServer().listen(0, '127.0.0.1');
    await new Promise((resolve) => server.once('listening', resolve));
    const { port } = server.address();
    await new Promise((resolve) => server.close(resolve));
    return port;
}

/** A socket once somebody listens there. */
async function connected(port, isAlive) {
    for (const end = Date.now() + PATIENCE; Date.now() < end && isAlive(); await pause(200)) {
        const socket = net.connect(port, '127.0.0.1');
        const is = await new Promise((resolve) => {
            socket.once('connect', () => resolve(true));
            socket.once('error', () => resolve(false));
        });
        if (is) return socket;
    }
    throw new Error('Firefox does not listen');
}

class Marionette {
    constructor(socket) {
        this.socket = socket;
        this.heard = Buffer.alloc(0);
        this.next = 1;
        this.waiting = new Map();
        socket.on('data', (bytes) => this.hear(bytes));
    }

    hear(bytes) {
        this.heard = Buffer.concat([this.heard, bytes]);
        for (;;) {
            const colon = this.heard.indexOf(':');
            const length = Number(this.heard.subarray(0, colon).toString());
            if (colon < 0 || this.heard.length < colon + 1 + length) return;
            const message = JSON.parse(this.heard.subarray(colon + 1, colon + 1 + length).toString());
            this.heard = this.heard.subarray(colon + 1 + length);
            if (!Array.isArray(message)) continue; // what it says of itself at first
            const [, id, error, result] = message;
            const asked = this.waiting.get(id);
            if (error) asked?.reject(new Error(error.message));
            else asked?.resolve(result);
        }
    }

    ask(name, parameters = {}) {
        const id = this.next++;
        const text = JSON.stringify([0, id, name, parameters]);
        this.socket.write(`${Buffer.byteLength(text)}:${text}`);
        return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    }

    async run(script) {
        return (await this.ask('WebDriver:ExecuteScript', { script, args: [] })).value;
    }

    async until(script) {
        for (let i = 0; i < 200; i++, await pause(100)) if (await this.run(script)) return;
        throw new Error(`it never came that ${script}`);
    }
}

const INSIDE = 'const { model } = window.wrappedJSObject?.luxel?.inside ?? window.luxel?.inside ?? {}; ';

async function smoke(firefox, url, value) {
    await firefox.ask('WebDriver:NewSession', { capabilities: {} });
    await firefox.ask('WebDriver:Navigate', { url: `${url}#scene=report` });
    await firefox.until(`${INSIDE} return model?.isSettled && document.querySelector('.value') !== null`);
    equal(await firefox.run(`${INSIDE} return model.picture.facts.maximum.value`), value, 'maximum');
    await firefox.run(
        `${INSIDE} model.moveThing(model.things.find(({ kind }) => kind === 'light'), [1500, 200, 1900], '')`,
    );
    await firefox.until(`${INSIDE} return model.picture?.of.text.includes('[1500, 200, 1900]')`);
    check(await firefox.run("return document.querySelector('.failure') === null"), 'the page failed');
}

/** The same page, where `value` is the maximum of the scene "report" in Chromium. */
export async function inFirefox(url, value) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'luxel-firefox-'));
    const port = await freePort();
    fs.writeFileSync(path.join(folder, 'user.js'), `user_pref("marionette.port", ${port});\n`);
    const child = spawn(FIREFOX, ['--headless', '--no-remote', '--marionette', '--profile', folder], {
        stdio: 'ignore',
        env: { ...process.env, HOME: folder, MOZ_CRASHREPORTER_DISABLE: '1' },
    });
    const ended = new Promise((resolve) => child.once('exit', resolve));
    let socket;
    try {
        socket = await connected(port, () => child.exitCode === null);
        await smoke(new Marionette(socket), url, value);
    } finally {
        socket?.destroy();
        child.kill('SIGKILL');
        await ended;
        fs.rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
    }
}
