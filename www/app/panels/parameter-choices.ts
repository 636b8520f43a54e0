/** What the parameters of methods from papers can be. The planner tells their defaults only. */

/** The values of parameters that are a choice between words, by parameter. All others are numbers or booleans. */
export const CHOICES: Record<string, string[]> = {
  measure: ['euclidean', 'chebyshev', 'seconds'],
  decode: ['keys', 'order-nearest', 'permutation'],
  draws: ['equation', 'key'],
  kappa: ['swarm', 'particle'],
  flights: ['keys', 'insertion'],
  shortest: ['whole', 'between'],
  step_4: ['merged', 'separate'],
  stagnation: ['chaos', 'step4'],
  regret: ['own', 'printed'],
  initial: ['random', 'proximity'],
  mean_reward: ['sentence', 'printed'],
  next_action: ['chosen', 'best'],
  reversed_run: ['turned', 'order-only'],
  encoding: ['keys', 'permutation'],
  start: ['pfr', 'single', 'each'],
  first: ['free', 'all', 'none'],
  nodes: ['entries', 'element-ends'],
  neighbourhood: ['near', 'all'],
  repartition: ['both', 'partitions', 'sequences'],
  reattach: ['reopened', 'as-it-is'],
  entries: ['all', 'moved'],
  repair: ['inner-forward', 'outer-back'],
};
