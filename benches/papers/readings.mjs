// The readings of each paper that the kit compares: parameters of methods (docs/papers), by name.

const PRESETS = [
  ['as-published', { preset: 'as-published' }],
  ['at-its-best', { preset: 'at-its-best' }],
];

/** All combinations of the values of some parameters, named by them. */
function factorial(base, factors) {
  let cells = [['', base]];
  for (const [name, values] of Object.entries(factors)) {
    // A value may be an object of several parameters; its name is then the factor.
    const given = (value) => (typeof value === 'object' ? value : { [name]: value });
    const text = (value) => Object.entries(given(value)).map(([key, v]) => `${key}=${v}`).join(' ');
    cells = cells.flatMap(([label, parameters]) => values.map((value) => [`${label} ${text(value)}`.trim(), { ...parameters, ...given(value) }]));
  }
  return cells;
}

const SWARMS = ['lpspso', 'pso', 'aco-pso', 'k-pso'];
/** With local search, 60 iterations: 3,000 local searches. */
const LOCAL = ['local search, 60 iterations', { rounds: 60 }];
const HULL = ['rlsga', 'sga', 'hull-pso', 'ofa', 'woa'];

/** For each paper: the readings that every run has, and those that `--readings` adds. A reading is `[method, name, parameters]`. */
export const READINGS = {
  'qu-du': {
    usual: SWARMS.flatMap((method) => [['as-published', PRESETS[0][1]], LOCAL].map(([name, parameters]) => [method, name, parameters])),
    more: [
      ...factorial({ preset: 'as-published' }, {
        decode: ['keys', 'order-nearest', 'permutation'], kappa: ['swarm', 'particle'], c_sum: [2.5, 3.0],
        flights: [{ flights: 'keys' }, { flights: 'insertion', levy_step: 10 }], flights_must_gain: [false, true],
      }).map(([name, parameters]) => ['lpspso', name, parameters]),
      ...SWARMS.slice(1).flatMap((method) =>
        factorial({ preset: 'as-published' }, { decode: ['keys', 'permutation'] }).map(([name, parameters]) => [method, name, parameters])),
    ],
  },
  hull: {
    usual: [
      ['rlsga', 'as-published', PRESETS[0][1]],
      ['rlsga', 'scaled_fitness=true', { scaled_fitness: true }],
      ...HULL.slice(1).map((method) => [method, 'as-published', PRESETS[0][1]]),
    ],
    more: [['rlsga', 'scaled_fitness=false mean_reward=printed', { scaled_fitness: false, mean_reward: 'printed' }]],
  },
  yang: {
    usual: PRESETS.map(([name, parameters]) => ['dual-coding-ga', name, parameters]),
    more: [],
  },
  dewil: {
    usual: [
      ['pfr', 'as-published', {}],
      ['gtsp-lk', 'as-published', {}],
      ['partition-tree', 'PFr-I', { stall: 0 }],
      ['partition-tree', 'as-published', {}],
    ],
    more: [
      ['partition-tree', 'start=each', { start: 'each' }],
      ['partition-tree', 'start=single', { start: 'single' }],
    ],
  },
};
