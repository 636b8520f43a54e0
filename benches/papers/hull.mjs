// Tables 3 and 4 of the hull-part paper (Liu & Chang 2023): the printed values, ours on sheets of the same sizes (the
// paper's layouts are lost, so values do not compare, only their order does), and the exact optimum.

import { availableParallelism } from 'node:os';
import { mean, table } from '../common/table.mjs';
import { parallel } from './parallel.mjs';
import { HULL } from './published.mjs';
import { native } from './runs.mjs';

const METHODS = ['rlsga', 'hull-pso', 'ofa', 'woa', 'sga'];

/** Of ten sheets of each size, the one of the table; `--only` takes another. */
const SHEET = '0';

/** Runs of methods on the sheet of a size. */
const runs = async (name, methods, seeds, sheet = SHEET) =>
  (await parallel(native('hull'), methods.map((method) => [name, sheet, String(seeds), method]), availableParallelism())).flat();

export const tables = { 'rlsga-3': emptyTravel, 'rlsga-4': seconds };

async function emptyTravel({ seeds, only }) {
  for (const [name, printed] of Object.entries(HULL)) {
    const all = await runs(name, [...METHODS, 'tour-tree'], seeds, only);
    const of = (method, what) => all.filter((r) => r.method === method).map((r) => r[what]);
    const { optimum } = all[0];
    const lines = [...METHODS, 'tour-tree'].map((method) => {
      const own = of(method, 'length');
      const [mean1, best1] = printed[method] ?? [];
      const part = (value, first) => (value / first).toFixed(3);
      return [
        method, mean1?.toFixed(2) ?? '', best1?.toFixed(2) ?? '', mean1 === undefined ? '' : part(mean1, printed.rlsga[0]),
        mean(own).toFixed(1), Math.min(...own).toFixed(1), part(mean(own), mean(of('rlsga', 'length'))), mean(of(method, 'plan')).toFixed(1),
        optimum.toFixed(1), `${own.filter((v) => v < optimum + 1e-6).length}/${own.length}`,
      ];
    });
    const columns = ['', 'printed: mean', 'best', 'to rlsga', 'ours: mean', 'best', 'to rlsga', 'plans, mean', 'optimum', 'at it'];
    const members = name === 'hull-5-20' ? 100 : 200;
    table(`Table 3, ${name}: empty travel in mm, ${seeds} seeds, ${members} members, 1000 generations, default readings; tour-tree 8 million moves`, columns, lines);
  }
  console.log('Printed values are of another layout and unit: only their order compares. A plan nests what a code says and is as long or shorter.');
}

async function seconds({ seeds, only }) {
  const all = {};
  for (const name of Object.keys(HULL)) all[name] = await runs(name, METHODS, seeds, only);
  const lines = METHODS.map((method) => [method, ...Object.keys(HULL).flatMap((name) => {
    const own = all[name].filter((r) => r.method === method);
    return [HULL[name][method][2].toFixed(1), mean(own.map((r) => r.seconds)).toFixed(2), (mean(own.map((r) => r.moves)) / 1e6).toFixed(1)];
  })]);
  const columns = ['', ...Object.keys(HULL).flatMap((name) => [`${name}: printed (Python)`, 'ours, natively', 'million moves'])];
  table(`Table 4: seconds a run, ${seeds} seeds, ${availableParallelism()} runs at a time`, columns, lines);
}
