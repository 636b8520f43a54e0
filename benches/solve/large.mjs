// The instances of GTSPLIB with 200 sets and more, natively in one thread:
//
//     npm run bench -- solve large --tsplib FOLDER --seconds 60 --seeds 5 --cpu --log benches/data/large.jsonl [--lkh PROGRAM]
//
// Runs go seed by seed through all instances, one process at a time. With `--log` each run is a line of that file as soon as it ends,
// runs that are there are not repeated, and the table is made of all lines: the command can be stopped and started again. With `--lkh`
// the program LKH solves each instance once after the first seed (benches/solve/lkh.py; KERFWAY_PYTHON with numpy). The length of
// every tour is added up again from the coordinates (benches/solve/tsplib.mjs); a wrong one ends the command.

import { appendFileSync, existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT, Stop } from '../../scripts/tools.mjs';
import { mb, median } from '../common/table.mjs';
import { generalisedFrom, generalisedRandom } from './clusters.mjs';
import { at, firstRow, HERE, natively, percent, PYTHON } from './runs.mjs';
import { lengthOf, parts } from './tsplib.mjs';

/** Least number of sets of a large instance. */
const LEAST = 200;
/** Seconds after which values are kept. */
const MARKS = [10, 60, 600];
/** Most nodes of an instance that LKH is given: it reads the costs of all pairs of nodes, and its preparation grows with their square. */
const LKH_MOST = 7500;

const US = 'kerfway';
const LKH = 'LKH';

export function large({ seconds, seeds, only, cpu = false, tsplib, log, lkh }) {
  if (tsplib === undefined) throw new Stop('The set large needs --tsplib FOLDER: a folder with the .tsp files of TSPLIB.');
  const instances = [...generalisedFrom(tsplib, { least: LEAST, only }), ...generalisedRandom({ least: LEAST, only })].sort((a, b) => a.sets - b.sets);
  const lines = log !== undefined && existsSync(log) ? read(readFileSync(log, 'utf8')) : [];
  const add = (line) => {
    lines.push(line);
    if (log !== undefined) appendFileSync(log, `${JSON.stringify(line)}\n`);
    console.log(`${line.instance}  ${line.by} seed ${line.seed}: ${line.value} after ${line.seconds} s`);
  };
  const isDone = ({ name }, by, seed) => lines.some((l) => l.instance === name && l.by === by && l.seed === seed && l.limit >= seconds);
  for (let seed = 1; seed <= seeds; seed++) {
    for (const instance of instances.filter((i) => !isDone(i, US, seed))) add(ours(instance, seed, { seconds, cpu }));
    if (lkh === undefined || seed > 1) continue;
    for (const instance of instances.filter((i) => i.nodes <= LKH_MOST && !isDone(i, LKH, seed))) {
      const line = byLkh(instance, seed, { program: lkh, seconds });
      if (line !== undefined) add(line);
    }
  }
  console.log(`\n${markdown(lines)}`);
}

/** The lines of a log. */
export const read = (text) => text.split('\n').filter(Boolean).map((line) => JSON.parse(line));

function ours({ name, nodes, sets, file }, seed, { seconds, cpu }) {
  const path = file();
  const [{ runs: [run] }] = natively(path, { seconds, seeds: 1, cpu }, '--on', '--tour', '--first', String(seed));
  return lineOf({ by: US, instance: name, nodes, sets, path }, { ...run, seed }, { seconds, clock: cpu ? 'processor' : 'wall' });
}

/**
 * The line of a run of the native program, its tour checked. On more nodes than a table of costs may have, the search counts distances
 * that are not rounded: values on the way are these, and the last one is that of the instance.
 */
export function lineOf({ path, ...about }, { seed, trace, value, memory, tour }, { seconds, clock }) {
  const after = Object.fromEntries(MARKS.filter((m) => m <= seconds).map((m) => [m, m === seconds ? value : at({ trace }, m)]));
  return { ...about, seed, limit: seconds, seconds, clock, first: trace[0][1], after, value: checked(path, tour, value), memory, checked: 'coordinates' };
}

/** The line of a run of LKH; `undefined`, with the reason printed, if it finds no tour. */
function byLkh({ name, nodes, sets, file }, seed, { program, seconds }) {
  const path = file();
  const row = firstRow(PYTHON, [join(HERE, 'lkh.py'), program, path, '--seconds', String(seconds), '--seed', String(seed)], `LKH on ${name}`);
  if (row === undefined) return undefined;
  const { tour, value, seconds: used } = row;
  return { by: LKH, instance: name, nodes, sets, seed, limit: seconds, seconds: used, clock: 'processor', value: checked(path, tour, value), checked: 'coordinates' };
}

/** The length of a tour, added up from the coordinates, which has to be what the solver says. */
export function checked(path, tour, value) {
  const length = lengthOf(parts(readFileSync(path, 'latin1')), tour);
  if (length !== value) throw new Stop(`${path}: the tour is ${length} long and not ${value}, as the solver says.`);
  return length;
}

/** The table of a log, in Markdown: medians of the seeds that were run, and LKH's value. */
export function markdown(lines) {
  const known = JSON.parse(readFileSync(join(ROOT, 'benches', 'data', 'gtsplib', 'best_known.json'), 'utf8'));
  const whole = (value) => (value === undefined ? '' : Math.round(value).toLocaleString('en'));
  const marks = MARKS.filter((m) => lines.some((l) => l.after?.[m] !== undefined));
  const names = [...new Set(lines.map((l) => l.instance))].sort((a, b) => parseInt(a) - parseInt(b) || (a < b ? -1 : 1));
  const body = names.map((name) => {
    // The longest run of each seed.
    const of = (by) => [...new Map(lines.filter((l) => l.instance === name && l.by === by).sort((a, b) => a.limit - b.limit).map((l) => [l.seed, l])).values()];
    const [runs, [lkh]] = [of(US), of(LKH)];
    const middle = (values) => (values.length > 0 ? median(values) : undefined);
    const after = marks.map((m) => middle(runs.map((r) => r.after[m]).filter((v) => v !== undefined)));
    // Ours after as many seconds as LKH was given.
    const ours = lkh && after[marks.indexOf(lkh.limit)];
    const beside = ours !== undefined ? `${whole(lkh.value)} (${percent(lkh.value, ours)}, ${lkh.seconds.toFixed(0)} s)` : '';
    const cells = [whole(lines.find((l) => l.instance === name).sets), runs.map((r) => `${r.seed}${r.checked === 'coordinates' ? '' : '*'}`).sort().join(', '), whole(middle(runs.map((r) => r.first))), ...after.map(whole)];
    const best = runs.length > 0 ? Math.min(...runs.map((r) => r.value)) : undefined;
    const memory = Math.max(0, ...runs.map((r) => r.memory ?? 0));
    return [name, ...cells, whole(best), whole(known[name]?.best), beside, memory > 0 ? `${mb(memory)} MB` : ''];
  });
  const columns = ['instance', 'sets', 'seeds', 'first tour', ...marks.map((m) => `after ${m} s`), 'best', 'best known', 'LKH', 'memory'];
  return [columns, columns.map(() => '---'), ...body].map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}
