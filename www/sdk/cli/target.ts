/** The file that an output name leads to: follows links, and compares files by their identity instead of their names. */

import { fstatSync, lstatSync, readlinkSync, realpathSync, statSync, type BigIntStats, type Stats } from 'node:fs';
import { basename, dirname, isAbsolute, join, resolve, sep } from 'node:path';

/** The name of standard output on the command line, and of standard input where a file is read. */
export const STANDARD_OUTPUT = '-';
export const STANDARD_INPUT = '-';

/** The most links in a row: the same number as in Linux. */
const MOST_LINKS = 40;

/** Paths of open file descriptors, such as the one that `/dev/stdout` leads to. */
const DESCRIPTOR = /^(\/proc\/.*\/fd|\/dev\/fd)\/[^/]+$/;

/** A file that exists or will be made. */
export interface Target {
  /** Its path, without links. */
  path: string;
  /** The existing file; `null` if there is none. */
  stat: BigIntStats | null;
  /** Whether another file can replace it. Devices, pipes and the like cannot be replaced and are written directly. */
  replaceable: boolean;
}

/** Follows the links of a name. Throws the system's error for links in a circle and for folders without permission. */
export function targetOf(name: string): Target {
  const path = followed(name);
  const stat = statSync(path, { bigint: true, throwIfNoEntry: false }) ?? null;
  return { path, stat, replaceable: !DESCRIPTOR.test(path) && (stat === null || stat.isFile()) };
}

/**
 * A text that is equal for all names of the same file. Existing files are identified by device and inode, which is
 * independent of links of both kinds and of upper and lower case; other files by their path without links. `null` for
 * terminals and `/dev/null`, which several outputs may use.
 */
export function identityOf(name: string): string | null {
  try {
    const { path, stat } = name === STANDARD_OUTPUT ? { path: name, stat: fstatSync(1, { bigint: true }) } : targetOf(name);
    if (stat === null || stat.ino === 0n) return path;
    return stat.isCharacterDevice() ? null : `${stat.dev}:${stat.ino}`;
  } catch {
    // A name that cannot be followed cannot be read or written either; the attempt reports it.
    return resolve(name);
  }
}

/** The same for an input; `null` for streams, which an output cannot overwrite. */
export function identityOfInput(name: string): string | null {
  return name === STANDARD_INPUT || lookAt(name)?.isFile() === false ? null : identityOf(name);
}

/** The file with this name; `null` if there is none, or if it must not be seen. */
export function lookAt(name: string): Stats | null {
  try {
    return statSync(name);
  } catch {
    return null;
  }
}

// A dangling link has no real path, so links are followed one by one. The system resolves the folders, because `..` after
// a link is not the folder that the text suggests.
function followed(name: string): string {
  let path = name;
  for (let links = 0; links < MOST_LINKS; links++) {
    path = join(realFolder(dirname(path)), basename(path));
    if (DESCRIPTOR.test(path) || lstatSync(path, { throwIfNoEntry: false })?.isSymbolicLink() !== true) return path;
    const link = readlinkSync(path);
    path = isAbsolute(link) ? link : `${dirname(path)}${sep}${link}`;
  }
  return realpathSync.native(name);
}

// For a folder that does not exist yet, resolves the part that exists.
function realFolder(folder: string): string {
  try {
    return realpathSync.native(folder);
  } catch (error) {
    const above = dirname(folder);
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT' || above === folder) throw error;
    return join(realFolder(above), basename(folder));
  }
}
