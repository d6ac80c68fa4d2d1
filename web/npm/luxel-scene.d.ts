// SPDX-License-Identifier: MIT
/**
 * A scene that is seen and moved: `<luxel-scene scene="report" view="both"></luxel-scene>`.  Attributes: `scene` (a
 * built-in one), `view` (picture, space, both), `lang` (en, ru), `label`, `files` (what the scene names, fetched by the
 * page), `src` (where luxel.html lies, unless it is beside the module).  A scene of one's own stands in it as
 * `<script type="text/yaml">`.  Each change is told by the event "luxel-change", whose detail has the text.
 */
export declare class LuxelScene extends HTMLElement {
    /** Where luxel.html lies. */
    static home: string;
    /** The text of the scene as it is now; setting it shows another. */
    text: string;
}

declare global {
    interface HTMLElementTagNameMap {
        'luxel-scene': LuxelScene;
    }
    interface HTMLElementEventMap {
        'luxel-change': CustomEvent<{ text: string }>;
    }
}
