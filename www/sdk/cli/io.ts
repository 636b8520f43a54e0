/** Reads files, writes streams, and defines the two ways in which a command can fail. `atomic.ts` writes output files. */

import { fstatSync } from 'node:fs';
import { open, writeFile, type FileHandle } from 'node:fs/promises';
import { KerfwayError, reportOf } from '../errors.js';
import type { ErrorReport } from '../generated/types.js';
import { basename } from 'node:path';
import { endless, MAX_BYTES, tooLarge } from '../size.js';
import { isPattern } from './glob.js';
import { visibleText } from './safe-text.js';
import { STANDARD_INPUT, STANDARD_OUTPUT } from './target.js';

/** The exit codes of the program. `some`: of several files, some failed and the others were processed; `all`: all of several failed. */
export const EXIT = { unusable: 1, wrongUse: 2, unwritable: 3, some: 4, all: 5 } as const;

/** The input cannot be used. The message is one sentence: what, where, what to do. */
export class Unusable extends Error {
  readonly exit: number = EXIT.unusable;

  /**
   * `report`: the error for programs, if it is known better than that a file cannot be read; `null`: programs have been told by a document of the
   * command's own.
   */
  constructor(
    message: string,
    readonly report: ErrorReport | null = new KerfwayError('unreadable-file', message).toJSON(),
  ) {
    super(message);
  }
}

/** An output cannot be written. */
export class Unwritable extends Unusable {
  override readonly exit = EXIT.unwritable;

  constructor(message: string) {
    super(message, new KerfwayError('unwritable-output', message).toJSON());
  }
}

/** The arguments cannot be understood. */
export class WrongUse extends Error {}

/** Why the system refuses a file, and what to do about it if it is an output. */
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
  EBADF: { why: 'it is not open for that', remedy: ELSEWHERE },
  EBUSY: { why: 'another program holds it, or it is a mount of its own', remedy: ELSEWHERE },
  EROFS: { why: 'the disk can only be read', remedy: ELSEWHERE },
  ENOSPC: { why: 'the disk is full', remedy: ROOM },
  EDQUOT: { why: 'there is no room left for this user', remedy: ROOM },
  EFBIG: { why: 'the file would be larger than the system allows', remedy: 'Raise the limit (ulimit -f), or name a place on another disk.' },
};

/** Explains an error of the system. An output file need not exist before, but its folder must. */
function cause(error: unknown, doing: 'read' | 'write'): Cause {
  const code = (error as NodeJS.ErrnoException).code ?? '';
  const known = CAUSES[doing === 'write' && code === 'ENOENT' ? 'ENOTDIR' : code];
  return known ?? { why: `the system says ${code || String(error)}`, remedy: ELSEWHERE };
}

/** The name of a drawing in reports and outputs. */
export function nameOf(file: string): string {
  return file === STANDARD_INPUT ? 'standard input' : basename(file);
}

/** A file that is read, at the beginning of a sentence. */
export function subject(file: string): string {
  return file === STANDARD_INPUT ? 'Standard input' : file;
}

/** What comes a second time from standard input is empty. */
let standardInputIsRead = false;

/** Reads a file, or standard input (`-`). A file above the size limit is not read to its end. */
export async function bytesOf(file: string): Promise<Uint8Array> {
  let handle: FileHandle | undefined;
  try {
    if (file === STANDARD_INPUT) {
      // Node's stream of a folder is empty.
      if (standardInputIsRead) throw new Unusable('Standard input was read already: name one of the files that are read from it.');
      standardInputIsRead = true;
      if (fstatSync(0).isDirectory()) throw Object.assign(new Error(), { code: 'EISDIR' });
      return await upToLimit(file, process.stdin);
    }
    handle = await open(file);
    const stat = await handle.stat();
    const refused = tooLarge(stat.size);
    if (refused !== null) throw new Unusable(`${file}: ${refused}`);
    // Pipes, devices and the files of /proc have no size before they are read.
    if (stat.isFile() && stat.size > 0) return await handle.readFile();
    return await upToLimit(file, handle.createReadStream({ autoClose: false }));
  } catch (error) {
    if (error instanceof Unusable) throw error;
    if (isPattern(file) && (error as NodeJS.ErrnoException).code === 'ENOENT') throw new Unusable(`No file matches the pattern ${file}.`);
    throw new Unusable(`${subject(file)} cannot be read: ${cause(error, 'read').why}.`);
  } finally {
    await handle?.close();
  }
}

/** The text of a file with JSON: UTF-8, or the UTF-16 in which Windows PowerShell stores what a command prints. */
export async function textOf(file: string): Promise<string> {
  const bytes = await bytesOf(file);
  return new TextDecoder(bytes[0] === 0xff && bytes[1] === 0xfe ? 'utf-16le' : 'utf-8').decode(bytes);
}

/** Reads the stream of a file to its end. */
async function upToLimit(file: string, stream: AsyncIterable<unknown>): Promise<Uint8Array> {
  const chunks: Uint8Array[] = [];
  let length = 0;
  for await (const chunk of stream as AsyncIterable<Uint8Array>) {
    chunks.push(chunk);
    length += chunk.length;
    if (length > MAX_BYTES) throw new Unusable(`${subject(file)}: ${endless()}`);
  }
  return Buffer.concat(chunks);
}

/** The document that a failure has in place of a result, for programs that read JSON from standard output. */
export function failureDocument(file: string | null, error: ErrorReport): string {
  return `${JSON.stringify({ schema: 'kerfway.error/1', file, error })}\n`;
}

/** Prints on standard output. */
export async function print(text: string): Promise<void> {
  try {
    await send(STANDARD_OUTPUT, text);
  } catch (error) {
    throw unwritable(STANDARD_OUTPUT, error);
  }
}

/** Writes to standard output (`-`), or to a device, a pipe or the like. Fails with the system's error. */
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

/** The failure of an output that could not be written. `kept` is a sentence about the state of the files. */
export function unwritable(out: string, error: unknown, kept = ''): Unwritable {
  const { why, remedy } = cause(error, 'write');
  return new Unwritable(`${out === STANDARD_OUTPUT ? 'Standard output' : out} cannot be written: ${why}. ${kept}${remedy}`);
}

/** Whether the work is for more than the reader of standard output: files are written, or the exit code is a verdict. */
let isForOthers = false;

/** From now on the work goes on when the reader of standard output has gone. */
export function goesOnWithoutReader(): void {
  isForOthers = true;
}

/** Handles a reader of standard output that has closed it (`| head`). This is not a failure, and ends the program if its work was for that reader only. */
export function readerLeft(): void {
  if (!isForOthers) process.exit();
}

/** Awaits work of the planner, whose errors are about the input. `written` puts a sentence into the words of the command line. */
export async function usable<T>(file: string, work: Promise<T>, written = (sentence: string) => sentence): Promise<T> {
  try {
    return await work;
  } catch (error) {
    const report = reportOf(error);
    // The core does not know by what name the option is given here.
    const option = report.code === 'off-bed' ? ' (--allow-off-bed)' : '';
    throw new Unusable(`${subject(file)}: ${written((error as Error).message)}${option}`, report);
  }
}
