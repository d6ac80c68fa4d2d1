// SPDX-License-Identifier: MIT
// What the page begins with: the sphere of the lab report, whole in view, under a lamp that can be taken by the hand.

export const FIRST_SCENE = `# A sphere under a lamp: take the lamp and move it
luxel: 1
units: radiometric
screen:   {width: 700, height: 700, resolution: [600, 600]}
observer: {z: 1700, projection: orthographic, view: parallel}
surfaces:
  - type: sphere
    center: [0, 0, 600]
    radius: 300
    material: {model: blinn-phong, diffuse: 0.8, specular: 0.5, shininess: 20}
lights:
  - {type: point, name: lamp, position: [420, 300, 1250], intensity: 10, attenuation: none}
points: [[0, 0], [120, 80], [-150, 0]]
`;
