// Tables 1, 2 and 3 of Dewil et al. (2014), in form, on sheets made by their description:
//
//     npm run bench -- dewil [--table N]... [--only INSTANCE]... [--seeds K] [--machine plate|corners]
//
// Table 4 is ours: on set 3, pierce groups that may and that must not be left, with the paths of the exact and beam search
// and with those of the paper's element insertion. Table 5 is ours too: set 3 as it is, with larger parts, and with larger
// parts close together. The machine `corners` pauses in sharp corners.
//
// Seconds are those of air moves, piercings and pre-cuts, for the paper's plate and ours; cutting is left out, as there.
// Printed values are of other sheets and another machine: only improvements over PFr compare. Every path of ours passes the
// checker. The methods of the paper have its nodes, the ends of elements. In table 1 `tour-tree` works for as many seconds of
// the processor as F-R takes on our entries, both begun with the same problem in hand, and no longer; where F-R is at its end
// after some milliseconds, both are run up to 25 times in turn, and the median counts. Beside that it works for a second at
// least.

import { mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { setup } from '../scripts/setup.mjs';
import { ROOT, run, Stop } from '../scripts/tools.mjs';
import { mean, table } from './common/table.mjs';
import { parallel } from './papers/parallel.mjs';
import { OURS } from './papers/readings.mjs';
import { native } from './papers/runs.mjs';
import { MACHINES } from './dewil/machine.mjs';
import { PRINTED } from './dewil/printed.mjs';
import { dxf, SHEETS } from './dewil/sheets.mjs';

const PUBLISHED = { preset: 'as-published' };
const tree = (name, parameters = {}) => ({ name, method: 'partition-tree', parameters: { ...PUBLISHED, ...parameters } });
const PFR = { name: 'PFr', method: 'pfr', parameters: PUBLISHED };
const GTSP = { name: 'GTSP', method: 'gtsp-lk', parameters: PUBLISHED };
// How the paths through pierce groups are found, and whether groups may be left.
const VARIANTS = [
  { suffix: '' },
  { suffix: ', whole', whole: true },
  { suffix: ', insertion', common_cuts: 'insertion' },
  { suffix: ', insertion, whole', common_cuts: 'insertion', whole: true },
];
/** Variants of set 3: parts some times as large, and blocks of them as close together as the parts of set 2 or closer. */
const LAYOUTS = [{ scale: 1 }, { scale: 3 }, { scale: 3, gap: [5, 5] }, { scale: 8, gap: [5, 5] }];
const TABLES = {
  1: [
    PFR,
    GTSP,
    // By the text of table 1. Its numbers are those of C-FR in table 3.
    tree('PFr-I', { stall: 0 }),
    tree('F-R'),
    OURS,
    { name: 'tour-tree', method: 'tour-tree', as_long_as: OURS.name },
    { name: 'tour-tree, 1 s', method: 'tour-tree', as_long_as: OURS.name, seconds: 1 },
  ],
  2: [PFR, tree('from PFr'), tree('from SP', { start: 'each' }), tree('from GTSP', { start: 'single' })],
  3: [
    PFR,
    tree('C-FR', { stall: 0, first: 'none' }),
    tree('C-MP', { stall: 0, first: 'none', repartition: 'partitions' }),
    tree('C-MSP', { stall: 0, first: 'none', repartition: 'sequences' }),
    tree('C-LKH-FR', { stall: 0 }),
  ],
  4: VARIANTS.flatMap(({ suffix, ...variant }) =>
    [
      PFR,
      GTSP,
      tree('F-R'),
      { name: 'tour-tree', method: 'tour-tree', as_long_as: 'F-R', seconds: 1 },
    ].map((run) => ({
      ...run,
      ...variant,
      name: run.name + suffix,
      ...(run.as_long_as === undefined ? {} : { as_long_as: run.as_long_as + suffix }),
    })),
  ),
  5: [
    PFR,
    GTSP,
    tree('F-R'),
    { name: 'tour-tree', method: 'tour-tree', as_long_as: 'F-R', seconds: 1 },
  ],
};
// Where two methods end within a tenth of a per cent of each other, one seed says little: the mean of so many.
const SEEDS = 5;
const FORMS = { 1: first, 2: second, 3: third, 4: fourth };
const STORED = join(ROOT, 'benches', 'dewil', 'sheets');
const MADE = join(ROOT, 'target', 'bench-data', 'dewil');

export async function bench(args) {
  const list = { type: 'string', multiple: true };
  const text = { type: 'string' };
  const { values } = parseArgs({ args, options: { table: list, only: list, seeds: text, machine: text } });
  const machine = MACHINES[values.machine ?? 'plate'];
  if (machine === undefined) throw new Stop(`There is no machine ${values.machine}: ${Object.keys(MACHINES).join(', ')}.`);
  const tables = values.table ?? Object.keys(TABLES);
  const wrong = tables.find((t) => !(t in TABLES));
  if (wrong !== undefined) throw new Stop(`There is no table ${wrong}: ${Object.keys(TABLES).join(', ')}.`);
  const sheets = SHEETS.filter(([name]) => values.only === undefined || values.only.includes(name));
  if (sheets.length === 0) throw new Stop(`No such sheet: ${values.only}.`);
  await setup();
  console.log('bench: the partition-tree, natively');
  run('cargo', ['build', '--release', '--manifest-path', join(ROOT, 'benches', 'solve', 'Cargo.toml'), '--bin', 'dewil']);
  for (const t of tables) {
    const begun = Date.now();
    const runs = TABLES[t].map((r) => ({ seeds: Number(values.seeds ?? SEEDS), ...r }));
    const chosen = Number(t) >= 4 ? sheets.filter(([, set]) => set === 3) : sheets;
    const solved = async (fileOf) => {
      const args = chosen.map(([name]) => [fileOf(name), JSON.stringify(machine), JSON.stringify(runs)]);
      const results = await parallel(native('dewil'), args, availableParallelism());
      return chosen.map(([name, set, elements], k) => ({ name, set, elements, printed: PRINTED[name], rows: results[k] }));
    };
    if (t === '5') {
      const all = [];
      for (const layout of LAYOUTS) all.push(await solved((name) => made(name, layout)));
      fifth(all);
    } else {
      FORMS[t](await solved((name) => join(STORED, `${name}.dxf`)));
    }
    console.log(`${((Date.now() - begun) / 1000).toFixed(0)} s`);
  }
}

/** Mean over seeds of what a run says. */
const of = ({ rows }, name, what = (r) => r.value) => mean(rows.filter((r) => r.name === name).map(what));
/** A value of its insight, with what every path costs besides. */
const inside = (name) => (r) => r.fixed + r.insight.curves.find((c) => c.name === name).value;
const FREE = inside('best with precedence left out, s');
const REPAIRED = inside('repaired and improved, s');
const TOUR = inside('tour with precedence left out, s');

const gain = (value, base) => 100 * (1 - value / base);
const seconds = (value) => value.toFixed(1);
const percent = (value) => `${value.toFixed(1)} %`;

/** Lines by set with averages: `columns` of title, cell and, where it is averaged, number. */
function print(title, sheets, columns) {
  const lines = [];
  const average = (label, some) => {
    const cell = ({ number }) => (number === undefined ? '' : percent(mean(some.map(number))));
    lines.push([label, ...columns.map(cell)]);
  };
  for (const set of [1, 2, 3]) {
    const own = sheets.filter((s) => s.set === set);
    for (const s of own) lines.push([`${set}: ${s.name}`, ...columns.map(({ cell, number }) => (cell ? cell(s) : percent(number(s))))]);
    if (own.length > 1) average(`set ${set}, mean`, own);
  }
  if (sheets.length > 1) average('all, mean', sheets);
  table(title, ['', ...columns.map((c) => c.title)], lines);
}

function first(sheets) {
  const ours = (name, what) => (s) => gain(of(s, name, what), of(s, 'PFr'));
  const paper = (k) => (s) => gain(s.printed[k], s.printed[0]);
  const pair = (title, k, number) => [{ title: `${title}: paper`, number: paper(k) }, { title: 'ours', number }];
  const time = (title, k, name) => ({ title, cell: (s) => `${s.printed[k]} / ${of(s, name, (r) => r.seconds).toFixed(3)}` });
  const bound = (s) => s.rows.find((r) => r.name === 'bound').value;
  print('Table 1: improvement over PFr; t: computing time, paper / ours, s', sheets, [
    { title: 'n', cell: (s) => String(s.elements) },
    { title: 'contours', cell: (s) => of(s, 'PFr', (r) => r.contours).toFixed(0) },
    { title: 'made ready in, ms', cell: (s) => (1000 * of(s, 'problem', (r) => r.seconds)).toFixed(0) },
    { title: 'PFr, s: paper', cell: (s) => seconds(s.printed[0]) },
    { title: 'ours', cell: (s) => seconds(of(s, 'PFr')) },
    ...pair('GTSP', 1, ours('GTSP', TOUR)),
    ...pair('PFr-I', 2, ours('PFr-I')),
    ...pair('F-NR', 4, ours('F-R', FREE)),
    ...pair('F-R', 6, ours('F-R', REPAIRED)),
    time('t', 7, 'F-R'),
    { title: 'pre-cuts', cell: (s) => of(s, 'F-R', (r) => r.pre_cuts).toFixed(0) },
    { title: 'tour-tree', number: ours('tour-tree') },
    { title: OURS.name, number: ours(OURS.name, REPAIRED) },
    { title: 'ahead of that', number: (s) => gain(of(s, 'tour-tree'), of(s, OURS.name, REPAIRED)) },
    { title: 'in 1 s or more', number: (s) => gain(of(s, 'tour-tree, 1 s'), of(s, OURS.name, REPAIRED)) },
    { title: 'of GTSP, repaired', number: (s) => gain(of(s, 'tour-tree, 1 s'), of(s, 'GTSP')) },
    { title: 'lower bound, s', cell: (s) => seconds(bound(s)) },
    { title: 'below', number: (s) => gain(bound(s), of(s, 'tour-tree, 1 s')) },
  ]);
}

function second(sheets) {
  const ours = (name) => (s) => gain(of(s, name, REPAIRED), of(s, 'PFr'));
  const paper = (k) => (s) => gain(s.printed[k], s.printed[0]);
  print('Table 2: F-R from other initial partitions, improvement over PFr', sheets, [
    { title: 'n', cell: (s) => String(s.elements) },
    ...[['PFr', 6], ['SP', 8], ['GTSP', 9]].flatMap(([name, k]) => [
      { title: `${name}: paper`, number: paper(k) },
      { title: 'ours', number: ours(`from ${name}`) },
    ]),
  ]);
}

function third(sheets) {
  print('Table 3: components, improvement over PFr', sheets, [
    { title: 'n', cell: (s) => String(s.elements) },
    ...['C-FR', 'C-MP', 'C-MSP', 'C-LKH-FR'].flatMap((name, k) => [
      { title: `${name}: paper`, number: (s) => s.printed[10 + k] },
      { title: 'ours', number: (s) => gain(of(s, name), of(s, 'PFr')) },
    ]),
  ]);
}

function fourth(sheets) {
  const paper = (k) => (s) => gain(s.printed[k], s.printed[0]);
  const over = (name, suffix, what) => (s) => gain(of(s, name + suffix, what), of(s, `PFr${suffix}`));
  const forms = VARIANTS.map((v) => v.suffix);
  const title = (suffix) => suffix.replace(/^, /, '') || 'left';
  print('Table 4: set 3 with pierce groups that may be left, or cut whole; improvement over PFr of the same column', sheets, [
    { title: 'n', cell: (s) => String(s.elements) },
    ...forms.map((f) => ({ title: `PFr, s: ${title(f)}`, cell: (s) => seconds(of(s, `PFr${f}`)) })),
    { title: 'GTSP: paper', number: paper(1) },
    ...forms.map((f) => ({ title: title(f), number: over('GTSP', f, TOUR) })),
    { title: 'F-R: paper', number: paper(6) },
    ...forms.map((f) => ({ title: title(f), number: over('F-R', f, REPAIRED) })),
    ...['PFr', 'F-R', 'tour-tree'].map((name) => ({
      title: `${name}: groups left`,
      cell: (s) => of(s, name, (r) => r.left).toFixed(1),
    })),
    { title: 'F-R left over whole', number: (s) => gain(of(s, 'F-R'), of(s, 'F-R, whole')) },
    { title: 'tour-tree left over whole', number: (s) => gain(of(s, 'tour-tree'), of(s, 'tour-tree, whole')) },
    { title: 'F-R: best over insertion', number: (s) => gain(of(s, 'F-R'), of(s, 'F-R, insertion')) },
  ]);
}

/** The file of a variant of a sheet. */
function made(name, layout) {
  mkdirSync(MADE, { recursive: true });
  const file = join(MADE, `${name}-${layout.scale}-${layout.gap?.[0] ?? 'gaps'}.dxf`);
  writeFileSync(file, dxf(name, layout));
  return file;
}

function fifth(layouts) {
  const title = ({ scale, gap }) => [scale === 1 ? 'as it is' : `${scale} times as large`, ...(gap === undefined ? [] : [`${gap[0]} mm apart`])].join(', ');
  const line = (k, name, what) => {
    const gains = layouts[k].map((s) => gain(of(s, name, what), of(s, 'PFr')));
    return [`${title(LAYOUTS[k])}: ${name}`, ...gains.map(percent), percent(mean(gains))];
  };
  table(
    'Table 5: set 3 by sheet, improvement over PFr on the same sheet (the paper: GTSP -6.0 %, F-R 2.7 %)',
    ['', ...layouts[0].map((s) => s.name), 'mean'],
    LAYOUTS.flatMap((_, k) => [line(k, 'GTSP', TOUR), line(k, 'F-R', REPAIRED), line(k, 'tour-tree')]),
  );
}
