/** Calibration: the seconds that one or two jobs really took, and the machine that is fitted to them, with the error before and after. */

import { button, h } from '../core/dom.js';
import { percent, seconds, upTo } from '../core/format.js';
import { messageOf } from '../core/strings.js';
import { shownIn } from '../core/lengths.js';
import { words } from '../core/words/index.js';
import type { Calibration, MachineProfile, MeasuredPlan } from 'kerfway';
import type { Session } from '../session/session.js';
import { numberInput } from './number-input.js';
import { field } from './section.js';

/** A job that was timed. */
interface Timed extends MeasuredPlan {
  name: string;
  planned: number;
}

export function calibration(session: Session, notify: (sentence: string) => void): HTMLElement {
  let timed: readonly Timed[] = [];
  let fitted: Calibration | null = null;
  let took = 0;
  const clock = numberInput({ unit: 's', least: 0.01, most: 999_999, empty: 0, placeholder: words.calibration.none }, (value) => (took = value));
  const add = h('button', { type: 'submit', class: 'small' }, words.calibration.add);
  const form = h('form', { class: 'stack', novalidate: true }, field(words.calibration.took, clock.input, 's'), add);
  const list = h('ul', { class: 'timed' });
  const fit = button(words.calibration.fit, { class: 'small', onclick: () => void run() });
  const clear = button(words.calibration.clear, { class: 'small', onclick: () => show([], null) });
  const table = h('table', { class: 'calibrated' });
  const take = button(words.calibration.take, { class: 'small', onclick: () => {
    if (fitted) session.setMachine(withMaterial(fitted.machine, session.state.material));
    show([], null);
  } });

  form.addEventListener('submit', (event) => {
    event.preventDefault();
    void note();
  });
  /** Notes the time that the present plan took. */
  const note = async () => {
    const { progress, name, phase } = session.state;
    if (took === 0 || progress === null || phase !== 'done') return notify(words.calibration.notYet);
    try {
      const plan = String(await session.output('json'));
      show([...timed, { name, plan, seconds: took, planned: progress.summary.total_time }], null);
      clock.input.value = '';
      clock.show((took = 0));
    } catch (error) {
      notify(messageOf(error));
    }
  };
  const run = async () => {
    try {
      show(timed, await session.calibrate(timed.map(({ plan, seconds: took }) => ({ plan, seconds: took }))));
    } catch (error) {
      notify(messageOf(error));
    }
  };
  const show = (jobs: readonly Timed[], found: Calibration | null) => {
    timed = jobs;
    fitted = found;
    list.replaceChildren(...jobs.map((j) => h('li', { class: 'number' }, words.calibration.job(j.name, seconds(j.seconds), seconds(j.planned)))));
    list.hidden = jobs.length === 0 || found !== null;
    actions.hidden = jobs.length === 0;
    fit.hidden = found !== null;
    result.hidden = found === null;
    table.replaceChildren(...(found === null ? [] : rows(found, session)));
  };
  const actions = h('div', { class: 'row' }, fit, clear);
  const result = h('div', { class: 'stack' }, table, take);
  show([], null);
  return h('div', { class: 'stack' }, h('p', { class: 'soft' }, words.calibration.hint), form, list, result, actions);
}

/** The pierce time of a material is that of its setting, so the fitted one belongs there. */
function withMaterial(machine: MachineProfile, material: string | null): MachineProfile {
  const materials = machine.materials?.map((m) => (m.name === material ? { ...m, pierce_time: machine.pierce_time } : m));
  return materials === undefined ? machine : { ...machine, materials };
}

const error = (planned: number, measured: number) => `${planned >= measured ? '+' : '−'}${percent(Math.abs(planned / measured - 1))}`;
const digits = (n: number | null | undefined, unit: string) => (typeof n !== 'number' ? words.machine.unlimited : upTo(Number((n / shownIn(unit).factor).toPrecision(4)), 20));

/** The error of each job and the fitted values, before and after. */
function rows({ jobs, machine }: Calibration, { state: { machine: before } }: Session): HTMLElement[] {
  const line = (label: string, from: string, to: string) => h('tr', {}, h('th', { scope: 'row' }, label), h('td', { class: 'number' }, from), h('td', { class: 'number' }, to));
  const row = (label: string, unit: string, from: number | null | undefined, to: number | null | undefined) => line(`${label}, ${shownIn(unit).unit}`, digits(from, unit), digits(to, unit));
  return [
    h('thead', {}, h('tr', {}, h('td', {}), ...[words.calibration.before, words.calibration.after].map((t) => h('th', { scope: 'col', class: 'number' }, t)))),
    h('tbody', {},
      ...jobs.map((j) => line(j.name, error(j.before, j.measured), error(j.after, j.measured))),
      row(words.machine.cutAccel, 'mm/s²', before?.cut.accel, machine.cut.accel),
      row(words.machine.corners, 'mm', before?.junction_deviation, machine.junction_deviation),
      row(words.machine.pierce, 's', before?.pierce_time, machine.pierce_time)),
  ];
}
