// SPDX-License-Identifier: MIT
// A plain server of static files, as the page wants no more; it counts what is asked for.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const TYPES = {
    '.html': 'text/html',
    '.js': 'text/javascript',
    '.css': 'text/css',
    '.json': 'application/json',
    '.wasm': 'application/wasm',
};

/** Serves a folder, and pages that are made by the test: by name their text, or who answers with the usual bytes. */
export function serve(folder, pages = {}) {
    const asked = [];
    const server = http.createServer((request, response) => {
        const name = path.basename(request.url.split('?')[0]) || 'index.html';
        asked.push(name);
        const file = path.join(folder, name);
        if (typeof pages[name] === 'function') pages[name](response, fs.readFileSync(file));
        else if (pages[name])
            response.writeHead(200, { 'content-type': TYPES[path.extname(name)] ?? 'text/plain' }).end(pages[name]);
        else if (!fs.existsSync(file)) response.writeHead(404).end();
        else
            response
                .writeHead(200, { 'content-type': TYPES[path.extname(name)] ?? 'application/octet-stream' })
                .end(fs.readFileSync(file));
    });
    return new Promise((resolve) =>
        server.listen(0, '127.0.0.1', () =>
            resolve({ server, asked, url: `http://127.0.0.1:${server.address().port}/index.html` }),
        ),
    );
}
