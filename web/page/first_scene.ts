// SPDX-License-Identifier: MIT
// The scene that the page begins with, where its link names no other: a still life in a window's soft light.
import type { Language } from './words';

export const FIRST_NAME = 'still-life';
export const FIRST_TITLE = 'Still life by a window';

const NAMES: Record<Language, string[]> = {
    en: ['table', 'wall', 'glazed ball', 'chalk ball', 'block', 'window', 'bulb', 'room'],
    ru: ['стол', 'стена', 'глазурованный шар', 'меловой шар', 'брусок', 'окно', 'лампочка', 'комната'],
};

/** Its text, with the names of its things in a language. */
export function firstScene(language: Language): string {
    const [table, wall, glazed, chalk, block, window, bulb, room] = NAMES[language];
    return `# ${FIRST_TITLE}
luxel: 1
units: photometric
screen: {width: 1500, height: 1000, resolution: [480, 320]}
observer: {position: [420, -2300, 1250], target: [40, 0, 190], up: [0, 0, 1], projection: perspective}
surfaces:
  - {type: rectangle, name: ${table}, center: [0, 0, 0], size: [7000, 7000], material: {model: lambert, diffuse: 0.5, over_pi: true}}
  - {type: rectangle, name: ${wall}, center: [0, 560, 0], size: [7000, 7000], axis: [0, -1, 0], up: [0, 0, 1], material: {model: lambert, diffuse: 0.45, over_pi: true}}
  - type: sphere
    name: ${glazed}
    center: [-190, 60, 210]
    radius: 210
    material: {diffuse: 0.45, specular: 0.1, shininess: 90, highlight: cosine, normalized: true, over_pi: true}
  - {type: sphere, name: ${chalk}, center: [270, -120, 105], radius: 105, material: {model: lambert, diffuse: 0.8, over_pi: true}}
  - {type: box, name: ${block}, center: [360, 200, 130], size: [240, 240, 260], rotate: [0, 0, 28], up: z, material: {model: lambert, diffuse: 0.6, over_pi: true}}
lights:
  - {type: planar, name: ${window}, rectangle: {center: [-1150, -260, 760], size: [620, 820], aim: [60, 40, 150], up: [0, 0, 1]}, radiance: 2600}
  - {type: point, name: ${bulb}, position: [620, -40, 560], intensity: 26}
  - {type: ambient, name: ${room}, irradiance: 45}
points: [[-260, 60], [150, -150], [330, 60]]
`;
}
