// GTSPLIB's instances, made from those of TSPLIB by the clustering of Fischetti, Salazar and Toth (Operations Research 45(3), 1997,
// section 6): a fifth as many sets as nodes, around centres that are far from each other. The first centre is the node farthest from the
// first node, each further one is farthest from all centres so far, and each node belongs to the nearest centre. A test makes the sets
// of all stored instances with coordinates again.

import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { ROOT, Stop } from '../../scripts/tools.mjs';

/** Nodes for each set. */
const NODES_OF_A_SET = 5;
const MADE = join(ROOT, 'target', 'bench-data', 'gtsplib-large');
/** Values known of some of them: the search looks for the list beside the instance. */
const KNOWN = join(ROOT, 'benches', 'data', 'gtsplib', 'best_known.json');

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

/** The number of nodes of an instance and the cost between two of them, which are counted from 0. */
function costs({ header, sections }) {
  const [count, kind, form] = ['DIMENSION', 'EDGE_WEIGHT_TYPE', 'EDGE_WEIGHT_FORMAT'].map((key) => header.get(key));
  const numbers = (rows) => rows.flatMap((row) => row.split(/\s+/).map(Number));
  if (kind === 'EXPLICIT' && form in PLACES) {
    const matrix = numbers(sections.get('EDGE_WEIGHT_SECTION'));
    const place = PLACES[form](Number(count));
    return { count: Number(count), cost: (a, b) => matrix[place(a, b)] };
  }
  if (!(kind in COSTS)) throw new Stop(`Costs of the kind ${kind} ${form ?? ''} are not read.`);
  const nodes = sections.get('NODE_COORD_SECTION').filter(Boolean).map((row) => numbers([row]).slice(1, 3));
  return { count: nodes.length, cost: (a, b) => COSTS[kind](nodes[a], nodes[b]) };
}

/** The sets of GTSPLIB for the nodes of an instance: lists of nodes, which are counted from 0, by their centres. */
export function clusters(instance) {
  const { count, cost } = costs(instance);
  const nearest = new Int32Array(count);
  let apart = Float64Array.from({ length: count }, (_, node) => cost(0, node));
  const farthest = () => apart.reduce((best, far, node) => (far > apart[best] ? node : best), 0);
  const sets = [];
  let centre = farthest();
  apart = new Float64Array(count).fill(Infinity);
  while (sets.length < Math.ceil(count / NODES_OF_A_SET)) {
    for (let node = 0; node < count; node++) {
      const far = cost(node, centre);
      if (far < apart[node]) [apart[node], nearest[node]] = [far, sets.length];
    }
    sets.push([]);
    centre = farthest();
  }
  nearest.forEach((set, node) => sets[set].push(node));
  return sets;
}

/** The instance of GTSPLIB that is made of one of TSPLIB. */
function generalised(name, instance, sets) {
  const keys = ['DIMENSION', 'EDGE_WEIGHT_TYPE', 'EDGE_WEIGHT_FORMAT'].filter((key) => instance.header.has(key));
  const sections = ['NODE_COORD_SECTION', 'EDGE_WEIGHT_SECTION'].filter((key) => instance.sections.has(key));
  return [
    `NAME: ${name}`, 'TYPE: GTSP', ...keys.map((key) => `${key}: ${instance.header.get(key)}`), `GTSP_SETS: ${sets.length}`,
    ...sections.flatMap((key) => [key, ...instance.sections.get(key).filter(Boolean)]),
    'GTSP_SET_SECTION', ...sets.map((set, k) => [k + 1, ...set.map((node) => node + 1), -1].join(' ')), 'EOF', '',
  ].join('\n');
}

/** The instances of GTSPLIB with at least `least` sets, made from the files of TSPLIB in a folder, the smallest first: paths of files. */
export function generalisedFrom(folder, { least, only = '' }) {
  mkdirSync(MADE, { recursive: true });
  copyFileSync(KNOWN, join(MADE, basename(KNOWN)));
  const found = readdirSync(folder).filter((file) => file.endsWith('.tsp')).map((file) => {
    const path = join(folder, file);
    const count = Number(/DIMENSION\s*:\s*(\d+)/.exec(readFileSync(path, 'latin1').slice(0, 2000))?.[1] ?? 0);
    return { path, sets: Math.ceil(count / NODES_OF_A_SET), name: `${Math.ceil(count / NODES_OF_A_SET)}${basename(file, '.tsp').toLowerCase()}` };
  });
  const chosen = found.filter(({ sets, name }) => sets >= least && name.includes(only)).sort((a, b) => a.sets - b.sets);
  return chosen.map(({ path, name }) => {
    const made = join(MADE, `${name}.gtsp`);
    if (!existsSync(made)) {
      const instance = parts(readFileSync(path, 'latin1'));
      writeFileSync(made, generalised(name, instance, clusters(instance)));
    }
    return made;
  });
}
