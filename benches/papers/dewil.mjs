// Dewil et al. in the kit: the rows of a run, and table 1 in form from the rows of a CSV.

import { join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';
import { mean, rows, table } from '../common/table.mjs';
import { MACHINE } from '../dewil/machine.mjs';
import { PRINTED } from '../dewil/printed.mjs';
import { SHEETS } from '../dewil/sheets.mjs';
import { OURS } from './readings.mjs';
import { native } from './runs.mjs';
import { holm, wilcoxon } from './statistics.mjs';

const SET = Object.fromEntries(SHEETS.map(([name, set]) => [name, set]));
const ELEMENTS = Object.fromEntries(SHEETS.map(([name, , elements]) => [name, elements]));
/** Among all nodes the method takes up to 13 s on sheets of at most this number of elements, and the work grows with more than its third power. */
const AMONG_ALL = 700;

/** What `partition-tree` and `gtsp-lk` report about themselves, by column: seconds without what every path costs besides, numbers, shares. */
const REPORTED = {
  seconds: {
    free: ['best with precedence left out, s', 'tour with precedence left out, s'], repaired: ['repaired, s'], improved: ['repaired and improved, s'],
  },
  numbers: {
    partitions: 'partitions', depth: 'depth', construction: 'construction', gtsp: 'GTSP', repartitioning: 'repartitioning', arborescence: 'arborescence',
    repair: 'repair and entries',
  },
};

/** The rows of one reading on one sheet; none where it says something about pierce groups and the sheet has none, or would take too long. */
export function runs({ instance, method, parameters, more, seeds }) {
  if ((more.common_cuts ?? more.whole) !== undefined && SET[instance] !== 3) return [];
  if (parameters.neighbourhood === 'all' && ELEMENTS[instance] > AMONG_ALL) return [];
  const run = { name: method, method, parameters, seeds, ...more };
  const timed = more.as_long_as === undefined ? [] : [{ ...OURS, seeds: 0 }];
  const args = [join(ROOT, 'benches', 'dewil', 'sheets', `${instance}.dxf`), JSON.stringify(MACHINE), JSON.stringify([run, ...timed])];
  return rows(native('dewil'), args).filter((r) => r.name === method && r.value !== null).map((r, k) => {
    const value = (name) => r.insight?.curves.find((c) => c.name === name)?.value ?? '';
    const seconds = (names) => names.map(value).filter((v) => v !== '').map((v) => r.fixed + v)[0] ?? '';
    return {
      ...r, seed: k + 1,
      more: {
        pre_cuts: r.pre_cuts, left: r.left,
        ...Object.fromEntries(Object.entries(REPORTED.seconds).map(([key, names]) => [key, seconds(names)])),
        ...Object.fromEntries(Object.entries(REPORTED.numbers).map(([key, name]) => [key, value(name)])),
      },
    };
  });
}

/** The lines of table 1: what is read from which rows, and the column of the printed values. */
const LINES = [
  { title: 'GTSP', name: 'gtsp-lk: as-published', key: 'free', printed: 1 },
  // By its text, PFr-I has the GTSP of partitions without precedence; by its numbers it has not (C-FR of table 3).
  { title: 'PFr-I by its text', name: 'partition-tree: PFr-I', key: 'value', printed: 2 },
  { title: 'PFr-I by its numbers, C-FR', name: 'partition-tree: C-FR', key: 'value', printed: 2 },
  { title: 'F-NR', name: 'partition-tree: as-published', key: 'free', printed: 4 },
  { title: 'F-R', name: 'partition-tree: as-published', key: 'improved', printed: 6 },
  { title: 'GTSP, our entries', name: 'gtsp-lk: nodes=entries', key: 'free' },
  { title: 'F-R, our entries', name: 'partition-tree: nodes=entries', key: 'improved' },
  { title: 'F-R, reattached otherwise', name: 'partition-tree: reattach=reopened', key: 'improved' },
  { title: 'F-R, all entries again', name: 'partition-tree: entries=all', key: 'improved' },
  { title: 'F-R, all nodes', name: 'partition-tree: neighbourhood=all', key: 'improved' },
  { title: 'F-R from SP', name: 'partition-tree: start=each', key: 'improved', printed: 8 },
  { title: 'F-R from GTSP', name: 'partition-tree: start=single', key: 'improved', printed: 9 },
  { title: 'tour-tree as long as that on our entries', name: 'tour-tree: as long as F-R', key: 'value' },
];
/** The same on set 3, with other paths through pierce groups. */
const FORMS = ['', 'whole', 'insertion', 'insertion, whole'];
const OF_GROUPS = FORMS.flatMap((form) => [
  { title: ['PFr', form].filter(Boolean).join(', '), name: `pfr: ${form || 'as-published'}`, key: 'value', form: '' },
  { title: ['GTSP', form].filter(Boolean).join(', '), name: `gtsp-lk: ${form || 'as-published'}`, key: 'free', printed: 1, form },
  { title: ['F-R', form].filter(Boolean).join(', '), name: `partition-tree: ${form || 'as-published'}`, key: 'improved', printed: 6, form },
]);

/** Table 1 in form, and what leaving pierce groups and the way of finding their paths change in it. */
export function report(all) {
  const at = (name, key) => (instance) => {
    const own = all.filter((r) => r.instance === instance && `${r.method}: ${r.reading}` === name).map((r) => r[key]);
    return own.length === 0 ? undefined : mean(own);
  };
  const gains = (line, instances, base) => instances.map((i) => 100 * (1 - line(i) / base(i)));
  const percent = (values) => (values.length === 0 ? '' : `${mean(values).toFixed(1)} %`);
  const instances = [...new Set(all.map((r) => r.instance))];
  const pfr = at('pfr: as-published', 'value');
  const tree = at('partition-tree: as-published', 'improved');
  const complete = (line, base, some) => some.filter((i) => line(i) !== undefined && base(i) !== undefined);
  const sets = [[1], [2], [3], [1, 2, 3]].map((set) => instances.filter((i) => set.includes(SET[i]))).filter((some) => some.length > 0);
  const titles = sets.map((some) => (some.length === instances.length && sets.length > 1 ? 'all' : `set ${SET[some[0]]}`));
  const shown = LINES.filter(({ name, key }) => complete(at(name, key), pfr, instances).length > 0);
  table(
    'Table 1 in form: improvement over PFr, mean over the sheets of a set, ours and printed (from its rows)',
    ['', ...titles.flatMap((t) => [t, 'printed'])],
    shown.map(({ title, name, key, printed }) => [title, ...sets.flatMap((some) => {
      const line = at(name, key);
      const paper = printed === undefined ? '' : percent(some.map((i) => 100 * (1 - PRINTED[i][printed] / PRINTED[i][0])));
      return [percent(gains(line, complete(line, pfr, some), pfr)), paper];
    })]),
  );
  against(shown.filter((l) => l.title !== 'F-R'), { at, tree, sets, titles, complete });
  const third = instances.filter((i) => SET[i] === 3);
  const groups = OF_GROUPS.filter(({ name, key }) => complete(at(name, key), pfr, third).length > 0);
  if (groups.length > 3) {
    table(
      'Set 3 by sheet: improvement over the PFr of the same paths through pierce groups; PFr over the PFr of the first line',
      ['', ...third.map(String), 'mean', 'printed'],
      groups.map(({ title, name, key, printed, form }) => {
        const base = at(`pfr: ${form || 'as-published'}`, 'value');
        const values = gains(at(name, key), third, base);
        return [title, ...values.map((v) => v.toFixed(1)), percent(values), printed === undefined ? '' : percent(third.map((i) => 100 * (1 - PRINTED[i][printed] / PRINTED[i][0])))];
      }),
    );
  }
}

/** How far each line is behind F-R (positive) or ahead of it, with a test over the sheets of each set. */
function against(lines, { at, tree, sets, titles, complete }) {
  const cells = lines.map(({ name, key }) => sets.map((some) => {
    const line = at(name, key);
    const both = complete(line, tree, some);
    if (both.length === 0) return null;
    const behind = both.map((i) => 100 * (line(i) / tree(i) - 1));
    return { behind, ...wilcoxon(both.map(tree), both.map(line)) };
  }));
  const corrected = holm(cells.flat().map((c) => c?.p ?? 1));
  table(
    'Behind F-R, mean, least and most over the sheets; p (Wilcoxon, pairs by sheet, Holm over the table)',
    ['', ...titles.flatMap((t) => [t, 'least', 'most', 'p'])],
    lines.map(({ title }, k) => [title, ...cells[k].flatMap((c, s) => (c === null ? ['', '', '', ''] : [
      `${mean(c.behind).toFixed(2)} %`, Math.min(...c.behind).toFixed(2), Math.max(...c.behind).toFixed(2), corrected[k * sets.length + s].toPrecision(2),
    ]))]),
  );
}
