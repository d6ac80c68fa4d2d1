// SPDX-License-Identifier: MIT
// The types of scenes for TypeScript, scene.d.ts: from the JSON Schema, which the core makes of its tables of keys.

const INDENT = '    ';

/** "lights-point" as LightsPoint. */
export function nameOf(definition) {
    return definition.replace(/(^|-)(\w)/g, (_, dash, letter) => letter.toUpperCase());
}

const union = (types) => [...new Set(types)].join(' | ');
const inBrackets = (type) => (type.includes(' | ') ? `(${type})` : type);

function documented(node, indent) {
    const said = [node.description, 'default' in node ? `Default: ${JSON.stringify(node.default)}.` : ''];
    const text = said.filter(Boolean).join(' ').replaceAll('*/', '*\\/');
    return text ? `${indent}/** ${text} */\n` : '';
}

function objectOf(node, indent) {
    const inner = indent + INDENT;
    const lines = Object.entries(node.properties).map(([key, value]) => {
        const mark = node.required?.includes(key) ? '' : '?';
        return `${documented(value, inner)}${inner}${key}${mark}: ${typeOf(value, inner)};\n`;
    });
    return `{\n${lines.join('')}${indent}}`;
}

function arrayOf(node, indent) {
    const item = node.items ? typeOf(node.items, indent) : 'unknown';
    const { minItems: least, maxItems: most } = node;
    if (least === most && least !== undefined) return `[${Array(least).fill(item).join(', ')}]`;
    return `${inBrackets(item)}[]`;
}

/** What JSON Schema calls a type, as TypeScript has it; what neither can say of numbers is left to the core. */
export function typeOf(node, indent = '') {
    if (node.$ref) return nameOf(node.$ref.split('/').pop());
    if (node.enum) return union(node.enum.map((choice) => JSON.stringify(choice)));
    if ('const' in node) return JSON.stringify(node.const);
    if (node.anyOf?.every((each) => each.type || each.enum)) return union(node.anyOf.map((each) => typeOf(each, indent)));
    switch (node.type) {
        case 'array':
            return arrayOf(node, indent);
        case 'object':
            return node.properties ? objectOf(node, indent) : 'object';
        case 'integer':
        case 'number':
            return 'number';
        case 'string':
        case 'boolean':
            return node.type;
        default:
            throw new Error(`a type of scenes that there is no word for: ${JSON.stringify(node).slice(0, 200)}`);
    }
}

/** A definition: of a list's elements, all kinds of them; of a kind, its keys. */
function declaration(name, node, all) {
    const kinds = all.filter((other) => other.startsWith(`${name}-`));
    if (kinds.length) return `export type ${nameOf(name)} = ${union(kinds.map(nameOf))};\n`;
    return `${documented(node, '')}export interface ${nameOf(name)} ${objectOf(node, '')}\n`;
}

/** The text of scene.d.ts. */
export function sceneTypes(schema, builtins) {
    const definitions = Object.entries(schema.definitions).filter(([, node]) => node.type === 'object');
    const names = definitions.map(([name]) => name);
    return [
        '// SPDX-License-Identifier: MIT\n// Scenes, as docs/SCENE.md of Luxel tells them.\n',
        `export type BuiltinName = ${union(builtins.map(({ name }) => JSON.stringify(name)))};\n`,
        `/** A scene. */\nexport interface SceneDocument ${objectOf(schema, '')}\n`,
        ...definitions.map(([name, node]) => declaration(name, node, names)),
    ].join('\n');
}
