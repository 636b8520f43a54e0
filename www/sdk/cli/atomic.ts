/**
 * Output files that are replaced whole or not at all. A program of G-code that ends in the middle can leave the beam on, so no output
 * is ever written in place: its bytes go to a temporary file in the same folder and are flushed to the disk, then that file takes
 * the name. Outputs of one drawing are all prepared before the first is renamed, so a failure leaves all files as they were.
 *
 * Files are written by synchronous calls, so that a signal is handled before or after, when the temporary files are known.
 */

import {
  accessSync, closeSync, constants, fchmodSync, fchownSync, fstatSync, fsyncSync, linkSync, openSync, renameSync, rmSync, writeSync, type BigIntStats,
} from 'node:fs';
import { dirname } from 'node:path';
import { send, unwritable } from './io.js';
import { STANDARD_OUTPUT, targetOf, type Target } from './target.js';
import { temporaryBeside, turn, withTemporaries } from './temporary.js';

/** Permission bits of a file's mode, and those of setuid, setgid and the sticky bit. */
const PERMISSIONS = 0o7777n;

/** Something to write, and the name the person gave it. */
export interface Writing {
  out: string;
  data: string | Uint8Array;
}

/** A temporary file that holds an output. */
interface Prepared {
  out: string;
  target: Target;
  temporary: string;
}

/** Writes all of these, or changes no file and throws a sentence that says so. */
export async function writeAll(writings: readonly Writing[]): Promise<void> {
  const streams: Writing[] = [];
  const prepared: Prepared[] = [];
  let out = '';
  await withTemporaries(async () => {
    try {
      for (const writing of writings) {
        out = writing.out;
        const target = out === STANDARD_OUTPUT ? null : targetOf(out);
        if (target?.replaceable === true) prepared.push({ out, target, temporary: prepare(target, writing.data) });
        else streams.push(writing);
      }
      for (const stream of streams) {
        out = stream.out;
        await send(out, stream.data);
      }
      // A signal that came meanwhile ends the program here, while the old files are all there.
      await turn();
      rename(prepared, (current) => (out = current));
    } catch (error) {
      throw unwritable(out, error, 'No file was changed. ');
    }
  });
}

function prepare({ path, stat }: Target, data: string | Uint8Array): string {
  // A file that is protected against writing could be replaced all the same, as that is a matter of its folder.
  if (stat !== null) accessSync(path, constants.W_OK);
  const temporary = temporaryBeside(path);
  // What was private must not be readable by others for a moment.
  const file = openSync(temporary, 'wx', stat === null ? 0o666 : 0o600);
  try {
    writeWhole(file, typeof data === 'string' ? Buffer.from(data) : data);
    if (stat !== null) resemble(file, stat);
    fsyncSync(file);
  } finally {
    closeSync(file);
  }
  return temporary;
}

function writeWhole(file: number, bytes: Uint8Array): void {
  for (let at = 0; at < bytes.length; ) at += writeSync(file, bytes, at);
}

/** Gives a file the owner and the permissions of the one it takes the place of. */
function resemble(file: number, { uid, gid, mode }: BigIntStats): void {
  const own = fstatSync(file, { bigint: true });
  if (own.uid !== uid || own.gid !== gid) {
    try {
      fchownSync(file, Number(uid), Number(gid));
    } catch {
      // Only an administrator may give files away.
    }
  }
  fchmodSync(file, Number(mode & PERMISSIONS));
}

// A file that cannot be renamed is rare by now: it is protected, or a folder took its name. What was renamed before it goes back.
function rename(all: readonly Prepared[], at: (out: string) => void): void {
  const undo: (() => void)[] = [];
  try {
    for (const { out, target: { path, stat }, temporary } of all) {
      at(out);
      const backup = all.length > 1 && stat !== null ? linked(path) : null;
      renameSync(temporary, path);
      undo.push(() => (backup !== null ? renameSync(backup, path) : stat === null ? rmSync(path) : undefined));
    }
  } catch (error) {
    for (const step of undo.reverse()) step();
    throw error;
  }
  for (const folder of new Set(all.map(({ target }) => dirname(target.path)))) flushFolder(folder);
}

/** A second name for a file; `null` where the disk knows no such thing. */
function linked(path: string): string | null {
  const name = temporaryBeside(path);
  try {
    linkSync(path, name);
    return name;
  } catch {
    return null;
  }
}

/** Makes new names last through a loss of power, where the system lets folders be flushed. */
function flushFolder(folder: string): void {
  try {
    const open = openSync(folder, 'r');
    try {
      fsyncSync(open);
    } finally {
      closeSync(open);
    }
  } catch {
    // Windows and some shares do not: they keep names by themselves.
  }
}
