// Parts of the page that only a later action needs: a first visit does without them, and once they are stored they need no network.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { download, openPage, phase, replanned, until } from './page-support.mjs';

const PARTS = ['plan', 'placement', 'pins', 'tolerances', 'project-files'].map((name) => `later-${name}-`);

/** Runs in the page: whether all these files are stored. */
const areStored = async (parts) => {
  const lists = await Promise.all((await caches.keys()).map(async (cache) => (await caches.open(cache)).keys()));
  const urls = lists.flat().map(({ url }) => url);
  return parts.every((part) => urls.some((url) => url.includes(part)));
};

test('the controls of closed sections, the lists of pinned contours and project files are loaded when they are needed, and then also without a network', async (t) => {
  const { page, sent } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  const isPart = ({ file }) => PARTS.some((part) => file.includes(part));
  assert.deepEqual(sent.filter(isPart), [], 'a first visit does without them');
  const section = (title) => page.locator('details.section', { has: page.getByRole('heading', { name: title, exact: true }) });
  assert.equal(await section('Plan').locator('.gist').textContent(), '0.4 s');
  assert.equal(await section('On the bed').locator('.gist').textContent(), 'as drawn');
  await page.keyboard.press('Shift');
  await until(page, 'the parts are stored', () => page.evaluate(areStored, PARTS));
  await page.context().setOffline(true);

  await section('Plan').locator('> summary').press('Enter');
  await replanned(page, () => section('Plan').getByLabel('Search for').selectOption('2 s'));
  assert.equal(await section('Plan').locator('.gist').textContent(), '2 s');
  await section('On the bed').locator('> summary').press('Enter');
  await replanned(page, () => section('On the bed').getByRole('button', { name: 'Turn left' }).click());
  assert.equal(await section('On the bed').locator('.gist').textContent(), 'reaches beyond it, turned 90°');

  await section('Drawing').locator('> summary').press('Enter');
  await section('Drawing').locator('summary', { hasText: 'Tolerances' }).click();
  await section('Drawing').locator('.tolerance-field input[type=number]').first().fill('0.01');
  await section('Drawing').locator('.comparison', { hasText: /\w\.$/ }).waitFor();
  await page.keyboard.press('Escape');
  await page.locator('#canvas').focus();
  await page.keyboard.press('Home');
  await replanned(page, () => page.keyboard.press('1'));
  await section('Drawing').locator('.pins', { hasText: 'Cut first' }).waitFor();

  const { name } = await download(page, () => page.locator('.downloads').getByRole('button', { name: 'Project' }).click());
  assert.match(name, /\.kerfway$/);
});

test('a part that could not be loaded was reported in the words of the browser, with its address', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', broken: true });
  await phase(page, 'done');
  await page.route(/later-plan-/, (route) => route.abort());
  const plan = page.locator('details.section', { has: page.getByRole('heading', { name: 'Plan', exact: true }) });
  await plan.locator('> summary').click();
  await page.getByText('This part of the page could not be loaded. Check the network and try again.').waitFor();
  assert.equal(await plan.evaluate((d) => d.open), false);
  await page.unroute(/later-plan-/);
  await plan.locator('> summary').click();
  await plan.getByLabel('Search for').waitFor();
});
