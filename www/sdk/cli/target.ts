/** Where an output goes in the end: behind all links, and compared with other files by what they are instead of by name. */

import { fstatSync, lstatSync, readlinkSync, realpathSync, statSync, type BigIntStats, type Stats } from 'node:fs';
import { basename, dirname, isAbsolute, join, resolve, sep } from 'node:path';

/** The name of standard output. */
export const STANDARD_OUTPUT = '-';

/** As many links in a row as Linux follows. */
const MOST_LINKS = 40;

/** Open files of a process by their numbers: `/dev/stdout` leads to one. */
const DESCRIPTOR = /^(\/proc\/.*\/fd|\/dev\/fd)\/[^/]+$/;

/** A file that is there, or is to be made. */
export interface Target {
  /** Its path, without links. */
  path: string;
  /** What is there; `null`: nothing yet. */
  stat: BigIntStats | null;
  /** It can be replaced by another file; otherwise it is a device, a pipe or the like, and is written directly. */
  replaceable: boolean;
}

/** Follows a name to its end. Throws the system's error for links that lead in circles and folders that may not be seen. */
export function targetOf(name: string): Target {
  const path = followed(name);
  const stat = statSync(path, { bigint: true, throwIfNoEntry: false }) ?? null;
  return { path, stat, replaceable: !DESCRIPTOR.test(path) && (stat === null || stat.isFile()) };
}

/**
 * What two names of one output have in common. Files that are there are told by device and inode, which see through links of both kinds and
 * through upper and lower case; others by their path without links. `null` for what may be named twice: terminals and `/dev/null`.
 */
export function identityOf(name: string): string | null {
  try {
    const { path, stat } = name === STANDARD_OUTPUT ? { path: name, stat: fstatSync(1, { bigint: true }) } : targetOf(name);
    if (stat === null || stat.ino === 0n) return path;
    return stat.isCharacterDevice() ? null : `${stat.dev}:${stat.ino}`;
  } catch {
    // What cannot be followed cannot be read or written either: that is reported when it is tried.
    return resolve(name);
  }
}

/** The same of an input; `null` for streams, which nothing can be written over. */
export function identityOfInput(name: string): string | null {
  return lookAt(name)?.isFile() === false ? null : identityOf(name);
}

/** What is there under a name; `null` when nothing is, or nothing that may be seen. */
export function lookAt(name: string): Stats | null {
  try {
    return statSync(name);
  } catch {
    return null;
  }
}

// A link that leads nowhere yet has no real path, so links are followed one by one. The system resolves the folders: `..` behind
// a link is not what it looks like.
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

// Of a folder that is yet to be made, the part that is there.
function realFolder(folder: string): string {
  try {
    return realpathSync.native(folder);
  } catch (error) {
    const above = dirname(folder);
    if ((error as NodeJS.ErrnoException).code !== 'ENOENT' || above === folder) throw error;
    return join(realFolder(above), basename(folder));
  }
}
