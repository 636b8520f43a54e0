/** Building the page from its parts and telling them of each other. */

import { Announcer } from './core/announce.js';
import { h, icon } from './core/dom.js';
import { acceptDrops, choose, save } from './core/files.js';
import { count, seconds } from './core/format.js';
import { bindKeys } from './core/keys.js';
import { baseName, messageOf } from './core/strings.js';
import { Theme } from './core/theme.js';
import { ContourCard, describe, Tooltip } from './panels/contour.js';
import { dock, head } from './panels/dock.js';
import { drawingPanel } from './panels/drawing.js';
import { helpDialog } from './panels/help.js';
import { machinePanel } from './panels/machine.js';
import { planPanel } from './panels/plan.js';
import { quotePanel } from './panels/quote.js';
import { questionCard } from './panels/question.js';
import { resultPanel } from './panels/result.js';
import { OrderTable } from './panels/table.js';
import { toolbar } from './panels/toolbar.js';
import { topBar } from './panels/topbar.js';
import { playbackBar } from './playback/bar.js';
import { Playback } from './playback/playback.js';
import { Timeline } from './playback/timeline.js';
import { type Fate, fateOf } from './session/choices.js';
import { Queue } from './session/queue.js';
import { read as readAddress } from './session/address.js';
import { Preview } from './session/preview.js';
import { fetchSample, SAMPLES, type Sample } from './session/samples.js';
import { Session } from './session/session.js';
import { worked } from './session/worked.js';
import { attachGestures } from './stage/gestures.js';
import { ramp } from './stage/ramp.js';
import type { Travel } from './stage/raster-messages.js';
import { Scene } from './stage/scene.js';
import { Viewport } from './stage/viewport.js';
import type { Finding, LoadOptions, MachineProfile, OutputKind } from 'kerfway';
import { words } from './core/words/index.js';
import { tooLarge } from 'kerfway';

/** CSS pixels around the pointer in which a contour is picked; a finger is wider. */
const REACH = { pointer: 8, touch: 20 };
/** Pixels of one step of the view by keys. */
const STEP = 60;
/** Milliseconds a notice stays. */
const NOTICE = 12_000;
/** Pixels of the picture's width. */
const PICTURE = 2400;

const FILES: Record<OutputKind, { suffix: string; type: string }> = {
  gcode: { suffix: '.nc', type: 'text/plain' },
  dxf: { suffix: '-ordered.dxf', type: 'image/vnd.dxf' },
  svg: { suffix: '.svg', type: 'image/svg+xml' },
  png: { suffix: '.png', type: 'image/png' },
  json: { suffix: '.plan.json', type: 'application/json' },
};

export async function startPage(): Promise<void> {
  const place = (id: string) => document.getElementById(id)!;
  const first = SAMPLES[0]!;
  // The sample is fetched and the page stands while the planner starts.
  const sampleBytes = fetchSample(first);
  sampleBytes.catch(() => {});
  const theme = new Theme();
  const shared = readAddress(location.hash);
  const session = new Session(shared);
  const { state } = session;
  const stage = place('stage');
  const canvas = place('canvas') as HTMLCanvasElement;
  const viewport = new Viewport();
  const scene = new Scene(canvas, viewport, theme.current);
  const playback = new Playback();
  const announcer = new Announcer(place('announcer'));

  // Files
  const hint = place('hint');
  const hideHint = () => {
    hint.hidden = true;
    layout();
  };
  const openFile = async (file: File, load: LoadOptions | null, begun: () => void) => {
    hideHint();
    const refused = tooLarge(file.size);
    if (refused !== null) {
      begun();
      session.refuse(file.name, refused);
      return;
    }
    try {
      const bytes = await file.arrayBuffer();
      begun();
      await session.open(bytes, file.name, false, load ?? shared.load);
    } catch {
      begun();
      session.refuse(file.name, words.page.unreadable(file.name));
    }
  };
  const queue = new Queue(session, openFile);
  const openSample = async (sample: Sample, bytes: Promise<ArrayBuffer>) => {
    queue.leave();
    try {
      await session.open(await bytes, sample.file, true, { ...sample.options, ...shared.load });
    } catch (error) {
      session.refuse(sample.file, error);
    }
  };
  const chooseFile = () => choose((files) => queue.take(files), { multiple: true });
  acceptDrops((files) => queue.take(files), (over) => document.body.classList.toggle('dropping', over));

  const download = async (kind: OutputKind) => {
    try {
      const data = await session.output(kind, kind === 'png' ? PICTURE : undefined);
      save(data, baseName(state.name) + FILES[kind].suffix, FILES[kind].type);
    } catch (error) {
      tell(messageOf(error));
    }
  };

  // Notices
  const notice = h('div', { class: 'notice', role: 'alert', hidden: true });
  let noticeTimer = 0;
  const tell = (sentence: string) => {
    notice.textContent = sentence;
    notice.hidden = false;
    clearTimeout(noticeTimer);
    noticeTimer = window.setTimeout(() => (notice.hidden = true), NOTICE);
  };
  session.on('notice', tell);

  // Selection
  const tooltip = new Tooltip();
  const select = (contour: number | null, reveal = false) => {
    scene.selected = contour;
    card.show(contour);
    table.select(contour);
    const box = contour === null ? null : scene.boxOf(contour);
    if (reveal && box) viewport.reveal(box);
    if (contour !== null && reveal) announcer.say(describe(session, playback, contour).join(', '));
    scene.invalidate();
  };
  /** Pins a contour to an end of the order or leaves it out; takes that back where it is so already. */
  const decide = (contour: number | null, fate: Fate) => {
    if (contour === null) return;
    const already = fateOf(state.load, contour) === fate;
    const [name = ''] = describe(session, playback, contour);
    session.decide(contour, already ? null : fate);
    announcer.say(already ? words.page.unpinned(name) : words.page.decided[fate](name));
  };
  // The stop stepped to: a contour that is left unfinished has several.
  let stepped = 0;
  const step = (to: number) => {
    stepped = Math.max(0, Math.min(playback.stops - 1, to));
    const contour = playback.path?.contours[stepped];
    if (contour !== undefined) select(contour, true);
  };
  const stepBy = (by: number) => {
    const there = scene.selected !== null && playback.path?.contours[stepped] === scene.selected;
    const at = scene.selected === null ? null : there ? stepped : playback.stopOf(scene.selected);
    step(at === null ? (by > 0 ? 0 : playback.stops - 1) : at + by);
  };
  const card = new ContourCard(session, playback, { decide, step: stepBy, close: () => select(null) });
  const table = new OrderTable(session, playback, (contour) => select(contour, true), () => toggleTable(false));
  const showFinding = (finding: Finding, zoom: boolean) => {
    scene.finding = finding;
    if (zoom && finding.at) {
      // On a phone the sheet of the panels lies over the place to be shown.
      if (document.body.classList.contains('sheet-open')) toggleSheet();
      viewport.showPlace(finding.at[0], finding.at[1]);
    }
    scene.invalidate();
  };

  // Panels
  const toggleSheet = () => {
    const open = document.body.classList.toggle('sheet-open');
    document.querySelector('.sheet-toggle')?.setAttribute('aria-expanded', String(open));
  };
  const preview = new Preview(session);
  preview.on('outlook', (outlook) => {
    scene.marks = outlook?.marks ?? [];
    scene.invalidate();
  });
  const drawing = drawingPanel(session, preview, (finding) => showFinding(finding, true), (contour) => select(contour, true));
  const scroller = place('sections');
  scroller.append(drawing, machinePanel(session, tell, () => choosingHome(true)), planPanel(session), resultPanel(session, theme, (kind) => void download(kind)), quotePanel(session, tell));
  place('dock').append(dock(session, { open: chooseFile, gcode: () => void download('gcode'), sheet: toggleSheet }));
  const help = helpDialog();
  const top = topBar(session, queue, theme, {
    open: chooseFile, sample: (s) => {
      hideHint();
      void openSample(s, fetchSample(s));
    },
    table: () => toggleTable(!table.open), help: () => help.showModal(), panel: () => togglePanel(),
  });
  place('top').append(...top.nodes);
  place('playback').append(...playbackBar(playback));
  const tools = toolbar(viewport, { ramp: (on) => scene.setView({ ramp: on }), air: (on) => scene.setView({ air: on }) });
  const showTheme = () => {
    scene.setTheme(theme.current);
    tools.colors(ramp(theme.current));
  };
  theme.on('change', showTheme);
  showTheme();
  const failure = h('div', { class: 'card failure', role: 'alert', hidden: true });
  stage.append(tools.root, tools.legend, card.root, questionCard(session), failure, table.root, notice, tooltip.root);
  document.body.append(help);

  const toggleTable = (open: boolean) => {
    table.toggle(open);
    top.toggles.table.setAttribute('aria-pressed', String(open));
    if (!open) top.toggles.table.focus();
    layout();
  };
  const togglePanel = () => {
    const closed = document.body.classList.toggle('panel-closed');
    top.toggles.panel.setAttribute('aria-expanded', String(!closed));
  };

  // Layout: the canvas fills the stage; what covers it is left out when fitting.
  const layout = () => {
    const box = stage.getBoundingClientRect();
    const cover = !table.open ? 0 : table.root.getBoundingClientRect().width;
    const side = cover < box.width * 0.7 ? cover : 0;
    stage.style.setProperty('--cover', `${side}px`);
    const tools = toolbarBox();
    viewport.resize(box.width, box.height, { top: hint.hidden ? 32 : 60, right: tools.beside, bottom: 40 + tools.below, left: 40 + side });
  };
  const toolbarBox = () => {
    const { offsetWidth: wide, offsetHeight: high } = tools.root;
    return wide > high ? { beside: 24, below: high } : { beside: wide + 24, below: 0 };
  };
  new ResizeObserver(layout).observe(stage);

  // The next click on the sheet is where the job starts.
  let homeNext = false;
  const choosingHome = (on: boolean) => {
    homeNext = on;
    canvas.classList.toggle('placing', on);
    if (on) tell(words.page.chooseHome);
    else notice.hidden = true;
  };
  const setHome = (x: number, y: number) => {
    choosingHome(false);
    const place = (mm: number) => Math.round(mm * 100) / 100;
    if (state.machine) session.setMachine({ ...state.machine, home: [place(viewport.worldX(x)), place(viewport.worldY(y))] });
  };

  // The stage under the hand
  attachGestures(canvas, viewport, {
    hover(at) {
      const contour = at && scene.pick(at.x, at.y, REACH.pointer);
      scene.hovered = contour ?? null;
      if (at && contour !== null) tooltip.show(describe(session, playback, contour!), at.x, at.y);
      else tooltip.hide();
      canvas.classList.toggle('over', scene.hovered !== null);
      scene.invalidate();
    },
    click(x, y, { touch, shift, alt }) {
      if (homeNext) return setHome(x, y);
      const finding = scene.pickFinding(x, y, touch ? REACH.touch : REACH.pointer + 4);
      if (finding) {
        showFinding(finding, false);
        drawing.open = true;
        drawing.findings.reveal(finding);
        return;
      }
      scene.finding = null;
      const contour = scene.pick(x, y, touch ? REACH.touch : REACH.pointer);
      if (shift || alt) decide(contour, alt ? 'exclude' : 'first');
      else select(contour);
    },
  });
  bindKeys({
    ' ': () => playback.toggle(), f: () => viewport.fit(), '+': () => viewport.zoom(1.4), '=': () => viewport.zoom(1.4), '-': () => viewport.zoom(1 / 1.4),
    ArrowRight: () => stepBy(1), ArrowLeft: () => stepBy(-1), Home: () => step(0), End: () => step(playback.stops - 1),
    'Shift+ArrowLeft': () => viewport.pan(STEP, 0), 'Shift+ArrowRight': () => viewport.pan(-STEP, 0),
    'Shift+ArrowUp': () => viewport.pan(0, STEP), 'Shift+ArrowDown': () => viewport.pan(0, -STEP),
    o: chooseFile, s: () => session.stop(), p: () => (state.phase === 'paused' ? session.resume() : session.pause()), k: () => session.keepImproving(),
    c: () => tools.flip('ramp'), a: () => tools.flip('air'), t: () => toggleTable(!table.open), 'Ctrl+z': () => session.undo(), 'Ctrl+Shift+z': () => session.redo(), 'Ctrl+y': () => session.redo(), '?': () => help.showModal(),
    1: () => decide(scene.selected, 'first'), 0: () => decide(scene.selected, 'last'), x: () => decide(scene.selected, 'exclude'),
    Escape: () => {
      if (homeNext) return choosingHome(false);
      scene.finding = null;
      select(null);
    },
  });

  // The job
  session.on('loaded', ({ loaded, fresh, same }) => {
    playback.setTimeline(null);
    // With the same contours, what is looked at stays.
    const selected = same ? scene.selected : null;
    scene.setDrawing(loaded, state.extent, !same);
    select(selected);
    const contours = worked(loaded).length;
    if (fresh) announcer.say(words.page.read(state.name, words.drawing.contours(contours, count(contours))));
  });
  session.on('cleared', () => {
    playback.setTimeline(null);
    select(null);
    scene.setDrawing(null, state.extent, false);
  });
  session.on('progress', ({ progress, path, machine }) => {
    if (!progress?.path || !path || !machine || !scene.shapes) return;
    const travel = travelOf(machine);
    scene.partitions = state.insights.now?.partitions ?? null;
    scene.setPath(path, travel);
    playback.setTimeline(new Timeline(path, progress.summary.total_time, scene.shapes, scene.lengths, travel, machine.pierce_time + machine.beam_on_delay));
    if (scene.selected !== null) card.show(scene.selected);
    announcer.say(words.page.best(seconds(progress.summary.total_time)));
  });
  session.on('change', () => {
    document.body.dataset.phase = state.phase;
    // Written only when it differs: each writing goes to the browser's process and takes milliseconds.
    const settings = `#${session.address()}`;
    if (session.methods.length > 0 && (location.hash || '#') !== settings) history.replaceState(null, '', settings);
    failure.hidden = state.phase !== 'failed';
    failure.replaceChildren(h('h2', {}, icon('error'), state.name), h('p', {}, state.error ?? ''));
    if (state.phase === 'done' || state.phase === 'paused') announcer.say(head(state));
    tools.common((state.common?.offsets.length ?? 0) > 1);
    if (scene.shapes) scene.setPlanned(state);
    if (state.progress === null && scene.shapes) {
      playback.setTimeline(null);
      scene.partitions = null;
      if (state.machine) scene.setPath(null, travelOf(state.machine));
    }
  });
  playback.on('moment', (moment) => {
    scene.moment = moment;
    scene.invalidate();
  });

  await openSample(first, sampleBytes);
}

function travelOf(machine: MachineProfile): Travel {
  return { home: machine.home, returnHome: machine.return_home, perAxis: machine.travel === 'per-axis' ? machine.rapid.speed : null };
}
