// SPDX-License-Identifier: MIT
// Versions of the scene.  Each question to a worker tells of which version it is, and each result keeps it; the model alone
// decides which one is current.

import type { ColourView } from './srgb';

/** A text and the quantity that is asked of it, under a number that is given once. */
export interface Version {
    readonly number: number;
    /** Counts the scenes that were opened: versions of one scene follow from each other by changes. */
    readonly scene: number;
    readonly text: string;
    readonly irradiance: boolean;
    readonly view?: ColourView; // of a picture in colour; the luminance
    readonly name: string; // what the scene is called, for the names of files
}

/** A version as it is computed: with all its light, or direct light alone. */
export interface Of extends Version {
    readonly direct: boolean;
    /** Seconds in which reflected light is solved for, as well as goes; none: as exactly as it should be. */
    readonly within?: number;
}

/** Why a question has no answer: it is of a version that is no longer wanted. */
export class Outdated extends Error {}
