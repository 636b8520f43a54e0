/** `kerfway plan`: plans drawings and writes the outputs. */

import { KerfwayError } from '../errors.js';
import { PROVEN } from '../gap.js';
import { jobReport } from '../job-report.js';
import type { Planner, PlanResult } from '../node.js';
import type { Loaded, MachineProfile, OutputKind, PlanOptions, Proof } from '../protocol.js';
import { withSavings } from '../savings.js';
import { parsed } from './arguments.js';
import { outputsOf, type Output, type Written } from './destinations.js';
import { nameOf, usable } from './io.js';
import { complain } from './safe-text.js';
import { planFiles } from './planning.js';
import type { Column } from './report.js';
import { savingLines, savingsOf } from './savings.js';
import { isNotable, ofDrawing } from './warnings.js';
import { duration, elapsed, meters, percentAtMost, plural, skeletonLines, unitOf } from '../words.js';

const OUTPUTS: readonly (OutputKind | 'report' | 'certificate')[] = ['json', 'gcode', 'svg', 'dxf', 'png', 'lbrn2', 'rd', 'remainder', 'report', 'certificate'];

export async function plan(args: string[]): Promise<void> {
  const given = parsed('plan', args);
  const outputs = outputsOf(given, OUTPUTS);
  await planFiles(given, { outputs, columns: COLUMNS }, async ({ file, place, planner, loaded, result, proof, options }, to) => {
    const written: Written[] = [];
    for (const output of outputs) {
      const { kind } = output;
      const data = kind === 'report' ? reported(planner, loaded, result, written) : kind === 'certificate' ? certified(proof) : planner.output(kind);
      written.push({ output, data: await usable(file, data, (sentence) => refused(sentence, kind, outputs)) });
    }
    const saved = given.values['savings'] === true ? await usable(file, savingsOf(planner, options, result)) : null;
    if (saved !== null) {
      for (const one of written) if (one.output.kind === 'json' && typeof one.data === 'string') one.data = withSavings(one.data, saved.saved);
    }
    // The controller of some machines takes another file than G-code.
    const takes = (options.machine as MachineProfile | undefined)?.takes ?? 'gcode';
    if (takes !== 'gcode' && outputs.some((o) => o.kind === 'gcode')) complain(`The controller of ${(options.machine as MachineProfile).name} takes ${takes.toUpperCase()} (--${takes}), not G-code.`);
    await to.write(file, written);
    const savings = () => savingLines(saved);
    await to.report(place, () => [...lines(file, loaded, result, options), ...findingLine(file, loaded, result, outputs), ...savings()], () => row(file, loaded, result), savings);
  });
}

/** Why an output cannot be made. It names the output, because those of a drawing are written together or not at all. */
function refused(sentence: string, kind: string, outputs: readonly Output[]): string {
  const isSaid = outputs.length === 1 || sentence.includes('Nothing was written');
  return isSaid ? sentence : `${sentence} Nothing was written: leave out --${kind} to have the other outputs.`;
}

/** The report of a job, with the picture and the checksum of the program that are written beside it: both come before it in `OUTPUTS`. */
async function reported(planner: Planner, loaded: Loaded, { progress: { summary, path }, baselines, beam, findings, shift }: PlanResult, written: readonly Written[]): Promise<string> {
  if (path === null) throw new KerfwayError('planner-died', 'The plan ended before it had a path.');
  const beside = (kind: OutputKind) => written.find(({ output }) => output.kind === kind)?.data as string | undefined;
  const [program, svg] = [beside('gcode') ?? null, beside('svg') ?? (await planner.output('svg'))];
  return jobReport({ loaded, summary, baselines, path, beam, findings, shift, program, quote: await planner.quote(), svg });
}

/** The certificate of the bound. */
async function certified(proof: Proof | null): Promise<string> {
  if (proof?.certificate) return `${proof.certificate}\n`;
  throw new KerfwayError('unwritable', `There is no certificate: ${proof?.hindrance ?? 'nothing was proven in this time. Give it longer by --bound.'}`);
}

const COLUMNS: readonly Column[] = [
  { title: 'Contours', width: 8, right: true },
  { title: 'To cut', width: 10, right: true },
  { title: 'Job', width: 11, right: true },
  { title: 'As drawn', width: 11, right: true },
  { title: 'Gap', width: 8, right: true },
  { title: 'Findings', width: 8, right: true },
];

function row(file: string, loaded: Loaded, { progress: { summary: s }, baselines, findings }: PlanResult): string[] {
  return [
    file,
    String(s.contours),
    meters(s.cut_length),
    duration(s.total_time),
    duration(baselines.drawing.total_time),
    s.gap === null ? '' : s.gap <= PROVEN ? 'proven' : percentAtMost(s.gap),
    String(ofDrawing(loaded).length + findings.filter(isNotable).length),
  ];
}

function lines(file: string, loaded: Loaded, result: PlanResult, { machine, workers = 1 }: PlanOptions): string[] {
  const { summary: s, moves, seconds } = result.progress;
  const { drawing, greedy } = result.baselines;
  const text = [
    `${nameOf(file)}: ${plural(s.contours, 'contour')} (${s.open_contours} open), ${plural(s.parts, 'part')}, ` +
      `${meters(s.cut_length)} to cut`,
    `Job        ${duration(s.total_time)}: cut ${duration(s.cut_time)}, air ${duration(s.air_time)} ` +
      `(${meters(s.air_length)}), pierce ${duration(s.pierce_time)}`,
    `Before     ${duration(drawing.total_time)} as drawn, ${duration(greedy.total_time)} nearest first`,
    ...skeletonLines(s),
    `Search     ${result.method}, seed ${result.seed}, ${plural(moves, 'move')} in ${elapsed(seconds)}` +
      `${workers > 1 ? ` by ${workers} workers` : ''}; ` +
      `machine ${(machine as MachineProfile).name}`,
  ];
  if (s.gap !== null) {
    text.push(`Optimum    ${s.gap <= PROVEN ? 'this path is proven optimal' : `at least ${duration(s.lower_bound)}: this path takes at most ${percentAtMost(s.gap)} longer`}`);
  }
  if (loaded.units.doubtful) text.push(`Units      ${unitOf(loaded.units)}, in doubt: ${loaded.units.reason}`);
  return text;
}

/** How many warnings and errors there are, and where they are listed. */
function findingLine(file: string, loaded: Loaded, { findings }: PlanResult, outputs: readonly Output[]): string[] {
  const [drawn, planned] = [ofDrawing(loaded).length, findings.filter(isNotable).length];
  if (drawn + planned === 0) return [];
  const inspect = `kerfway inspect ${file} lists`;
  const where = planned === 0 ? `${inspect} them` : outputs.some(({ kind }) => kind === 'json') ? 'the JSON lists them' : drawn === 0 ? '--json lists them' : `${inspect} ${drawn} of them, --json all`;
  return [`Findings   ${drawn + planned}: ${where}`];
}
