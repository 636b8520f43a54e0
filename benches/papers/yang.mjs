// The example of Yang (2013): what the dual coding genetic algorithm saves against the existing path, contours as drawn,
// each from its nearest point. The paper's layout is lost; ours has its numbers of contours (tests/fixtures/yang). How much
// there is to save hangs on the order of drawing: row by row from left to right, as in the file, or rows in turn, which is far
// better already.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';
import { mean, rows, table } from '../common/table.mjs';
import { native } from './runs.mjs';

/** What the paper saved, in percent. */
const PRINTED = { length: 7.2, time: 10.4 };

export const tables = { yang };

function yang({ seeds }) {
  const { optimum } = JSON.parse(readFileSync(join(ROOT, 'tests', 'fixtures', 'yang', 'yang-27.json'), 'utf8'));
  const all = rows(native('yang'), [String(seeds)]);
  const of = (name, what) => all.filter((r) => r.name === name).map((r) => r[what]);
  const saved = (from, to) => `${((100 * (from - to)) / from).toFixed(1)} %`;
  const names = [...new Set(all.map((r) => r.name))];
  const drawn = (what) => of('as drawn', what)[0];
  const turned = (what) => of('rows in turn', what)[0];
  const line = (name, time, best, length) => [
    name, time.toFixed(1), best.toFixed(1), length === null ? '' : length.toFixed(1), saved(drawn('time'), time), length === null ? '' : saved(drawn('length'), length),
    saved(turned('time'), time), length === null ? '' : saved(turned('length'), length),
  ];
  const lines = names.map((name) => line(name, mean(of(name, 'time')), Math.min(...of(name, 'time')), mean(of(name, 'length'))));
  lines.push(line('exact optimum of time', optimum.chebyshev, optimum.chebyshev, null));
  lines.push(['printed', '', '', '', `${PRINTED.time} %`, `${PRINTED.length} %`, '', '']);
  const columns = ['', 'time, mean', 'best', 'length, mean', 'saved: time', 'length', 'from rows in turn: time', 'length'];
  table(`Yang's example, 27 contours: spare travel by the longer axis (time) and straight, mm; ${seeds} seeds, population 50, 2000 generations, default readings; tour-tree 4 million moves`, columns, lines);
}
