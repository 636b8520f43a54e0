/** `kerfway plan`: a drawing planned and written out. */

import { basename } from 'node:path';
import type { PlanResult } from '../node.js';
import type { Loaded, MachineProfile, OutputKind, PlanOptions } from '../protocol.js';
import { text, words, type Words } from './arguments.js';
import { put, usable, WrongUse } from './io.js';
import { planFile, PLANNING } from './planning.js';
import { duration, percent, meters, plural } from './words.js';

const OUTPUTS: readonly OutputKind[] = ['json', 'gcode', 'svg', 'dxf', 'png'];

const OPTIONS = {
  ...PLANNING,
  ...Object.fromEntries(OUTPUTS.map((o) => [o, { type: 'string' }])),
} as const;

interface Output {
  kind: OutputKind;
  out: string;
}

export async function plan(args: string[]): Promise<void> {
  const given = words(args, OPTIONS);
  const { file } = given;
  const outputs = outputsOf(given);
  await planFile(given, async ({ planner, loaded, result, options }) => {
    for (const { kind, out } of outputs) await put(out, await usable(file, planner.output(kind)));
    const summary = told(file, loaded, result, options);
    if (outputs.some((o) => o.out === '-')) process.stderr.write(summary);
    else await put('-', summary);
  });
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
