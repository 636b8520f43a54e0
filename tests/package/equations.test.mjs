// docs/papers/equations.md: every file, name, line and test it lists exists, and every equation of the papers has its row.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { withLines } from '../../scripts/equations.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const rust = (folder) =>
  readdirSync(join(ROOT, folder), { recursive: true }).filter((f) => f.endsWith('.rs')).map((f) => readFileSync(join(ROOT, folder, f), 'utf8')).join('\n');

const text = readFileSync(join(ROOT, 'docs', 'papers', 'equations.md'), 'utf8');
const rows = text.split('\n').filter((l) => /^\| [^|-]/.test(l) && !l.startsWith('| equation')).map((l) => l.split('|').slice(1, 6).map((c) => c.trim()));
const names = (cell) => [...cell.matchAll(/`([^`]+)`/g)].map(([, name]) => name);

describe('the page of equations', () => {
  it('names files, functions and tests that exist', () => {
    const all = `${rust('src')}\n${rust('tests/it')}`;
    assert.ok(rows.length > 50, String(rows.length));
    for (const [what, file, name, tests] of rows) {
      if (file === 'none') continue;
      const source = readFileSync(join(ROOT, 'src', 'solve', ...names(file)[0].split('/')), 'utf8');
      for (const n of names(name)) assert.match(source, new RegExp(`\\b(fn|struct|enum|trait|type) ${n}\\b`), `${what}: ${n} in ${file}`);
      assert.ok(names(tests).length > 0, `${what} has a test`);
      for (const t of names(tests)) assert.match(all, new RegExp(`#\\[test\\]\\s*(#\\[[^\\]]*\\]\\s*)*fn ${t}\\(`), `${what}: ${t}`);
    }
  });

  it('names the lines of today', () => {
    assert.equal(text, withLines(text), 'node scripts/equations.mjs writes them anew');
  });

  it('has a row for every numbered equation', () => {
    const sections = text.split('\n## ').slice(1);
    for (const [title, last] of [['Qu & Du', 27], ['Liu & Chang', 11], ['Yang', 3]]) {
      const section = sections.find((s) => s.startsWith(title));
      const first = section.split('\n').filter((l) => l.startsWith('| (') || l.includes('(')).map((l) => l.split('|')[1] ?? '').join(' ');
      const covered = new Set();
      for (const [, a, b] of first.matchAll(/\((\d+)\)(?:-\((\d+)\))?/g)) for (let k = Number(a); k <= Number(b ?? a); k += 1) covered.add(k);
      for (let k = 1; k <= last; k += 1) assert.ok(covered.has(k), `${title} (${k})`);
    }
  });
});
