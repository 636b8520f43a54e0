/**
 * What a price is based on: parts, areas, weight, narrow places, warnings. Loaded when its section is opened; the report is made when the plan is done and the
 * section is open.
 */

import { button, h } from '../core/dom.js';
import { save } from '../core/files.js';
import { area, betweenFacts, count, fixed, metres, three, upTo, width } from '../core/format.js';
import { lengthUnit } from '../core/lengths.js';
import { doubtOf, downloadName, messageOf } from '../core/strings.js';
import type { Material, Quote } from 'kerfway';
import type { Session } from '../session/session.js';
import { numberInput } from './number-input.js';
import { field, type Section } from './section.js';
import { words } from '../core/words/index.js';

/** How many groups of parts are listed; the file holds all of them. */
const LISTED = 8;

export function quoteContent(session: Session, { root, setGist }: Section, notify: (sentence: string) => void): HTMLElement {
  const material: Material = {};
  // The limits are those of the planner.
  const [thickness, density] = ([['thickness', 'mm', 1000], ['density', 'g/cm³', 25]] as const).map(([name, unit, most]) => {
    const { input } = numberInput({ unit, least: 0.001, most, empty: 0, placeholder: words.quote.notGiven }, (value) => {
      if (value === 0) delete material[name];
      else material[name] = value;
    });
    input.addEventListener('change', () => void make());
    return field(words.quote[name], input, unit);
  });
  const rows = h('dl', { class: 'parts' });
  const note = h('p', { class: 'soft' });
  let report: Quote | null = null;
  let asked = 0;
  const download = button(words.quote.download, { class: 'small', onclick: () => {
    if (report) save(`${JSON.stringify(report, null, 2)}\n`, downloadName(session.state, '.quote.json'), 'application/json');
  } });

  const show = () => {
    rows.replaceChildren(...(report === null ? [] : facts(report)).flatMap(([term, value]) => [h('dt', {}, term), h('dd', { class: 'number' }, value)]));
    note.textContent = report === null ? words.quote.none : [words.quote.confidence[report.confidence.level], ...report.confidence.reasons.map(doubtOf)].join(' ');
    download.hidden = report === null;
    setGist(report === null ? '' : words.drawing.parts(report.part_count, count(report.part_count)));
  };
  const make = async () => {
    const now = (asked += 1);
    report = null;
    show();
    if (!root.open || session.state.phase !== 'done') return;
    try {
      const made = await session.quote({ ...material, ...(session.state.material === null ? {} : { name: session.state.material }) });
      if (now !== asked) return;
      report = made;
      show();
    } catch (error) {
      if (now === asked) notify(messageOf(error));
    }
  };
  let phase = '';
  session.store.on('change', (state) => {
    if (state.phase !== phase) void make();
    phase = state.phase;
  });
  root.addEventListener('toggle', () => void make());
  void make();
  return h('div', { class: 'stack' }, thickness, density, note, rows, download);
}

/** A web is not measured more exactly than to some hundredths of a millimetre. */
const hundredths = (mm: number) => (mm < 1 && lengthUnit === 'mm' ? `${upTo(mm, 2)} mm` : width(mm));

function facts(q: Quote): [string, string][] {
  // Narrow places are measured along chords, to some hundredths of a millimetre: a hole of 6 mm has 5.98, which is shown as it was drawn.
  const against = (ratio: number | null) => (ratio === null ? '' : words.quote.against(ratio < 1 ? three(ratio) : upTo(ratio, 1)));
  const parts = q.part_count === 1 ? count(1) : words.quote.different(count(q.part_count), count(q.parts.length));
  const all: [string, string][] = [[words.quote.parts, parts], [words.quote.area, area(q.net_area)]];
  if (q.weight !== null) all.push([words.quote.weight, q.weight < 1000 ? `${fixed(q.weight, 0)} g` : `${fixed(q.weight / 1000, 2)} kg`]);
  if (q.smallest_hole !== null) all.push([words.quote.hole, width(q.smallest_hole.width) + against(q.smallest_hole.over_thickness)]);
  if (q.narrowest_web !== null) all.push([words.quote.web, hundredths(q.narrowest_web.width) + against(q.narrowest_web.over_thickness)]);
  const listed = q.parts.slice(0, LISTED);
  const least = Math.min(...listed.map((p) => p.net_area));
  for (const p of listed) all.push([`${count(p.count)} × ${area(p.net_area, least)}`, betweenFacts(words.quote.part(metres(p.cut_length), p.holes, count(p.holes)))]);
  if (q.parts.length > LISTED) all.push([words.quote.and, words.quote.others(q.parts.length - LISTED, count(q.parts.length - LISTED))]);
  return all;
}
