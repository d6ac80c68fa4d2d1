// SPDX-License-Identifier: MIT
// Makes the packages for npm: node build.mjs BUILD-WEB FOLDER leaves FOLDER/luxel-core, FOLDER/luxel-scene and both as
// .tgz.  BUILD-WEB holds the core of the package and, for luxel-scene, the page as one file.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { compiled } from '../node_core.mjs';
import { check, SCENES, split } from '../split.mjs';
import { pack } from './pack.mjs';
import { sceneTypes } from './types.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const web = path.dirname(here);
const root = path.dirname(web);
const VERSION = fs.readFileSync(path.join(root, 'meson.build'), 'utf8').match(/version: '([\d.]+)'/)[1];
const ABOUT = { version: VERSION, license: 'MIT AND Apache-2.0', type: 'module' };

async function bundle(entry, target, how) {
    await build({
        entryPoints: [path.join(here, entry)],
        outfile: target,
        bundle: true,
        format: 'esm',
        target: 'es2022',
        minifySyntax: true,
        banner: { js: '// SPDX-License-Identifier: MIT' },
        logLevel: 'error',
        ...how,
    });
}

/** A core of the package for this script. */
async function coreClass() {
    const [file] = (await build({ entryPoints: [path.join(here, 'core.ts')], bundle: true, format: 'esm', write: false })).outputFiles;
    return (await import(`data:text/javascript;base64,${Buffer.from(file.contents).toString('base64')}`)).PackageCore;
}

/** What a program asks until it has shown and probed a plain scene. */
function trial(core) {
    const builtins = core.builtins();
    for (const name of SCENES) {
        const { text } = builtins.find((each) => each.name === name);
        core.settings({});
        check(core.edit(text, []) === text && core.open(text, name), JSON.stringify(core.messages()));
        for (const stride of [4, 1]) check(core.render(stride) && core.field().values.length, 'no picture');
        core.get('lights[0].intensity');
        check(core.scene() && core.probePoints([[10, 20]]), 'no probe');
    }
}

/** The declarations of the package's modules, as the compiler makes them. */
function declarations(folder) {
    const types = path.join(folder, 'types');
    execFileSync('npx', ['tsc', '-p', path.join(here, 'tsconfig.json'), '--outDir', types], { cwd: web, stdio: 'inherit' });
    for (const name of ['index', 'remote', 'results']) {
        const text = fs.readFileSync(path.join(types, `npm/${name}.d.ts`), 'utf8');
        const named = text.replace(/from '(?:#|\.\/)(\w+)'/g, "from './$1.js'");
        fs.writeFileSync(path.join(folder, `${name}.d.ts`), named);
    }
    fs.writeFileSync(path.join(folder, 'worker.d.ts'), '// SPDX-License-Identifier: MIT\nexport {};\n');
    fs.rmSync(types, { recursive: true });
}

function conditions(name) {
    return { types: `./${name}.d.ts`, node: `./${name}_node.js`, default: `./${name}.js` };
}

function describe(folder, about) {
    fs.writeFileSync(path.join(folder, 'package.json'), `${JSON.stringify({ ...about, ...ABOUT }, null, 2)}\n`);
    fs.copyFileSync(path.join(here, `${about.name}.md`), path.join(folder, 'README.md'));
    fs.copyFileSync(path.join(root, 'LICENSE'), path.join(folder, 'LICENSE'));
}

/** What of other hands is inside: libraries of the core, in the words of their licences. */
function licences(folder, sources) {
    const target = path.join(folder, 'LICENSES');
    fs.mkdirSync(target);
    for (const name of fs.readdirSync(sources).sort()) {
        const licence = path.join(sources, name, 'debian/copyright');
        if (fs.existsSync(licence)) fs.copyFileSync(licence, path.join(target, `${name.replace(/-\d.*/, '')}.txt`));
    }
    fs.copyFileSync('/usr/share/emscripten/system/lib/libc/musl/COPYRIGHT', path.join(target, 'musl.txt'));
    fs.copyFileSync(path.join(root, 'LICENSES/Apache-2.0.txt'), path.join(target, 'Apache-2.0.txt'));
}

async function makeCore(builds, folder) {
    const PackageCore = await coreClass();
    const wasm = ['luxel-core.wasm', 'luxel-core-2.wasm'].map((name) => path.join(folder, name));
    await split(path.join(builds, 'core/web/core/luxel-package.wasm'), ...wasm, { Core: PackageCore, trial });
    const core = await PackageCore.start(...(await Promise.all(wasm.map(compiled))));
    fs.writeFileSync(path.join(folder, 'scene.d.ts'), sceneTypes(core.schema(), core.builtins()));
    declarations(folder);
    for (const name of ['index', 'remote', 'worker']) {
        await bundle(`${name}.ts`, path.join(folder, `${name}.js`), { alias: { '#read': path.join(here, 'read_web.ts') } });
        const node = { platform: 'node', alias: { '#read': path.join(here, 'read_node.ts') } };
        await bundle(`${name}.ts`, path.join(folder, `${name}_node.js`), node);
    }
    licences(folder, path.join(builds, 'libraries/sources'));
    describe(folder, {
        name: 'luxel-core',
        description: 'How light sources brighten a surface: exact values with a bound of their error, pictures; WebAssembly',
        keywords: ['lighting', 'photometry', 'radiometry', 'illuminance', 'luminance', 'ies', 'eulumdat', 'webassembly'],
        exports: {
            '.': conditions('index'),
            './remote': conditions('remote'),
            './worker': conditions('worker'),
            './luxel-core.wasm': './luxel-core.wasm',
            './luxel-core-2.wasm': './luxel-core-2.wasm',
            './package.json': './package.json',
        },
        types: './index.d.ts',
        sideEffects: ['./worker.js', './worker_node.js'],
        engines: { node: '>=18' },
    });
}

async function makeElement(builds, folder) {
    await bundle('element.ts', path.join(folder, 'luxel-scene.js'), {});
    fs.copyFileSync(path.join(here, 'luxel-scene.d.ts'), path.join(folder, 'luxel-scene.d.ts'));
    fs.copyFileSync(path.join(builds, 'page/luxel.html'), path.join(folder, 'luxel.html'));
    describe(folder, {
        name: 'luxel-scene',
        description: 'The element <luxel-scene>: a scene of light that is seen and moved in a page',
        keywords: ['lighting', 'custom-element', 'web-component', 'education'],
        exports: {
            '.': { types: './luxel-scene.d.ts', default: './luxel-scene.js' },
            './luxel.html': './luxel.html',
            './package.json': './package.json',
        },
        types: './luxel-scene.d.ts',
        sideEffects: true,
    });
}

const [builds, target] = process.argv.slice(2).map((name) => path.resolve(name));
for (const [name, make] of Object.entries({ 'luxel-core': makeCore, 'luxel-scene': makeElement })) {
    const folder = path.join(target, name);
    if (name === 'luxel-scene' && !fs.existsSync(path.join(builds, 'page/luxel.html'))) {
        console.log('luxel-scene is left out: it brings the page, which `make web` builds');
        continue;
    }
    fs.rmSync(folder, { recursive: true, force: true });
    fs.mkdirSync(folder, { recursive: true });
    await make(builds, folder);
    const archive = path.join(target, `${name}-${VERSION}.tgz`);
    fs.writeFileSync(archive, pack(folder));
    console.log(`${archive} ${fs.statSync(archive).size} bytes`);
}
