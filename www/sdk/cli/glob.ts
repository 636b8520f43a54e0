/**
 * Patterns of file names, for shells that do not expand them and for patterns in quotes: `*` and `?` within a name, `[ab]`
 * for one of these characters, `**` for folders at any depth, and at the end for all files in them. Names that
 * begin with a dot match only patterns that do too.
 */

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const MAGIC = /[*?[]/;
const NOTHING = /(?!)/;

/** Whether a word may be a pattern. A file may have such a name too. */
export const isPattern = (word: string): boolean => MAGIC.test(word);

/** The files that these arguments name, sorted within each pattern, without duplicates. A pattern that matches nothing is kept as it is. */
export function filesOf(words: readonly string[]): string[] {
  const named = words.flatMap((word) => {
    if (!isPattern(word) || existsSync(word)) return [word];
    const found = matches(word);
    return found.length > 0 ? found : [word];
  });
  return [...new Set(named)];
}

function matches(pattern: string): string[] {
  // On Windows a backslash separates folders; elsewhere it is part of a name.
  const names = (process.platform === 'win32' ? pattern.replaceAll('\\', '/') : pattern).split('/');
  // The folder before the first pattern is used as it is: /, ../.., C:/.
  const first = names.findIndex((name) => MAGIC.test(name));
  if (names.at(-1) === '**') names.push('*');
  const found = new Set<string>();
  walk(first === 0 ? '' : `${names.slice(0, first).join('/')}/`, names.slice(first), found);
  return [...found].sort();
}

function walk(folder: string, [name, ...rest]: string[], found: Set<string>): void {
  if (name === undefined) return;
  if (name === '**') {
    walk(folder, rest, found);
    for (const entry of entries(folder)) if (entry.isDirectory() && !entry.name.startsWith('.')) walk(`${folder}${entry.name}/`, [name, ...rest], found);
    return;
  }
  const expression = expressionOf(name);
  for (const entry of entries(folder)) {
    if (!expression.test(entry.name) || (entry.name.startsWith('.') && !name.startsWith('.'))) continue;
    if (rest.length > 0) walk(`${folder}${entry.name}/`, rest, found);
    else if (!entry.isDirectory()) found.add(join(folder, entry.name));
  }
}

function entries(folder: string) {
  try {
    return readdirSync(folder === '' ? '.' : folder, { withFileTypes: true });
  } catch {
    // Something that is not a folder, or not readable, has no matching entries.
    return [];
  }
}

function expressionOf(name: string): RegExp {
  const parts = name.split(/(\*+|\?|\[!?[^\]]+\])/).map((part, k) => {
    if (k % 2 === 0) return part.replace(/[.+^${}()|[\]\\]/g, '\\$&');
    if (part.startsWith('*')) return '.*';
    if (part === '?') return '.';
    return part.replace(/^\[!/, '[^').replaceAll('\\', '\\\\');
  });
  try {
    return new RegExp(`^${parts.join('')}$`);
  } catch {
    // A range that runs backwards, as in [3-1], has no characters.
    return NOTHING;
  }
}
