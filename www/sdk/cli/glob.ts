/**
 * Patterns of file names, for shells that know none and for patterns in quotes: `*` and `?` within a name, `[ab]` one of
 * these, `**` folders at any depth. Names that begin with a dot must be asked for.
 */

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const MAGIC = /[*?[]/;

/** The files these words name, sorted within each pattern, each once. What matches nothing stays as it is. */
export function filesOf(words: readonly string[]): string[] {
  const named = words.flatMap((word) => {
    if (!MAGIC.test(word) || existsSync(word)) return [word];
    const found = matches(word);
    return found.length > 0 ? found : [word];
  });
  return [...new Set(named)];
}

function matches(pattern: string): string[] {
  // On Windows people write backslashes; elsewhere they are part of a name.
  const names = (process.platform === 'win32' ? pattern.replaceAll('\\', '/') : pattern).split('/');
  // What comes before the first pattern is a folder as it stands: /, ../.., C:/.
  const first = names.findIndex((name) => MAGIC.test(name));
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
    // Not a folder, or not ours to read: it holds nothing that matches.
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
  return new RegExp(`^${parts.join('')}$`);
}
