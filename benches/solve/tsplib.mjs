// Files of the TSPLIB family, read by the definitions of TSPLIB 95 (G. Reinelt) and by no code of the planner: the bench makes instances
// from them, and adds up again the lengths of the tours that solvers give.

import { Stop } from '../../scripts/tools.mjs';

/** The header values and the rows of each section of a file of the TSPLIB family. */
export function parts(text) {
  const header = new Map();
  const sections = new Map();
  let rows;
  for (const line of text.split('\n').map((l) => l.trim())) {
    const name = line.replace(/\s*:$/, '');
    if (name.endsWith('_SECTION')) sections.set(name, (rows = []));
    else if (line === 'EOF') rows = undefined;
    else if (rows !== undefined) rows.push(line);
    else if (line.includes(':')) header.set(line.slice(0, line.indexOf(':')).trim(), line.slice(line.indexOf(':') + 1).trim());
  }
  return { header, sections };
}

/** Costs as TSPLIB 95 defines them. */
const COSTS = {
  EUC_2D: ([ax, ay], [bx, by]) => Math.floor(Math.sqrt((ax - bx) ** 2 + (ay - by) ** 2) + 0.5),
  CEIL_2D: ([ax, ay], [bx, by]) => Math.ceil(Math.sqrt((ax - bx) ** 2 + (ay - by) ** 2)),
  ATT: ([ax, ay], [bx, by]) => Math.ceil(Math.sqrt(((ax - bx) ** 2 + (ay - by) ** 2) / 10)),
  GEO: geographical,
};

function geographical(a, b) {
  const radians = (x) => (3.141592 * (Math.trunc(x) + (5 * (x - Math.trunc(x))) / 3)) / 180;
  const [[p, l], [q, m]] = [a, b].map((node) => node.map(radians));
  const [q1, q2, q3] = [Math.cos(l - m), Math.cos(p - q), Math.cos(p + q)];
  return Math.trunc(6378.388 * Math.acos(0.5 * ((1 + q1) * q2 - (1 - q1) * q3)) + 1);
}

/** The places in a list of the numbers of each row of a matrix: its diagonal and what is to the left or to the right of it, or all. */
const PLACES = {
  FULL_MATRIX: (n) => (a, b) => a * n + b,
  LOWER_DIAG_ROW: () => (a, b) => (Math.max(a, b) * (Math.max(a, b) + 1)) / 2 + Math.min(a, b),
  UPPER_DIAG_ROW: (n) => (a, b) => Math.min(a, b) * n - (Math.min(a, b) * (Math.min(a, b) + 1)) / 2 + Math.max(a, b),
};

const numbers = (rows) => rows.filter(Boolean).flatMap((row) => row.split(/\s+/).map(Number));

/** The number of nodes of an instance and the cost between two of them, which are counted from 0. */
export function costs({ header, sections }) {
  const [count, kind, form] = ['DIMENSION', 'EDGE_WEIGHT_TYPE', 'EDGE_WEIGHT_FORMAT'].map((key) => header.get(key));
  if (kind === 'EXPLICIT' && form in PLACES) {
    const matrix = numbers(sections.get('EDGE_WEIGHT_SECTION'));
    const place = PLACES[form](Number(count));
    return { count: Number(count), cost: (a, b) => matrix[place(a, b)] };
  }
  if (!(kind in COSTS)) throw new Stop(`Costs of the kind ${kind} ${form ?? ''} are not read.`);
  const nodes = sections.get('NODE_COORD_SECTION').filter(Boolean).map((row) => numbers([row]).slice(1, 3));
  return { count: nodes.length, cost: (a, b) => COSTS[kind](nodes[a], nodes[b]) };
}

/** The sets of an instance of GTSPLIB, as node numbers from 1. A set may go on in the next line of the file. */
export function setsOf({ sections }) {
  const sets = [];
  let open = [];
  for (const number of numbers(sections.get('GTSP_SET_SECTION'))) {
    if (number !== -1) {
      open.push(number);
      continue;
    }
    // The number of the set comes first.
    sets.push(open.slice(1));
    open = [];
  }
  return sets;
}

/** The length of a tour, node numbers from 1, that visits every set of an instance of GTSPLIB once; a fault is a sentence of a `Stop`. */
export function lengthOf(instance, tour) {
  const { count, cost } = costs(instance);
  const sets = setsOf(instance);
  const setOf = new Map(sets.flatMap((nodes, set) => nodes.map((node) => [node, set])));
  const visited = new Set();
  for (const node of tour) {
    if (!(node >= 1 && node <= count) || !setOf.has(node)) throw new Stop(`The tour has a node ${node}, which the instance has not.`);
    if (visited.has(setOf.get(node))) throw new Stop(`The tour visits the set of node ${node} twice.`);
    visited.add(setOf.get(node));
  }
  if (visited.size < sets.length) throw new Stop(`The tour visits ${visited.size} of ${sets.length} sets.`);
  return tour.reduce((sum, node, k) => sum + cost(tour.at(k - 1) - 1, node - 1), 0);
}
