// All texts of the page are in www/app/core/words, so that another language is another file there.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { it } from 'node:test';
import { ROOT } from './support.mjs';

const APP = join(ROOT, 'www', 'app');

const sources = readdirSync(APP, { recursive: true })
  .map((file) => join(APP, file))
  .filter((file) => /\.ts$/.test(file) && !/core\/words\/|offline\/|vite\.config/.test(file));

/** Literals of a source without its comments and imports. */
function literals(text) {
  const code = text.replace(/\/\*[\s\S]*?\*\//g, '').replace(/(^|\s)\/\/.*$/gm, '').replace(/^import [^;]*;$/gm, '').replace(/^} from .*$/gm, '');
  return [...code.matchAll(/'((?:[^'\\\n]|\\.)*)'|"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`/g)].map(([, ...m]) => m.find((x) => x !== undefined).replace(/\$\{[^}]*\}/g, '…'));
}

/** Names of keys and of things of the browser, classes (so all in small letters), selectors, style: nobody reads them. */
const NOT_READ = /^(button, |…px |Arrow|Ctrl\+|Shift\+|Enter$|Escape$|Home$|End$|Files$|Kerfway$|AC10|R1[234]$|R20|[a-z-]+( [a-z-]+)*$|.*[{}[\]#>=;(]|\d|[a-z]+\/[a-z])/;

it('texts of the page are in the word files only', () => {
  const found = sources.flatMap((file) =>
    literals(readFileSync(file, 'utf8'))
      // Two words, or one that begins like a sentence or a label.
      .filter((text) => /[A-Za-z]{2,}[.,:]? [A-Za-z]{2,}|^[A-Z][a-z]{2,}/.test(text) && !NOT_READ.test(text))
      .map((text) => `${relative(APP, file)}: ${text}`));
  assert.deepEqual(found, []);
});

it('every entry of the word files is used', () => {
  const all = sources.map((file) => readFileSync(file, 'utf8')).join('\n');
  const en = readFileSync(join(APP, 'core', 'words', 'en.ts'), 'utf8');
  const sections = [...en.matchAll(/^ {2}(\w+): \{([\s\S]*?)^ {2}\},$|^ {2}(\w+): \{(.*)\},$/gm)];
  assert.ok(sections.length > 12);
  for (const [, long, body, short, line] of sections) {
    const [name, text] = [long ?? short, body ?? line];
    for (const [, key] of text.matchAll(/(?:^|[,{\n]) *(\w+): (?:['"{[]|\()/g)) {
      const nested = new RegExp(`words\\.\\w+\\.\\w+(\\.${key}\\b|\\[)`);
      assert.ok(all.includes(`words.${name}.${key}`) || nested.test(all) || new RegExp(`words\\.${name}\\[`).test(all), `${name}.${key}`);
    }
  }
});
