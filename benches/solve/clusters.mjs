// GTSPLIB's instances, made from those of TSPLIB by the clustering of Fischetti, Salazar and Toth (Operations Research 45(3), 1997,
// section 6): a fifth as many sets as nodes, around centres that are far from each other. The first centre is the node farthest from the
// first node, each further one is farthest from all centres so far, and each node belongs to the nearest centre. A test makes the sets
// of all stored instances with coordinates again.

import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';
import { RANDOM, random } from './dimacs.mjs';
import { costs, parts } from './tsplib.mjs';

/** Nodes for each set. */
const NODES_OF_A_SET = 5;
const MADE = join(ROOT, 'target', 'bench-data', 'gtsplib-large');
/** Values known of some of them: the search looks for the list beside the instance. */
const KNOWN = join(ROOT, 'benches', 'data', 'gtsplib', 'best_known.json');

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

/** The path of an instance of GTSPLIB, made of the text of one of TSPLIB if it has not been made before. */
function made(name, text) {
  mkdirSync(MADE, { recursive: true });
  copyFileSync(KNOWN, join(MADE, basename(KNOWN)));
  const path = join(MADE, `${name}.gtsp`);
  if (!existsSync(path)) {
    const instance = parts(text());
    writeFileSync(path, generalised(name, instance, clusters(instance)));
  }
  return path;
}

/** One instance: how many nodes and sets it has, and `file`, which makes it and gives its path. */
function described(of, nodes, text) {
  const sets = Math.ceil(nodes / NODES_OF_A_SET);
  const name = `${sets}${of}`;
  return { name, nodes, sets, file: () => made(name, text) };
}

/** The instances of GTSPLIB with at least `least` sets that are made from the files of TSPLIB in a folder, the smallest first. */
export function generalisedFrom(folder, { least, only = '' }) {
  const all = readdirSync(folder).filter((file) => file.endsWith('.tsp')).map((file) => {
    const text = () => readFileSync(join(folder, file), 'latin1');
    return described(basename(file, '.tsp').toLowerCase(), Number(/DIMENSION\s*:\s*(\d+)/.exec(text().slice(0, 2000))?.[1] ?? 0), text);
  });
  return chosen(all, least, only);
}

/** The same of the random instances of DIMACS, which need no files. */
export function generalisedRandom({ least, only = '' }) {
  return chosen(Object.entries(RANDOM).map(([name, [, nodes]]) => described(name, nodes, () => random(name))), least, only);
}

const chosen = (all, least, only) => all.filter(({ sets, name }) => sets >= least && name.includes(only)).sort((a, b) => a.sets - b.sets);
