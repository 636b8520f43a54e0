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
import { longestTime, type State } from '../session/state.js';
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
  /** The report is of the path before: a better one was found, and its program is being checked. */
  isBefore?: boolean;
}

/** `refuse` gets why the program is not handed out; nothing if it may be. */
export function preflight(session: Session, refuse: (why: string) => void): HTMLElement {
  const verdict = h('p', { class: 'verdict' });
  const facts = h('p', { class: 'soft' });
  const problems = h('ul', { class: 'problems' });
  const root = h('section', { class: 'preflight', 'aria-label': words.preflight.title }, verdict, facts, problems);
  const latest = new Latest();
  /** Another one for each job. */
  let job = {};
  /** What the check says of the plan, or of the one before of the same job. */
  let report: ProgramCheck | undefined;
  /** The check that runs. */
  let running: Promise<unknown> = mayFetchWriters;
  let phase = '';

  const show = (known: Known) => {
    root.hidden = known === 'nothing';
    const { unchecked, refused, report, isBefore = false }: Checked = typeof known === 'string' ? {} : known;
    const fails = known === 'off-bed' || refused !== undefined || report?.passed === false;
    const reason = known === 'off-bed' ? words.dock.offBed : words.preflight.fails;
    root.classList.toggle('fails', fails);
    root.classList.toggle('unchecked', unchecked !== undefined);
    if (unchecked !== undefined) verdict.replaceChildren(words.preflight.unchecked);
    else verdict.replaceChildren(icon(fails ? 'warning' : 'check'), fails ? reason : words.preflight.passes);
    root.setAttribute('aria-busy', String(isBefore));
    facts.textContent = isBefore ? words.preflight.again : report ? unbroken(factsOf(report, session.state).join('\u00a0· ')) : (refused ?? unchecked ?? '');
    const list = report?.problems ?? [];
    problems.replaceChildren(...list.slice(0, LISTED).map((p) => h('li', { class: p.severity }, p.count > 1 ? words.preflight.more(inChosenUnit(p.message), count(p.count - 1)) : inChosenUnit(p.message))));
    // What is not checked yet is checked while it is written, and is not handed out if it fails.
    refuse(fails ? reason : '');
  };
  const make = async () => {
    const isLatest = latest.begin();
    // A plan that becomes better after its search is planned for no time at all. Until its program is checked, the one before has the say.
    await null;
    if (!isLatest()) return;
    if (phase !== 'done') {
      [job, report] = [{}, undefined];
      return show('nothing');
    }
    if (isRefusedOffBed(session.state, 'gcode')) return show('off-bed');
    show(report ? { report, isBefore: true } : { unchecked: words.preflight.soon });
    const checked = job;
    // One after the other: a prover finds better plans faster than their programs are checked.
    await running;
    if (!isLatest()) return;
    running = session.preflight().then(
      (made) => checked === job && show({ report: (report = made), isBefore: !isLatest() }),
      (error: unknown) => {
        // While a choice is being applied, nothing is wrong with the program: there is none.
        if (checked !== job || session.state.applying) return;
        report = undefined;
        const isLost = isKerfwayError(error) && error.code === 'not-started';
        show(isLost ? { unchecked: messageOf(error) } : { refused: messageOf(error) });
      },
    );
  };
  session.store.on('change', (state) => {
    if (state.phase !== phase) {
      phase = state.phase;
      void make();
    }
  });
  show('nothing');
  return root;
}

function factsOf(r: ProgramCheck, state: State): string[] {
  const w = words.preflight;
  const { joints, contours } = state.progress?.summary ?? {};
  const cuts = r.contours * (r.passes || 1);
  return [
    // Joints part an outline into open cuts.
    ...(joints ? [] : [w.outlines(r.parts, count(r.parts))]),
    joints || r.contours !== contours ? words.result.skeletonCuts(cuts, count(cuts)) : r.passes === 1 ? w.once(r.contours, count(r.contours)) : r.passes === 0 ? w.uneven(count(r.contours)) : w.times(r.contours, count(r.contours), count(r.passes)),
    r.dark_rapids ? w.dark : w.lit,
    ...(r.fits_bed === null ? [] : [r.fits_bed ? w.onBed : w.offBed]),
    `${metres(r.cut_length)}, ${seconds(r.seconds, longestTime(state))}`,
    w.read(r.dialect),
  ];
}
