/** Files in and out, and the two ways a command can fail. */

import { readFile, writeFile } from 'node:fs/promises';

/** The input cannot be used: exit 1. One sentence: what, where, what to do. */
export class Unusable extends Error {}

/** The command line cannot be understood: exit 2. */
export class WrongUse extends Error {}

const WHY: Record<string, string> = {
  ENOENT: 'there is no such file',
  ENOTDIR: 'there is no such folder',
  EISDIR: 'that is a folder, not a file',
  EACCES: 'the system does not allow it',
  EPERM: 'the system does not allow it',
  ENOSPC: 'the disk is full',
  ERR_FS_FILE_TOO_LARGE: 'the file is larger than 2 GB',
};

function why(error: unknown): string {
  const code = (error as NodeJS.ErrnoException).code ?? '';
  return WHY[code] ?? `the system says ${code || String(error)}`;
}

/** The bytes of a file. */
export async function bytesOf(file: string): Promise<Uint8Array> {
  try {
    return await readFile(file);
  } catch (error) {
    throw new Unusable(`${file} cannot be read: ${why(error)}.`);
  }
}

/** Writes to a file, or to standard output for `-`. */
export async function put(out: string, data: string | Uint8Array): Promise<void> {
  if (out === '-') {
    const end = typeof data === 'string' && !data.endsWith('\n') ? '\n' : '';
    await new Promise<void>((done) => {
      if (typeof data === 'string') process.stdout.write(data + end, () => done());
      else process.stdout.write(data, () => done());
    });
    return;
  }
  try {
    await writeFile(out, data);
  } catch (error) {
    throw new Unusable(`${out} cannot be written: ${why(error)}.`);
  }
}

/** Errors of the planner are about the input. */
export async function usable<T>(file: string, work: Promise<T>): Promise<T> {
  try {
    return await work;
  } catch (error) {
    throw new Unusable(`${file}: ${(error as Error).message}`);
  }
}
