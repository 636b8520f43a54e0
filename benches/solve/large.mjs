// The instances of GTSPLIB with 200 sets and more, natively in one thread:
//
//     npm run bench -- solve large --gtsplib FOLDER --seconds 60 --seeds 5 --cpu --log benches/data/large.jsonl [--tours FOLDER] [--lkh PROGRAM]
//
// `--gtsplib` names the folder with GTSPLIB's files, `--tours` that with the best tours of GLKH, which are in its archive beside each
// other (benches/data/README.md). Runs go seed by seed through all instances, one process at a time. With `--log` each run is a line of
// that file as soon as it ends, runs that are there are not repeated, and the table is made of all lines: the command can be stopped and
// started again. With `--lkh` the program LKH solves each instance once after the first seed (benches/solve/lkh.py; KERFWAY_PYTHON with
// numpy). The length of every tour is added up again from the coordinates (benches/solve/tsplib.mjs); a wrong one ends the command.

import { appendFileSync, existsSync, readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { Stop } from '../../scripts/tools.mjs';
import { mb, median } from '../common/table.mjs';
import { at, firstRow, HERE, natively, percent, PYTHON } from './runs.mjs';
import { lengthOf, parts } from './tsplib.mjs';

/** Characters within which the header of a file ends. */
const HEAD = 2000;
/** Least number of sets of a large instance. */
const LEAST = 200;
/** Seconds after which values are kept. */
const MARKS = [10, 60, 600];
/** Most nodes of an instance that LKH is given: it reads the costs of all pairs of nodes, and its preparation grows with their square. */
const LKH_MOST = 7500;

const US = 'kerfway';
const LKH = 'LKH';
const GLKH = 'GLKH';

export function large({ seconds, seeds, only, cpu = false, gtsplib, tours, log, lkh }) {
  if (gtsplib === undefined) throw new Stop('The set large needs --gtsplib FOLDER: a folder with the .gtsp files of GTSPLIB.');
  const instances = instancesIn(gtsplib, only);
  const lines = log !== undefined && existsSync(log) ? read(readFileSync(log, 'utf8')) : [];
  const add = (line) => {
    lines.push(line);
    if (log !== undefined) appendFileSync(log, `${JSON.stringify(line)}\n`);
    console.log(`${line.instance}  ${line.by}${line.seed === undefined ? '' : ` seed ${line.seed}`}: ${line.value}${line.seconds === undefined ? '' : ` after ${line.seconds} s`}`);
  };
  const isDone = ({ name }, by, seed) => lines.some((l) => l.instance === name && l.by === by && l.seed === seed && l.limit >= seconds);
  if (tours !== undefined) {
    for (const instance of instances.filter(({ name }) => !lines.some((l) => l.instance === name && l.by === GLKH))) add(published(instance, tours));
  }
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

/** The instances in a folder with so many sets, the smallest first. */
export function instancesIn(folder, only = '') {
  const all = readdirSync(folder).filter((file) => file.endsWith('.gtsp') && file.includes(only)).map((file) => {
    const path = join(folder, file);
    const { header } = parts(readFileSync(path, 'latin1').slice(0, HEAD));
    return { name: basename(file, '.gtsp'), nodes: Number(header.get('DIMENSION')), sets: Number(header.get('GTSP_SETS')), path };
  });
  return all.filter(({ sets }) => sets >= LEAST).sort((a, b) => a.sets - b.sets || (a.name < b.name ? -1 : 1));
}

/** The lines of a log. */
export const read = (text) => text.split('\n').filter(Boolean).map((line) => JSON.parse(line));

function ours({ name, nodes, sets, path }, seed, { seconds, cpu }) {
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
function byLkh({ name, nodes, sets, path }, seed, { program, seconds }) {
  const row = firstRow(PYTHON, [join(HERE, 'lkh.py'), program, path, '--seconds', String(seconds), '--seed', String(seed)], `LKH on ${name}`);
  if (row === undefined) return undefined;
  const { tour, value, seconds: used } = row;
  return { by: LKH, instance: name, nodes, sets, seed, limit: seconds, seconds: used, clock: 'processor', value: checked(path, tour, value), checked: 'coordinates' };
}

/** The line of the best tour that GLKH's archive has: `NAME.LENGTH.tour`, a file of TSPLIB. */
export function published({ name, nodes, sets, path }, folder) {
  const file = readdirSync(folder).find((file) => file.startsWith(`${name}.`) && /^\d+\.tour$/.test(file.slice(name.length + 1)));
  if (file === undefined) throw new Stop(`${folder} has no tour of ${name}: its name would be ${name}.LENGTH.tour.`);
  const rows = parts(readFileSync(join(folder, file), 'latin1')).sections.get('TOUR_SECTION') ?? [];
  const tour = rows.slice(0, rows.indexOf('-1')).map(Number);
  return { by: GLKH, instance: name, nodes, sets, value: checked(path, tour, Number(file.split('.').at(-2))), checked: 'coordinates' };
}

/** The length of a tour, added up from the coordinates, which has to be what the solver says. */
export function checked(path, tour, value) {
  const length = lengthOf(parts(readFileSync(path, 'latin1')), tour);
  if (length !== value) throw new Stop(`${path}: the tour is ${length} long and not ${value}, as the solver says.`);
  return length;
}

/** The table of a log, in Markdown: medians of the seeds that were run, beside the best values of GLKH's archive and LKH's. */
export function markdown(lines) {
  const whole = (value) => (value === undefined ? '' : Math.round(value).toLocaleString('en'));
  const marks = MARKS.filter((m) => lines.some((l) => l.after?.[m] !== undefined));
  const names = [...new Set(lines.map((l) => l.instance))].sort((a, b) => parseInt(a) - parseInt(b) || (a < b ? -1 : 1));
  const body = names.map((name) => {
    // The longest run of each seed.
    const of = (by) => [...new Map(lines.filter((l) => l.instance === name && l.by === by).sort((a, b) => a.limit - b.limit).map((l) => [l.seed, l])).values()];
    const [runs, [lkh], [glkh]] = [of(US), of(LKH), of(GLKH)];
    const middle = (values) => (values.length > 0 ? median(values) : undefined);
    const after = marks.map((m) => middle(runs.map((r) => r.after[m]).filter((v) => v !== undefined)));
    // Ours after as many seconds as LKH was given.
    const ours = lkh && after[marks.indexOf(lkh.limit)];
    const beside = ours !== undefined ? `${whole(lkh.value)} (${percent(lkh.value, ours)}, ${lkh.seconds.toFixed(0)} s)` : '';
    const cells = [whole(lines.find((l) => l.instance === name).sets), runs.map((r) => `${r.seed}${r.checked === 'coordinates' ? '' : '*'}`).sort().join(', '), whole(middle(runs.map((r) => r.first))), ...after.map(whole)];
    const best = runs.length > 0 ? Math.min(...runs.map((r) => r.value)) : undefined;
    const against = best !== undefined && glkh !== undefined ? percent(best, glkh.value) : '';
    const memory = Math.max(0, ...runs.map((r) => r.memory ?? 0));
    return [name, ...cells, whole(best), whole(glkh?.value), against, beside, memory > 0 ? `${mb(memory)} MB` : ''];
  });
  const columns = ['instance', 'sets', 'seeds', 'first tour', ...marks.map((m) => `after ${m} s`), 'best', 'best of GLKH', 'our best against it', 'LKH', 'memory'];
  return [columns, columns.map(() => '---'), ...body].map((cells) => `| ${cells.join(' | ')} |`).join('\n');
}
