// Stands for the program LKH in tests: reads its parameter file, solves the asymmetric TSP exactly by dynamic programming over subsets
// (M. Held and R. Karp, 1962), and writes the tour file, with the cost of the tour in its comment.

import { readFileSync, writeFileSync } from 'node:fs';

const parameters = new Map(readFileSync(process.argv[2], 'utf8').split('\n').filter(Boolean).map((line) => line.split(' = ')));
const [head, rows] = readFileSync(parameters.get('PROBLEM_FILE'), 'utf8').split('EDGE_WEIGHT_SECTION\n');
const costs = rows.split('\n').slice(0, -2).map((row) => row.split(' ').map(Number));
const n = costs.length;
if (!head.includes('TYPE: ATSP\n') || !head.includes(`DIMENSION: ${n}\n`)) throw new Error(head);

// By set of nodes and last node, from node 0: the least cost, and the node before.
const least = Array.from({ length: 1 << n }, () => new Float64Array(n).fill(Infinity));
const before = Array.from({ length: 1 << n }, () => new Int8Array(n));
least[1][0] = 0;
for (let set = 1; set < 1 << n; set++) {
  for (let last = 0; last < n; last++) {
    for (let next = 0; next < n && least[set][last] < Infinity; next++) {
      const [with_, cost] = [set | (1 << next), least[set][last] + costs[last][next]];
      if (with_ !== set && cost < least[with_][next]) [least[with_][next], before[with_][next]] = [cost, last];
    }
  }
}
const all = (1 << n) - 1;
const closed = [...least[all]].map((cost, last) => cost + costs[last][0]);
const tour = [];
for (let set = all, last = closed.indexOf(Math.min(...closed)); set !== 0; ) {
  tour.unshift(last + 1);
  [set, last] = [set & ~(1 << last), before[set][last]];
}
const text = ['NAME : exact', 'TYPE : TOUR', `DIMENSION : ${n}`, 'TOUR_SECTION', ...tour, '-1', 'EOF', ''].join('\n');
writeFileSync(parameters.get('TOUR_FILE'), text);
if (process.env.EXACT_COSTS) writeFileSync(process.env.EXACT_COSTS, String(Math.min(...closed)));
