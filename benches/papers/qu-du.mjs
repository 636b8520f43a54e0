// Tables 3, 5 (with 6) and 7 (with 8) of P. Qu, F. Du, IEEE Access 11 (2023), doi 10.1109/ACCESS.2023.3236006.

import { readFileSync } from 'node:fs';
import { NOT_RUN } from '../common/data.mjs';
import { mean, table } from '../common/table.mjs';
import { above, average, best, percent, runs } from './runs.mjs';

/** Straight lines, no way back, the paper's feature points: centres of circles among them. */
const VARIANT = 'qu-du euclid open paper';
const OPTIMUM = 2545.445;

const METHODS = { PSO: 'pso', 'ACO-PSO': 'aco-pso', 'K-PSO': 'k-pso', LPSPSO: 'lpspso' };
/** Iterations with local search: 3,000 local searches come further than 30,000 particles without, and all tables end
 * within the hour. Without it the paper's 600. */
const LOCAL_ROUNDS = 60;
const ROUNDS = 600;
/** Seconds the default solver gets; it needs a fraction of them. */
const SECONDS = 2;

const read = (instances, name) => JSON.parse(readFileSync(instances.file(`qu-du-43/${name}`), 'utf8'));

export const tables = { 'qu-du-3': tsplib, 'qu-du-5': (o) => contours('fixed', o), 'qu-du-7': (o) => contours('random', o) };

/** As published, then with local search, by the default readings. */
const kinds = (rounds = LOCAL_ROUNDS) => [
  [`as published, no local search, ${ROUNDS} iterations of 50 particles`, { preset: 'as-published', rounds: ROUNDS }],
  [`with local search, ${rounds} iterations of 50 particles`, { local_search: true, rounds }],
];

function tsplib({ seeds, rounds, only, instances }) {
  const all = read(instances, 'tsplib_table.json').instances.filter((i) => i.name !== 'fv36' && (only === undefined || i.name === only));
  for (const [kind, parameters] of kinds(rounds)) {
    const sums = Object.keys(METHODS).map(() => ({ printed: [], mean: [], best: [] }));
    const own = [];
    const lines = all.map(({ name, optimal, results }) => {
      const file = instances.find(`qu-du-43/tsplib/${name}.tsp`);
      if (file === null) return [name, String(optimal), NOT_RUN, ...Array(3 * Object.keys(METHODS).length).fill('')];
      const cells = Object.entries(METHODS).flatMap(([title, method], m) => {
        const list = runs(method, file, { parameters, seeds });
        const values = [results[title].result, average(list), best(list)].map((v) => above(v, optimal));
        ['printed', 'mean', 'best'].forEach((key, k) => sums[m][key].push(values[k]));
        return values.map(percent);
      });
      own.push(above(average(runs('tour-tree', file, { seeds, seconds: SECONDS })), optimal));
      console.log([name, ...cells].join('  '));
      return [name, String(optimal), ...cells, percent(own.at(-1))];
    });
    const means = sums.flatMap((s) => [s.printed, s.mean, s.best].map((list) => percent(mean(list.filter(Number.isFinite)))));
    const columns = Object.keys(METHODS).flatMap((title) => [`${title} printed`, 'mean', 'best']);
    table(
      `Qu & Du, table 3: above the optimum, ${kind}, ${seeds} seeds (fv36 is not public)`,
      ['', 'optimum', ...columns, 'tour-tree'],
      [...lines, ['mean', '', ...means, percent(mean(own))]],
    );
  }
  console.log('Printed deviations are shares of the result; here all are shares of the optimum.');
}

function contours(start, { seeds, rounds, instances }) {
  const file = instances.file('qu-du-43/qu_du_43.json');
  // S11, the first node, is also the best free start.
  const first = start === 'fixed' ? 0 : null;
  const published = read(instances, 'sequences.json').sequences.filter((s) => s.start === start);
  const lines = Object.entries(METHODS).map(([title, method]) => {
    const { eval: again, claimed_empty_length_mm: claimed, complete } = published.find((s) => s.algorithm === title);
    const cells = kinds(rounds).flatMap(([, parameters]) => {
      const list = runs(method, file, { only: VARIANT, parameters: { ...parameters, first }, seeds });
      return [average(list).toFixed(3), best(list).toFixed(3), mean(list.map((r) => r.found)).toFixed(0)];
    });
    return [title, claimed.toFixed(2), `${again.total_open.toFixed(2)}${complete ? '' : ' *'}`, ...cells];
  });
  const own = runs('tour-tree', file, { only: VARIANT, seeds, seconds: SECONDS });
  const blank = ['', '', ''];
  lines.push(['tour-tree', '', '', ...blank, average(own).toFixed(3), best(own).toFixed(3), '']);
  lines.push(['optimum', '', '', ...blank, OPTIMUM.toFixed(3), OPTIMUM.toFixed(3), '']);
  table(
    `Qu & Du, table ${start === 'fixed' ? '5, fixed start S11' : '7, random start'}: 43 contours, mm, from the origin, ${seeds} seeds`,
    ['', 'printed', 'its sequence', 'as published: mean', 'best', 'iterations', `local search: mean`, 'best', 'iterations'],
    lines,
  );
  const [, local] = kinds(rounds).map(([, p]) => p.rounds);
  console.log(`As published: ${ROUNDS} iterations; with local search: ${local}; 50 particles.`);
  console.log(
    'Printed lengths do not follow from the printed coordinates (800 x 560 mm): "its sequence" is the published sequence ' +
      `(table ${start === 'fixed' ? 6 : 8}) on them; * some contours are missing in it.`,
  );
}
