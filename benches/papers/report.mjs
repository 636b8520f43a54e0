// The tables of a CSV of the kit: statistics of each instance, ranks over all instances, and the papers' own tables with the printed
// values beside ours.

import { Stop } from '../../scripts/tools.mjs';
import { table } from '../common/table.mjs';
import { report as dewil } from './dewil.mjs';
import { HULL, QU_DU } from './published.mjs';
import { deviation, friedman, holm, mean, median, wilcoxon } from './statistics.mjs';

/** A difference counts from this p on; below it, nothing is called shorter or longer. */
const LEVEL = 0.05;

/** The tables of the rows of a paper. `against`: what all others are tested against, the first of the rows by default. */
export function report(paper, runs, against) {
  // A run that has found no path that is allowed, as random keys without the fixed edge of `linhp318`, has no value.
  const hasValue = (r) => typeof r.value === 'number';
  const [all, lost] = [runs.filter(hasValue), runs.filter((r) => !hasValue(r))];
  if (lost.length > 0) console.log(`\n${lost.length} runs found no path and are left out: ${[...new Set(lost.map((r) => `${nameOf(r)} on ${r.instance}`))].join('; ')}.`);
  const names = order(all, against);
  const instances = [...new Set(all.map((r) => r.instance))];
  for (const instance of instances) {
    const lists = names.map((name) => [name, of(all, name, instance)]).filter(([, list]) => list.length > 0);
    statistics(instance, lists);
    FORMS[paper]?.(instance, lists);
  }
  if (paper === 'dewil') {
    dewil(all);
    trees(all, names, instances);
  }
  ranks(all, names, instances);
}

const nameOf = (row) => `${row.method}: ${row.reading}`;
const of = (all, name, instance) => all.filter((r) => r.instance === instance && nameOf(r) === name).sort((a, b) => a.seed - b.seed);

/** The methods with their readings in the order of the rows, `against` first. */
function order(all, against) {
  const found = [...new Set(all.map(nameOf))];
  if (against === undefined) return found;
  if (!found.includes(against)) throw new Stop(`No run is of ${against}.`);
  return [against, ...found.filter((name) => name !== against)];
}

/** The tests of all lists against the first, with Holm's correction. Both must have the same seeds. */
export function tests(lists) {
  const values = (list) => list.map((r) => r.value);
  const seeds = (list) => list.map((r) => r.seed).join();
  const [[, lead], ...others] = lists;
  const single = others.map(([, list]) => (seeds(list) === seeds(lead) ? wilcoxon(values(lead), values(list)) : null));
  const corrected = holm(single.map((t) => t?.p ?? 1));
  return single.map((t, k) => t && { p: corrected[k], effect: t.effect, verdict: verdict(corrected[k], t.effect) });
}

/** What may be said about a difference. */
export const verdict = (p, effect) => (p >= LEVEL ? 'not told apart' : effect > 0 ? 'more' : 'less');

function statistics(instance, lists) {
  const tested = tests(lists);
  const lines = lists.map(([name, list], k) => {
    const values = list.map((r) => r.value);
    const test = k === 0 ? null : tested[k - 1];
    const at = list[0].optimum === '' ? '' : `${list.filter((r) => r.value <= r.optimum + 1e-6).length}/${list.length}`;
    return [
      name, String(values.length), median(values).toFixed(3), mean(values).toFixed(3), Math.min(...values).toFixed(3), deviation(values).toFixed(3), at,
      mean(list.map((r) => r.seconds)).toFixed(3), test === null ? '' : test.p.toPrecision(2), test === null ? '' : test.effect.toFixed(2), test?.verdict ?? '',
    ];
  });
  table(
    `${instance}: p (Wilcoxon signed-rank, pairs by seed, Holm over the table) and effect (rank-biserial; 1: always longer) against ${lists[0][0]}`,
    ['', 'runs', 'median', 'mean', 'best', 'deviation', 'at optimum', 's a run', 'p', 'effect', 'than the first'],
    lines,
  );
}

function ranks(all, names, instances) {
  const complete = names.filter((name) => instances.every((i) => of(all, name, i).length > 0));
  if (instances.length < 2 || complete.length < 2) return;
  // Means as multiples of the optimum or, where it is not known, of the least mean of the instance: one unit for all instances.
  const blocks = instances.map((i) => {
    const means = complete.map((name) => mean(of(all, name, i).map((r) => r.value)));
    const { optimum } = all.find((r) => r.instance === i);
    return means.map((m) => m / (optimum === '' ? Math.min(...means) : optimum));
  });
  const found = friedman(blocks);
  const [lead, ...others] = complete.map((_, k) => blocks.map((block) => block[k]));
  const single = others.map((values) => wilcoxon(lead, values));
  const corrected = holm(single.map((t) => t.p));
  table(
    `Over ${instances.length} instances: Friedman ranks of the means (chi-square ${found.statistic.toFixed(2)}, p ${found.p.toPrecision(2)}); p (Wilcoxon, pairs by instance, Holm) against ${complete[0]}`,
    ['', 'above optimum or least, mean', 'mean rank', 'p', 'effect', 'than the first'],
    complete.map((name, k) => {
      const above = `${(100 * (mean(blocks.map((block) => block[k])) - 1)).toFixed(3)} %`;
      const test = k === 0 ? null : { p: corrected[k - 1], effect: single[k - 1].effect };
      return [name, above, found.ranks[k].toFixed(2), test?.p.toPrecision(2) ?? '', test?.effect.toFixed(2) ?? '', test ? verdict(test.p, test.effect) : ''];
    }),
  );
}

const FORMS = { 'qu-du': quDu, hull };

/** Mean of a column, without its empty cells. */
const column = (list, key, digits) => {
  const values = list.map((r) => r[key]).filter((v) => v !== '' && v !== undefined);
  return values.length === 0 ? '' : mean(values).toFixed(digits);
};

/** Tables 5 and 7. Cutting times of ours are those of another machine, `co2-100w`; iterations count until the best was found. */
function quDu(instance, lists) {
  const start = instance.includes('fixed') ? 'fixed' : 'random';
  const lines = lists.map(([name, list]) => {
    const printed = QU_DU[start][list[0].method];
    const values = list.map((r) => r.value);
    return [
      name, `${printed.sequence.toFixed(2)}${printed.incomplete ? ' *' : ''}`, mean(values).toFixed(2), Math.min(...values).toFixed(2), String(printed.iterations),
      column(list, 'best_at', 0), printed.time.toFixed(2), column(list, 'cutting_time', 2), column(list, 'cprv', 4),
    ];
  });
  table(
    `${instance}, in the form of table ${start === 'fixed' ? 5 : 7}; the length printed is that of the published sequence on the printed coordinates, * a contour is missing in it`,
    ['', 'length, mm: printed', 'ours, mean', 'best', 'iterations: printed', 'ours', 'cutting time, s: printed', 'ours', 'CPRV'],
    lines,
  );
}

/** Table 3, as ratios to RLSGA, because the layouts of the paper are not published. */
function hull(instance, lists) {
  const printed = HULL[instance];
  const lead = lists.find(([, list]) => list[0].method === 'rlsga');
  if (lead === undefined) return;
  const least = mean(lead[1].map((r) => r.value));
  const lines = lists.map(([name, list]) => [
    name, (mean(list.map((r) => r.value)) / least).toFixed(3), (printed[list[0].method][0] / printed.rlsga[0]).toFixed(3),
    ...['psx', 'rsx', 'isx', 'low', 'middle', 'high'].map((key) => column(list, key, 3)),
  ]);
  table(
    `${instance}, in the form of table 3: mean as a multiple of ${lead[0]}; shares of the crossovers and of the three states`,
    ['', 'ours', 'printed', 'PSX', 'RSX', 'ISX', 'div < 0.25', 'to 0.75', 'above'],
    lines,
  );
}

/** Partitions, what the repair costs, and the shares of the work, over all sheets. */
function trees(all, names, instances) {
  const gain = (key) => (name) => {
    const gains = instances.flatMap((i) => of(all, name, i)).filter((r) => r[key] !== '').map((r) => 100 * (r[key] / r.free - 1));
    return gains.length === 0 ? '' : `${mean(gains).toFixed(2)} %`;
  };
  const some = (key, digits) => (name) => column(instances.flatMap((i) => of(all, name, i)), key, digits);
  const columns = {
    partitions: some('partitions', 1), depth: some('depth', 1), 'pre-cuts': some('pre_cuts', 1), 'repair only': gain('repaired'), 'repair, improved': gain('improved'),
    construction: some('construction', 3), GTSP: some('gtsp', 3), repartitioning: some('repartitioning', 3), arborescence: some('arborescence', 3), 'repair and entries': some('repair', 3),
  };
  const own = names.filter((name) => columns.partitions(name) !== '');
  if (own.length === 0) return;
  table(
    'Means over the sheets: partitions of the best path, what its repair costs (alone, and after entries are chosen again), shares of the work by step (figure 9)',
    ['', ...Object.keys(columns)],
    own.map((name) => [name, ...Object.values(columns).map((f) => f(name))]),
  );
}
