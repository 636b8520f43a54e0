// The dialect editor with its preview, and the check of the program below the downloads.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { download, machineSection, openPage, phase, SIZES } from './page-support.mjs';

test('a program is checked below the downloads, and a dialect of one\'s own is tried while it is typed', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  // The writers, which check it, are loaded when somebody uses the page, or after twelve seconds.
  await page.keyboard.press('Shift');
  const preflight = page.locator('.preflight');
  await preflight.getByText('The program passes its check').waitFor();
  assert.match(await preflight.innerText(), /The program passes its check[^]*500 contours, each cut once[^]*beam off on every rapid[^]*read back as grbl-m4/);

  const machine = page.locator('details.section', { has: page.locator('h2', { hasText: 'Machine' }) });
  await machine.locator('> summary').click();
  await machine.getByLabel('G-code dialect').selectOption('linuxcnc-m67');
  await machine.getByText('Edit the dialect').click();
  const preview = page.locator('pre.program');
  await page.waitForFunction(() => document.querySelector('pre.program')?.textContent?.includes('M68 E0 Q0'));

  const text = machine.getByLabel('Dialect document (JSON)');
  const document = JSON.parse(await text.inputValue());
  await text.fill(JSON.stringify({ ...document, name: 'mine', title: 'My LinuxCNC', header: ['G21 G90', 'M64 P0'] }));
  await page.waitForFunction(() => document.querySelector('pre.program')?.textContent?.includes('M64 P0'));
  assert.match(await preview.innerText(), /^G21 G90\nM64 P0\nG0 X0 Y0\n/);
  await text.fill(JSON.stringify({ ...document, pierce: { by: 'dwell-m3' } }));
  await machine.getByText(/pierces by "dwell-m3", which does not work/).waitFor();
  assert.equal(await machine.getByRole('button', { name: 'Use this dialect' }).isDisabled(), true);

  await text.fill(JSON.stringify({ ...document, name: 'mine', title: 'My LinuxCNC' }));
  await page.waitForFunction(() => !document.querySelector('.section-body button.primary')?.disabled);
  await machine.getByRole('button', { name: 'Use this dialect' }).click();
  await phase(page, 'done');
  await page.waitForFunction(() => document.querySelector('.preflight')?.textContent?.includes('read back as mine'));
});

test('a program that fails its check is not offered, neither among the downloads nor at the foot', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  const foot = page.locator('.dock').getByRole('button', { name: 'G-code' });
  assert.equal(await foot.isEnabled(), true);
  const machine = await machineSection(page, SIZES.desktop);
  await machine.evaluate((section) => section.querySelectorAll('details').forEach((d) => (d.open = true)));
  await machine.getByLabel('Name of your machine').fill('Inches');
  await machine.getByRole('button', { name: 'Save', exact: true }).click();
  await page.waitForFunction(() => document.querySelector('[aria-label=Preset]').value === 'my-inches');
  const { bytes } = await download(page, () => machine.getByRole('button', { name: 'Export' }).last().click());
  const { schema, profile } = JSON.parse(bytes);
  // Numbers in millimetres behind a header that says inches.
  const dialect = JSON.parse(readFileSync(new URL('../../src/machine/dialect/shipped/linuxcnc-m67.json', import.meta.url), 'utf8'));
  const wrong = { ...profile, dialect: { ...dialect, name: 'mine', title: 'Mine', header: ['G20 G90 G91.1 G17 G94'] } };
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), machine.getByRole('button', { name: 'Import' }).last().click()]);
  await chooser.setFiles({ name: 'inches.machine.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify({ schema, profile: wrong })) });
  await page.locator('.preflight').getByText('The program fails its check and is not handed out').waitFor();
  assert.match(await page.locator('.preflight').innerText(), /cuts with \d+ mm\/min; this machine moves with at most 24000/);
  assert.equal(await foot.isDisabled(), true);
  assert.match(await page.locator('.dock').innerText(), /The program fails its check, so no G-code/);
});
