/** `kerfway plan`: a drawing planned and written out. */

import { basename } from 'node:path';
import { createPlanner, type Planner, type PlanResult } from '../node.js';
import type { Loaded, MachineProfile, OutputKind, PlanOptions, Progress } from '../protocol.js';
import { loadOptions, oneOf, parameters, READING, seconds, text, whole, words, type Words } from './arguments.js';
import { bytesOf, put, Unusable, usable, WrongUse } from './io.js';
import { duration, percent, meters, plural } from './words.js';

const OUTPUTS: readonly OutputKind[] = ['json', 'gcode', 'svg', 'dxf', 'png'];
const DEFAULT_MACHINE = 'co2-100w';

const OPTIONS = {
  ...READING,
  ...Object.fromEntries([...OUTPUTS, 'machine', 'method', 'seconds', 'moves', 'workers', 'seed'].map((o) => [o, { type: 'string' }])),
  set: { type: 'string', multiple: true },
  'no-return': { type: 'boolean' },
} as const;

interface Output {
  kind: OutputKind;
  out: string;
}

export async function plan(args: string[]): Promise<void> {
  const given = words(args, OPTIONS);
  const { file, values } = given;
  const outputs = outputsOf(given);
  const load = loadOptions(values);
  const [moves, workers, seed] = ['moves', 'workers', 'seed'].map((name) => whole(values, name));
  const budget = { seconds: seconds(values), moves, workers, seed };
  const bytes = await bytesOf(file);
  const planner = await createPlanner();
  try {
    const options: PlanOptions = { ...budget, ...(await choices(given, planner)) };
    const loaded = await usable(file, planner.load(bytes, basename(file), load));
    const result = await usable(file, searched(planner, options));
    for (const { kind, out } of outputs) await put(out, await usable(file, planner.output(kind)));
    const summary = told(file, loaded, result, options);
    if (outputs.some((o) => o.out === '-')) process.stderr.write(summary);
    else await put('-', summary);
  } finally {
    planner.close();
  }
}

function outputsOf({ values }: Words): Output[] {
  const outputs = OUTPUTS.flatMap((kind) => {
    const out = text(values, kind);
    return out === undefined ? [] : [{ kind, out }];
  });
  const [first, second] = outputs.filter((o) => o.out === '-');
  if (first !== undefined && second !== undefined) {
    throw new WrongUse(`--${first.kind} and --${second.kind} cannot both go to standard output.`);
  }
  return outputs;
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

/** A path this near to what is proven is optimal: what is left is rounding. */
const PROVEN = 1e-9;

function told(file: string, loaded: Loaded, result: PlanResult, { machine, workers = 1 }: PlanOptions): string {
  const { summary: s, moves, seconds } = result.progress;
  const { drawing, greedy } = result.baselines;
  const findings = loaded.findings.filter((f) => f.severity !== 'info').length;
  const lines = [
    `${basename(file)}: ${plural(s.contours, 'contour')} (${s.open_contours} open), ${plural(s.parts, 'part')}, ` +
      `${meters(s.cut_length)} to cut`,
    `Job        ${duration(s.total_time)}: cut ${duration(s.cut_time)}, air ${duration(s.air_time)} ` +
      `(${meters(s.air_length)}), pierce ${duration(s.pierce_time)}`,
    `Before     ${duration(drawing.total_time)} as drawn, ${duration(greedy.total_time)} nearest first`,
    `Search     ${result.method}, seed ${result.seed}, ${moves} moves in ${seconds.toFixed(1)} s` +
      `${workers > 1 ? ` by ${workers} workers` : ''}; ` +
      `machine ${(machine as MachineProfile).name}`,
  ];
  if (s.gap !== null) {
    lines.push(`Optimum    ${s.gap <= PROVEN ? 'this is it: proven' : `at least ${duration(s.lower_bound)}: this is at most ${percent(s.gap)} above`}`);
  }
  if (findings > 0) lines.push(`Findings   ${findings}: kerfway inspect ${file} tells them`);
  return `${lines.join('\n')}\n`;
}
