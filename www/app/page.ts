/** Builds the page: makes its parts and connects them. What they do is in the controllers, the panels and the session. */

import type { Finding } from 'kerfway';
import { BeforeAfter } from './controllers/before-after.js';
import { dragSheet } from './controllers/bottom-sheet.js';
import { Files } from './controllers/files.js';
import { Help } from './controllers/help.js';
import { JobView } from './controllers/job-view.js';
import { bindKeyboard } from './controllers/keyboard.js';
import { Layout } from './controllers/layout.js';
import { Notices } from './controllers/notices.js';
import { Pointer } from './controllers/pointer.js';
import { Selection } from './controllers/selection.js';
import { Announcer } from './core/announce.js';
import { takeDecimalCommas } from './core/decimal-comma.js';
import { Theme } from './core/theme.js';
import { dock } from './panels/dock.js';
import { firstMachine } from './panels/first-machine.js';
import { drawingPanel } from './panels/drawing.js';
import { machineSection } from './panels/machine-section.js';
import { placementSection } from './panels/placement-section.js';
import { planSection } from './panels/plan-section.js';
import { questionCard } from './panels/question.js';
import { resultPanel } from './panels/result.js';
import { laterSection } from './panels/section.js';
import { toolbar } from './panels/toolbar.js';
import { topBar } from './panels/topbar.js';
import { playbackBar } from './playback/bar.js';
import { Playback } from './playback/playback.js';
import type { Alternatives } from './session/alternatives.js';
import { readAddress } from './session/address.js';
import { Keeper } from './session/keeper.js';
import { keepSample, keptSample } from './session/kept-sample.js';
import { isRefusedOffBed } from './session/off-bed.js';
import { bedAround } from './session/placing.js';
import { fetchSample, SAMPLES } from './session/samples.js';
import { Session } from './session/session.js';
import { longestTime } from './session/state.js';
import { translate } from './core/markup.js';
import { words } from './core/words/index.js';
import { ramp } from './stage/ramp.js';
import { Scene } from './stage/scene.js';
import { Viewport } from './stage/viewport.js';

export async function startPage(): Promise<void> {
  const element = (id: string) => document.getElementById(id)!;
  translate();
  takeDecimalCommas();
  // The sample is fetched, and the page is built, while the planner starts.
  const before = keptSample();
  const first = before?.sample ?? SAMPLES[0]!;
  const sampleBytes = fetchSample(first);
  sampleBytes.catch(() => {}); // `openSample` reports it.
  const shared = readAddress();
  const session = new Session(shared);
  const theme = new Theme();
  const playback = new Playback();
  const viewport = new Viewport();
  const canvas = element('canvas') as HTMLCanvasElement;
  const scene = new Scene(canvas, viewport, theme.current);
  const announcer = new Announcer(element('announcer'));
  const notices = new Notices();
  const notify = (sentence: string) => notices.show(sentence);

  const files = new Files(session, notices, shared.load, () => layout.hideHint());
  const selection = new Selection(session, playback, scene, announcer, () => layout.toggleTable(false), () => layout.update());
  const tools = toolbar(viewport, { ramp: (on) => scene.setView({ colors: on ? 'order' : 'plain' }), layers: (on) => scene.setView({ colors: on ? 'layers' : 'plain' }), air: (on) => scene.setView({ air: on }), measure: (on) => void pointer.measure(on), several: (on) => {
    selection.several = on;
    canvas.classList.toggle('selecting', on);
  } });
  const restart = async () => {
    await keeper.settled();
    const start = () => location.reload();
    const isOwn = session.drawing.source !== null && !session.state.sample;
    // Of several files only the open one is kept, and in some browsers none, so the person decides when.
    const lost = files.queue.items.length > 0 ? words.settings.later : isOwn && !keeper.keeps ? words.page.nothingKept : null;
    if (lost === null) start();
    else notices.show(lost, { label: words.settings.reload, act: () => void keeper.settled().then(start) });
  };
  const top = topBar(session, files.queue, theme, {
    open: () => files.choose(), sample: (sample) => files.chooseSample(sample),
    table: () => layout.toggleTable(), help: () => void help.open(), panel: () => layout.togglePanel(), restart: () => void restart(), notKept: () => notify(words.page.nothingKept),
  });
  const question = questionCard(session);
  const layout = new Layout(viewport, { stage: element('stage'), hint: element('hint'), toolbar: tools.root, table: selection.table, card: selection.card.root, question, toggles: top.toggles, showOne: () => void orders.setBeside(false) });

  const help = new Help(notify);
  const showPlaceOf = (finding: Finding) => {
    selection.showFinding(finding);
    if (!finding.at) return;
    layout.closeSheet();
    viewport.showPlace(...finding.at);
  };
  const keeper = new Keeper(session);
  keepSample(session);
  const forget = async () => {
    await keeper.forget();
    notices.show(words.page.forgotten);
  };
  const drawing = drawingPanel(session, (marks) => scene.highlight({ marks }), { keeper, forget: () => void forget() }, showPlaceOf, (contour) => selection.reveal(contour), (contours) => selection.selectAll(contours));
  const showInList = (finding: Finding) => {
    drawing.open = true;
    drawing.findings.reveal(finding);
  };
  const placement = placementSection(session, notify, { drag: (on) => pointer.dragJob(on), showBed: () => showBed(session, viewport) });
  const pointer: Pointer = new Pointer(canvas, scene, session, playback, selection, notices, announcer, showInList, (on) => placement.setDragging(on));
  const place = () => {
    layout.showPanel();
    void placement.reveal();
  };
  const program = () => (isRefusedOffBed(session.state) ? place() : void files.download(session.state.machine?.takes ?? 'gcode'));
  bindKeyboard({ session, playback, viewport, files, layout, pointer, selection, help, flip: tools.flip, program });
  let made: Promise<Alternatives> | null = null;
  // The planner of comparisons is loaded when somebody compares.
  const alternatives = () => (made ??= import('./session/alternatives.js').then((module) => new module.Alternatives(session)));
  const orders = new BeforeAfter({ session, scene, playback, stage: element('stage'), alternatives, theme: () => theme.current, relayout: (begins) => {
    if (!begins) return layout.update();
    selection.select(null);
    layout.toggleTable(false);
    viewport.fit(false);
  } });
  new JobView({ session, scene, playback, announcer, notices, selection, orders, showStage: () => layout.closeSheet(), showCommon: tools.common });

  const quote = laterSection(words.quote.title, async (section) => (await import('./panels/quote.js')).quoteContent(session, section, notify), notify);
  element('top').replaceChildren(...top.nodes);
  element('sections').replaceChildren(
    firstMachine(session), drawing, machineSection(session, notify, { chooseHome: () => pointer.chooseHome(), placeJoints: (show) => pointer.togglePlacing(show) }), placement.root, planSection(session, notify),
    resultPanel(session, theme, { download: (kind) => void files.download(kind), saveProject: () => void files.saveProject(), saveReport: () => void files.saveReport(), copyProgram: () => void files.copyProgram() }, alternatives), quote.root);
  element('dock').append(dock(session, { open: () => files.choose(), program, place, sheet: () => layout.toggleSheet() }));
  dragSheet(document.querySelector('.dock-state')!, element('sections'), { open: () => document.body.classList.contains('sheet-open'), toggle: () => layout.toggleSheet() });
  element('playback').append(...playbackBar(playback, () => longestTime(session.state)));
  element('stage').append(tools.root, orders.root, tools.legend, selection.card.root, question, notices.failure, selection.table.root, notices.notice, pointer.tooltip.root);

  const showTheme = () => {
    document.documentElement.dataset.painted = theme.current;
    scene.setTheme(theme.current);
    orders.setTheme(theme.current);
    tools.colors(ramp(theme.current));
  };
  theme.on('change', showTheme);
  showTheme();

  await files.begin(keeper.last(location.hash === ''), () => void forget(), first, sampleBytes, before?.decided);
}

/** Shows the whole bed and the job. */
function showBed({ state: { placing, machine, loaded, extent } }: Session, viewport: Viewport): void {
  const bed = bedAround(placing, machine, loaded);
  if (bed) viewport.show([Math.min(bed[0], extent[0]), Math.min(bed[1], extent[1]), Math.max(bed[2], extent[2]), Math.max(bed[3], extent[3])]);
}
