// Seconds of whole jobs: what the search and each lever of docs/levers.md save against the nearest-next path with holes first on
// the same preset without levers:
//
//     npm run bench -- whole-job [drawings|sheets|nests|pierced|kerfed|bordered|plates|tips|heat|joint]... [--moves N] [--seconds S] [--seeds K] [--preset NAME] [--only NAME] [--data FOLDER]
//
// `tips` is the table of docs/tips.md: what avoiding tipped pieces costs on the four sheets, against lifting the head for every move.
// `heat` is that of docs/heat.md: what keeping cuts apart costs, against a path that was found without it and waits afterwards.
// `joint` compares the search that knows leads, or pieces that tip, with "plan, then attach leads" and "plan, then avoid or lift", with as much processor
// time each: `--seconds` a search on sheets (default 5), a fifth of that on nests, `--seeds` of them (default 5).
// Drawings are those of tests/fixtures/dxf-dev, and of `FOLDER/dxf-dev` with `--data FOLDER`; sheets are those of benches/data;
// nests are parts side by side, with a hole each, `pierced` are the same in plate whose piercing takes 3 s, `kerfed` are nests one kerf of 0.3 mm apart on machines with that kerf, and `bordered` are nests whose sheet is
// drawn 10 mm around them; plates are perforated ones that benches/solve/grids.mjs draws. Budgets are in moves, so the figures do not depend on the
// machine's load. Every plan is checked.

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { parseArgs } from 'node:util';
import { ROOT, run, Stop } from '../scripts/tools.mjs';
import { Instances } from './common/data.mjs';
import { drawings } from './common/drawings.mjs';
import { drawing, polyline } from './common/dxf.mjs';
import { mean, median, rows, table } from './common/table.mjs';
import { drawn } from './solve/grids.mjs';

const HERE = join(ROOT, 'benches', 'solve');
const NATIVE = join(HERE, 'target', 'release', 'whole_job');
const JOINT = join(HERE, 'target', 'release', 'joint');
/** Number of seeded nests. */
const NESTS = 20;
/** Cuts through waste of any length: the search takes those that are quicker than what they stand for. */
const CHAINS = { levers: { chains: { reach: 100 } } };
/** The same, also from elsewhere on the kerf of the last contour. */
const EDGES = { levers: { chains: { reach: 100, edge_starts: true } } };
/** Strips of any length between parts, which a person separates, or which are cut later. */
const BRIDGES = { width: 2, reach: 100 };
const BRIDGED = { bridges: { levers: { bridges: BRIDGES } }, 'bridges, cut later': { levers: { bridges: { ...BRIDGES, cut_later: true } } } };
/** What shares cuts is pierced once. */
const SHARED = { levers: { common_cuts: {} } };
/** mm: what a fibre laser cuts in thick plate. */
const KERF = 0.3;
/** What all machines of a set have. */
const MACHINES = { kerfed: { kerf_width: KERF }, pierced: { pierce_time: 3 } };
/** What each lever sets, by machine. */
const LEVERS = {
  // 1 mm sheet is through after some milliseconds: at this acceleration within half a millimetre.
  'fibre-3kw-thin': { 'moving pierce': { levers: { moving_pierce: { overcut: 0.5 } } }, fly: { levers: { fly: { reach: 20, overcut: 0.5 } } }, chains: CHAINS, 'chains, edge starts': EDGES, ...BRIDGED, 'common cuts': SHARED },
  // Acrylic is cut at a speed at which the beam is through at once.
  'co2-100w': { 'moving pierce': { levers: { moving_pierce: { overcut: 1 } } }, fly: { levers: { fly: { reach: 20, overcut: 1 } } }, chains: CHAINS, 'chains, edge starts': EDGES, ...BRIDGED, 'common cuts': SHARED },
  // No piercing and no delays: nothing to save.
  'diode-hobby': {},
  // Plate is pierced at rest.
  'fibre-6kw-thick': { chains: CHAINS, 'chains, edge starts': EDGES, ...BRIDGED, 'common cuts': SHARED },
};
/** Levers that a machine has not together with the others: what begins moving is not pierced, so that chains have nothing to save, and connected parts
 * are not cut on the run. */
const APART = { 'fibre-6kw-thick': ['chains', ...Object.keys(BRIDGED)], 'fibre-3kw-thin': ['chains', 'chains, edge starts', ...Object.keys(BRIDGED)], 'co2-100w': ['chains', 'chains, edge starts', ...Object.keys(BRIDGED)] };
const PLATES = [['round', 20], ['round', 100], ['staggered', 20], ['slots', 20]];
/** Tables of one machine each. */
const TABLES = { tips, heat, joint };
const nests = ({ only = '' }) => [['rectangles', 10], ['discs', 10]].filter(([name, side]) => `${name}_${side * side}`.includes(only)).map(([name, side]) => nest(name, side));
const SETS = {
  drawings: ({ data, only }) => drawings([join(ROOT, 'tests', 'fixtures', 'dxf-dev'), ...(data ? [join(data, 'dxf-dev')] : [])], only),
  sheets: ({ instances, only = '' }) => [100, 500, 2000].map((n) => `sheets/sheet_${n}.dxf`).filter((f) => f.includes(only)).map((f) => instances.file(f)),
  nests,
  pierced: nests,
  kerfed: ({ only = '' }) => [['rectangles', 4], ['rectangles', 10]].filter(([name, side]) => `${name}_${side * side}`.includes(only)).map(([name, side]) => nest(name, side, KERF)),
  bordered: ({ only = '' }) => [['rectangles', 4], ['rectangles', 10]].filter(([name, side]) => `${name}_${side * side}`.includes(only)).map(([name, side]) => nest(name, side, 8, 10)),
  plates: ({ only = '' }) => PLATES.filter(([name, side]) => `${name}_${side * side}`.includes(only)).map(([name, side]) => drawn(name, side)),
};

export async function bench(args) {
  const { values, positionals } = parseArgs({
    args,
    allowPositionals: true,
    options: { moves: { type: 'string' }, seconds: { type: 'string' }, seeds: { type: 'string' }, preset: { type: 'string' }, only: { type: 'string' }, data: { type: 'string' } },
  });
  const unknown = positionals.find((name) => !(name in SETS) && !(name in TABLES));
  if (unknown !== undefined) throw new Stop(`There is no set ${unknown}: ${[...Object.keys(SETS), ...Object.keys(TABLES)].join(', ')}.`);
  console.log('bench: the planner, natively');
  run('cargo', ['build', '--release', '--manifest-path', join(HERE, 'Cargo.toml'), '--bin', 'whole_job', '--bin', 'joint']);
  const { moves = '1000000', preset: only } = values;
  const options = { ...values, instances: new Instances(values.data) };
  const presets = Object.keys(LEVERS).filter((name) => only === undefined || name === only);
  for (const name of positionals.length > 0 ? positionals : Object.keys(SETS)) {
    if (name in TABLES) {
      TABLES[name](options, only ?? 'fibre-3kw-thin', moves);
      continue;
    }
    const files = SETS[name](options);
    for (const preset of presets) whole(name, preset, files, moves);
    if (['plates', 'nests', 'pierced', 'kerfed', 'bordered'].includes(name)) for (const file of files) rmSync(dirname(file), { recursive: true });
  }
}

/** Parts side by side, `gap` mm apart, in a sheet that ends `border` mm around them if it is drawn, each with a hole of 12 mm: rectangles of 60 x 40 mm, or discs of 50 mm. */
function nest(name, side, gap = 8, border = 0) {
  const [width, height] = name === 'discs' ? [50, 50] : [60, 40];
  const round = (x, y, radius) => ['0', 'CIRCLE', '8', 'CUT', '10', x, '20', y, '40', radius];
  const entities = [];
  for (let k = 0; k < side * side; k += 1) {
    const [x, y] = [10 + (width + gap) * (k % side), 10 + (height + gap) * Math.floor(k / side)];
    const corners = [[0, 0], [width, 0], [width, height], [0, height]].map(([dx, dy]) => [x + dx, y + dy, 0]);
    entities.push(...(name === 'discs' ? round(x + 25, y + 25, 25) : polyline(corners)), ...round(x + width / 2, y + height / 2, 6));
  }
  if (border > 0) {
    const [low, right, top] = [10 - border, 10 - gap + border + (width + gap) * side, 10 - gap + border + (height + gap) * side];
    entities.push(...polyline([[low, low, 0], [right, low, 0], [right, top, 0], [low, top, 0]], true, 'SHEET'));
  }
  const file = join(mkdtempSync(join(tmpdir(), 'kerfway-')), `${name}_${side * side}.dxf`);
  writeFileSync(file, drawing(entities));
  return file;
}

/** One table: a row for each drawing, and a column for each lever alone and for all of them. */
function whole(set, preset, files, moves) {
  const levers = LEVERS[preset];
  const names = Object.keys(levers);
  const together = names.filter((name) => !(APART[preset] ?? []).includes(name));
  const all = { levers: Object.assign({}, ...together.map((name) => levers[name].levers)) };
  const variants = [['search', {}], ...names.map((name) => [name, levers[name]]), ...(together.length > 1 ? [[together.length < names.length ? together.join(' and ') : 'all', all]] : [])];
  const machines = JSON.stringify(variants.map(([, changes]) => ({ preset, base: MACHINES[set], set: changes })));
  const saved = variants.map(() => []);
  const lines = [];
  for (const file of files) {
    let found;
    try {
      found = rows(NATIVE, [file, '--machines', machines, '--moves', moves]);
    } catch (e) {
      console.log(`${basename(file)} is left out: ${e.message.trim().split('\n').at(-1)}`);
      continue;
    }
    if (found[0].nearest_next <= 0) continue;
    const [{ nearest_next: nearest, contours, air, pierce, total }] = found;
    const share = (part) => `${((100 * part) / total).toFixed(0)} %`;
    const less = found.map((row) => (100 * (nearest - row.total)) / nearest);
    less.forEach((value, k) => saved[k].push(value));
    lines.push([basename(file), String(contours), nearest.toFixed(1), share(air), share(pierce), ...less.map((v) => `${v.toFixed(1)} %`)]);
  }
  const medians = saved.map((values) => (values.length > 0 ? `${median(values).toFixed(1)} %` : ''));
  lines.push(['median', '', '', '', '', ...medians]);
  const columns = ['', 'contours', 'nearest next, s', 'air', 'piercing', ...variants.map(([name]) => name)];
  table(`${preset}, ${set}: whole-job seconds less than nearest-next with holes first, ${moves} moves`, columns, lines);
}

/** Ways to get past pieces that may have tipped: what is set, and what the path is then run on. */
function pastTips(at_rest) {
  const lift = { height: 10, at_rest };
  const down = { levers: { tips: { risky_moves: 'ignore' } } };
  const avoid = { z_speed: 100, levers: { lift, tips: {} } };
  return [
    ['head down, ignored', { set: down }],
    ['avoided afterwards', { set: down, then: avoid }],
    ['avoided', { set: avoid }],
    ['always lifted', { set: { z_speed: 100, levers: { lift } } }],
  ];
}

/** Seconds of the four sheets with pieces below 150 mm tipping and those below 50 mm dropping, by what is done about moves over them. */
function tips({ instances, only = '' }, preset, moves) {
  for (const atRest of [false, true]) {
    const ways = pastTips(atRest);
    const machines = JSON.stringify(ways.map(([, changes]) => ({ preset, ...changes })));
    const files = fourSheets(instances, only);
    const lines = files.map((file) => {
      const found = rows(NATIVE, [file, '--machines', machines, '--moves', moves]);
      const cell = ({ total, lifts, detours, crossings }) => `${total.toFixed(1)} s, ${lifts} lifts, ${detours} around, ${crossings} risky`;
      return [basename(file), ...found.map(cell)];
    });
    table(`${preset}, lifted ${atRest ? 'at rest' : 'on the way'} by 10 mm at 100 mm/s, ${moves} moves`, ['', ...ways.map(([name]) => name)], lines);
  }
}

/** Seconds of the four sheets with cuts kept apart by heat, and what is left of that by a path that knows nothing of it. */
function heat({ instances, only = '' }, preset, moves) {
  const minds = (rule) => ({ levers: { heat: { distance: 20, seconds: 5, ...rule } } });
  const ways = [
    ['nothing asked', { set: minds({ charge: 0 }) }],
    ['waiting afterwards', { set: {}, then: minds({}) }],
    ['waiting', { set: minds({}) }],
    ['a charge of 1 s', { set: minds({ charge: 1 }) }],
    ['a charge of 0.05 s', { set: minds({ charge: 0.05 }) }],
  ];
  const machines = JSON.stringify(ways.map(([, changes]) => ({ preset, ...changes })));
  const lines = fourSheets(instances, only).map((file) => {
    const cell = ({ total, waits, wait_time, hot_pairs }) => `${total.toFixed(1)} s, ${waits} waits of ${wait_time.toFixed(1)} s, ${hot_pairs} pairs`;
    return [basename(file), ...rows(NATIVE, [file, '--machines', machines, '--moves', moves]).map(cell)];
  });
  table(`${preset}, cuts nearer than 20 mm 5 s apart, ${moves} moves`, ['', ...ways.map(([name]) => name)], lines);
}

/** What deciding together saves against one thing after the other, on the four sheets and on nests. */
function joint({ instances, only = '', seconds = '5', seeds = '5' }) {
  const nests = 'nests'.includes(only) ? Array.from({ length: NESTS }, (_, k) => `nest:${k}`) : [];
  const run = (names, s) => (names.length > 0 ? rows(JOINT, [...names, '--seconds', String(s), '--seeds', seeds]) : []);
  const all = [...fourSheets(instances, only).flatMap((file) => run([file], Number(seconds))), ...run(nests, Number(seconds) / 5)];
  const names = [...new Set(all.map((row) => basename(row.name)).map((name) => (name.startsWith('nest:') ? `${NESTS} nests` : name)))];
  const of = (name, what) => all.filter((row) => row.table === what && (row.name.startsWith('nest:') ? `${NESTS} nests` : basename(row.name)) === name);
  const saved = (found, key) => {
    const less = found.map((row) => row[key] - row.joint);
    return [`${mean(less).toFixed(3)} s`, `${Math.min(...less).toFixed(3)} s`, String(less.filter((s) => s < -1e-6).length)];
  };
  const total = (found) => `${mean(found.map((row) => row.joint)).toFixed(1)} s`;
  const lines = (what, ...keys) => names.map((name) => [name, String(of(name, what).length), total(of(name, what)), ...keys.flatMap((key) => saved(of(name, what), key))]);
  const columns = (...keys) => ['', 'searches', 'together', ...keys.flatMap((key) => [`less than ${key}`, 'least', 'slower'])];
  table(`fibre-3kw-thin, arcs of 1.5 mm as leads: together against attached afterwards, ${seconds} s of processor time`, columns('attached'), lines('leads', 'afterwards'));
  table(`fibre-3kw-thin, pieces that tip: together against avoided afterwards, and always lifted, ${seconds} s of processor time`, columns('avoided', 'lifted'), lines('tips', 'afterwards', 'lifted'));
  const rate = (found, key) => mean(found.map((row) => row[key]));
  const speed = (name) => {
    const found = of(name, 'leads');
    return [name, `${(rate(found, 'moves_off') / 1e6).toFixed(2)} M/s`, `${(rate(found, 'moves_on') / 1e6).toFixed(2)} M/s`, `${(100 * rate(found, 'rate')).toFixed(0)} %`];
  };
  table('Moves per second of processor time, with all options off and with leads', ['', 'off', 'with leads', 'share'], names.map(speed));
}

/** The sheets with 100 to 10,000 contours whose names hold `only`. */
function fourSheets(instances, only) {
  return [100, 500, 2000, 10000].map((n) => `sheets/sheet_${n}.dxf`).filter((f) => f.includes(only)).map((f) => instances.file(f));
}
