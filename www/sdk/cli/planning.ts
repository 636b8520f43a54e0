/** What `plan` and `quote` share: the options of planning, and a drawing planned by them. */

import { basename } from 'node:path';
import { createPlanner, type Planner, type PlanResult } from '../node.js';
import type { Loaded, MachineProfile, PlanOptions, Progress } from '../protocol.js';
import { loadOptions, oneOf, parameters, READING, seconds, text, whole, type Words } from './arguments.js';
import { bytesOf, Unusable, usable, WrongUse } from './io.js';
import { duration } from './words.js';

const DEFAULT_MACHINE = 'co2-100w';

/** The options of reading and planning. */
export const PLANNING = {
  ...READING,
  ...Object.fromEntries(['machine', 'method', 'seconds', 'moves', 'workers', 'seed'].map((o) => [o, { type: 'string' }])),
  set: { type: 'string', multiple: true },
  'no-return': { type: 'boolean' },
} as const;

/** A drawing that is planned. */
export interface PlannedFile {
  planner: Planner;
  loaded: Loaded;
  result: PlanResult;
  options: PlanOptions;
}

/** Plans the file named, and hands it to whoever writes of it. */
export async function planFile(given: Words, write: (planned: PlannedFile) => Promise<void>): Promise<void> {
  const { file, values } = given;
  const load = loadOptions(values);
  const [moves, workers, seed] = ['moves', 'workers', 'seed'].map((name) => whole(values, name));
  const budget = { seconds: seconds(values), moves, workers, seed };
  const bytes = await bytesOf(file);
  const planner = await createPlanner();
  try {
    const options: PlanOptions = { ...budget, ...(await choices(given, planner)) };
    const loaded = await usable(file, planner.load(bytes, basename(file), load));
    const result = await usable(file, searched(planner, options));
    await write({ planner, loaded, result, options });
  } finally {
    planner.close();
  }
}

async function choices({ values }: Words, planner: Planner): Promise<PlanOptions> {
  const options: PlanOptions = {};
  const method = text(values, 'method');
  const own = planner.methods.map((m) => m.name);
  const set = parameters(values);
  if (set !== undefined) options.parameters = set;
  if (method !== undefined) {
    const papers = own.includes(method) ? [] : (await planner.paperMethods()).map((m) => m.name);
    options.method = oneOf('--method', method, [...own, ...papers]);
  }
  const machine = await machineOf(text(values, 'machine') ?? DEFAULT_MACHINE, planner);
  options.machine = values['no-return'] === true ? { ...machine, return_home: false } : machine;
  return options;
}

/** A preset by its name; anything that looks like a file is one. */
async function machineOf(word: string, { machines }: Planner): Promise<MachineProfile> {
  const preset = machines.find((m) => m.name === word);
  if (preset !== undefined) return preset;
  if (!/[./\\]/.test(word)) return Promise.reject(unknownMachine(word, machines));
  const bytes = await bytesOf(word);
  try {
    return JSON.parse(new TextDecoder().decode(bytes)) as MachineProfile;
  } catch {
    throw new Unusable(`${word} is not JSON: a machine profile is an object like those of the presets.`);
  }
}

function unknownMachine(word: string, machines: readonly MachineProfile[]): WrongUse {
  const names = machines.map((m) => m.name).join(', ');
  return new WrongUse(`--machine ${word}: choose one of ${names}, or name a file ending in .json.`);
}

async function searched(planner: Planner, options: PlanOptions): Promise<PlanResult> {
  const show = process.stderr.isTTY;
  const plan = planner.plan(options, show ? showProgress : () => {});
  // Once ends the search and keeps what it found; twice ends the program.
  const stop = () => plan.stop();
  process.once('SIGINT', stop);
  try {
    return await plan.done;
  } finally {
    process.removeListener('SIGINT', stop);
    if (show) process.stderr.write('\r\x1b[K');
  }
}

function showProgress({ seconds, rate, summary }: Progress): void {
  const pace = rate >= 1e6 ? `${(rate / 1e6).toFixed(1)} million` : `${Math.round(rate / 1000)} thousand`;
  process.stderr.write(`\r\x1b[K${seconds.toFixed(1)} s  job ${duration(summary.total_time)}  ${pace} moves a second`);
}
