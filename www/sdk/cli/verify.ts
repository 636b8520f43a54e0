/** `kerfway verify`: checks the certificate of a lower bound against its drawing. */

import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { createPlanner } from '../node.js';
import type { Verified } from '../protocol.js';
import { parsed, text } from './arguments.js';
import { Destinations, outputsOf } from './destinations.js';
import { bytesOf, Unusable, WrongUse } from './io.js';
import { machineOf } from './machine.js';
import { say } from './report.js';

export async function verify(args: string[]): Promise<void> {
  const given = parsed('verify', args, 'a certificate');
  const [file = '', drawing, more] = given.words;
  if (more !== undefined) throw new WrongUse(`Give a certificate and its drawing: ${more} is one too many.`);
  const outputs = outputsOf(given, ['json']);
  const destinations = new Destinations(outputs);
  destinations.begin([file]);
  const machine = text(given.values, 'machine') === undefined ? {} : { machine: await namedMachine(given) };
  const certificate = new TextDecoder().decode(await bytesOf(file));
  const bytes = await (drawing === undefined ? besideCertificate(file, certificate) : bytesOf(drawing));
  const research = await import('../pkg/kerfway_research.js');
  research.initSync({ module: await readFile(new URL('../pkg/kerfway_research_bg.wasm', import.meta.url)) });
  let verified: Verified;
  try {
    verified = research.verifyCertificate(certificate, bytes, machine);
  } catch (error) {
    throw new Unusable(`${file} proves nothing: ${(error as Error).message}`);
  }
  await destinations.write(file, outputs.map((output) => ({ output, data: `${JSON.stringify(verified)}\n` })));
  if (given.values['quiet'] !== true) await say([sentence(verified)], destinations.piped);
}

async function namedMachine(given: Parameters<typeof machineOf>[0]) {
  const planner = await createPlanner();
  try {
    return await machineOf(given, planner);
  } finally {
    planner.close();
  }
}

/** Without a drawing in the arguments, the file of the certificate's own name beside it. */
async function besideCertificate(file: string, certificate: string): Promise<Uint8Array> {
  const name = /"drawing":\{"name":("(?:[^"\\]|\\.)*")/.exec(certificate)?.[1];
  if (name === undefined) throw new Unusable(`${file} names no drawing: either it is no certificate, or give its drawing after it.`);
  try {
    return await bytesOf(join(dirname(file), JSON.parse(name) as string));
  } catch (error) {
    throw error instanceof Unusable ? new Unusable(`${error.message} Give the drawing after the certificate.`) : error;
  }
}

function sentence({ seconds, paid, drawing, machine }: Verified): string {
  const travel = Math.max(seconds - paid, 0);
  return `Proven: no plan of ${drawing} on ${machine} takes less than ${down(seconds)} s, because each pays ${down(paid)} s for piercing and cutting, and travels for at least ${down(travel)} s.`;
}

/** Seconds with three decimals, rounded down, because more is not proven. */
const down = (seconds: number) => (Math.floor(seconds * 1000) / 1000).toFixed(3);
