/** What was read: counts, layers with what is done with them, the sheet's border, tolerances, findings. */

import { button, h, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import type { Finding, Loaded } from 'kerfway';
import { type Fate, FATES } from '../session/choices.js';
import type { Preview } from '../session/preview.js';
import type { Session } from '../session/session.js';
import { worked } from '../session/worked.js';
import { FindingList, problemCounts } from './findings.js';
import { layerList } from './layers.js';
import { check, section } from './section.js';
import { tolerances } from './tolerances.js';
import { words } from '../core/words/index.js';

/** CSS pixels of height from which drawing and result fit below each other. */
const ROOMY = 1000;

/** Contours listed one by one where something was decided of many. */
const LISTED = 24;

export function drawingPanel(session: Session, preview: Preview, onFinding: (finding: Finding) => void, onContour: (contour: number) => void): HTMLDetailsElement & { findings: FindingList } {
  const { root, body, setGist } = section(words.drawing.title, innerHeight >= ROOMY);
  const layers = h('div');
  const counts = h('p', { class: 'soft' });
  const findings = new FindingList(onFinding);
  const outline = check(words.drawing.outline, (on) => void session.reread({ ...session.state.load, ignoreOutline: on }));
  const pins = h('div', { class: 'stack' });
  const content = h('div', { class: 'stack' }, counts, layers, outline.root, pins, findings.root, tolerances(session, preview));
  const empty = h('p', { class: 'soft' }, words.drawing.none);
  body.append(empty, content);

  // Those of the drawing, and what a plan finds.
  const showFindings = () => {
    const { loaded, found, beam } = session.state;
    // A plan for a machine with a kerf width measures features again, against that width.
    const ofDrawing = (loaded?.findings ?? []).filter((f) => beam === null || f.code !== 'feature-too-small');
    findings.show([...ofDrawing, ...found]);
  };
  const show = () => {
    const { loaded, load } = session.state;
    empty.hidden = loaded !== null;
    content.hidden = loaded === null;
    if (!loaded) {
      setGist('');
      showFindings();
      return;
    }
    const problems = problemCounts(loaded.findings);
    const contours = worked(loaded);
    setGist([words.drawing.contours(contours.length, count(contours.length)), ...problems].join(', '), problems.length > 0);
    const open = contours.filter((c) => !c.closed).length;
    setText(counts, [words.drawing.parts(loaded.parts.length, count(loaded.parts.length)), open ? words.drawing.openContours(open, count(open)) : '', loaded.version ? versionName(loaded.version) : '']
      .filter(Boolean).join(' · '));
    layers.replaceChildren(layerList(session, loaded));
    pins.replaceChildren(...FATES.flatMap((fate) => listed(session, fate, onContour)));
    outline.root.hidden = !load.ignoreOutline && (loaded.outline === null || suggestedAnyway(loaded, loaded.outline));
    outline.input.checked = load.ignoreOutline ?? false;
    showFindings();
  };
  session.on('loaded', ({ loaded, fresh }) => {
    show();
    // On a low screen the result comes first, unless the drawing wants a look.
    if (fresh && !session.state.sample) root.open = innerHeight >= ROOMY || wantsALook(loaded);
  });
  // What a plan finds comes when it starts.
  let told = session.state.found;
  session.on('change', ({ found, loaded }) => {
    if (found !== told && loaded) showFindings();
    told = found;
  });
  session.on('cleared', show);
  show();
  return Object.assign(root, { findings });
}

/** The contours of which something was decided, each to be shown, and how to take that back. */
function listed(session: Session, fate: Fate, onContour: (contour: number) => void): HTMLElement[] {
  const contours = session.state.load[fate] ?? [];
  if (contours.length === 0) return [];
  const loosen = button(words.drawing.unpin[fate], { class: 'quiet small', 'aria-label': words.drawing.unpinAll[fate], onclick: () => session.loosen(fate) });
  const shown = contours.slice(0, LISTED).map((c) => button(count(c + 1), { class: 'small number', 'aria-label': words.drawing.show(count(c + 1)), onclick: () => onContour(c) }));
  const more = contours.length > LISTED && h('span', { class: 'soft' }, words.drawing.others(count(contours.length - LISTED)));
  return [h('div', { class: 'pins' }, h('span', {}, words.drawing.decided[fate](words.drawing.contours(contours.length, count(contours.length)))), h('span', { class: 'pinned' }, ...shown, more), loosen)];
}

/** Whether there is something in a drawing for a person to decide or see. */
function wantsALook({ findings, layers, outline }: Loaded): boolean {
  return outline !== null || findings.some((f) => f.severity !== 'info') || layers.some((l) => l.suggestion !== null);
}

/** Whether the border is alone on a layer that is suggested to be left out: one suggestion is enough. */
function suggestedAnyway({ contours, layers }: Loaded, outline: number): boolean {
  const layer = layers.find((l) => l.name === contours[outline]?.layer);
  return layer?.suggestion === 'ignore' && layer.contours === 1;
}

const VERSIONS: Record<string, string> = {
  AC1009: 'R12', AC1012: 'R13', AC1014: 'R14', AC1015: 'R2000', AC1018: 'R2004', AC1021: 'R2007', AC1024: 'R2010', AC1027: 'R2013', AC1032: 'R2018',
};

function versionName(version: string): string {
  return words.drawing.version(VERSIONS[version] ?? version);
}
