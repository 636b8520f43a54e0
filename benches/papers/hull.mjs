// Tables 3 and 4 of the hull-part paper (Liu & Chang 2023): the printed values, ours on sheets of the same sizes (the
// paper's layouts are lost, so values do not compare, only their order does), and the exact optimum.

import { availableParallelism } from 'node:os';
import { mean, table } from '../common/table.mjs';
import { parallel } from './parallel.mjs';

const METHODS = ['rlsga', 'hull-pso', 'ofa', 'woa', 'sga'];

/** Mean and best of table 3, seconds of table 4, by sheet and method. */
const PRINTED = {
  'hull-5-20': {
    rlsga: [49.68, 49.68, 16.523],
    'hull-pso': [56.36, 55.95, 24.671],
    ofa: [54.95, 54.38, 30.587],
    woa: [53.96, 53.14, 35.641],
    sga: [53.34, 52.09, 16.003],
  },
  'hull-10-45': {
    rlsga: [84.31, 81.79, 27.714],
    'hull-pso': [97.65, 96.17, 46.529],
    ofa: [97.19, 92.51, 50.319],
    woa: [102.3, 98.78, 55.413],
    sga: [95.49, 92.32, 26.66],
  },
};

/** Runs of every method on one sheet of a size, and of the default method. */
async function runs(native, name, { seeds, sheets }) {
  const jobs = [...METHODS, 'tour-tree'].flatMap((method) =>
    Array.from({ length: sheets }, (_, sheet) => [name, String(sheet), String(seeds), method]),
  );
  return (await parallel(native, jobs, availableParallelism())).flat();
}

const budget = (name) => `${name === 'hull-5-20' ? 100 : 200} members, 1000 generations`;

/** Empty travel. Values of several sheets are parts of each one's optimum. */
export async function rlsga3(native, options) {
  for (const name of Object.keys(PRINTED)) {
    const all = await runs(native, name, options);
    const lines = [...METHODS, 'tour-tree'].map((method) => {
      const own = all.filter((r) => r.method === method);
      const over = own.map((r) => r.length / r.optimum);
      const plans = own.map((r) => r.plan / r.optimum);
      const [printedMean, printedBest] = PRINTED[name][method] ?? [];
      const first = PRINTED[name].rlsga[0];
      const scale = options.sheets === 1 ? own[0].optimum : 1;
      const show = (v) => (options.sheets === 1 ? (v * scale).toFixed(1) : v.toFixed(4));
      const printed = printedMean === undefined ? ['', '', ''] : [printedMean.toFixed(2), printedBest.toFixed(2), (printedMean / first).toFixed(3)];
      const reached = over.filter((v) => v < 1 + 1e-9).length;
      return [method, ...printed, show(mean(over)), show(Math.min(...over)), show(mean(plans)), show(1), `${reached}/${own.length}`, (mean(over) / mean(all.filter((r) => r.method === 'rlsga').map((r) => r.length / r.optimum))).toFixed(3)];
    });
    const unit = options.sheets === 1 ? 'mm' : `parts of the optimum, ${options.sheets} sheets`;
    const columns = ['', 'printed mean', 'printed best', 'to rlsga', 'mean', 'best', 'mean of plans', 'optimum', 'at it', 'to rlsga'];
    table(`Table 3, ${name}: empty travel, ${unit}, ${options.seeds} seeds, ${budget(name)}; tour-tree 8 million moves`, columns, lines);
  }
}

/** Seconds a run. */
export async function rlsga4(native, options) {
  const names = Object.keys(PRINTED);
  const all = {};
  for (const name of names) all[name] = await runs(native, name, { ...options, seeds: Math.min(options.seeds, 5), sheets: 1 });
  const lines = METHODS.map((method) => {
    const own = (name) => all[name].filter((r) => r.method === method);
    return [method, ...names.flatMap((name) => [
      PRINTED[name][method][2].toFixed(1), mean(own(name).map((r) => r.seconds)).toFixed(2), `${(mean(own(name).map((r) => r.moves)) / 1e6).toFixed(1)} M`,
    ])];
  });
  const columns = ['', ...names.flatMap((name) => [`${name} printed, Python`, 'ours, natively', 'moves'])];
  table('Table 4: seconds a run, the same populations and generations', columns, lines);
}
