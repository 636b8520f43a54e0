/**
 * The foot of the panel, which is always visible: the state in one sentence, and the actions that are possible now. While the page is
 * planning, Stop is the largest control.
 */

import { button, disable, h, setText } from '../core/dom.js';
import { fileName } from '../core/file-name.js';
import { seconds, short, unbroken } from '../core/format.js';
import { doneSentence } from '../core/strings.js';
import type { Session } from '../session/session.js';
import { isRefusedOffBed } from '../session/off-bed.js';
import { isOptimal, longestTime, type State } from '../session/state.js';
import { words } from '../core/words/index.js';

export interface DockActions {
  open(): void;
  /** Opens and closes the bottom sheet that holds the panel on a phone. */
  sheet(): void;
  /** Downloads the file that the machine takes. */
  program(): void;
  /** Shows where the job can be placed on the bed. */
  place(): void;
}

export function dock(session: Session, actions: DockActions): HTMLElement {
  const head = h('p', { class: 'dock-head' });
  const detail = h('p', { class: 'soft number' });
  // On a phone, whose top bar has no room for it.
  const name = fileName('dock-file soft');
  const bar = h('div', { class: 'budget', role: 'progressbar', 'aria-label': words.dock.progress, 'aria-valuemin': 0, 'aria-valuemax': 100 }, h('span'));
  const stop = button(words.dock.stop, { icon: 'stop', class: 'stop', onclick: () => session.planning.stop() });
  const pause = button(words.dock.pause, { icon: 'pause', onclick: () => session.planning.pause() });
  const resume = button(words.dock.resume, { icon: 'play', onclick: () => session.planning.resume() });
  const more = button(words.dock.more, { icon: 'next', onclick: () => session.planning.keepImproving() });
  const gcode = button(words.result.kinds.gcode, { icon: 'download', class: 'primary', onclick: actions.program });
  const gcodeLabel = gcode.querySelector('span')!;
  const place = button(words.dock.place, { icon: 'move', class: 'primary', onclick: actions.place });
  const undo = button(words.dock.undo, { icon: 'undo', class: 'primary', onclick: () => session.undo() });
  const open = button(words.dock.choose, { icon: 'open', class: 'primary', onclick: actions.open });
  const sheet = button(words.dock.sheet, { icon: 'up', iconOnly: true, class: 'quiet sheet-toggle', 'aria-expanded': false, 'aria-controls': 'sections', onclick: actions.sheet });
  const root = h('div', { class: 'dock' }, bar, name.root, h('div', { class: 'dock-state' }, h('div', {}, head, detail), sheet), h('div', { class: 'dock-actions' }, stop, pause, resume, more, gcode, place, undo, open));

  const show = (state: State) => {
    const { phase, progress } = state;
    const running = phase === 'planning' || phase === 'paused';
    // Of somebody who presses buttons by keyboard. After a click, the next key is a shortcut.
    const pressed = [stop, pause, resume, more].find((b) => b.matches(':focus-visible'));
    stop.hidden = !running;
    pause.hidden = phase !== 'planning';
    resume.hidden = phase !== 'paused';
    more.hidden = phase !== 'done' || state.reason === 'exhausted' || isOptimal(state);
    place.hidden = phase !== 'done' || !isRefusedOffBed(state);
    gcode.hidden = phase !== 'done' || !place.hidden;
    const applying = state.applying ? words.dock.applying : '';
    for (const control of [stop, pause, resume, more]) disable(control, applying);
    disable(gcode, applying || (failsCheck(state) ? words.dock.fails : ''));
    setText(gcodeLabel, words.result.kinds[state.machine?.takes ?? 'gcode']);
    // A choice with which nothing can be planned is what to go back from; the drawing is not at fault.
    undo.hidden = phase !== 'ready' || !session.canUndo;
    open.hidden = phase !== 'failed' && (phase !== 'ready' || !undo.hidden);
    const busy = phase === 'starting' || phase === 'reading' || state.applying;
    if (pressed?.hidden) root.querySelector<HTMLElement>('.dock-actions button:not([hidden])')?.focus();
    bar.hidden = !running && !busy;
    bar.classList.toggle('busy', busy);
    root.dataset.phase = phase;
    setText(head, headline(state));
    name.show(state.name);
    setText(detail, detailOf(state));
    detail.hidden = detail.textContent === '';
    const share = progress ? Math.min(1, progress.seconds / state.budget) : 0;
    bar.style.setProperty('--share', String(share));
    if (busy) bar.removeAttribute('aria-valuenow');
    else bar.setAttribute('aria-valuenow', String(Math.round(share * 100)));
  };
  session.store.on('change', show);
  session.store.on('progress', show);
  session.store.on('applying', () => show(session.state));
  show(session.state);
  return root;
}

/** The state in one sentence. */
export function headline(state: State): string {
  const { phase, progress } = state;
  const best = progress ? seconds(progress.summary.total_time, longestTime(state)) : null;
  if (state.applying && phase !== 'reading') return words.dock.applying;
  switch (phase) {
    case 'starting': return words.dock.starting;
    case 'reading': return words.dock.reading(state.opening ?? state.name);
    case 'question': return words.dock.question;
    case 'ready': return state.error ?? words.dock.nothing;
    case 'planning': return words.dock.planning(best);
    case 'paused': return words.dock.paused(best);
    case 'failed': return words.dock.failed;
    case 'done': return isOptimal(state) ? words.dock.optimal : doneSentence(state.reason, quietFor(state));
  }
}

function detailOf(state: State): string {
  const { phase, progress } = state;
  if (!progress || (phase !== 'planning' && phase !== 'paused' && phase !== 'done')) return '';
  const left = seconds(progress.summary.total_time - progress.summary.lower_bound);
  const refused = isRefusedOffBed(state) ? words.dock.offBed : failsCheck(state) ? words.dock.fails : null;
  // Why there is no G-code comes first, and leaves no room for more than the gain.
  const bound = refused !== null || progress.summary.gap === null || isOptimal(state) || left === seconds(0) ? null : words.dock.gap(left);
  const pace = refused !== null || progress.moves === 0 ? null : phase === 'planning' ? words.dock.pace(short(Math.round(progress.rate))) : words.dock.moves(progress.moves, short(progress.moves));
  const gain = (state.baselines?.greedy.total_time ?? 0) - progress.summary.total_time;
  return unbroken([refused, gain > 0 && seconds(gain) !== seconds(0) ? words.dock.saved(seconds(gain)) : null, pace, bound].filter((part) => part !== null).join(', '));
}

function failsCheck({ programFails, machine }: State): boolean {
  return programFails && (machine?.takes ?? 'gcode') === 'gcode';
}

/** Seconds of search since the last improvement. */
function quietFor(state: State): number {
  const { at, total } = state.curve;
  const last = total.at(-1);
  let i = total.length - 1;
  while (i > 0 && total[i - 1] === last) i -= 1;
  return (at.at(-1) ?? 0) - (at[i] ?? 0);
}
