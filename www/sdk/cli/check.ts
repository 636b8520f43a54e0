/** `kerfway check`: reads G-code programs back and says what they would do on a machine. */

import { createPlanner } from '../node.js';
import type { CheckProblem, MachineProfile, ProgramCheck } from '../protocol.js';
import { parsed } from './arguments.js';
import { eachFile } from './batch.js';
import { outputsOf } from './destinations.js';
import { bytesOf, goesOnWithoutReader, nameOf, subject, Unusable, usable } from './io.js';
import { machineFiles, machineOf } from './machine.js';
import type { Column } from './report.js';
import { duration, meters, plural } from '../words.js';

export async function check(args: string[]): Promise<void> {
  const given = parsed('check', args, 'a G-code file');
  const outputs = outputsOf(given, ['json']);
  // The exit code says whether all programs pass.
  goesOnWithoutReader();
  const piped = outputs.some((output) => output.out === '-');
  const planner = await createPlanner();
  try {
    const machine = await machineOf(given, planner);
    await eachFile(given, { outputs, columns: COLUMNS, inputs: machineFiles(given, planner) }, async (file, place, to) => {
      const program = new TextDecoder().decode(await bytesOf(file));
      const report = await usable(file, planner.check(program, { machine }));
      await to.write(file, outputs.map((output) => ({ output, data: `${JSON.stringify({ name: nameOf(file), ...report })}\n` })));
      if (!piped || place.of > 1) await to.report(place, () => lines(file, report, machine), () => row(file, report));
      const first = report.problems.find(isError);
      if (first !== undefined) throw new Unusable(`${subject(file)} fails: ${first.message}`, null);
    });
  } finally {
    planner.close();
  }
}

const COLUMNS: readonly Column[] = [
  { title: 'Contours', width: 8, right: true },
  { title: 'Parts', width: 5, right: true },
  { title: 'To cut', width: 10, right: true },
  { title: 'Time', width: 11, right: true },
  { title: 'Verdict', width: 8 },
];

function row(file: string, report: ProgramCheck): string[] {
  const { contours, parts, cut_length, seconds, passed } = report;
  return [file, String(contours), String(parts), meters(cut_length), duration(seconds), passed ? 'passes' : 'fails'];
}

function lines(file: string, report: ProgramCheck, machine: MachineProfile): string[] {
  const { passed, contours, passes, parts, pierces, cut_length, air_length, seconds, fits_bed, dark_rapids, bounds, problems } = report;
  const times = passes === 1 ? 'each cut once' : passes === 0 ? 'not all cut equally often' : `each cut ${passes} times`;
  const reach = bounds === null ? '' : `x ${bounds[0].toFixed(1)} to ${bounds[2].toFixed(1)}, y ${bounds[1].toFixed(1)} to ${bounds[3].toFixed(1)} mm`;
  const bed = fits_bed === null ? 'the bed of this machine is not known' : fits_bed ? 'on the bed' : 'off the bed';
  return [
    `${nameOf(file)}: ${passed ? 'passes' : 'fails'}, read as ${report.dialect} on ${machine.name}`,
    contours === 0 ? 'Contours   none' : `Contours   ${plural(contours, 'contour')}, ${times}; ${plural(parts, 'part')}, ${plural(pierces, 'piercing')}`,
    `Length     ${meters(cut_length)} to cut, ${meters(air_length)} of air moves`,
    `Time       ${duration(seconds)}`,
    ...(bounds === null ? [] : [`Reach      ${reach}; ${bed}`]),
    `Beam       ${dark_rapids ? 'off on every rapid' : 'on during a rapid'}`,
    ...problems.map(problem),
  ];
}

function problem({ severity, message, count }: CheckProblem): string {
  return `${severity === 'error' ? 'Error     ' : 'Warning   '} ${message}${count > 1 ? ` And ${count - 1} more like it.` : ''}`;
}

const isError = ({ severity }: CheckProblem) => severity === 'error';
