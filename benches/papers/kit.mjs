// The benchmark kit: every reading of a paper, seed by seed, one row a run, and the statistics of the rows:
//
//     npm run bench -- papers --paper qu-du|hull|yang|dewil [--readings] [--seeds N] [--only TEXT] [--threads N] --csv OUT
//     npm run bench -- papers --paper NAME --from CSV [--against 'METHOD: READING']
//
// `--from` prints the statistics of a CSV again, without a run; `--against` names what all others are tested against. Seconds are those of the processor. The value of a run is
// what its paper minimises: mm on the 43 contours and the hull sheets, mm by the longer axis for Yang, seconds for Dewil.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask, ROOT, run, Stop } from '../../scripts/tools.mjs';
import { MACHINE } from '../dewil/machine.mjs';
import { SHEETS } from '../dewil/sheets.mjs';
import { rows, table } from '../common/table.mjs';
import { parse, write } from './csv.mjs';
import { READINGS } from './readings.mjs';
import { native } from './runs.mjs';
import { deviation, friedman, holm, mean, median, wilcoxon } from './statistics.mjs';

/** As the tables of Qu & Du: straight lines, no way back, the paper's feature points. */
const VARIANT = 'qu-du euclid open paper';
/** The paper's populations. */
const POPULATION = { 'hull-5-20': 100, 'hull-10-45': 200 };

/** For each paper: its program, its instances, and the rows of one reading on one instance. */
const PAPERS = {
  'qu-du': { bin: 'papers', instances: () => ['43 contours, fixed start', '43 contours, random start'], runs: quDu },
  hull: { bin: 'hull', instances: () => Object.keys(POPULATION), runs: hull },
  yang: { bin: 'yang', instances: () => ['yang-27'], runs: yang },
  dewil: { bin: 'dewil', instances: () => SHEETS.map(([name]) => name), runs: dewil },
};

export async function kit({ paper, readings, seeds, only, threads, csv, from, against, instances }) {
  if (!(paper in PAPERS)) throw new Stop(`There is no paper ${paper}: ${Object.keys(PAPERS).join(', ')}.`);
  if (from !== undefined) return report(parse(readFileSync(from, 'utf8')), against);
  if (csv === undefined) throw new Stop('Where to write the runs? --csv OUT');
  const { bin, instances: listed, runs } = PAPERS[paper];
  run('cargo', ['build', '--release', '--manifest-path', join(ROOT, 'benches', 'solve', 'Cargo.toml'), '--bin', bin]);
  const commit = ask('git', 'rev-parse', '--short', 'HEAD') ?? 'unknown';
  const { usual, more } = READINGS[paper];
  const all = [];
  for (const instance of listed().filter((name) => only === undefined || name.includes(only))) {
    for (const [method, reading, parameters] of readings ? [...usual, ...more] : usual) {
      for (const row of runs({ instance, method, parameters, seeds, threads, instances })) {
        all.push({ paper, method, reading, instance, seed: row.seed, value: row.value, optimum: row.optimum ?? '', seconds: row.seconds, moves: row.moves ?? '', best_at: row.found ?? '', commit });
      }
      // After each reading, so that an interrupted kit leaves what it has.
      writeFileSync(csv, write(all));
    }
  }
  if (all.length === 0) throw new Stop(`No instance of ${paper} contains ${only} in its name.`);
  report(all, against);
}

function quDu({ instance, method, parameters, seeds, threads, instances }) {
  // S11, the first node, is the paper's fixed start.
  const first = instance.includes('fixed') ? 0 : null;
  const args = [method, instances.file('qu-du-43/qu_du_43.json'), '--only', VARIANT, '--seeds', String(seeds), '--threads', String(threads), '--parameters', JSON.stringify({ ...parameters, first })];
  return rows(native('papers'), args).map((r) => ({ ...r, value: r.length, optimum: r.known }));
}

function hull({ instance, method, parameters, seeds }) {
  const one = JSON.stringify({ method, parameters: { ...parameters, population: POPULATION[instance] } });
  return rows(native('hull'), [instance, '0', String(seeds), one]).map((r) => ({ ...r, value: r.length }));
}

function yang({ method, parameters, seeds }) {
  return rows(native('yang'), [String(seeds), JSON.stringify(parameters)])
    .filter((r) => r.name === method)
    .map((r) => ({ ...r.run, seed: r.seed, value: r.time }));
}

function dewil({ instance, method, parameters, seeds }) {
  const args = [join(ROOT, 'benches', 'dewil', 'sheets', `${instance}.dxf`), JSON.stringify(MACHINE), JSON.stringify([{ name: method, method, parameters, seeds }])];
  return rows(native('dewil'), args).filter((r) => r.name === method).map((r, k) => ({ ...r, seed: k + 1 }));
}

/** The statistics of rows, instance by instance, and over all instances. */
export function report(all, against) {
  const instances = [...new Set(all.map((r) => r.instance))];
  const found = [...new Set(all.map((r) => `${r.method}: ${r.reading}`))];
  if (against !== undefined && !found.includes(against)) throw new Stop(`No run is of ${against}.`);
  const names = against === undefined ? found : [against, ...found.filter((name) => name !== against)];
  const of = (name, instance) => all.filter((r) => r.instance === instance && `${r.method}: ${r.reading}` === name).sort((a, b) => a.seed - b.seed);
  for (const instance of instances) {
    const lists = names.map((name) => [name, of(name, instance)]).filter(([, list]) => list.length > 0);
    const [, lead] = lists[0];
    const tests = lists.slice(1).map(([, list]) => (list.length === lead.length ? wilcoxon(lead.map((r) => r.value), list.map((r) => r.value)) : null));
    const corrected = holm(tests.map((t) => t?.p ?? 1));
    const lines = lists.map(([name, list], k) => {
      const values = list.map((r) => r.value);
      const test = k === 0 ? null : tests[k - 1];
      const at = list[0].optimum === '' ? '' : `${list.filter((r) => r.value <= r.optimum + 1e-6).length}/${list.length}`;
      return [
        name, String(values.length), median(values).toFixed(3), mean(values).toFixed(3), Math.min(...values).toFixed(3), deviation(values).toFixed(3), at,
        mean(list.map((r) => r.seconds)).toFixed(3), test === null ? '' : corrected[k - 1].toPrecision(2), test === null ? '' : test.effect.toFixed(2),
      ];
    });
    table(
      `${instance}: p (Wilcoxon signed-rank, pairs by seed, Holm over the table) and effect (rank-biserial; 1: always longer) against ${lists[0][0]}`,
      ['', 'runs', 'median', 'mean', 'best', 'deviation', 'at optimum', 's a run', 'p', 'effect'],
      lines,
    );
  }
  const complete = names.filter((name) => instances.every((i) => of(name, i).length > 0));
  if (instances.length < 2 || complete.length < 2) return;
  const { ranks, statistic, p } = friedman(instances.map((i) => complete.map((name) => mean(of(name, i).map((r) => r.value)))));
  table(`Friedman ranks of the means over ${instances.length} instances (chi-square ${statistic.toFixed(2)}, p ${p.toPrecision(2)})`, ['', 'mean rank'], complete.map((name, k) => [name, ranks[k].toFixed(2)]));
}
