// The curves of several runs as one: at each round the mean, the least and the largest value over the runs.

/** `traces`: for each run the names of its curves, its rounds, and the values by round and curve. One point for every so many rounds. */
export function curves(traces, every = 1) {
  const kept = traces.filter((t) => t !== null && t.rounds.length > 0);
  if (kept.length === 0) return [];
  const rounds = thinned([...new Set(kept.flatMap((t) => t.rounds))].sort((a, b) => a - b), every);
  // Runs report at slightly different rounds; each keeps its last value until its next.
  const at = kept.map(() => 0);
  return rounds.flatMap((round) => {
    kept.forEach((t, k) => {
      while (at[k] + 1 < t.rounds.length && t.rounds[at[k] + 1] <= round) at[k] += 1;
    });
    return kept[0].names.map((curve, c) => {
      const values = kept.map((t, k) => t.values[at[k]][c]);
      return { round, curve, mean: short(values.reduce((sum, v) => sum + v, 0) / values.length), least: short(Math.min(...values)), most: short(Math.max(...values)) };
    });
  });
}

/** The first of the rounds in each stretch of so many, and the last of all. */
export function thinned(rounds, every) {
  let next = 0;
  return rounds.filter((round, k) => {
    if (round < next && k + 1 < rounds.length) return false;
    next = (Math.floor(round / every) + 1) * every;
    return true;
  });
}

/** Six significant digits are more than a figure shows. */
const short = (value) => Number(value.toPrecision(6));
