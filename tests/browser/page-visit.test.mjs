// What a first visit transfers: each file once, and no more than the budget of the build.

import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { test } from 'node:test';
import { BUDGETS } from '../../scripts/build.mjs';
import { DIST, ROOT } from '../../scripts/tools.mjs';
import { openPage, phase, stored } from './page-support.mjs';

/** A quick build is not optimised, so it is larger than the budget. */
const quick = readFileSync(join(ROOT, 'www', 'sdk', 'pkg', 'kerfway.stamp'), 'utf8').startsWith('quick');

const isWriter = ({ file }) => file.includes('kerfway_outputs');

// The second plan is done long before the ten seconds are over.
for (const hash of ['', 'seconds=1']) {
  test(`the first ten seconds of a first visit transfer each file once, service worker included, within the budget (${hash || 'as it is'})`, async (t) => {
    const { page, sent } = await openPage(t, { hash });
    await phase(page, ...(hash === '' ? ['planning', 'done'] : ['done']));
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
}

test('on a first visit the program counts as unchecked until a key is pressed; then the check is fetched and runs', async (t) => {
  const { page, sent } = await openPage(t, { hash: 'seconds=1' });
  await phase(page, 'done');
  const check = page.locator('.preflight');
  assert.match(await check.innerText(), /^The program is not checked yet/);
  assert.equal(await check.locator('svg').count(), 0, 'no mark of a check that has passed');
  assert.deepEqual(sent.filter(isWriter), []);
  await page.keyboard.press('Shift');
  await check.getByText('The program passes its check').waitFor();
  assert.ok(sent.some(isWriter));
});

test('without anybody touching it, the page checks the program after twelve seconds and stores what it needs for that', async (t) => {
  const { page, sent } = await openPage(t, { hash: 'seconds=1' });
  await page.locator('.preflight').getByText('The program passes its check').waitFor();
  assert.ok(await page.evaluate(() => performance.now() >= 12_000));
  const names = sent.filter(isWriter).map(({ file }) => file).sort();
  assert.deepEqual(names, [...new Set(names)], 'each file once');
  await stored(page, 'kerfway_outputs');
  // The file for proofs is larger than all the rest: it waits for somebody.
  assert.deepEqual(sent.filter(({ file }) => file.includes('kerfway_research')), []);
});
