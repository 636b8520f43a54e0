/**
 * The check of the program beside the download buttons: it is read back by the rules of the machine's dialect when the plan is done. A
 * program that fails is not handed out.
 */

import { h, icon } from '../core/dom.js';
import { count, metres, seconds } from '../core/format.js';
import { inChosenUnit } from '../core/lengths.js';
import { messageOf } from '../core/strings.js';
import type { ProgramCheck } from 'kerfway';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';

/** How many problems are listed. */
const LISTED = 4;

export function preflight(session: Session, usable: (passed: boolean) => void): HTMLElement {
  const verdict = h('p', { class: 'verdict' });
  const facts = h('p', { class: 'soft' });
  const problems = h('ul', { class: 'problems' });
  const root = h('section', { class: 'preflight', 'aria-label': words.preflight.title }, verdict, facts, problems);
  let asked = 0;

  const show = (report: ProgramCheck | null, refusal: string | null) => {
    root.hidden = report === null && refusal === null;
    const passed = report?.passed ?? false;
    root.classList.toggle('fails', !passed);
    verdict.replaceChildren(icon(passed ? 'check' : 'warning'), passed ? words.preflight.passes : words.preflight.fails);
    facts.textContent = report === null ? refusal : factsOf(report).join(' · ');
    const list = report?.problems ?? [];
    problems.replaceChildren(...list.slice(0, LISTED).map((p) => h('li', { class: p.severity }, p.count > 1 ? words.preflight.more(inChosenUnit(p.message), count(p.count - 1)) : inChosenUnit(p.message))));
    usable(root.hidden || passed);
  };
  const make = async () => {
    const now = (asked += 1);
    show(null, null);
    if (session.state.phase !== 'done') return;
    try {
      const report = await session.preflight();
      if (now === asked) show(report, null);
    } catch (error) {
      if (now === asked) show(null, messageOf(error));
    }
  };
  let phase = '';
  session.store.on('change', (state) => {
    if (state.phase !== phase) {
      phase = state.phase;
      void make();
    }
  });
  show(null, null);
  return root;
}

function factsOf(r: ProgramCheck): string[] {
  const w = words.preflight;
  return [
    w.parts(r.parts, count(r.parts)),
    r.passes === 1 ? w.once(r.contours, count(r.contours)) : r.passes === 0 ? w.uneven(count(r.contours)) : w.times(r.contours, count(r.contours), count(r.passes)),
    r.dark_rapids ? w.dark : w.lit,
    ...(r.fits_bed === null ? [] : [r.fits_bed ? w.onBed : w.offBed]),
    `${metres(r.cut_length)}, ${seconds(r.seconds)}`,
    w.read(r.dialect),
  ];
}
