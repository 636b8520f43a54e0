// The reference of the package and the guides.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { describe, it } from 'node:test';
import * as kerfway from 'kerfway';
import { ROOT } from './support.mjs';

const DOCS = join(ROOT, 'docs');
const SDK = join(ROOT, 'dist', 'sdk');

const markdownIn = (folder) => readdirSync(folder).filter((f) => f.endsWith('.md')).map((f) => join(folder, f));

describe('docs/api', () => {
  it('is up to date, and every exported name has a sentence: npm run docs', () => {
    const { status, stderr } = spawnSync(process.execPath, [join(ROOT, 'scripts', 'docs.mjs'), '--check'], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
  });

  it('describes every export of the package', () => {
    const page = readFileSync(join(DOCS, 'api', 'kerfway.md'), 'utf8');
    for (const name of Object.keys(kerfway)) assert.match(page, new RegExp(`^### ${name.replaceAll('_', '\\\\?_')}(\\(\\))?$`, 'm'));
  });
});

it('the types of the elements for JSX and templates lacked attributes that the documents name', () => {
  const page = readFileSync(join(DOCS, 'embedding.md'), 'utf8');
  const types = readFileSync(join(SDK, 'element', 'attributes.d.ts'), 'utf8');
  const named = [...page.matchAll(/^\| Attributes \|([^|]+)\|/gm)].flatMap(([, row]) => [...row.matchAll(/`([\w-]+)`/g)].map(([, name]) => name));
  assert.ok(named.length >= 12, named.join());
  assert.deepEqual(named.filter((name) => !new RegExp(`^ *'?${name}'?\\?:`, 'm').test(types)), []);
});

it('the types for CommonJS lacked half of the functions', async () => {
  for (const [file, exported] of [['node-types.d.cts', kerfway], ['portable-types.d.cts', await import('kerfway/portable')]]) {
    const declared = [...readFileSync(join(SDK, file), 'utf8').matchAll(/^export declare const (\w+)/gm)].map(([, name]) => name);
    assert.deepEqual(declared.sort(), Object.keys(exported).sort(), file);
  }
});

describe('the documentation', () => {
  const pagesOf = [ROOT, join(ROOT, 'examples'), DOCS, join(DOCS, 'api'), join(DOCS, 'internals')].filter(existsSync).flatMap(markdownIn);

  /** The anchors of a page: its headings, numbered as GitHub numbers them, and those written in HTML. */
  const anchors = (text) => {
    const seen = new Map();
    const headings = [...text.replace(/^```.*?^```/gms, '').matchAll(/^#+ (.*)$/gm)].map(([, heading]) => {
      const key = heading.toLowerCase().replace(/[^\w\- ]/g, '').replaceAll(' ', '-');
      const n = seen.get(key) ?? 0;
      seen.set(key, n + 1);
      return n === 0 ? key : `${key}-${n}`;
    });
    return [...headings, ...[...text.matchAll(/<a id="([^"]+)">/g)].map(([, id]) => id)];
  };

  it('has no broken link', () => {
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

  it('describes every field of the quote report', () => {
    const schema = JSON.parse(readFileSync(join(SDK, 'quote.schema.json'), 'utf8'));
    const text = readFileSync(join(DOCS, 'quote.md'), 'utf8');
    for (const name of Object.keys(schema.properties)) assert.match(text, new RegExp(`^\\|.*\`${name}\``, 'm'), name);
  });

  it('describes every field of a machine profile, and every preset', async () => {
    const planner = await kerfway.createPlanner();
    planner.close();
    const text = readFileSync(join(DOCS, 'machines.md'), 'utf8');
    for (const machine of planner.machines) {
      assert.match(text, new RegExp(`\`${machine.name}\``), machine.name);
      for (const name of Object.keys(machine)) assert.match(text, new RegExp(`^\\|.*\`${name}\``, 'm'), name);
    }
  });
});
