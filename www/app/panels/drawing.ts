/** What was read: counts, layers with what is done with them, the sheet's border, tolerances, findings. */

import { button, h, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import type { Finding, Loaded } from 'kerfway';
import type { Session } from '../session/session.js';
import { FindingList } from './findings.js';
import { layerList } from './layers.js';
import { check, field, section } from './section.js';
import { words } from '../core/words/index.js';

/** CSS pixels of height from which drawing and result fit below each other. */
const ROOMY = 1000;

/** What a tolerance is when nobody chose one, mm; as `LoadOptions` says. */
const DEFAULTS = { joinTolerance: 0.05, tolerance: 0.005 };

export function drawingPanel(session: Session, onFinding: (finding: Finding) => void): HTMLDetailsElement & { findings: FindingList } {
  const { root, body, setGist } = section(words.drawing.title, innerHeight >= ROOMY);
  const layers = h('div');
  const counts = h('p', { class: 'soft' });
  const findings = new FindingList(onFinding);
  const outline = check(words.drawing.outline, (on) => void session.reread({ ...session.state.load, ignoreOutline: on }));
  const tolerances = h('details', { class: 'more' }, h('summary', {}, words.drawing.tolerances),
    toleranceField(session, 'joinTolerance', words.drawing.join), toleranceField(session, 'tolerance', words.drawing.curves));
  const pins = h('div', { class: 'stack' });
  const content = h('div', { class: 'stack' }, counts, layers, outline.root, pins, findings.root, tolerances);
  const empty = h('p', { class: 'soft' }, words.drawing.none);
  body.append(empty, content);

  const show = () => {
    const { loaded, load, found } = session.state;
    empty.hidden = loaded !== null;
    content.hidden = loaded === null;
    if (!loaded) {
      setGist('');
      findings.show([]);
      return;
    }
    const grave = loaded.findings.filter((f) => f.severity !== 'info').length;
    setGist([words.drawing.contours(loaded.contours.length, count(loaded.contours.length)), grave ? words.drawing.toLookAt(count(grave)) : ''].filter(Boolean).join(', '), grave > 0);
    const open = loaded.contours.filter((c) => !c.closed).length;
    setText(counts, [words.drawing.parts(loaded.parts.length, count(loaded.parts.length)), open ? words.drawing.openContours(open, count(open)) : '', loaded.version ? versionName(loaded.version) : '']
      .filter(Boolean).join(' · '));
    layers.replaceChildren(layerList(session, loaded));
    pins.replaceChildren(...(['first', 'last'] as const).flatMap((place) => pinned(session, place)));
    outline.root.hidden = !load.ignoreOutline && (loaded.outline === null || suggestedAnyway(loaded, loaded.outline));
    outline.input.checked = load.ignoreOutline ?? false;
    findings.show([...loaded.findings, ...found]);
  };
  session.on('loaded', ({ loaded, fresh }) => {
    show();
    // On a low screen the result comes first, unless the drawing wants a look.
    if (fresh && !session.state.sample) root.open = innerHeight >= ROOMY || wantsALook(loaded);
  });
  // What a plan finds comes when it starts.
  let told = session.state.found;
  session.on('change', ({ found, loaded }) => {
    if (found !== told && loaded) findings.show([...loaded.findings, ...found]);
    told = found;
  });
  session.on('cleared', show);
  show();
  return Object.assign(root, { findings });
}

/** The contours that were pinned to one end of the order, and how to loosen them. */
function pinned(session: Session, place: 'first' | 'last'): HTMLElement[] {
  const contours = session.state.load[place] ?? [];
  if (contours.length === 0) return [];
  const loosen = button(words.drawing.loosen, { class: 'quiet small', 'aria-label': words.drawing.loosenWhat(place), onclick: () => session.loosen(place) });
  return [h('p', { class: 'pins' }, words.drawing.pinned(place, words.drawing.contours(contours.length, count(contours.length))), loosen)];
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

function toleranceField(session: Session, key: keyof typeof DEFAULTS, label: string): HTMLElement {
  const input = h('input', { type: 'number', min: '0.0001', max: '10', step: 'any', inputmode: 'decimal' });
  const reset = () => (input.value = String(session.state.load[key] ?? DEFAULTS[key]));
  input.addEventListener('change', () => {
    const value = input.valueAsNumber;
    if (value > 0 && value <= 10) void session.reread({ ...session.state.load, [key]: value });
    else reset();
  });
  session.on('loaded', reset);
  reset();
  return field(label, input, 'mm');
}

const VERSIONS: Record<string, string> = {
  AC1009: 'R12', AC1012: 'R13', AC1014: 'R14', AC1015: 'R2000', AC1018: 'R2004', AC1021: 'R2007', AC1024: 'R2010', AC1027: 'R2013', AC1032: 'R2018',
};

function versionName(version: string): string {
  return words.drawing.version(VERSIONS[version] ?? version);
}
