/**
 * The foot of the panel, always in view: what is going on in one sentence, and what can be done about it. While
 * planning, Stop is the largest control there is.
 */

import { button, h, setText } from '../core/dom.js';
import { percent, seconds, short } from '../core/format.js';
import { doneSentence } from '../core/strings.js';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';

export interface DockActions {
  open(): void;
  /** Opens and closes the sheet of the panels, on a phone. */
  sheet(): void;
  gcode(): void;
}

export function dock(session: Session, actions: DockActions): HTMLElement {
  const headline = h('p', { class: 'dock-head' });
  const detail = h('p', { class: 'soft number' });
  const bar = h('div', { class: 'budget', role: 'progressbar', 'aria-label': 'Progress', 'aria-valuemin': 0, 'aria-valuemax': 100 }, h('span'));
  const stop = button('Stop', { icon: 'stop', class: 'stop', onclick: () => session.stop() });
  const pause = button('Pause', { icon: 'pause', onclick: () => session.pause() });
  const resume = button('Resume', { icon: 'play', onclick: () => session.resume() });
  const more = button('Keep improving', { icon: 'next', onclick: () => session.keepImproving() });
  const gcode = button('G-code', { icon: 'download', class: 'primary', onclick: actions.gcode });
  const open = button('Choose a DXF', { icon: 'open', class: 'primary', onclick: actions.open });
  const sheet = button('Drawing, machine, plan, result', { icon: 'up', iconOnly: true, class: 'quiet sheet-toggle', 'aria-expanded': false, 'aria-controls': 'sections', onclick: actions.sheet });
  const root = h('div', { class: 'dock' }, bar, h('div', { class: 'dock-state' }, h('div', {}, headline, detail), sheet), h('div', { class: 'dock-actions' }, stop, pause, resume, more, gcode, open));

  const show = (state: State) => {
    const { phase, progress } = state;
    const running = phase === 'planning' || phase === 'paused';
    stop.hidden = !running;
    pause.hidden = phase !== 'planning';
    resume.hidden = phase !== 'paused';
    more.hidden = phase !== 'done' || state.reason === 'exhausted';
    gcode.hidden = phase !== 'done';
    open.hidden = phase !== 'failed' && phase !== 'ready';
    const busy = phase === 'starting' || phase === 'reading';
    bar.hidden = !running && !busy;
    bar.classList.toggle('busy', busy);
    root.dataset.phase = phase;
    setText(headline, head(state));
    setText(detail, tail(state));
    detail.hidden = detail.textContent === '';
    const share = progress ? Math.min(1, progress.seconds / state.budget) : 0;
    bar.style.setProperty('--share', String(share));
    if (busy) bar.removeAttribute('aria-valuenow');
    else bar.setAttribute('aria-valuenow', String(Math.round(share * 100)));
  };
  session.on('change', show);
  session.on('progress', show);
  show(session.state);
  return root;
}

/** The state in one sentence. */
export function head(state: State): string {
  const { phase, progress } = state;
  const best = progress ? `, best ${seconds(progress.summary.total_time)}` : '';
  switch (phase) {
    case 'starting': return 'Starting the planner…';
    case 'reading': return `Reading ${state.name}…`;
    case 'question': return 'An answer is needed before planning.';
    case 'ready': return state.error ?? 'Nothing to cut: set a layer to cut or mark.';
    case 'planning': return `Planning${best}`;
    case 'paused': return `Paused${best}`;
    case 'failed': return 'This file cannot be used.';
    case 'done': return isOptimal(state) ? 'Optimal: no better path exists.' : doneSentence(state.reason, quietFor(state));
  }
}

function tail(state: State): string {
  const { phase, progress } = state;
  if (!progress || (phase !== 'planning' && phase !== 'paused' && phase !== 'done')) return '';
  const bound = progress.summary.gap === null || isOptimal(state) ? '' : `, at most ${percent(progress.summary.gap)} above the optimum`;
  const pace = phase === 'planning' ? `${short(Math.round(progress.rate))} moves/s` : `${short(progress.moves)} moves`;
  const gain = (state.baselines?.drawing.total_time ?? 0) - progress.summary.total_time;
  return `${gain > 0 ? `${seconds(gain)} saved, ` : ''}${pace}${bound}`;
}

function isOptimal(state: State): boolean {
  const gap = state.progress?.summary.gap;
  return gap !== null && gap !== undefined && gap <= 1e-9;
}

/** Seconds of search since the last improvement. */
function quietFor(state: State): number {
  const { at, total } = state.history;
  const last = total.at(-1);
  let i = total.length - 1;
  while (i > 0 && total[i - 1] === last) i -= 1;
  return (at.at(-1) ?? 0) - (at[i] ?? 0);
}
