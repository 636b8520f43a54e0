// The tables of the papers whose methods Kerfway has, run again:
//
//     npm run bench -- papers [--table NAME]... [--seeds K] [--rounds R] [--only INSTANCE]
//                             [--data FOLDER]
//     npm run bench -- papers --paper qu-du|tsplib|hull|yang|dewil [--readings] [--seeds N] --csv OUT    (benches/papers/kit.mjs)
//     npm run bench -- papers --figures FOLDER                                                    (benches/papers/figures.mjs)
//
// Beside each printed value stand the method as published, the method with local search, the default solver and the
// proven optimum or the best value known. Instances come from benches/data, and from `--data FOLDER` where they may
// not be copied (benches/data/README.md). Every value is that of a tour checked by code that shares nothing with the methods. A run ends at the method's own budget, or at the best value known.

import { availableParallelism } from 'node:os';
import { parseArgs } from 'node:util';
import { setup } from '../scripts/setup.mjs';
import { Stop } from '../scripts/tools.mjs';
import { Instances } from './common/data.mjs';
import { tables as hull } from './papers/hull.mjs';
import { kit } from './papers/kit.mjs';
import { build } from './papers/runs.mjs';
import { tables as quDu } from './papers/qu-du.mjs';
import { tables as stop } from './papers/stop.mjs';
import { tables as yang } from './papers/yang.mjs';

const TABLES = { ...quDu, ...hull, ...yang, ...stop };

export async function bench(args) {
  const { values } = parseArgs({
    args,
    options: {
      table: { type: 'string', multiple: true },
      seeds: { type: 'string' },
      rounds: { type: 'string' },
      only: { type: 'string' },
      data: { type: 'string' },
      paper: { type: 'string' },
      readings: { type: 'boolean' },
      threads: { type: 'string' },
      csv: { type: 'string' },
      from: { type: 'string' },
      against: { type: 'string' },
      first: { type: 'string' },
      reading: { type: 'string' },
      curves: { type: 'string' },
      figures: { type: 'string' },
    },
  });
  if (values.figures !== undefined) {
    await setup();
    // Imported only now: a fresh clone has the drawing library after set-up.
    const { figures } = await import('./papers/figures.mjs');
    return figures(values.figures);
  }
  const names = values.table ?? Object.keys(TABLES);
  const unknown = names.find((name) => !(name in TABLES));
  if (unknown !== undefined) throw new Stop(`There is no table ${unknown}: ${Object.keys(TABLES).join(', ')}.`);
  const instances = new Instances(values.data);
  if (values.paper !== undefined) {
    if (values.from === undefined) await setup();
    const { paper, readings, only, reading, csv, curves, from, against } = values;
    const numbers = { seeds: Number(values.seeds ?? 30), first: Number(values.first ?? 1), threads: Number(values.threads ?? availableParallelism()) };
    return kit({ paper, readings, only, reading, csv, curves, from, against, instances, ...numbers });
  }
  await setup();
  build();
  const rounds = values.rounds === undefined ? undefined : Number(values.rounds);
  for (const name of names) {
    const begun = Date.now();
    await TABLES[name]({ seeds: Number(values.seeds ?? 30), rounds, only: values.only, instances });
    instances.report();
    console.log(`${name}: ${((Date.now() - begun) / 1000).toFixed(0)} s`);
  }
}
