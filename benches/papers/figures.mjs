// The figures of docs/papers, drawn with Vega-Lite from the CSV files of the kit in docs/papers/data:
//
//     npm run bench -- papers --figures docs/papers/figures
//
// tests/package/figures.test.mjs checks that the figures in the repository are those of its CSV files.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as vega from 'vega';
import { compile } from 'vega-lite';
import { ROOT } from '../../scripts/tools.mjs';
import { SHEETS } from '../dewil/sheets.mjs';
import { parse } from './csv.mjs';

const DATA = join(ROOT, 'docs', 'papers', 'data');
/** Colours that people with any kind of colour vision can tell apart (Okabe and Ito). */
const COLORS = ['#0072b2', '#d55e00', '#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#000000'];
const SWARMS = ['lpspso', 'pso', 'aco-pso', 'k-pso'];

const read = (...names) =>
  names.map((name) => join(DATA, `${name}.csv`)).filter(existsSync).flatMap((file) => parse(readFileSync(file, 'utf8')));

/** Every figure: its file and its specification; none without data. */
const FIGURES = {
  'qu-du-7': () => convergence('43 contours, fixed start'),
  'qu-du-10': () => convergence('43 contours, random start'),
  'qu-du-2': singer,
  'qu-du-kappa': kappa,
  'hull-10-11': hullConvergence,
  'hull-shares': hullShares,
  'dewil-9': dewilShares,
};

export async function figures(folder) {
  mkdirSync(folder, { recursive: true });
  for (const [name, svg] of Object.entries(await drawn())) {
    writeFileSync(join(folder, `${name}.svg`), svg);
    console.log(join(folder, `${name}.svg`));
  }
}

/** The SVG of every figure whose data are there, by name. */
export async function drawn() {
  const all = {};
  for (const [name, figure] of Object.entries(FIGURES)) {
    const specification = figure();
    if (specification !== null) all[name] = await svg(specification);
  }
  return all;
}

async function svg(specification) {
  const font = 'system-ui, sans-serif';
  const config = {
    background: 'white', font, view: { stroke: null }, range: { category: COLORS },
    axis: { gridColor: '#e5e7eb', domainColor: '#6b7280', tickColor: '#6b7280', labelFontSize: 11, titleFontSize: 12, titleFontWeight: 'normal' },
    legend: { labelFontSize: 12, titleFontSize: 12, labelLimit: 300, symbolStrokeWidth: 3 }, title: { fontSize: 14, anchor: 'start' }, header: { labelFontSize: 12, labelFontWeight: 'bold' },
  };
  const view = new vega.View(vega.parse(compile({ config, ...specification }).spec), { renderer: 'none' });
  try {
    return `${await view.toSVG()}\n`;
  } finally {
    view.finalize();
  }
}

/** The legend shows lines, not the pale areas around them. */
const LINES = { symbolType: 'stroke', symbolOpacity: 1, symbolStrokeWidth: 3 };

/** Lines with the range of all seeds around their means. */
const lines = (values, { y, x = 'iteration', scale = {}, width = 330 }) => ({
  facet: { column: { field: 'panel', title: null, sort: null } },
  spec: {
    width, height: 240,
    layer: [
      { mark: { type: 'area', opacity: 0.15 }, encoding: { y: { field: 'least', type: 'quantitative', scale }, y2: { field: 'most' } } },
      { mark: { type: 'line', strokeWidth: 2 }, encoding: { y: { field: 'mean', type: 'quantitative', title: y, scale } } },
    ],
    encoding: { x: { field: 'round', type: 'quantitative', title: x }, color: { field: 'series', type: 'nominal', title: null, sort: null, legend: LINES } },
  },
  data: { values },
});

const pick = ({ round, mean, least, most }) => ({ round, mean, least, most });

/** Figures 7 and 10 of Qu & Du: the shortest path by iteration, under two readings. */
function convergence(instance) {
  const rows = read('qu-du-fixed-curves', 'qu-du-random-curves').filter((r) => r.instance === instance && r.curve === 'shortest (G)');
  if (rows.length === 0) return null;
  const readings = { 'as-published': 'preset as-published', nearest: 'reading nearest to the print' };
  const values = Object.keys(readings).flatMap((reading) =>
    SWARMS.flatMap((method) => rows.filter((r) => r.method === method && r.reading === reading).map((r) => ({ ...pick(r), series: method, panel: readings[reading] }))));
  const title = { text: `Shortest path by iteration, ${instance}`, subtitle: 'Line: mean of 30 seeds; area: from the best to the worst of them' };
  return { title, description: `Qu and Du, ${instance}: the shortest path of four swarms by iteration`, ...lines(values, { y: 'length, mm (log scale)', scale: { type: 'log', nice: false } }) };
}

/** Figure 2 of Qu & Du: eq. (18) for 600 iterations. */
function singer() {
  const values = [];
  for (let k = 0, x = 0.18; k <= 600; k += 1, x = 1.04 * (7.86 * x - 23.3 * x ** 2 + 28.75 * x ** 3 - 13.3 * x ** 4)) values.push({ iteration: k, x });
  return {
    title: { text: 'The Singer map, eq. (18)', subtitle: 'mu = 1.04, first value 0.18' }, description: 'Values of the Singer map over 600 iterations',
    width: 640, height: 200, data: { values }, mark: { type: 'line', strokeWidth: 0.7 },
    encoding: { x: { field: 'iteration', type: 'quantitative' }, y: { field: 'x', type: 'quantitative', title: 'r2' } },
  };
}

/** Kappa against tau, and how many particles fly, under the two readings of kappa. */
function kappa() {
  const names = { 'spread (κ)': 'kappa', 'threshold (τ)': 'tau', 'share of particles that fly': 'share of particles that fly' };
  const readings = { 'as-published': 'as published: kappa of each particle (mean shown)', 'kappa=swarm': 'kappa of the swarm' };
  const rows = read('qu-du-fixed-curves', 'qu-du-random-curves').filter((r) => r.instance === '43 contours, fixed start' && r.method === 'lpspso' && r.curve in names && r.reading in readings);
  if (rows.length === 0) return null;
  const values = Object.keys(readings).flatMap((reading) => rows.filter((r) => r.reading === reading).map((r) => ({ ...pick(r), series: names[r.curve], panel: readings[reading] })));
  return {
    title: { text: 'Kappa (26) against tau (27), 43 contours, fixed start', subtitle: 'Line: mean of 30 seeds; area: all of them. A particle flies while kappa exceeds tau' },
    description: 'Kappa, tau and the share of flying particles by iteration', ...lines(values, { y: 'value' }),
  };
}

/** Figures 10 and 11 of Liu & Chang. */
function hullConvergence() {
  const rows = read('hull-curves').filter((r) => r.curve === 'shortest empty travel TL');
  if (rows.length === 0) return null;
  const series = (r) => (r.reading === 'as-published' ? r.method : r.reading === 'encoding=permutation' ? `${r.method}, permutation` : null);
  const values = rows.flatMap((r) => (series(r) === null ? [] : [{ ...pick(r), series: series(r), panel: r.instance, encoding: r.reading === 'as-published' ? 'as published' : 'permutation', method: r.method }]));
  const figure = lines(values, { y: 'empty travel, mm (log scale)', x: 'generation', scale: { type: 'log', nice: false } });
  figure.spec.encoding.color = { field: 'method', type: 'nominal', title: null, sort: null, legend: LINES };
  figure.spec.encoding.detail = { field: 'encoding' };
  figure.spec.layer[1].encoding.strokeDash = { field: 'encoding', type: 'nominal', title: 'encoding', sort: null };
  figure.resolve = { scale: { y: 'independent' } };
  return { title: { text: 'Shortest empty travel by generation', subtitle: 'Line: mean of the seeds; area: from the best to the worst of them' }, description: 'Hull parts: shortest empty travel of five methods by generation on two sheets', ...figure };
}

/** Shares of states and of crossovers of RLSGA at the end of a run, under both fitness readings. */
function hullShares() {
  const kinds = { psx: 'PSX', rsx: 'RSX', isx: 'ISX', low: 'div < 0.25', middle: '0.25 to 0.75', high: 'div > 0.75' };
  const readings = { 'as-published': 'unscaled', 'scaled_fitness=true': 'scaled' };
  const rows = read('hull').filter((r) => r.method === 'rlsga' && r.reading in readings);
  if (rows.length === 0) return null;
  const values = Object.entries(kinds).flatMap(([key, part]) =>
    [...new Set(rows.map((r) => r.instance))].flatMap((instance) =>
      Object.entries(readings).map(([reading, label]) => {
        const own = rows.filter((r) => r.instance === instance && r.reading === reading);
        const share = own.reduce((sum, r) => sum + r[key], 0) / own.length;
        return { share, part, order: Object.keys(kinds).indexOf(key), kind: key.endsWith('sx') ? 'crossovers' : 'states', bar: `${instance}, ${label}` };
      })));
  const panel = (kind) => ({
    title: { text: `Share of the ${kind}`, fontSize: 12 }, width: 260, height: { step: 26 }, transform: [{ filter: { field: 'kind', equal: kind } }], mark: 'bar',
    encoding: {
      x: { field: 'share', type: 'quantitative', title: 'share of the generations', scale: { domain: [0, 1] } },
      y: { field: 'bar', type: 'nominal', title: null, sort: null, axis: { labelLimit: 300 } }, color: { field: 'part', type: 'nominal', title: null, sort: null }, order: { field: 'order' },
    },
  });
  return {
    title: { text: 'RLSGA: crossovers chosen, and states of the population', subtitle: 'Fitness unscaled, as printed, or scaled' }, description: 'Shares of the three crossovers and the three states of RLSGA', data: { values },
    hconcat: [panel('crossovers'), panel('states')], resolve: { scale: { color: 'independent' } },
  };
}

/** Figure 9 of Dewil et al.: printed shares of the time (means over the instances) beside our shares of the work. */
function dewilShares() {
  const steps = { construction: 'construction', gtsp: 'GTSP', repartitioning: 'repartitioning', arborescence: 'arborescence', repair: 'repair and entries' };
  const printed = { construction: 0.0047, gtsp: 0.6022, repartitioning: 0.2934, arborescence: 0.0389, repair: 0.0547 };
  const rows = read('dewil').filter((r) => r.method === 'partition-tree' && r.reading === 'as-published');
  if (rows.length === 0) return null;
  const bars = { 'paper, time': null, 'ours, work: set 1': 1, 'set 2': 2, 'set 3': 3 };
  const setOf = Object.fromEntries(SHEETS.map(([name, set]) => [name, set]));
  const values = Object.entries(bars).flatMap(([bar, set]) =>
    Object.entries(steps).map(([key, part]) => {
      const own = rows.filter((r) => setOf[r.instance] === set);
      return { bar, part, order: Object.keys(steps).indexOf(key), share: set === null ? printed[key] : own.reduce((sum, r) => sum + r[key], 0) / own.length };
    }));
  return {
    title: { text: 'Where the partition tree spends its effort', subtitle: 'Printed: share of the time. Ours: share of the moves that are priced' }, description: 'Shares of the steps of the partition-tree framework',
    width: 420, height: { step: 30 }, data: { values }, mark: 'bar',
    encoding: {
      x: { field: 'share', type: 'quantitative', title: 'share', scale: { domain: [0, 1] } }, y: { field: 'bar', type: 'nominal', title: null, sort: null },
      color: { field: 'part', type: 'nominal', title: null, sort: null }, order: { field: 'order' },
    },
  };
}
