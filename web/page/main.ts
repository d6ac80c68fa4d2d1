// SPDX-License-Identifier: MIT
// The page: what stands where, and what each control does.
import './style.css';
import { BalancePanel } from './balance';
import type { Builtin } from './core';
import { Client, hasVectors, Interrupted } from './client';
import { scaleControls, sideControls, viewControl, zoomButtons } from './controls';
import { Compare } from './compare';
import { Dial } from './dial';
import { h, isTypedOver, showIn, sizeOf, styleColour } from './dom';
import { Embedding, wishes } from './embedding';
import { Figures } from './figures/figures';
import { Finder } from './find';
import { Files } from './files';
import { Form } from './form';
import { FIRST_NAME, FIRST_TITLE, firstScene } from './first_scene';
import { Gallery } from './gallery';
import { GridsPanel } from './grids/panel';
import { header } from './header';
import { Histogram } from './histogram';
import { download, packed, unpacked } from './link';
import { keep, kept } from './keeping';
import { jump, KeysHelp } from './keys_help';
import { Layout, type Camera } from './layout';
import { lessonIn, startLessons } from './lessons/lesson';
import { LoadingNotice } from './loading';
import { Looks } from './looks';
import { Messages } from './messages';
import { Model, type Thing } from './model';
import { Explanation, lightName, ProbePanel } from './panels';
import { PictureView } from './picture';
import { polarOf } from './figures/polar';
import { PointsPanel } from './points';
import { Saving } from './saving';
import { SectionPanel } from './section';
import { Several } from './several';
import { Sharing } from './sharing';
import { placeWords, SpaceView } from './space';
import type { Place } from './space_math';
import { Statistics } from './statistics';
import { standWords } from './sun/sun';
import { Task, taskIn } from './task';
import { TextEditor } from './text';
import { Outdated } from './version';
import { WorkNotice } from './work';
import { currentLanguage, exactly, number, setLanguage, t, type Language } from './words';

const HINT = 'Drag a lamp – the light follows';
const FIRST_PICTURE = 'first picture'; // a mark of the browser's measurements
const MOMENT = 1000; // milliseconds that what it does not need waits for it
const HINTED = 'luxel-hinted'; // of the browser's storage

const NO_VECTORS =
    'This browser cannot run Luxel: it needs WebAssembly with SIMD (Chromium 91, Firefox 89, Safari 16.4 or newer).';
const SAME_PLACE = 2e-3; // of the screen: within it two lines of sight meet the same place
const LONGEST_TITLE = 34; // letters that the bar has room for

/** The licences that the page was made with, taken out of its footer. */
function licences(): HTMLElement {
    const footer = document.querySelector('footer');
    footer?.remove();
    return h('div', { class: 'licences dim' }, ...(footer?.children ?? []));
}

class Page {
    private readonly app = document.getElementById('app')!;
    private readonly model = new Model();
    private readonly compare = new Compare(this.model);
    private readonly section = new SectionPanel(this.model, this.compare);
    private readonly several = new Several(this.model);
    private readonly picture = new PictureView(this.model, this.compare, this.section, this.several);
    private view!: HTMLSelectElement; // of pictures in colour
    private readonly dial = new Dial(this.picture.scale);
    private readonly space = new SpaceView(this.model, () => this.picture.shownScale, this.several);
    private readonly form = new Form(
        this.model,
        () => (this.space.selected?.kind === 'light' ? this.space.selected.index : 0),
        this.several.element,
    );
    private readonly text = new TextEditor(this.model);
    private readonly probe = new ProbePanel(this.model, this.compare);
    private readonly balance = new BalancePanel(this.model);
    private readonly files = new Files(this.model);
    private readonly gallery = new Gallery(this.model.client);
    private readonly embedding = new Embedding(this.model);
    private readonly explanation = new Explanation(this.model, (html) =>
        download(`${this.model.version.name}-explanation.html`, html, 'text/html'),
    );
    private readonly work = new WorkNotice(this.model);
    private readonly looks = new Looks(this.model, this.picture, this.space);
    private readonly figures = new Figures(this.model, this.picture, this.section);
    private readonly saving = new Saving(this.model, this.picture, (text, milliseconds) => this.say(text, milliseconds));
    private readonly sharing = new Sharing(this.model, this.looks, () => this.stageAsPicture());
    private readonly task = new Task(this.model);
    private readonly readout = h('output', { class: 'readout', hidden: true, 'aria-hidden': 'true' });
    private readonly messages = new Messages(this.model);
    private readonly stale = h('p', { class: 'stale', role: 'alert', hidden: true });
    private readonly loading = new LoadingNotice(this.model.client);
    private readonly layout = new Layout();
    private readonly licences = licences();
    private readonly keysHelp = new KeysHelp();
    private readonly finder = new Finder();
    private readonly toast = h('p', { class: 'toast', role: 'status', hidden: true });
    private readonly points = new PointsPanel(this.model);
    private readonly statistics = new Statistics(this.model);
    private readonly histogram = new Histogram(this.model);
    private readonly grids = new GridsPanel(this.model);
    private readonly chosen = h('p', { class: 'chosen', 'aria-live': 'polite' });
    private showBar: (title: string) => void = () => undefined;
    private low!: HTMLInputElement;
    private high!: HTMLInputElement;
    private locked!: HTMLInputElement;
    private builtins: Builtin[] = [];
    private linkTimer = 0;
    private isReadoutOfProbe = true;
    private isTelling = false; // the readout names a thing or a size rather than a value
    private hasBegun = false; // a scene was opened

    async start() {
        setLanguage(this.firstLanguage());
        if (!hasVectors()) {
            this.fail(NO_VECTORS);
            return;
        }
        const started = this.model.client.start(currentLanguage());
        this.offer([]);
        this.listen();
        this.build(); // while the core is on its way
        try {
            this.offer(await started);
        } catch (error) {
            this.fail('Luxel could not be loaded.', String(error));
            return;
        }
        await this.openFirst();
        this.hintFirst();
        this.embedding.begin();
        await this.firstPicture();
        await this.form.reload();
    }

    // What the first picture does not need comes after it, or after a moment where there is none.
    private firstPicture(): Promise<void> {
        return new Promise((resolve) => {
            this.model.listen((topic) => topic === 'picture' && requestAnimationFrame(() => setTimeout(resolve)));
            setTimeout(resolve, MOMENT);
        });
    }

    private firstLanguage(): Language {
        let kept: string | null = null;
        try {
            kept = localStorage.getItem('luxel-language');
        } catch {
            // A frame may be without storage; then the browser's language counts.
        }
        const wanted = wishes(location.hash).language ?? kept ?? navigator.language;
        return wanted.startsWith('ru') ? 'ru' : 'en';
    }

    private fail(message: string, detail = '') {
        this.app.replaceChildren(h('p', { class: 'failure', role: 'alert' }, t(message), ' ', detail));
    }

    private async openFirst() {
        const named = (wanted: string) => this.builtins.find(({ name }) => name === wanted);
        let wanted: { name: string; text: string } = this.builtins[0];
        try {
            const linked = await unpacked(this.task.scene || location.hash);
            const builtin = linked?.name ? named(linked.name) : undefined;
            if (linked?.text !== undefined) wanted = { name: 'scene', text: linked.text };
            else if (builtin) wanted = builtin;
            else if (linked) this.say(`${t('There is no built-in scene of this name')}: ${linked.name}`);
        } catch {
            this.say(t('The link holds no scene that can be read.'));
        }
        const before = this.hasBegun ? null : kept();
        this.hasBegun = true;
        if (before && !this.task.data) this.model.resumeHistory(before);
        else this.openText(wanted.text, wanted.name);
        this.looks.take(location.hash);
        this.showTask();
        this.build(); // the controls show what the link has set
    }

    // The task that the link sets: of the scene that it opens.
    private showTask() {
        const { step } = this.task;
        if (!step) return;
        this.task.begin();
        this.picture.asked = step.at;
        this.picture.hidesValues = this.task.hides('values');
        const mark = (place: number[] | null) => {
            this.space.asked = place;
            this.space.draw();
        };
        void this.task.position().then(mark, () => undefined);
    }

    private listen() {
        this.model.client.onRestart = () => {
            this.say(t('The core failed and was started anew. Nothing is lost.'));
            this.model.recover(t('The core fails on this scene. Change it, or undo.'));
        };
        this.model.listen((topic) => {
            if (topic === 'begin') this.clear();
            else if (topic === 'text') this.textChanged();
            else if (topic === 'scene') this.sceneChanged();
            else if (topic === 'geometry') this.geometryChanged();
            else if (topic === 'picture') void this.pictureChanged();
            else if (topic === 'light') this.lightChanged();
            this.work.show();
            this.showBusy();
        });
        const ofPicture = () => this.model.picture?.of ?? null;
        this.model.follow(this.picture.canvas, ofPicture);
        this.model.follow(
            () => [this.dial.element, this.low, this.high],
            () => (this.picture.scale.locked ? null : ofPicture()),
        );
        this.model.follow(this.chosen, () => this.model.whole);
        this.model.follow(this.readout, () => this.probe.shown);
        this.picture.onProbe = (x, y) => {
            this.probe.ask(x, y);
            this.section.through(x, y);
            this.keepAddress();
        };
        this.points.onChoose = this.histogram.onChoose = (x, y) => this.picture.moveProbe(x, y);
        this.layout.onChart = (chart) => {
            this.histogram.isShown = chart === 'histogram';
            this.grids.isShown = chart === 'grids';
        };
        this.grids.onChange = () => {
            this.space.measured = this.grids.inSpace;
            this.space.draw();
        };
        this.points.place = () => this.picture.probe ?? [0, 0];
        this.probe.onValue = (probe) => {
            this.space.probe = this.picture.known = probe;
            this.dial.mark(probe?.value ?? null);
            this.space.draw();
            if (this.picture.lit) this.picture.draw();
            if (this.isReadoutOfProbe) this.readout.textContent = this.probe.told;
        };
        this.probe.onLit = (lit, of) => this.form.tellLit(lit?.shares ?? [], of);
        this.form.onPolar = (index) => this.figures.open(String(index));
        this.form.onAim = (index) => {
            const aim = this.model.aimOf(index);
            const place = this.space.probe;
            if (aim && place && place.surface !== null) void this.model.moveThing(aim, place.position, '');
        };
        this.picture.onHand = (x, y) => {
            this.isTelling = false;
            this.isReadoutOfProbe = true;
            this.readout.textContent = this.probe.told;
            this.showReadout(x, y);
        };
        this.space.onPlace = (place, x, y) => {
            this.isTelling = false;
            void this.pointInSpace(place, x, y);
        };
        this.space.onTell = (text, x, y) => this.tellBeside(text, x, y);
        this.space.onHover = (thing) => this.hover(thing);
        this.space.onDrag = () => this.hintDone();
        this.space.onMade = () => this.tellMissing();
        this.picture.onMark = (thing, x, y) => {
            if (thing) this.tellBeside(this.space.nameOf(thing), x, y);
            this.hover(thing);
        };
        this.picture.onDrag = (place, x, y) => {
            this.hintDone();
            this.tellBeside(place && placeWords(place), x, y);
        };
        this.explanation.onPoint = (vector, place) => {
            this.space.lit = this.picture.lit = vector;
            if (vector) this.picture.moveProbe(...place); // the hand may have moved it on its way
            this.picture.draw();
            this.space.draw();
        };
        this.form.onHover = (list, index) => {
            const kinds = list === 'lights' ? ['light', 'direction'] : ['surface'];
            this.space.hovered = list ? (this.model.things.find((each) => kinds.includes(each.kind) && each.index === index) ?? null) : null;
            this.space.draw();
        };
        this.several.onChange = () => {
            this.form.markSeveral(this.several.all);
            this.picture.draw();
            this.space.draw();
        };
        this.form.onChooseMore = (index, isRange) => {
            const { selected } = this.space;
            if (isRange && selected && selected.kind !== 'surface' && selected.kind !== 'observer') this.several.from(selected.index, index);
            else this.several.toggle(index, selected);
        };
        this.layout.onLook = (camera, go) => this.fly(camera, go);
        this.layout.onTab = () => this.text.textChanged();
        this.layout.onCamera = () => this.cameraChanged();
        this.picture.onPaint = () => this.space.draw();
        this.picture.onWhy = () => this.why();
        const select = (thing: Thing | null) => {
            this.picture.selected = this.space.selected = thing;
            if (thing) this.layout.follow(thing.kind === 'observer' ? 'place' : thing.kind === 'surface' ? 'matter' : 'light');
            this.picture.draw();
            this.space.draw();
            this.showChosen();
        };
        this.picture.onSelect = select;
        this.space.onSelect = select;
        this.form.onChoose = (list, index) => {
            this.several.clear();
            const kinds = list === 'lights' ? ['light', 'direction'] : ['surface'];
            select(this.model.things.find((each) => kinds.includes(each.kind) && each.index === index) ?? null);
        };
        this.sharing.onStep = (step) => this.say(`${t('Set up the scene and the probe, then press Share: step')} ${step}`);
        this.task.onStep = () => void this.openFirst();
        this.embedding.onText = (text) => this.openText(text);
        this.files.onScene = (text, name) => this.openText(text, name);
        this.files.onTrouble = (text) => this.say(text);
        // What a worker was asked that had to make way is asked anew of the next scene.
        window.addEventListener(
            'unhandledrejection',
            (event) =>
                (event.reason instanceof Interrupted || event.reason instanceof Outdated) && event.preventDefault(),
        );
        window.addEventListener('hashchange', () => {
            const isOther = JSON.stringify(taskIn(location.hash)) !== JSON.stringify(this.task.data);
            if (isOther && !isLesson()) location.reload();
            else void this.openFirst();
        });
        if (this.embedding.view === 'all' && !this.task.data) window.addEventListener('pagehide', () => keep(this.model));
        window.addEventListener('keydown', (event) => this.key(event));
        document.addEventListener('dragover', (event) => event.preventDefault());
        document.addEventListener('drop', (event) => {
            event.preventDefault();
            this.files.take([...(event.dataTransfer?.files ?? [])]);
        });
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.redraw());
        this.section.onLine = () => this.picture.draw();
        this.dial.onChange = () => this.pictureChanged();
        this.compare.onChange = () => {
            this.pictureChanged();
            this.section.draw();
        };
        this.finder.onChoose = ({ path, tab }) => {
            this.layout.open(tab);
            this.form.show(path);
        };
        this.gallery.onChoose = ({ text, name }) => this.openText(text, name);
        this.messages.onShow = (message) => {
            this.layout.open('text');
            this.text.show(message);
        };
    }

    private key(event: KeyboardEvent) {
        const { target } = event;
        if (target instanceof HTMLCanvasElement && !event.ctrlKey && !event.metaKey && !event.altKey) this.stageKey(event.key);
        // What is being typed is undone by the browser, letter by letter; what was taken is a step of the history.
        const isField = target instanceof HTMLInputElement && !['checkbox', 'range', 'file'].includes(target.type);
        const isTyping = target instanceof HTMLTextAreaElement || (isField && isTypedOver(target));
        const isBare = !event.ctrlKey && !event.metaKey && !event.altKey;
        if (isBare && event.key === 'F6') {
            jump(event.shiftKey ? -1 : 1);
            return event.preventDefault();
        }
        if (isBare && event.key === '?' && !isTyping && !isField) return this.keysHelp.open();
        if (!(event.ctrlKey || event.metaKey)) return;
        if (event.code === 'KeyK' && !event.shiftKey && !event.altKey && this.find()) return event.preventDefault();
        if (isTyping) return;
        const letter = event.key.toLowerCase();
        if (letter === 'z' && !event.shiftKey) this.model.undo();
        else if (letter === 'y' || (letter === 'z' && event.shiftKey)) this.model.redo();
        else return;
        event.preventDefault();
    }

    // Looks for a parameter, where the drawer is shown; false: it is not.
    private find(): boolean {
        if (this.embedding.view !== 'all' || !this.model.scene) return false;
        const all = this.form.parameters().filter(({ tab }) => !this.task.hides(tab));
        this.finder.open(all);
        return true;
    }

    // A lamp is chosen by its number.
    private chooseLamp(number: number) {
        const thing = this.model.things.find((each) => ['light', 'direction'].includes(each.kind) && each.index === number - 1);
        if (thing) this.space.select(thing);
    }

    // Keys of the stage, whichever camera it has.
    private stageKey(key: string) {
        if (/^[1-9]$/.test(key)) this.chooseLamp(Number(key));
        else if (key === 'v' || key === 'V') this.space.nextSide();
        else if (key === 'o' || key === 'O') this.switchCamera();
        else if (key === '[' || key === ']') this.dial.turn(key === ']' ? 0.5 : -0.5);
        else if (key === 'w' || key === 'W') void this.why();
        else if (key === 'p' || key === 'P') this.points.add();
        else if (key === 'a' || key === 'A') this.addLamp();
        else this.thingKey(key.length === 1 ? key.toLowerCase() : key);
    }

    // Keys for what is chosen: D duplicates it, Delete removes it, S has a lamp alone, H switches it.
    private thingKey(key: string) {
        if (this.several.all.length) return this.keyOfSeveral(key);
        const { selected } = this.space;
        if (!selected || selected.kind === 'observer' || this.model.isFixed(selected)) return;
        const { index } = selected;
        const list = selected.kind === 'surface' ? 'surfaces' : 'lights';
        if (key === 'd') void this.model.duplicate(list, [index]);
        else if (key === 'Delete') void this.model.change([{ remove: `${list}[${index}]` }]);
        else if (key === 's' && list === 'lights') void this.model.solo(index);
        else if (key === 'h' && list === 'lights')
            void this.model.change([{ set: `lights[${index}].enabled=${!this.model.scene?.lights[index]?.enabled}` }]);
    }

    // One like the chosen lamp, or the first.
    private addLamp() {
        const chosen = this.space.selected?.kind === 'light' ? this.space.selected.index : 0;
        void this.model.addLight(this.model.scene?.lights[chosen]?.type ?? 'point', chosen);
    }

    private keyOfSeveral(key: string) {
        if (key === 'd') void this.several.duplicate();
        else if (key === 'Delete') void this.several.remove();
        else if (key === 'h') void this.several.toggleLight();
    }

    private switchCamera() {
        if (this.embedding.view === 'picture' || this.embedding.view === 'space') return;
        this.layout.look(this.layout.camera === 'space' ? 'picture' : 'space');
        (this.layout.camera === 'space' ? this.space : this.picture).canvas.focus();
    }

    // Everything that has words; called anew for another language.
    private build() {
        this.picture.relabel();
        this.space.relabel();
        this.text.relabel();
        this.dial.relabel();
        this.compare.relabel();
        this.loading.relabel();
        this.task.relabel();
        this.several.relabel();
        if (this.space.hint) this.space.hint = t(HINT);
        const { layout } = this;
        const main = layout.build({
            space: this.space.canvas,
            picture: this.picture.canvas,
            readout: this.readout,
            notices: [this.loading.element, this.work.element, this.stale],
            tools: [zoomButtons((factor) => this.zoomBy(factor)), sideControls(this.space)],
            dial: this.dial.element,
            chosen: this.chosen,
            values: this.values(),
            form: this.form.element,
            look: this.look(),
            text: this.text.element,
            below: [this.files.element, this.messages.element],
            charts: {
                section: this.section.element,
                points: this.points.element,
                histogram: this.histogram.element,
                grids: this.grids.element,
                balance: this.balance.element,
            },
            task: this.task.data && this.task.element,
            hidden: (tab) => this.task.hides(tab === 'charts' ? 'values' : tab),
        });
        const parts = [
            this.header(),
            main,
            this.embedding.link(),
            this.toast,
            this.explanation.dialog,
            this.gallery.dialog,
            this.sharing.dialog,
            this.figures.dialog,
            this.keysHelp.dialog,
            this.finder.dialog,
        ];
        this.app.replaceChildren(...parts.filter((part) => part !== null));
        this.stale.textContent = t('The scene has errors. What is dimmed is of the last scene without errors.');
        this.tellCharts();
        this.tellSmall();
        this.showHistory();
    }

    private values(): HTMLElement {
        const why = h('button', { type: 'button', class: 'link', onclick: () => this.why() }, t('Why?'));
        return h(
            'section',
            { class: 'values floating', 'aria-label': t('Value') },
            h('h2', { class: 'unseen' }, t('Value')),
            this.probe.element,
            why,
        );
    }

    // The tab of how it is shown.
    private look(): HTMLElement[] {
        const title = (words: string) => h('h3', {}, t(words));
        return [
            title('Scale'),
            this.newScaleControls(),
            this.statistics.element,
            title('Section'),
            this.section.controls(),
            title('Compare'),
            this.compare.element,
            this.compare.summary,
            this.licences,
        ];
    }

    // What the stage shows, on its ground.
    private stageAsPicture(): HTMLCanvasElement | null {
        const { canvas } = this.layout.camera === 'space' ? this.space : this.picture;
        if (canvas.width < 2) return null;
        const made = h('canvas', { width: canvas.width, height: canvas.height });
        const context = made.getContext('2d')!;
        const ground = context.createLinearGradient(0, 0, 0, made.height);
        ground.addColorStop(0, styleColour('--stage-top'));
        ground.addColorStop(1, styleColour('--stage-low'));
        context.fillStyle = ground;
        context.fillRect(0, 0, made.width, made.height);
        context.drawImage(canvas, 0, 0);
        return made;
    }

    private zoomBy(factor: number) {
        if (this.layout.camera === 'space') this.space.zoomBy(factor);
        else this.picture.zoomBy(factor);
    }

    // What only some scenes have.
    private tellCharts() {
        this.layout.offer('balance', !!this.model.whole?.reflects);
        this.tellMissing();
        this.layout.offer('grids', !!this.model.scene?.grids || !!this.model.scene?.observers);
    }

    // Of reflected light, in space.
    private tellMissing() {
        const of = this.space.stage.made?.of;
        const isRough = of?.within !== undefined && this.model.work?.state !== 'done';
        this.layout.tellMissing(of && this.model.isPartial(of) ? t('direct light alone') : isRough ? t('reflected light roughly') : '');
    }

    private header(): HTMLElement {
        const made = header(this.model, {
            gallery: () => this.gallery.open(this.builtins),
            take: (files) => this.files.take(files),
            save: (ending) => (ending === 'figure' ? this.figures.open() : void this.saving.save(ending)),
            keys: () => this.keysHelp.open(),
            share: () => void this.sharing.open(this.picture.probe ?? [0, 0]),
            changeLanguage: (code) => this.changeLanguage(code),
        });
        this.showBar = made.show;
        return made.element;
    }

    private newScaleControls(): HTMLElement {
        const controls = scaleControls(this.picture, this.dial, () => this.pictureChanged());
        [this.low, this.high] = controls.ends;
        this.locked = controls.locked;
        this.view = viewControl(this.model.version.view ?? 'luminance', (view) => this.model.setView(view));
        this.view.hidden = true;
        controls.element.prepend(this.view);
        return controls.element;
    }

    // The scenes that can be opened by name: the first one, and those of the core.
    private offer(builtins: Builtin[]) {
        const language = currentLanguage();
        this.builtins = [{ name: FIRST_NAME, title: t(FIRST_TITLE), text: firstScene(language) }, ...builtins];
    }

    private async changeLanguage(code: Language) {
        let builtins: Builtin[] = [];
        try {
            builtins = await this.model.translate(code);
        } catch {
            this.say(t('The words of that language could not be loaded. The page keeps its own.'));
            this.build();
            return;
        }
        setLanguage(code);
        this.offer(builtins);
        try {
            localStorage.setItem('luxel-language', code);
        } catch {
            // Without storage the choice lasts as long as the page.
        }
        this.build();
        await this.form.reload();
        await this.pictureChanged();
        this.sceneChanged();
        this.lightChanged();
        this.grids.again();
    }

    private openText(text: string, name?: string) {
        this.model.begin(text, name);
    }

    /** Shows nothing of the scene before, as another one was opened. */
    private clear() {
        const { picture, space, probe, section, points, balance, form, explanation, statistics, histogram, grids } = this;
        const parts = [picture, space, probe, section, points, balance, form, explanation, statistics, histogram, grids];
        for (const part of parts) part.clear();
        this.readout.textContent = '';
        this.readout.hidden = true;
        this.isTelling = false;
        this.stale.hidden = true;
        this.app.classList.remove('is-stale');
        this.app.dataset.stride = '0';
        this.dial.element.hidden = true; // its range and unit were those of the picture before
        this.layout.tellSize('');
        for (const input of [this.low, this.high]) if (!this.picture.scale.locked) showIn(input, '');
        this.compare.tell();
        this.messages.show();
        this.files.show();
        this.showChosen();
    }

    // Screen readers hear that numbers are on their way.
    private showBusy() {
        const isBusy = !this.model.stale && !this.model.isSettled && !this.model.isStopped;
        this.app.querySelector('main')?.setAttribute('aria-busy', String(isBusy));
    }

    private async why() {
        if (this.task.hides('values')) return;
        const [x, y] = this.picture.probe ?? [0, 0];
        await this.explanation.show(x, y);
    }

    private textChanged() {
        this.text.textChanged();
        this.showHistory();
        this.keepAddress();
    }

    // The address of the page is a link to what it shows, as soon as the hand rests.
    private keepAddress() {
        clearTimeout(this.linkTimer);
        if (!this.hasBegun || this.embedding.view !== 'all' || this.task.data) return;
        this.linkTimer = window.setTimeout(async () => {
            history.replaceState(null, '', (await packed(this.model.text)) + this.looks.told());
            keep(this.model);
        }, 600);
    }

    // The number beside the hand, or above the finger, which hides what it points at; null: no hand is there.
    private showReadout(x: number, y: number | null) {
        this.readout.hidden = y === null;
        if (y === null) return;
        const { width } = sizeOf(this.readout.parentElement!);
        const isRight = x > width / 2;
        Object.assign(this.readout.style, {
            insetBlockStart: `${Math.max(8, y - 46)}px`,
            left: isRight ? 'auto' : `${x + 18}px`,
            right: isRight ? `${width - x + 18}px` : 'auto',
        });
    }

    private tellBeside(text: string | null, x: number, y: number) {
        this.isTelling = text !== null;
        this.isReadoutOfProbe = false;
        if (text) this.readout.textContent = text;
        this.readout.hidden = !text;
        if (text) this.showReadout(x, y);
    }

    private hover(thing: Thing | null) {
        const list = !thing || thing.kind === 'observer' ? null : thing.kind === 'surface' ? 'surfaces' : 'lights';
        this.form.markHovered(list, thing?.index ?? 0);
    }

    // Who has never dragged anything is told that lamps are dragged.
    private hintFirst() {
        try {
            if (localStorage.getItem(HINTED)) return;
        } catch {
            return; // it would come again and again
        }
        if (this.embedding.view !== 'all' || this.task.data) return;
        this.space.hint = t(HINT);
        this.space.draw();
    }

    private hintDone() {
        if (!this.space.hint) return;
        this.space.hint = '';
        try {
            localStorage.setItem(HINTED, '1');
        } catch {
            // It has been said once, at least.
        }
    }

    private showHistory() {
        const { name } = this.model.version;
        const title = this.builtins.find((each) => each.name === name)?.title;
        this.showBar(title && title.length <= LONGEST_TITLE ? title : name === 'scene' ? t('Scene') : name);
    }

    private sceneChanged() {
        this.stale.hidden = !this.model.stale;
        this.app.classList.toggle('is-stale', this.model.stale);
        this.text.number();
        this.files.show();
        this.messages.show();
        if (this.model.stale) this.form.showMessages();
        else this.form.refresh();
    }

    private geometryChanged() {
        this.tellCharts();
        this.space.geometryChanged();
        this.showChosen();
        this.picture.geometryChanged();
        this.askForNumbers();
        void this.balance.refresh();
    }

    /** Asks for all numbers anew: of another version of the scene, or with light that was not known before. */
    private askForNumbers() {
        const first = (this.model.scene?.points[0] as [number, number] | undefined) ?? [0, 0];
        this.picture.moveProbe(...(this.picture.probe ?? first));
        void this.points.refresh();
    }

    private lightChanged() {
        this.askForNumbers();
        void this.balance.refresh();
    }

    private showChosen() {
        const thing = this.model.things.find(
            ({ key, kind }) => key === this.space.selected?.key && kind === this.space.selected.kind,
        );
        const words = {
            light: 'light',
            aim: 'aim of light',
            direction: 'direction of light',
            surface: 'surface',
            observer: 'observer',
        };
        const which =
            thing &&
            (thing.kind === 'light' || thing.kind === 'aim' || thing.kind === 'direction'
                ? lightName(this.model, thing.index)
                : thing.kind === 'surface'
                  ? String(thing.index + 1)
                  : '');
        this.chosen.classList.toggle('none', !thing);
        const list = !thing || thing.kind === 'observer' ? null : thing.kind === 'surface' ? 'surfaces' : 'lights';
        this.form.markChosen(list, thing?.index ?? 0);
        const where = (of: Thing) => (of.sun ? `(${standWords(of.sun)})` : `(${of.at.map((c) => number(c, 5)).join('; ')}) ${t('mm')}`);
        this.chosen.textContent = thing
            ? `${t('Selected')}: ${t(words[thing.kind])} ${which} ${where(thing)}`
            : `${t('Selected')}: ${t('nothing')}`;
    }

    private async pictureChanged() {
        if (this.model.picture && !performance.getEntriesByName(FIRST_PICTURE).length) performance.mark(FIRST_PICTURE);
        this.locked.checked = this.picture.scale.locked;
        await this.picture.pictureChanged();
        const scale = this.picture.shownScale;
        this.view.hidden = !this.model.picture?.facts.colour;
        this.compare.tell();
        for (const [input, value] of [
            [this.low, scale.low],
            [this.high, scale.high],
        ] as const)
            showIn(input, number(value, 4));
        this.dial.element.hidden = !this.model.picture;
        this.dial.draw(scale);
        this.keepAddress();
        this.statistics.show();
        this.histogram.show();
        const { picture, scene } = this.model;
        this.layout.tellSize(picture ? `${picture.facts.columns} × ${picture.facts.rows}` : '');
        this.dial.tellUnit(scene?.unit === 'relative' ? t('relative') : (scene?.unit ?? ''));
        this.app.dataset.stride = String(this.model.picture?.stride ?? 0);
    }

    // The newest place that the hand points at in space.
    private pointed: { x: number; y: number } | null = null;
    private isPointing = false;

    private async pointInSpace(place: Place | null, x: number, y: number) {
        this.pointed = place && { x, y };
        if (!place) this.readout.hidden = true;
        if (this.isPointing) return;
        this.isPointing = true;
        while (this.pointed) {
            const { pointed } = this;
            this.pointed = null;
            await this.probeInSpace(pointed).catch(() => undefined);
        }
        this.isPointing = false;
    }

    // The probe goes to where the observer sees the place; of what is hidden from it, the value as it is seen from here is told.
    private async probeInSpace({ x, y }: { x: number; y: number }) {
        const whole = this.model.asWhole();
        if (!whole || !this.model.isCurrent(whole)) return;
        const { client, screen, scene } = this.model;
        const here = await this.space.valueAt(x, y); // the distances of pixels are too coarse to tell places apart by
        if (!here || here.surface === null || !this.model.isCurrent(whole) || !scene) return;
        if (this.isTelling) return;
        const seen = await client.ask('project', whole, here.position);
        const isBeside = !seen || [0, 1].some((axis) => Math.abs(seen[axis]) > screen[axis] / 2);
        const met = isBeside ? null : await client.ask('probe', whole, seen[0], seen[1]);
        if (!this.model.isCurrent(whole) || this.isTelling) return;
        const isMet = met && met.surface !== null;
        const off = isMet ? Math.hypot(...met.position.map((c, axis) => c - here.position[axis])) : Infinity;
        if (seen && off < SAME_PLACE * Math.max(...screen)) {
            this.isReadoutOfProbe = true;
            this.picture.moveProbe(seen[0], seen[1]);
            return this.showReadout(x, y);
        }
        if (typeof here.value !== 'number') return;
        this.isReadoutOfProbe = false;
        const unit = scene.unit === 'relative' ? t('relative') : scene.unit;
        const source = this.model.source();
        const partial = source && this.model.isPartial(source.of) ? `, ${t('direct light alone')}` : '';
        this.readout.textContent = `${exactly(here.value, here.error)} ${unit} (${t('not seen by the observer')}${partial})`;
        this.showReadout(x, y);
    }

    // Space and the picture are two cameras: one flies from one to the other.
    private fly(camera: Camera, go: () => void) {
        const { width, height } = this.readout.parentElement!.getBoundingClientRect();
        const pixels = (name: string) => parseFloat(getComputedStyle(this.app).getPropertyValue(name)) || 0;
        const clear = width - pixels('--clear');
        const below = pixels('--clear-below');
        const { factor } = this.picture.frame(clear, height - below);
        const to = this.space.observerView(factor, [(clear - width) / 2, below / 2]);
        if (!to || this.model.stale) return go();
        if (camera === 'picture') return this.space.fly(to, false, go);
        go();
        this.space.fly(to, true, () => undefined);
    }

    private cameraChanged() {
        this.tellSmall();
        this.readout.hidden = true;
        this.redraw();
    }

    private tellSmall() {
        this.model.isSmall = this.layout.camera === 'space' && this.embedding.view === 'all';
    }

    private redraw() {
        this.picture.draw();
        this.space.draw();
        this.dial.draw(this.picture.shownScale);
        this.section.draw();
        this.histogram.draw();
    }

    private toastTimer = 0;

    // Says something for a while; an empty text: nothing more.
    private say(text: string, milliseconds = 6000) {
        this.toast.textContent = text;
        this.toast.hidden = !text;
        clearTimeout(this.toastTimer);
        if (milliseconds < Infinity) this.toastTimer = window.setTimeout(() => (this.toast.hidden = true), milliseconds);
    }

    /** For the tests: what there is to look at, and a fault in the core. */
    get inside() {
        const { model, picture, space, section, compare, dial, builtins } = this;
        const polar = (index: number) => polarOf(model, index);
        return { model, picture, space, section, compare, dial, builtins, polar, open: (text: string) => this.openText(text) };
    }
}

/** The lessons, where the link asks for one. */
class Lessons {
    inside: unknown = null;

    async start() {
        const root = document.getElementById('app')!;
        const fail = (message: string, detail = '') =>
            root.replaceChildren(h('p', { class: 'failure', role: 'alert' }, t(message), ' ', detail));
        if (!hasVectors()) return fail(NO_VECTORS);
        try {
            this.inside = await startLessons(new Client(), root);
        } catch (error) {
            fail('Luxel could not be loaded.', String(error));
        }
    }
}

const isLesson = () => lessonIn(location.hash) !== null;
const page = isLesson() ? new Lessons() : new Page();
(window as unknown as { luxel: Page | Lessons }).luxel = page;
window.addEventListener('hashchange', () => isLesson() !== page instanceof Lessons && location.reload());
page.start();
