/**
 * The check of the program beside the download buttons: when the plan is done, it is read back by the rules of the machine's dialect. On a first
 * visit the check is fetched only then (see first-visit.ts), and until it has run the program counts as unchecked. A program that fails is not
 * handed out.
 */

import { h, icon } from '../core/dom.js';
import { count, metres, seconds, unbroken } from '../core/format.js';
import { Latest } from '../core/latest.js';
import { inChosenUnit } from '../core/lengths.js';
import { messageOf } from '../core/strings.js';
import { isKerfwayError, type ProgramCheck } from 'kerfway';
import { isRefusedOffBed } from '../session/off-bed.js';
import type { Session } from '../session/session.js';
import { longestTime } from '../session/state.js';
import { words } from '../core/words/index.js';
import { mayFetchWriters } from '../offline/first-visit.js';

/** How many problems are listed. */
const LISTED = 4;

/** What is known of the program: nothing while there is no finished plan, or that none is written because of its place. */
type Known = 'nothing' | 'off-bed' | Checked;

/** One of these: why the check has not run yet, why the program cannot be checked, or what the check says. */
interface Checked {
  unchecked?: string;
  refused?: string;
  report?: ProgramCheck;
}

/** `refuse` gets why the program is not handed out; nothing if it may be. */
export function preflight(session: Session, refuse: (why: string) => void): HTMLElement {
  const verdict = h('p', { class: 'verdict' });
  const facts = h('p', { class: 'soft' });
  const problems = h('ul', { class: 'problems' });
  const root = h('section', { class: 'preflight', 'aria-label': words.preflight.title }, verdict, facts, problems);
  const latest = new Latest();

  const show = (known: Known) => {
    root.hidden = known === 'nothing';
    const { unchecked, refused, report }: Checked = typeof known === 'string' ? {} : known;
    const fails = known === 'off-bed' || refused !== undefined || report?.passed === false;
    const reason = known === 'off-bed' ? words.dock.offBed : words.preflight.fails;
    root.classList.toggle('fails', fails);
    root.classList.toggle('unchecked', unchecked !== undefined);
    if (unchecked !== undefined) verdict.replaceChildren(words.preflight.unchecked);
    else verdict.replaceChildren(icon(fails ? 'warning' : 'check'), fails ? reason : words.preflight.passes);
    facts.textContent = report ? unbroken(factsOf(report, longestTime(session.state)).join('\u00a0· ')) : (refused ?? unchecked ?? '');
    const list = report?.problems ?? [];
    problems.replaceChildren(...list.slice(0, LISTED).map((p) => h('li', { class: p.severity }, p.count > 1 ? words.preflight.more(inChosenUnit(p.message), count(p.count - 1)) : inChosenUnit(p.message))));
    // What is not checked yet is checked while it is written, and is not handed out if it fails.
    refuse(fails ? reason : '');
  };
  const make = async () => {
    const isLatest = latest.begin();
    if (session.state.phase !== 'done') return show('nothing');
    if (isRefusedOffBed(session.state, 'gcode')) return show('off-bed');
    show({ unchecked: words.preflight.soon });
    await mayFetchWriters;
    if (!isLatest()) return;
    try {
      const report = await session.preflight();
      if (isLatest()) show({ report });
    } catch (error) {
      // While a choice is being applied, nothing is wrong with the program: there is none.
      if (!isLatest() || session.state.applying) return;
      const isLost = isKerfwayError(error) && error.code === 'not-started';
      show(isLost ? { unchecked: messageOf(error) } : { refused: messageOf(error) });
    }
  };
  let phase = '';
  session.store.on('change', (state) => {
    if (state.phase !== phase) {
      phase = state.phase;
      void make();
    }
  });
  show('nothing');
  return root;
}

function factsOf(r: ProgramCheck, longest: number): string[] {
  const w = words.preflight;
  return [
    w.outlines(r.parts, count(r.parts)),
    r.passes === 1 ? w.once(r.contours, count(r.contours)) : r.passes === 0 ? w.uneven(count(r.contours)) : w.times(r.contours, count(r.contours), count(r.passes)),
    r.dark_rapids ? w.dark : w.lit,
    ...(r.fits_bed === null ? [] : [r.fits_bed ? w.onBed : w.offBed]),
    `${metres(r.cut_length)}, ${seconds(r.seconds, longest)}`,
    w.read(r.dialect),
  ];
}
