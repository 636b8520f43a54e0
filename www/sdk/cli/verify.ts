/** `kerfway verify`: checks the certificate of a lower bound against its drawing. */

import { dirname, join } from 'node:path';
import { createPlanner } from '../node.js';
import type { MachineProfile, Verified } from '../protocol.js';
import { parsed, text, type Words } from './arguments.js';
import { Destinations, outputsOf } from './destinations.js';
import { subject, textOf, Unusable, WrongUse } from './io.js';
import { machineFiles, machineOf } from './machine.js';
import { opened } from './opened.js';
import { say } from './report.js';
import { loadedResearch } from './research.js';

export async function verify(args: string[]): Promise<void> {
  const given = parsed('verify', args, 'a certificate');
  const [file = '', drawing, more] = given.words;
  if (more !== undefined) throw new WrongUse(`Give a certificate and its drawing: ${more} is one too many.`);
  const outputs = outputsOf(given, ['json']);
  const { files, ...machine } = await namedMachine(given);
  const certificate = await textOf(file);
  const beside = drawing ?? besideCertificate(file, certificate);
  const destinations = new Destinations(outputs, [beside, ...files]);
  destinations.begin([file]);
  const project = await (drawing === undefined ? orGiven(opened(beside)) : opened(drawing));
  const research = await loadedResearch();
  let verified: Verified;
  try {
    verified = research.verifyCertificate(certificate, project.drawing, machine);
  } catch (error) {
    throw new Unusable(`${subject(file)} proves nothing: ${(error as Error).message}`);
  }
  await destinations.write(file, outputs.map((output) => ({ output, data: `${JSON.stringify(verified)}\n` })));
  if (given.values['quiet'] !== true) await say(lines(verified), destinations.piped);
}

/** The machine that `--machine` names, if it names one, and the files that it is read from. */
async function namedMachine(given: Words): Promise<{ files: string[]; machine?: MachineProfile }> {
  if (text(given.values, 'machine') === undefined) return { files: [] };
  const planner = await createPlanner();
  try {
    return { files: machineFiles(given, planner), machine: await machineOf(given, planner) };
  } finally {
    planner.close();
  }
}

/** The drawing that the certificate names, in the folder of the certificate. It is used when the arguments name no drawing. */
function besideCertificate(file: string, certificate: string): string {
  const name = /"drawing":\{"name":("(?:[^"\\]|\\.)*")/.exec(certificate)?.[1];
  try {
    return join(dirname(file), JSON.parse(name ?? '') as string);
  } catch {
    throw new Unusable(`${subject(file)} names no drawing: either it is no certificate, or give its drawing after it.`);
  }
}

async function orGiven<T>(read: Promise<T>): Promise<T> {
  try {
    return await read;
  } catch (error) {
    throw error instanceof Unusable ? new Unusable(`${error.message} Give the drawing after the certificate.`) : error;
  }
}

/** What is proven, and under which conditions that a certificate brings with it. */
function lines({ seconds, paid, drawing, machine, known_machine, settings }: Verified): string[] {
  const travel = Math.max(seconds - paid, 0);
  const on = known_machine ? machine : `a machine that calls itself ${machine}, not the preset,`;
  const proven = `Proven: no plan of ${drawing} on ${on} takes less than ${down(seconds)} s, because each pays ${down(paid)} s for piercing and cutting, and travels for at least ${down(travel)} s.`;
  return settings === '{}' ? [proven] : [proven, `This holds with ${settings}: with other settings a plan may take less.`];
}

/** Seconds with three decimals, rounded down, because more is not proven. */
const down = (seconds: number) => (Math.floor(seconds * 1000) / 1000).toFixed(3);
