/**
 * Writes output files atomically. A G-code program that ends in the middle can leave the beam on, so no file is written in
 * place: the bytes go to a temporary file in the same folder, are flushed to the disk, and then the file is renamed. All
 * outputs of a drawing are prepared before the first is renamed, so a failure leaves all files as they were. While several are
 * renamed, no other program renames files there.
 *
 * Files are written by synchronous calls, so that a signal is handled before or after, when all temporary files are known.
 */

import {
  accessSync, closeSync, constants, fchmodSync, fchownSync, fstatSync, fsyncSync, linkSync, openSync, renameSync, rmSync, writeSync, type BigIntStats,
} from 'node:fs';
import { dirname, sep } from 'node:path';
import { send, unwritable } from './io.js';
import { locked } from './lock.js';
import { STANDARD_OUTPUT, targetOf, type Target } from './target.js';
import { temporaryBeside, turn, withTemporaries } from './temporary.js';

/** Permission bits of a file's mode, and those of setuid, setgid and the sticky bit. */
const PERMISSIONS = 0o7777n;

/** What a failure leaves, in a sentence. */
const UNCHANGED = 'No file was changed. ';

/** Data to write, and the file name that the person gave. */
export interface Writing {
  out: string;
  data: string | Uint8Array;
}

/** A temporary file that contains an output. */
interface Prepared {
  out: string;
  target: Target;
  temporary: string;
}

/** Writes all outputs, or changes no file and throws a sentence that says so. */
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
      await locked(prepared.length > 1 ? prepared.map(({ target }) => dirname(target.path)) : [], async () => {
        // A pending signal ends the program here, before any file has been replaced.
        await turn();
        rename(prepared, (current) => (out = current));
      });
    } catch (error) {
      throw unwritable(out, error, UNCHANGED);
    }
  });
}

/** Fails as `writeAll` would, if this output, or any in its folder, cannot be written as things are now: no search is made for nothing. */
export function checkWritable(out: string, folderOnly: boolean): void {
  try {
    const { path, stat, replaceable } = targetOf(out);
    if (stat !== null && !folderOnly) accessSync(path, constants.W_OK);
    if (replaceable) accessSync(`${dirname(path)}${sep}.`, constants.W_OK);
  } catch (error) {
    throw unwritable(out, error, UNCHANGED);
  }
}

function prepare({ path, stat }: Target, data: string | Uint8Array): string {
  // A read-only file is refused here: renaming would replace it, because that depends on the permissions of the folder only.
  if (stat !== null) accessSync(path, constants.W_OK);
  const temporary = temporaryBeside(path);
  // The data of a private file must never be readable by others, not even for a moment.
  const file = openSync(temporary, 'wx', stat === null ? 0o666 : 0o600);
  try {
    writeWhole(file, typeof data === 'string' ? Buffer.from(data) : data);
    if (stat !== null) copyOwnership(file, stat);
    fsyncSync(file);
  } finally {
    closeSync(file);
  }
  return temporary;
}

function writeWhole(file: number, bytes: Uint8Array): void {
  for (let at = 0; at < bytes.length; ) at += writeSync(file, bytes, at);
}

/** Gives a file the owner and the permissions of the file that it replaces. */
function copyOwnership(file: number, { uid, gid, mode }: BigIntStats): void {
  const own = fstatSync(file, { bigint: true });
  if (own.uid !== uid || own.gid !== gid) {
    try {
      fchownSync(file, Number(uid), Number(gid));
    } catch {
      // Only an administrator may change the owner of a file.
    }
  }
  fchmodSync(file, Number(mode & PERMISSIONS));
}

// A rename seldom fails at this point: the file is protected, or a folder has its name now. The renames before it are undone.
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

/** Gives a file a second name; `null` on disks without hard links. */
function linked(path: string): string | null {
  const name = temporaryBeside(path);
  try {
    linkSync(path, name);
    return name;
  } catch {
    return null;
  }
}

/** Flushes a folder, so that new names survive a loss of power, on systems that allow it. */
function flushFolder(folder: string): void {
  try {
    const open = openSync(folder, 'r');
    try {
      fsyncSync(open);
    } finally {
      closeSync(open);
    }
  } catch {
    // Windows and some network shares do not allow it, and keep names without it.
  }
}
