/** What was read from the drawing: counts, layers with their operations, the border of the sheet, pinned and skipped contours, tolerances, findings. */

import { button, h, setText } from '../core/dom.js';
import { count, extent } from '../core/format.js';
import { leave, refill } from '../core/refill.js';
import { messageOf } from '../core/strings.js';
import { activeContours, type Finding, type Loaded } from 'kerfway';
import type { ChangeMark } from '../session/comparison.js';
import type { Keeper } from '../session/keeper.js';
import { partsOf } from '../session/parts.js';
import { namesContours } from '../session/rules.js';
import type { Session } from '../session/session.js';
import { findingActions } from './finding-actions.js';
import { FindingList, problemCounts } from './findings.js';
import { layerList } from './layers.js';
import type { Pins } from './pins.js';
import { laterDetails, section } from './section.js';
import { words } from '../core/words/index.js';

/** Height in CSS pixels from which the drawing and the result fit below each other. */
const ROOMY = 1000;
/** How many shapes with several copies are listed. */
const COPIES = 4;

/** `mark` marks on the sheet what other tolerances would change. */
export function drawingPanel(session: Session, mark: (changes: ChangeMark[]) => void, { keeper, forget }: { keeper: Keeper; forget: () => void }, onFinding: (finding: Finding) => void, onContour: (contour: number) => void, onContours: (contours: readonly number[]) => void): HTMLDetailsElement & { findings: FindingList } {
  const { root, body, setGist } = section(words.drawing.title, innerHeight >= ROOMY);
  // Whether the person has opened the section, which stays open then.
  let opened = false;
  root.firstElementChild!.addEventListener('click', () => (opened = !root.open));
  const layers = h('div');
  const copies = h('div', { class: 'copies' });
  const counts = h('p', { class: 'soft' });
  const findings = new FindingList(onFinding, (finding) => findingActions(session, finding));
  // Most jobs have no pinned or skipped contours, so their lists are loaded with the first one.
  const pins = h('div', { hidden: true });
  let lists: Pins | null = null;
  let areLoading = false;
  const loadPins = async () => {
    areLoading = true;
    try {
      lists = new (await import('./pins.js')).Pins(session, onContour);
      pins.replaceWith(lists.root);
      lists.show();
    } catch (error) {
      session.store.notify(messageOf(error));
    }
    areLoading = false;
  };
  const showPins = () => {
    if (lists !== null) lists.show();
    else if (!areLoading && namesContours(session.state.load)) void loadPins();
  };
  const kept = h('p', { class: 'soft kept', hidden: true }, words.page.kept, ' ', button(words.page.forget, { class: 'quiet small', onclick: forget }));
  const tolerances = laterDetails(words.drawing.tolerances, async () => (await import('./tolerances.js')).tolerances(session, mark), (sentence) => session.store.notify(sentence));
  const content = h('div', { class: 'stack' }, counts, copies, layers, pins, findings.root, tolerances, kept);
  const empty = h('p', { class: 'soft unread' }, words.drawing.none);
  body.append(empty, content);

  // The parts of which there are several copies; a click selects them.
  const showCopies = (loaded: Loaded) => {
    const parts = partsOf(loaded);
    const repeated = parts.isGrouped ? parts.repeated() : [];
    const one = ({ parts: same }: (typeof repeated)[number]) => {
      const [first = 0] = same;
      const [x0, y0, x1, y1] = parts.boxOf(parts.contours(first));
      return button(words.drawing.copies(count(same.length), extent(x1 - x0, y1 - y0)), { class: 'small number', title: words.drawing.copiesHint, onclick: () => onContours(same.flatMap((p) => parts.contours(p))) });
    };
    const more = repeated.length > COPIES && h('span', { class: 'soft' }, words.drawing.others(count(repeated.length - COPIES)));
    refill(copies, ...repeated.slice(0, COPIES).map(one), ...(more ? [more] : []));
    copies.hidden = repeated.length === 0;
  };
  const showCounts = (loaded: Loaded, contours = activeContours(loaded)) => {
    const open = contours.reduce((n, c) => n + Number(!c.closed), 0);
    const parts = partsOf(loaded);
    const kinds = parts.isGrouped ? parts.kinds : loaded.parts.length;
    const different = kinds < loaded.parts.length ? words.drawing.kinds(kinds, count(kinds)) : '';
    setText(counts, [words.drawing.parts(loaded.parts.length, count(loaded.parts.length)) + different, open ? words.drawing.openContours(open, count(open)) : '', loaded.version ? versionName(loaded.version) : '']
      .filter(Boolean).join(' · '));
  };
  // The findings about the drawing, then those of the plan.
  const showFindings = () => {
    const { loaded, planFindings, beam } = session.state;
    // A plan for a machine with a kerf width measures features again, against that width.
    const ofDrawing = (loaded?.findings ?? []).filter((f) => beam === null || f.code !== 'feature-too-small');
    const all = [...ofDrawing, ...planFindings];
    findings.show(all);
    // On a phone there is room for the gravest only; the list below has them all.
    const gravest = problemCounts(all)[0];
    const contours = loaded ? activeContours(loaded).length : 0;
    setGist(loaded ? [words.drawing.contours(contours, count(contours)), gravest?.text].filter(Boolean).join(', ') : '', gravest?.severity);
  };
  const show = () => {
    const { loaded } = session.state;
    empty.hidden = loaded !== null;
    content.hidden = loaded === null;
    if (!loaded) {
      showFindings();
      return;
    }
    const contours = activeContours(loaded);
    refill(layers, layerList(session, loaded));
    showPins();
    showCounts(loaded, contours);
    showCopies(loaded);
    showFindings();
    if (!partsOf(loaded).isGrouped) void group(loaded);
  };
  // The shapes of very many parts are found little by little.
  const group = async (loaded: Loaded) => {
    await partsOf(loaded).group();
    if (session.state.loaded !== loaded) return;
    showCounts(loaded);
    showCopies(loaded);
  };
  session.store.on('loaded', ({ loaded, fresh }) => {
    // A field that is typed into does not stay for the layer of another drawing.
    if (fresh) layers.replaceChildren();
    show();
    // What is said of another drawing is new; it has not moved from where the lines about the drawing before were.
    if (fresh) body.append(content);
    // On a low screen the result comes first, unless the person should look at the drawing.
    if (fresh && !session.state.sample) root.open = opened || innerHeight >= ROOMY || needsAttention(loaded);
  });
  // The findings of the plan arrive when it starts. What layers do where nothing is set for them depends on the machine.
  let shown = session.state;
  session.store.on('change', (state) => {
    const { planFindings, loaded, machine, material } = state;
    if (planFindings !== shown.planFindings && loaded) showFindings();
    if ((machine !== shown.machine || material !== shown.material) && loaded) refill(layers, layerList(session, loaded));
    shown = state;
  });
  const showKept = () => {
    if (!keeper.keeps) leave(kept);
    kept.hidden = !keeper.keeps;
  };
  // The next choice is made in lists that have the one before, although the drawing is still being read with it.
  session.store.on('decided', showPins);
  keeper.on('change', showKept);
  session.store.on('loaded', showKept);
  session.store.on('cleared', show);
  show();
  return Object.assign(root, { findings });
}

/** Whether there is something in a drawing that a person should decide or see. */
function needsAttention({ findings, layers, outline }: Loaded): boolean {
  return outline !== null || findings.some((f) => f.severity !== 'info') || layers.some((l) => l.suggestion !== null);
}

const VERSIONS: Record<string, string> = {
  AC1009: 'R12', AC1012: 'R13', AC1014: 'R14', AC1015: 'R2000', AC1018: 'R2004', AC1021: 'R2007', AC1024: 'R2010', AC1027: 'R2013', AC1032: 'R2018',
};

function versionName(version: string): string {
  return words.drawing.version(VERSIONS[version] ?? version);
}
