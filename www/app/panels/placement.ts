/**
 * The controls for where the job lies on the bed: as drawn, or one of nine points of the job at a place; turning, dragging, and what the coordinates
 * mean.
 */

import { button, disable, h, setText } from '../core/dom.js';
import { size } from '../core/format.js';
import { shownIn } from '../core/lengths.js';
import { leave } from '../core/refill.js';
import { words } from '../core/words/index.js';
import { type Anchor, ANCHORS, type Place } from 'kerfway';
import { anchoredAt, AS_DRAWN, fitsBed, jobBox } from '../session/placing.js';
import { isRefusedOffBed, reachOf } from '../session/off-bed.js';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';
import { numberInput } from './number-input.js';
import { type PlacementActions, whyOff } from './placement-section.js';
import { check, field, select } from './section.js';

/** The rows of the picker from the top, as the points lie on the bed. */
const ROWS: readonly (readonly Anchor[])[] = [ANCHORS.slice(6, 9), ANCHORS.slice(3, 6), ANCHORS.slice(0, 3)];

export interface PlacementControls {
  root: HTMLElement;
  /** Shows whether the job is being dragged. */
  setDragging(on: boolean): void;
  /** The last control of those that bring the job onto the bed. */
  end: HTMLElement;
  /** Puts the focus on what brings the job onto the bed. */
  focus(): void;
}

export function placementControls(session: Session, actions: PlacementActions): PlacementControls {
  const mode = select<'drawn' | 'placed'>((chosen) => {
    const { loaded, placing } = session.state;
    if (loaded) session.setPlacing({ place: chosen === 'drawn' ? null : anchoredAt('lower-left', placing, loaded) });
  }, { wide: true });
  const points = new Map(ANCHORS.map((anchor) => [anchor, radio(anchor, () => choosePoint(session, anchor))]));
  const picker = h('div', { class: 'nine', role: 'radiogroup', 'aria-label': words.placement.point },
    ...ROWS.flat().map((anchor) => points.get(anchor)!.root));
  const at = ([0, 1] as const).map((axis) => numberInput({ unit: 'mm', least: -1e6, most: 1e6 }, (value) => moveTo(session, axis, value)));
  const where = h('div', { class: 'placement-point' }, picker, h('div', { class: 'stack' }, ...at.map(({ input }, axis) => field(words.placement[axis === 0 ? 'x' : 'y'], input, 'mm'))));
  const turn = (by: number) => session.drawing.change({ turn: ((session.state.load.turn ?? 0) + by + 360) % 360 });
  const turnLeft = button(words.placement.turnLeft, { icon: 'turnLeft', class: 'small', onclick: () => turn(90) });
  const turnRight = button(words.placement.turnRight, { icon: 'turnRight', class: 'small', onclick: () => turn(270) });
  const drag = button(words.placement.drag, { icon: 'move', class: 'small', 'aria-pressed': false, onclick: () => actions.drag(drag.getAttribute('aria-pressed') !== 'true') });
  const show = button(words.placement.show, { icon: 'fit', class: 'small', onclick: actions.showBed });
  const start = select<State['placing']['start']>((chosen) => session.setPlacing({ start: chosen }));
  const allow = check(words.placement.allow, (on) => session.setPlacing({ allowOffBed: on }));
  const fits = h('p', { class: 'soft number' });
  const refused = h('strong', {}, words.dock.offBed);
  const advice = h('p', { role: 'status' });
  const corner = button(words.placement.corner, { class: 'small', onclick: () => {
    const place = atCorner(session.state);
    if (place) session.setPlacing({ place, start: AS_DRAWN.start });
  } });
  const alert = h('div', { class: 'suggestion grave' }, h('div', { class: 'advice stack' }, refused, advice), corner);
  const none = h('p', { class: 'soft' }, words.placement.noBed);
  const root = h('div', { class: 'stack' }, none, field(words.placement.position, mode.root), where, h('div', { class: 'row' }, turnLeft, turnRight), h('div', { class: 'row' }, drag, show), field(words.placement.coordinates, start.root), fits, alert, allow.root);

  const refresh = () => {
    const { loaded, machine, placing } = session.state;
    root.hidden = loaded === null || machine === null;
    if (!loaded || !machine) return;
    const { place } = placing;
    none.hidden = Boolean(machine.bed);
    drag.hidden = show.hidden = placing.start === 'current';
    disable(show, machine.bed ? '' : words.placement.noBed);
    mode.fill([{ value: 'drawn', label: words.placement.asDrawn }, { value: 'placed', label: words.placement.atPoint }], place === null ? 'drawn' : 'placed');
    start.fill([{ value: 'absolute', label: words.placement.absolute }, { value: 'current', label: words.placement.current }], placing.start);
    where.hidden = place === null;
    if (place !== null) {
      for (const [anchor, { input }] of points) input.checked = place.point === anchor;
      at.forEach(({ show }, axis) => show(place.at[axis]!));
    }
    const sentence = whyOff(session.state);
    const [x0, y0, x1, y1] = jobBox(placing, loaded, reachOf(session.state));
    setText(fits, words.placement.reaches(size(x0), size(x1), size(y0), size(y1), shownIn('mm').unit));
    setText(advice, sentence);
    refused.hidden = !isRefusedOffBed(session.state, 'gcode');
    if (!sentence) leave(alert);
    alert.hidden = sentence === '';
    corner.hidden = atCorner(session.state) === null;
    allow.root.hidden = sentence === '' && !placing.allowOffBed;
    allow.input.checked = placing.allowOffBed;
  };
  session.store.on('change', refresh);
  session.store.on('loaded', refresh);
  refresh();
  return {
    root, end: allow.root,
    setDragging: (on) => drag.setAttribute('aria-pressed', String(on)),
    focus: () => (corner.hidden ? mode.list : corner).focus({ preventScroll: true }),
  };
}

/** The place with the lower left corner of what the beam reaches at that of the bed; null where that has no room for the job. */
function atCorner(state: State): Place | null {
  const { machine, loaded } = state;
  const box = reachOf(state);
  if (!machine?.bed || !loaded || !box) return null;
  const { bed } = machine;
  const at = (axis: 0 | 1) => Math.ceil(100 * (bed[axis] + loaded.bounds[axis] - box[axis]) - 1e-6) / 100 + 0;
  const place: Place = { point: 'lower-left', at: [at(0), at(1)] };
  return fitsBed({ ...AS_DRAWN, place }, machine, loaded, box) ? place : null;
}

function choosePoint(session: Session, anchor: Anchor): void {
  const { loaded, placing } = session.state;
  if (loaded) session.setPlacing({ place: anchoredAt(anchor, placing, loaded) });
}

function moveTo(session: Session, axis: 0 | 1, value: number): void {
  const { place } = session.state.placing;
  if (place === null) return;
  const at: [number, number] = [...place.at];
  at[axis] = value;
  session.setPlacing({ place: { ...place, at } }, true);
}

function radio(anchor: Anchor, onChoose: () => void): { root: HTMLLabelElement; input: HTMLInputElement } {
  const input = h('input', { type: 'radio', name: 'placement-point', 'aria-label': words.placement.points[anchor] });
  input.addEventListener('change', onChoose);
  return { root: h('label', { title: words.placement.points[anchor] }, input), input };
}
