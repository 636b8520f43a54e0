// A file of 400 MB is refused by its size: neither the page nor the element reads it.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { embedding, openHost } from './embed-support.mjs';
import { grid } from './page-drawings.mjs';
import { openPage, phase, planned, drop } from './page-support.mjs';

const SENTENCE = 'The file has 400 MB; up to 256 MB can be read. Delete what is not to be cut, or split the drawing.';
const at = embedding();

/** A file without content, which takes no room on the disk. */
function sparse(t) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const file = join(folder, 'large.dxf');
  writeFileSync(file, '');
  truncateSync(file, 400 * 2 ** 20);
  return file;
}

/** Counts the bytes of files that are read whole. */
function countReads() {
  window.bytesRead = 0;
  const { arrayBuffer } = Blob.prototype;
  Blob.prototype.arrayBuffer = function () {
    window.bytesRead += this.size;
    return arrayBuffer.call(this);
  };
}

const choose = async (page, press, file) => {
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), press()]);
  await chooser.setFiles(file);
};

test('the page refuses it, and plans the next file', async (t) => {
  const { page } = await openPage(t, { prepare: countReads, hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await page.evaluate(() => (window.bytesRead = 0));
  await choose(page, () => page.locator('button.open').click(), sparse(t));
  await page.locator('.failure h2', { hasText: 'large.dxf' }).waitFor();
  assert.equal(await page.locator('.failure p').first().textContent(), SENTENCE);
  assert.equal(await page.evaluate(() => window.bytesRead), 0);
  await drop(page, 'right.dxf', grid(12));
  await planned(page, 'right.dxf');
});

test('the element refuses it, and tells its host', async (t) => {
  const script = `(${countReads})(); import('./element/index.js').then(() => {
    window.said = [];
    document.querySelector('kerfway-planner').addEventListener('error', ({ detail }) => window.said.push(detail.message));
  });`;
  const { page } = await openHost(t, at, { html: '<kerfway-planner units="mm"></kerfway-planner>', script });
  await page.waitForFunction(() => window.said !== undefined);
  await choose(page, () => page.getByRole('button', { name: 'Choose a file' }).click(), sparse(t));
  await page.waitForFunction(() => window.said.length > 0);
  assert.deepEqual(await page.evaluate(() => [window.said, window.bytesRead]), [[SENTENCE], 0]);
});
