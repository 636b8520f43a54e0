// The statistics of the benchmark kit, against values published by scipy and R.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { chiSquareAbove, deviation, friedman, holm, median, ranks, wilcoxon } from '../../benches/papers/statistics.mjs';
import { parse, write } from '../../benches/papers/csv.mjs';

const close = (found, wanted, within = 1e-12) => assert.ok(Math.abs(found - wanted) <= within, `${found} is not ${wanted}`);

describe('statistics of the benchmark kit', () => {
  it('the Wilcoxon signed-rank test of the example in the documentation of scipy.stats.wilcoxon', () => {
    const d = [6, 8, 14, 16, 23, 24, 28, 29, 41, -48, 49, 56, 60, -67, 75];
    const { statistic, p, effect } = wilcoxon(d, d.map(() => 0));
    assert.equal(statistic, 24);
    close(p, 0.041259765625);
    // (24 - 96) / 120: most of the first values are above.
    close(effect, -0.6);
    close(wilcoxon(d.map(() => 0), d).effect, 0.6);
  });

  it('the same test by the normal approximation where differences are tied', () => {
    // Ranks 1.5, 1.5, 3, 4 and 5, all on one side: z^2 = 7.5^2 / (13.75 - 6 / 48).
    const { p, statistic } = wilcoxon([1, 1, 2, 3, 4], [0, 0, 0, 0, 0]);
    assert.equal(statistic, 0);
    close(p, chiSquareAbove(7.5 ** 2 / (13.75 - 6 / 48), 1));
    close(p, 0.0421682, 1e-5);
    assert.deepEqual(wilcoxon([1, 2], [1, 2]), { statistic: 0, p: 1, effect: 0, n: 0 });
  });

  it('the Friedman test of the example in the documentation of scipy.stats.friedmanchisquare', () => {
    const before = [72, 96, 88, 92, 74, 76, 82];
    const after = [120, 120, 132, 120, 101, 96, 112];
    const later = [76, 95, 104, 96, 84, 72, 76];
    const { statistic, p } = friedman(before.map((v, i) => [v, after[i], later[i]]));
    close(statistic, 10.57142857142857);
    close(p, 0.005063414171757498);
  });

  it("Holm's correction as R's p.adjust", () => {
    holm([0.01, 0.04, 0.03, 0.005]).forEach((p, i) => close(p, [0.03, 0.06, 0.06, 0.02][i]));
  });

  it('chi-square tails, ranks, medians and deviations', () => {
    // Quantiles of every table: 5 % above 3.841 with 1 degree of freedom, 5.991 with 2, 18.307 with 10.
    for (const [x, k] of [[3.841458820694124, 1], [5.991464547107979, 2], [18.307038053275146, 10]]) close(chiSquareAbove(x, k), 0.05, 1e-9);
    close(chiSquareAbove(0.01, 3), 0.99973, 1e-5);
    assert.deepEqual(ranks([5, 1, 5, 0]), [3.5, 2, 3.5, 1]);
    assert.equal(median([4, 1, 3, 2]), 2.5);
    close(deviation([2, 4, 4, 4, 5, 5, 7, 9]), Math.sqrt(32 / 7));
  });

  it('a CSV is read as it was written', () => {
    const rows = [{ method: 'pso', reading: 'a, "b"', value: 1.5, seed: 2, fault: '' }];
    assert.deepEqual(parse(write(rows)), rows);
  });
});
