/** Files in, streams out, and the two ways a command can fail. Output files: see `atomic.ts`. */

import { open, writeFile, type FileHandle } from 'node:fs/promises';
import { endless, MAX_BYTES, tooLarge } from '../size.js';
import { visibleText } from './safe-text.js';
import { STANDARD_OUTPUT } from './target.js';
import { writing } from './temporary.js';

/** The input cannot be used: exit 1. One sentence: what, where, what to do. */
export class Unusable extends Error {}

/** The command line cannot be understood: exit 2. */
export class WrongUse extends Error {}

/** Why the system refuses, and what to do about it when a file is written. */
interface Cause {
  why: string;
  remedy: string;
}

const ELSEWHERE = 'Name another place.';
const ROOM = 'Make room on the disk, or name another place.';
const PERMISSION = 'Name another place, or change the permissions of that file and its folder.';
const NO_PERMISSION: Cause = { why: 'the system does not allow it', remedy: PERMISSION };

const CAUSES: Record<string, Cause> = {
  ENOENT: { why: 'there is no such file', remedy: ELSEWHERE },
  ENOTDIR: { why: 'there is no such folder', remedy: ELSEWHERE },
  EISDIR: { why: 'that is a folder, not a file', remedy: ELSEWHERE },
  ELOOP: { why: 'its links lead in a circle', remedy: ELSEWHERE },
  ENAMETOOLONG: { why: 'its name is too long', remedy: 'Give it a shorter name.' },
  EACCES: NO_PERMISSION,
  EPERM: NO_PERMISSION,
  EBUSY: { why: 'another program holds it, or it is a mount of its own', remedy: ELSEWHERE },
  EROFS: { why: 'the disk can only be read', remedy: ELSEWHERE },
  ENOSPC: { why: 'the disk is full', remedy: ROOM },
  EDQUOT: { why: 'there is no room left for this user', remedy: ROOM },
  EFBIG: { why: 'the file would be larger than the system allows', remedy: 'Raise the limit (ulimit -f), or name a place on another disk.' },
};

/** What an error of the system means. A file that is written need not be there before, but its folder must. */
function cause(error: unknown, doing: 'read' | 'write'): Cause {
  const code = (error as NodeJS.ErrnoException).code ?? '';
  const known = CAUSES[doing === 'write' && code === 'ENOENT' ? 'ENOTDIR' : code];
  return known ?? { why: `the system says ${code || String(error)}`, remedy: ELSEWHERE };
}

/** The bytes of a file, of which no more than can be used are read. */
export async function bytesOf(file: string): Promise<Uint8Array> {
  let handle: FileHandle | undefined;
  try {
    handle = await open(file);
    const stat = await handle.stat();
    const refused = tooLarge(stat.size);
    if (refused !== null) throw new Unusable(`${file}: ${refused}`);
    // Pipes and devices have no size before they are read, and neither have the files of /proc.
    if (stat.isFile() && stat.size > 0) return await handle.readFile();
    const bytes = await upToLimit(handle);
    if (bytes === null) throw new Unusable(`${file}: ${endless()}`);
    return bytes;
  } catch (error) {
    if (error instanceof Unusable) throw error;
    throw new Unusable(`${file} cannot be read: ${cause(error, 'read').why}.`);
  } finally {
    await handle?.close();
  }
}

/** What comes until the end of a stream; `null` when that is too much. */
async function upToLimit(handle: FileHandle): Promise<Uint8Array | null> {
  const chunks: Uint8Array[] = [];
  let length = 0;
  for await (const chunk of handle.createReadStream({ autoClose: false }) as AsyncIterable<Uint8Array>) {
    chunks.push(chunk);
    length += chunk.length;
    if (length > MAX_BYTES) return null;
  }
  return Buffer.concat(chunks);
}

/** Prints on standard output. */
export async function print(text: string): Promise<void> {
  try {
    await send(STANDARD_OUTPUT, text);
  } catch (error) {
    throw unwritable(STANDARD_OUTPUT, error);
  }
}

/** Writes to standard output for `-`, else to a device, a pipe or the like. Fails with the system's error. */
export async function send(out: string, data: string | Uint8Array): Promise<void> {
  if (out !== STANDARD_OUTPUT) return writeFile(out, data);
  if (process.stdout.destroyed) return readerLeft();
  const whole = typeof data !== 'string' ? data : (process.stdout.isTTY ? visibleText(data) : data) + (data.endsWith('\n') ? '' : '\n');
  await new Promise<void>((done, failed) => {
    process.stdout.write(whole, (error) => {
      if (error === null || error === undefined || (error as NodeJS.ErrnoException).code === 'EPIPE') done();
      else failed(error);
    });
  });
}

/** Why an output could not be written; `kept` says what became of the files. */
export function unwritable(out: string, error: unknown, kept = ''): Unusable {
  const { why, remedy } = cause(error, 'write');
  return new Unusable(`${out === STANDARD_OUTPUT ? 'Standard output' : out} cannot be written: ${why}. ${kept}${remedy}`);
}

/** Whoever reads our output may stop reading (`| head`): that is no failure, and ends the program when no file is being written. */
export function readerLeft(): void {
  if (!writing()) process.exit();
}

/** Errors of the planner are about the input. */
export async function usable<T>(file: string, work: Promise<T>): Promise<T> {
  try {
    return await work;
  } catch (error) {
    throw new Unusable(`${file}: ${(error as Error).message}`);
  }
}
