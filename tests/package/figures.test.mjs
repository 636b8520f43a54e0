// The figures of docs/papers are those of the CSV files beside them, and the pages show every one of them.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { fileURLToPath } from 'node:url';
import { curves, thinned } from '../../benches/papers/curves.mjs';
import { parse, write } from '../../benches/papers/csv.mjs';
import { drawn } from '../../benches/papers/figures.mjs';
import { tests as tested, verdict } from '../../benches/papers/report.mjs';

const PAGES = fileURLToPath(new URL('../../docs/papers', import.meta.url));

describe('the figures of the papers', () => {
  it('are those of the CSV files in the repository', async () => {
    const all = await drawn();
    const files = readdirSync(join(PAGES, 'figures')).filter((f) => f.endsWith('.svg')).sort();
    assert.deepEqual(files, Object.keys(all).map((name) => `${name}.svg`).sort());
    for (const [name, svg] of Object.entries(all)) {
      assert.equal(readFileSync(join(PAGES, 'figures', `${name}.svg`), 'utf8'), svg, `${name}: npm run bench -- papers --figures docs/papers/figures`);
    }
  });

  it('are on the pages, each with a text for people who cannot see it', () => {
    const pages = readdirSync(PAGES).filter((f) => f.endsWith('.md')).map((f) => readFileSync(join(PAGES, f), 'utf8')).join('\n');
    for (const file of readdirSync(join(PAGES, 'figures'))) assert.match(pages, new RegExp(`!\\[[^\\]]{20,}\\]\\(figures/${file}\\)`), file);
  });
});

describe('the kit', () => {
  it('joins the curves of runs: each keeps its last value until its next', () => {
    const names = ['length'];
    const runs = [{ names, rounds: [0, 4], values: [[8], [2]] }, { names, rounds: [0, 2, 4], values: [[6], [5], [4]] }];
    assert.deepEqual(curves(runs), [
      { round: 0, curve: 'length', mean: 7, least: 6, most: 8 },
      { round: 2, curve: 'length', mean: 6.5, least: 5, most: 8 },
      { round: 4, curve: 'length', mean: 3, least: 2, most: 4 },
    ]);
    assert.deepEqual(curves([null]), []);
    assert.deepEqual(thinned([0, 1, 3, 9, 12, 25, 26], 10), [0, 12, 25, 26]);
  });

  it('writes rows of several kinds to one CSV and reads them back', () => {
    const rows = [{ method: 'a', value: 1.5 }, { method: 'b, "c"', value: 2, more: 'x' }];
    assert.deepEqual(parse(write(rows)), [{ method: 'a', value: 1.5, more: '' }, rows[1]]);
  });

  it('calls nothing shorter or longer without a p below 0.05', () => {
    assert.deepEqual([verdict(0.049, 1), verdict(0.049, -1), verdict(0.05, 1)], ['more', 'less', 'not told apart']);
    const list = (name, add) => [name, Array.from({ length: 8 }, (_, k) => ({ seed: k + 1, value: k + add * (k + 1) }))];
    const [[, lead], same, longer] = [list('lead', 0), list('same', 0), list('longer', 1)];
    const found = tested([['lead', lead], same, longer]);
    assert.deepEqual(found.map((t) => t.verdict), ['not told apart', 'more']);
    // 2 / 2^8 for eight pairs of one sign, twice by Holm.
    assert.equal(found[1].p, 2 * (2 / 256));
    // Runs of other seeds are not pairs.
    assert.equal(tested([['lead', lead], ['other', lead.slice(1)]])[0], null);
  });
});
