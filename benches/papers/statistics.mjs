// Statistics of runs of methods: summaries, the Wilcoxon signed-rank test with Holm's correction, effect sizes and
// Friedman ranks. Checked against published values of scipy and R in tests/package/statistics.test.mjs.

/** Pairs up to this number are tested exactly; 2^50 sign patterns are counted, not enumerated. As in scipy. */
const EXACT = 50;

export const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

/** Standard deviation of a sample. */
export function deviation(values) {
  if (values.length < 2) return 0;
  const m = mean(values);
  return Math.sqrt(values.reduce((sum, v) => sum + (v - m) ** 2, 0) / (values.length - 1));
}

/** Ranks from 1; equal values share the mean of their ranks. */
export function ranks(values) {
  const order = values.map((_, i) => i).sort((a, b) => values[a] - values[b]);
  const result = Array(values.length);
  for (let from = 0; from < order.length; ) {
    let to = from;
    while (to + 1 < order.length && values[order[to + 1]] === values[order[from]]) to += 1;
    for (let k = from; k <= to; k += 1) result[order[k]] = (from + to) / 2 + 1;
    from = to + 1;
  }
  return result;
}

/**
 * The two-sided Wilcoxon signed-rank test of paired values. Pairs without a difference are left out. Exact without ties and up
 * to 50 pairs, otherwise by the normal approximation with its correction for ties. `effect` is the matched-pairs rank-biserial
 * correlation: 1 when every `a` is below its `b`, -1 when every one is above.
 */
export function wilcoxon(a, b) {
  const differences = a.map((v, i) => v - b[i]).filter((d) => d !== 0);
  const n = differences.length;
  if (n === 0) return { statistic: 0, p: 1, effect: 0, n };
  const rank = ranks(differences.map(Math.abs));
  const above = rank.reduce((sum, r, i) => sum + (differences[i] > 0 ? r : 0), 0);
  const all = (n * (n + 1)) / 2;
  const statistic = Math.min(above, all - above);
  const tied = rank.some((r) => !Number.isInteger(r)) || new Set(rank).size < n;
  const p = tied || n > EXACT ? approximate(statistic, rank, n) : exact(statistic, n);
  return { statistic, p, effect: (all - 2 * above) / all, n };
}

function exact(statistic, n) {
  const all = (n * (n + 1)) / 2;
  // Number of sign patterns with each sum of ranks, as a share of all patterns.
  const share = new Float64Array(all + 1);
  share[0] = 1;
  for (let rank = 1; rank <= n; rank += 1) {
    for (let sum = all; sum >= 0; sum -= 1) share[sum] = (share[sum] + (sum >= rank ? share[sum - rank] : 0)) / 2;
  }
  return Math.min(1, 2 * share.subarray(0, statistic + 1).reduce((sum, v) => sum + v, 0));
}

function approximate(statistic, rank, n) {
  const counts = new Map();
  for (const r of rank) counts.set(r, (counts.get(r) ?? 0) + 1);
  const ties = [...counts.values()].reduce((sum, t) => sum + t ** 3 - t, 0);
  const spread = Math.sqrt((n * (n + 1) * (2 * n + 1)) / 24 - ties / 48);
  return chiSquareAbove(((statistic - (n * (n + 1)) / 4) / spread) ** 2, 1);
}

/** Holm's correction of p-values for so many tests, in their order. */
export function holm(values) {
  const order = values.map((_, i) => i).sort((a, b) => values[a] - values[b]);
  const result = Array(values.length);
  let least = 0;
  order.forEach((i, place) => {
    least = Math.max(least, Math.min(1, (values.length - place) * values[i]));
    result[i] = least;
  });
  return result;
}

/** Friedman's test. `blocks` has a row for each instance, with a value for each method; less is better. */
export function friedman(blocks) {
  const [n, k] = [blocks.length, blocks[0].length];
  const rows = blocks.map(ranks);
  const sums = Array.from({ length: k }, (_, j) => rows.reduce((sum, row) => sum + row[j], 0));
  const ties = rows.reduce((sum, row) => {
    const counts = new Map();
    for (const r of row) counts.set(r, (counts.get(r) ?? 0) + 1);
    return sum + [...counts.values()].reduce((s, t) => s + t ** 3 - t, 0);
  }, 0);
  const plain = (12 / (n * k * (k + 1))) * sums.reduce((sum, s) => sum + s * s, 0) - 3 * n * (k + 1);
  const correction = 1 - ties / (n * (k ** 3 - k));
  const statistic = correction > 0 ? plain / correction : 0;
  return { ranks: sums.map((s) => s / n), statistic, p: chiSquareAbove(statistic, k - 1) };
}

/** The probability that a chi-square number exceeds x: the upper incomplete gamma function Q(k / 2, x / 2), regularized. */
export function chiSquareAbove(x, degrees) {
  if (x <= 0) return 1;
  const [a, z] = [degrees / 2, x / 2];
  const front = Math.exp(a * Math.log(z) - z - logGamma(a));
  if (z < a + 1) {
    // The series of the lower function.
    let [term, sum] = [1 / a, 1 / a];
    for (let n = 1; term > sum * 1e-16; n += 1) sum += term *= z / (a + n);
    return Math.max(0, 1 - front * sum);
  }
  // The continued fraction of the upper one, by Lentz's algorithm.
  let b = z + 1 - a;
  let [c, d] = [1e300, 1 / b];
  let h = d;
  for (let i = 1; i < 1000; i += 1) {
    const an = -i * (i - a);
    b += 2;
    d = 1 / (an * d + b);
    c = b + an / c;
    h *= d * c;
    if (Math.abs(d * c - 1) < 1e-15) break;
  }
  return front * h;
}

/** ln Gamma of a positive whole or half number. */
function logGamma(x) {
  let [value, at] = x % 1 === 0 ? [0, 1] : [Math.log(Math.PI) / 2, 0.5];
  for (; at < x; at += 1) value += Math.log(at);
  return value;
}
