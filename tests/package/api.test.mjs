// The reference of the package, and the guides that lead into it.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { describe, it } from 'node:test';
import * as kerfway from 'kerfway';
import { exportsOf } from '../../scripts/api/declarations.mjs';
import { FOLDER, pages } from '../../scripts/api.mjs';
import { ROOT } from './support.mjs';

const DOCS = join(ROOT, 'docs');
const SDK = join(ROOT, 'dist', 'sdk');
const ENTRIES = ['index.d.ts', 'element/index.d.ts', 'frame/host.d.ts', 'inline.d.ts'];
const guides = readdirSync(DOCS).filter((f) => f.endsWith('.md'));

describe('docs/api', () => {
  it('is what the types say now: npm run docs', () => {
    const written = pages();
    assert.deepEqual(readdirSync(FOLDER).sort(), [...written.keys()].sort());
    for (const [file, text] of written) assert.equal(readFileSync(join(FOLDER, file), 'utf8'), text, file);
  });

  it('tells all that the package exports, each with a sentence', () => {
    const page = readFileSync(join(FOLDER, 'kerfway.md'), 'utf8');
    for (const name of Object.keys(kerfway)) assert.match(page, new RegExp(`^### ${name}$`, 'm'));
    for (const entry of ENTRIES) {
      const silent = [...exportsOf(join(SDK, entry)).values()].filter((d) => d.doc === '').map((d) => d.name);
      assert.deepEqual(silent, [], entry);
    }
  });
});

describe('the documentation', () => {
  const pagesOf = [join(ROOT, 'README.md'), join(ROOT, 'examples', 'README.md'), ...guides.map((f) => join(DOCS, f)), ...readdirSync(FOLDER).map((f) => join(FOLDER, f))];

  /** Places within a page that can be led to, as those who show Markdown number them. */
  const anchors = (text) => {
    const seen = new Map();
    return [...text.replace(/^```.*?^```/gms, '').matchAll(/^#+ (.*)$/gm)].map(([, heading]) => {
      const key = heading.toLowerCase().replace(/[^\w\- ]/g, '').replaceAll(' ', '-');
      const n = seen.get(key) ?? 0;
      seen.set(key, n + 1);
      return n === 0 ? key : `${key}-${n}`;
    });
  };

  it('leads nowhere that is not there', () => {
    for (const file of pagesOf) {
      const text = readFileSync(file, 'utf8');
      const links = [...text.matchAll(/\]\((?!https?:)([^)\s]+)\)/g), ...text.matchAll(/<a href="([^"]+)"/g)].map((m) => m[1]);
      for (const link of links) {
        const [path, anchor] = link.split('#');
        const target = path === '' ? file : resolve(dirname(file), path);
        assert.ok(existsSync(target), `${file}: ${link}`);
        if (anchor) assert.ok(anchors(readFileSync(target, 'utf8')).includes(anchor), `${file}: ${link}`);
      }
    }
  });

  it('tells every field of the report of a quote', () => {
    const schema = JSON.parse(readFileSync(join(SDK, 'quote.schema.json'), 'utf8'));
    const text = readFileSync(join(DOCS, 'quote.md'), 'utf8');
    for (const name of Object.keys(schema.properties)) assert.match(text, new RegExp(`^\\|.*\`${name}\``, 'm'), name);
  });

  it('tells every field of a machine profile, and every preset', async () => {
    const planner = await kerfway.createPlanner();
    planner.close();
    const text = readFileSync(join(DOCS, 'machines.md'), 'utf8');
    for (const machine of planner.machines) {
      assert.match(text, new RegExp(`\`${machine.name}\``), machine.name);
      for (const name of Object.keys(machine)) assert.match(text, new RegExp(`^\\|.*\`${name}\``, 'm'), name);
    }
  });
});
