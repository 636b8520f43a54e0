// What is left to gain: the proof goes on after the search, in a worker of its own, once somebody uses the page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from './page-drawings.mjs';
import { drop, openPage, phase, planned } from './page-support.mjs';

const isProof = ({ file }) => file.includes('kerfway_research');

test('after the search the path is proven optimal, and there is nothing more to improve', async (t) => {
  // On a busy machine the search knows no bound yet after 0.4 s.
  const { page, sent } = await openPage(t, { hash: 'seconds=2' });
  await phase(page, 'done');
  await drop(page, 'grid.dxf', grid(9));
  await planned(page, 'grid.dxf', 'done');
  // What the search itself knows: little, because squares have corners.
  assert.match(await page.locator('.parts .gap + dd').innerText(), /^at most/);
  assert.equal(await page.getByRole('button', { name: 'Keep improving' }).isVisible(), true);
  assert.equal(sent.filter(isProof).length, 0, 'a plan of under ten seconds waits for them');
  await page.waitForFunction(() => document.querySelector('.dock-head').textContent === 'Optimal: no better path exists.');
  await page.locator('.parts .gap + dd').getByText('nothing: this path is optimal').waitFor();
  assert.equal(await page.getByRole('button', { name: 'Keep improving' }).isVisible(), false);
  assert.equal(await page.getByRole('button', { name: 'G-code' }).first().isVisible(), true);
  assert.ok(sent.some(isProof));
});
