// The benchmark kit: every reading of a paper, seed by seed, one row a run, and the statistics of the rows:
//
//     npm run bench -- papers --paper qu-du|tsplib|hull|yang|dewil [--readings] [--seeds N] [--first SEED] [--only TEXT] [--reading TEXT]
//                             [--threads N] --csv OUT [--curves OUT]
//     npm run bench -- papers --paper NAME --from CSV [--against 'METHOD: READING']
//
// `--only` selects instances and `--reading` readings by a part of their names. `--from` prints the tables of a CSV again, without a
// run; `--against` names what all others are tested against. `--curves` writes how the values of the methods change round by round, the
// mean, the best and the worst over the seeds, without the readings that only `--readings` adds (benches/papers/figures.mjs draws them). Seconds are those of the processor. The value of a
// run is what its paper minimises: mm on the 43 contours and the hull sheets, mm by the longer axis for Yang, seconds for Dewil.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask, ROOT, run, Stop } from '../../scripts/tools.mjs';
import { SHEETS } from '../dewil/sheets.mjs';
import { rows } from '../common/table.mjs';
import { parse, write } from './csv.mjs';
import { curves } from './curves.mjs';
import { runs as dewil } from './dewil.mjs';
import { READINGS } from './readings.mjs';
import { report } from './report.mjs';
import { native } from './runs.mjs';

/** As the tables of Qu & Du: straight lines, no way back, the paper's feature points. */
const VARIANT = 'qu-du euclid open paper';
/** The same on the drawing, with feature points by the rule of the text instead of the printed ones. */
const RULED = 'qu_du_43, feature points of the paper';
/** The paper's populations. */
const POPULATION = { 'hull-5-20': 100, 'hull-10-45': 200 };

/** The curves that figures show. */
export const DRAWN = ['shortest (G)', 'spread (κ)', 'threshold (τ)', 'share of particles that fly', 'shortest empty travel TL'];

/** For each paper: its program, its instances, the rows of one reading on one instance, and the rounds between two points of a curve. */
const PAPERS = {
  'qu-du': { bin: 'papers', instances: () => ['43 contours, fixed start', '43 contours, random start', '43 contours drawn, fixed start'], runs: quDu, every: 6 },
  tsplib: { bin: 'papers', instances: tsplib, runs: quDu, every: 0 },
  hull: { bin: 'hull', instances: () => Object.keys(POPULATION), runs: hull, every: 10 },
  yang: { bin: 'yang', instances: () => ['yang-27'], runs: yang, every: 0 },
  dewil: { bin: 'dewil', instances: () => SHEETS.map(([name]) => name), runs: dewil, every: 0 },
};

export async function kit(options) {
  const { paper, readings, seeds, first, only, reading: part, threads, csv, curves: traced, from, against, instances } = options;
  if (!(paper in PAPERS)) throw new Stop(`There is no paper ${paper}: ${Object.keys(PAPERS).join(', ')}.`);
  if (from !== undefined) return report(paper, parse(readFileSync(from, 'utf8')), against);
  if (csv === undefined) throw new Stop('Where to write the runs? --csv OUT');
  const { bin, instances: listed, runs, every } = PAPERS[paper];
  if (traced !== undefined && every === 0) throw new Stop(`There are no curves of ${paper}.`);
  run('cargo', ['build', '--release', '--manifest-path', join(ROOT, 'benches', 'solve', 'Cargo.toml'), '--bin', bin]);
  const commit = sources();
  const { usual, more } = READINGS[paper];
  const chosen = (readings ? [...usual, ...more] : usual).filter(([method, name]) => part === undefined || `${method}: ${name}`.includes(part));
  const [all, points] = [[], []];
  for (const instance of listed(instances).filter((name) => only === undefined || name.includes(only))) {
    for (const [method, reading, parameters, more = {}] of chosen) {
      const shown = traced !== undefined && usual.some((r) => r[0] === method && r[1] === reading);
      const found = runs({ instance, method, parameters, more, seeds, first, threads, instances, every: shown ? every : 0 });
      for (const row of found) {
        const { seed, value, optimum = '', seconds, moves = '', found: best_at = '' } = row;
        all.push({ paper, method, reading, instance, seed, value, optimum, seconds, moves, best_at, commit, ...row.more });
      }
      if (shown) points.push(...curves(found.map((r) => r.trace), every).filter((point) => DRAWN.includes(point.curve)).map((point) => ({ method, reading, instance, ...point })));
      // After each reading, so that an interrupted kit leaves what it has.
      writeFileSync(csv, write(all));
      if (traced !== undefined) writeFileSync(traced, write(points));
    }
  }
  if (all.length === 0) throw new Stop(`No instance or reading of ${paper} contains that in its name.`);
  report(paper, all, against);
}

/** The instances of Qu & Du's table 3 that are here; fv36 is not public. Data that may not be copied come from `--data`. */
function tsplib(instances) {
  const names = JSON.parse(readFileSync(instances.file('qu-du-43/tsplib_table.json'), 'utf8')).instances;
  return names.filter(({ name }) => name !== 'fv36' && instances.find(`qu-du-43/tsplib/${name}.tsp`) !== null).map(({ name }) => name);
}

/** The commit of the sources; with a plus sign if they have been changed since. */
function sources() {
  const commit = ask('git', 'rev-parse', '--short', 'HEAD');
  if (commit === null) return 'unknown';
  return ask('git', 'status', '--porcelain', '--', 'src', 'benches', 'Cargo.toml', 'tests/fixtures') === '' ? commit : `${commit}+`;
}

/** A value that a method reports about itself. */
const inside = ({ insight }, name) => insight?.curves.find((c) => c.name === name)?.value ?? '';

function quDu({ instance, method, parameters, seeds, first, threads, instances, every }) {
  const drawn = instance.includes('drawn');
  const city = !instance.startsWith('43');
  const file = city ? instances.find(`qu-du-43/tsplib/${instance}.tsp`) : join(ROOT, 'tests', 'fixtures', 'qu-du-43', drawn ? 'qu_du_43.dxf' : 'qu_du_43.json');
  // S11, the first node, is the paper's fixed start.
  const start = { first: instance.includes('fixed') ? 0 : null };
  const args = [method, file, ...(city ? [] : ['--only', drawn ? RULED : VARIANT]), '--parameters', JSON.stringify({ ...parameters, ...start })];
  const numbers = { '--seeds': seeds, '--first': first, '--threads': threads, '--trace': every };
  return rows(native('papers'), [...args, ...Object.entries(numbers).flatMap(([name, value]) => [name, String(value)])]).map((r) => ({
    ...r, value: r.length, optimum: r.known ?? '',
    more: { cprv: inside(r, 'prospect-regret value of the shortest (Z)'), cutting_time: r.cut_seconds === null || r.air_seconds === null ? '' : r.cut_seconds + r.air_seconds },
  }));
}

function hull({ instance, method, parameters, seeds, every }) {
  const one = JSON.stringify({ method, parameters: { ...parameters, population: POPULATION[instance] }, trace: every });
  const shares = { psx: 'share of PSX', rsx: 'share of RSX', isx: 'share of ISX', low: 'share of div < 0.25', middle: 'share of 0.25 to 0.75', high: 'share of div > 0.75' };
  return rows(native('hull'), [instance, '0', String(seeds), one]).map((r) => ({
    ...r, value: r.length, more: Object.fromEntries(Object.entries(shares).map(([key, name]) => [key, inside(r, name)])),
  }));
}

function yang({ method, parameters, seeds }) {
  return rows(native('yang'), [String(seeds), JSON.stringify(parameters)])
    .filter((r) => r.name === method)
    .map((r) => ({ ...r.run, seed: r.seed, value: r.time, more: { straight: r.length } }));
}
