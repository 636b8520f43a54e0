// node scripts/equations.mjs: writes into docs/papers/equations.md the line at which each function or type of the page is defined.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from './tools.mjs';

const PAGE = join(ROOT, 'docs', 'papers', 'equations.md');

/** A row of the page: the cells before the file, the file, the names in it, and the rest. */
const ROW = /^(\|[^|]*\|) `([\w/]+\.rs)` \|([^|]*)\|/;

/** The line of a source at which a function or type is defined, from 1; 0 if it is not. */
const lineOf = (source, name) => source.split('\n').findIndex((line) => new RegExp(`\\b(fn|struct|enum|trait|type) ${name}\\b`).test(line)) + 1;

/** The text of the page with the lines as they are now. */
export function withLines(text) {
  return text.split('\n').map((row) => row.replace(ROW, (whole, before, file, cell) => {
    const names = [...cell.matchAll(/`([^`]+)`/g)].map(([, name]) => name);
    const source = readFileSync(join(ROOT, 'src', 'solve', ...file.split('/')), 'utf8');
    const linked = names.map((name) => `[\`${name}\`](../../src/solve/${file}#L${lineOf(source, name)}) line ${lineOf(source, name)}`);
    return names.length === 0 ? whole : `${before} \`${file}\` | ${linked.join(', ')} |`;
  })).join('\n');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) writeFileSync(PAGE, withLines(readFileSync(PAGE, 'utf8')));
