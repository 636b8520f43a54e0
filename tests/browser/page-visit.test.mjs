// What a first visit transfers: each file once, and no more than the budget of the build.

import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { test } from 'node:test';
import { BUDGETS } from '../../scripts/build.mjs';
import { DIST, ROOT } from '../../scripts/tools.mjs';
import { openPage, phase } from './page-support.mjs';

/** A quick build is not optimised, so it is larger than the budget. */
const quick = readFileSync(join(ROOT, 'www', 'sdk', 'pkg', 'kerfway.stamp'), 'utf8').startsWith('quick');

test('the first ten seconds of a first visit transfer each file once, service worker included, within the budget', async (t) => {
  const { page, sent } = await openPage(t);
  await phase(page, 'planning', 'done');
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => performance.now() > 10_000);
  const files = sent.map(({ file }) => relative(join(DIST, 'app'), file));
  assert.deepEqual([...files].sort(), [...new Set(files)].sort(), 'each file once');
  assert.ok(files.includes('offline.js'), 'the service worker is counted');
  const kB = sent.reduce((sum, { source }) => sum + statSync(source).size, 0) / 1000;
  t.diagnostic(`${files.length} files, ${kB.toFixed(1)} kB${quick ? ' (quick build, uncompressed)' : ''}`);
  if (quick) return;
  assert.deepEqual(sent.filter(({ source }) => !source.endsWith('.br')), [], 'the browser gets every file compressed');
  assert.ok(kB <= BUDGETS.page, `${kB.toFixed(1)} kB of ${BUDGETS.page} kB: ${files.join(', ')}`);
});
