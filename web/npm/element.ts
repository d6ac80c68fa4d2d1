// SPDX-License-Identifier: MIT
// The element <luxel-scene> as a module of npm, with the page as one file beside it.
import { LuxelScene } from '../page/luxel-scene';

LuxelScene.home = new URL('./luxel.html', import.meta.url).href;

export { LuxelScene };
