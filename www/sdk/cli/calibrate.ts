/** `kerfway calibrate`: fits a machine to the seconds that jobs took. */

import { createPlanner } from '../node.js';
import { checkProfile } from '../options.js';
import type { Calibration, MachineProfile, MeasuredPlan } from '../protocol.js';
import { parsed } from './arguments.js';
import { Destinations, outputsOf } from './destinations.js';
import { textOf, usable, WrongUse } from './io.js';
import { machineFiles, machineOf } from './machine.js';
import { say } from './report.js';
import { complain } from './safe-text.js';
import { duration, percent } from '../words.js';

export async function calibrate(args: string[]): Promise<void> {
  const given = parsed('calibrate', args, 'a plan and the seconds it took: plan.json=120');
  const jobs = given.words.map(jobOf);
  const outputs = outputsOf(given, ['json']);
  const files = jobs.map((j) => j.file);
  const [first = ''] = files;
  const planner = await createPlanner();
  try {
    const destinations = new Destinations(outputs, [...files, ...machineFiles(given, planner)]);
    destinations.begin([first]);
    const measured: MeasuredPlan[] = [];
    for (const { file, seconds } of jobs) measured.push({ plan: await textOf(file), seconds });
    const own = measured.map(({ plan }) => plannedFor(plan));
    const machine = await machineOf(given, planner, own[0]);
    for (const [k, { name } = machine] of own.entries()) {
      if (name === machine.name) continue;
      if (given.values['machine'] === undefined) throw new WrongUse(`${first} was planned for ${machine.name} and ${files[k]} for ${name}: say with --machine which one is to be fitted.`);
      complain(`${files[k]} was planned for ${name}. ${machine.name} is fitted to its time.`);
    }
    const calibration = await planner.calibrate(machine, measured).catch(async (error: unknown) => {
      // Of several plans, the first that cannot be used alone is named.
      for (const [k, file] of files.entries()) await usable(file, planner.calibrate(machine, measured.slice(k, k + 1)));
      return usable(files.join(', '), Promise.reject(error));
    });
    await destinations.write(first, outputs.map((output) => ({ output, data: `${JSON.stringify(calibration.machine, null, 2)}\n` })));
    if (given.values['quiet'] !== true) await say(lines(calibration, machine), destinations.piped);
  } finally {
    planner.close();
  }
}

/** The machine in a plan document; undefined in what is none, of which the fit says more. */
function plannedFor(plan: string): MachineProfile | undefined {
  try {
    const { machine } = JSON.parse(plan) as { machine: MachineProfile };
    checkProfile(machine);
    return machine;
  } catch {
    return undefined;
  }
}

/** `FILE=SECONDS`; the name may contain equals signs. */
function jobOf(word: string): { file: string; seconds: number } {
  const at = word.lastIndexOf('=');
  const seconds = at < 1 ? NaN : Number(word.slice(at + 1));
  if (!(seconds > 0 && seconds < MOST)) throw new WrongUse(`${word}: write PLAN.json=SECONDS, with the seconds that the job took.`);
  return { file: word.slice(0, at), seconds };
}

function lines({ jobs, machine: now }: Calibration, before: Calibration['machine']): string[] {
  const off = (planned: number, measured: number) => {
    const share = Math.abs(planned / measured - 1);
    return share < LEAST ? 'the same' : `${planned >= measured ? '+' : '-'}${percent(share)}`;
  };
  const value = (name: string, from: number | null, to: number | null, unit: string) => `${name.padEnd(20)}${digits(from)} to ${digits(to)} ${unit}${isLimit(from, to) ? ', as far as the fit goes' : ''}`;
  return [
    ...jobs.map((j) => `${j.name}: ${duration(j.measured)} measured; planned ${duration(j.before)} before (${off(j.before, j.measured)}), ${duration(j.after)} after (${off(j.after, j.measured)})`),
    value('cut.accel', before.cut.accel, now.cut.accel, 'mm/s2'),
    value('junction_deviation', before.junction_deviation, now.junction_deviation, 'mm'),
    value('pierce_time', before.pierce_time, now.pierce_time, 's'),
  ];
}

/** The seconds of no job: the most that the fit takes. */
const MOST = 1e7;
/** The factor within which the fit changes acceleration and deviation: the same as in `src/calibration`. */
const LARGEST = 20;

/** Whether a fitted value is one at which the fit ends. No pierce time is below 0. */
function isLimit(from: number | null, to: number | null): boolean {
  if (from === null || to === null || from === to) return false;
  return to === 0 || Math.max(to / from, from / to) > LARGEST * (1 - 1e-6);
}

/** The least difference that two decimals of a per cent show. */
const LEAST = 0.00005;

const digits = (n: number | null) => (n === null ? 'none' : String(Number(n.toPrecision(4))));
