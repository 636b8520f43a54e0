// No work is lost: wrong files, undo, reloads, crashes, other tabs, project files.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { grid, sample } from './page-drawings.mjs';
import { shot } from './page-pictures.mjs';
import { download, drop, nextFrames, openPage, phase, plan, planned, replanned, SIZES, storedWith, tap, until } from './page-support.mjs';

const CLI = join(dirname(dirname(dirname(fileURLToPath(import.meta.url)))), 'dist', 'sdk', 'cli.js');

/** The number of moves that the page shows behind the plan. */
const moves = (page) => page.evaluate(() => {
  const [, n, unit] = /([\d.,]+)(?: (thousand|million))? moves(?!\/)/.exec(document.querySelector('.dock-state').textContent) ?? [];
  return n === undefined ? null : Number(n.replaceAll(',', '')) * ({ thousand: 1e3, million: 1e6 }[unit] ?? 1);
});

/** The job time that the page shows, s. */
const jobTime = async (page) => (await page.waitForFunction(() => document.querySelector('.compare tbody:last-of-type td.number').textContent)).jsonValue();

/** Opens an own drawing and lets its search end. */
async function done(page, name, bytes) {
  await drop(page, name, bytes);
  await planned(page, name, 'done');
}

/** Skips the contour with this number, as a person does by table and key. */
async function skip(page) {
  await page.keyboard.press('Escape');
  await page.keyboard.press('Home');
  await replanned(page, () => page.keyboard.press('x'));
  await page.waitForFunction(() => /Skipped: 1 contour/.test(document.querySelector('#sections').textContent));
}

/** Waits until the browser has stored the current job. */
const stored = (page) => page.locator('.kept').waitFor({ state: 'attached' }).then(() => page.waitForFunction(() => !document.querySelector('.kept').hidden));

/** Two tabs with one file: the second begins with the job that the first keeps. */
async function twoTabs(t) {
  const { page, url } = await openPage(t, { hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(60));
  await stored(page);
  const other = await page.context().newPage();
  await other.goto(url);
  await planned(other, 'own.dxf', 'done');
  return { page, other };
}

test('a wrong file leaves the drawing, its plan and its undo as they were, and is explained beside them', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(60));
  await skip(page);
  const [time, before] = [await jobTime(page), await moves(page)];
  await drop(page, 'letter.pdf', Buffer.from('%PDF-1.7 not a drawing'));
  const card = page.locator('.failure');
  await card.waitFor();
  assert.match(await card.textContent(), /letter\.pdf.*Your current drawing has not changed/s);
  await shot(page, 'refused');
  assert.equal(await page.locator('.file-name').textContent(), 'own.dxf');
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'done');
  assert.deepEqual([await jobTime(page), await moves(page)], [time, before]);
  assert.equal(await page.getByRole('button', { name: 'Undo' }).isEnabled(), true);
  await card.getByRole('button', { name: 'Close' }).click();
  await card.waitFor({ state: 'hidden' });
  const program = await download(page, () => page.locator('.dock-actions').getByRole('button', { name: 'G-code' }).click());
  assert.match(program.bytes.toString(), /M5/);
});

test('a search goes on while a wrong file is dropped', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=600' });
  await drop(page, 'own.dxf', grid(60));
  await planned(page, 'own.dxf', 'planning');
  await drop(page, 'nothing.dxf', Buffer.from('0\nEOF\n'));
  await page.locator('.failure').waitFor();
  await phase(page, 'planning');
  const pace = () => page.evaluate(() => document.querySelector('.budget').getAttribute('aria-valuenow'));
  await page.waitForFunction(() => /moves\/s/.test(document.querySelector('.dock-state').textContent));
  assert.ok((await pace()) !== null);
  await page.keyboard.press('s');
  await phase(page, 'done');
});

test('undo and redo bring back the plan found for each state, and its search goes on where it was', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(90));
  // What is stored is the plan in which the search ended.
  await stored(page);
  const first = { time: await jobTime(page), moves: await moves(page) };
  await skip(page);
  const second = { time: await jobTime(page), moves: await moves(page) };
  await page.keyboard.press('Control+z');
  await page.waitForFunction((time) => document.querySelector('.compare tbody:last-of-type td.number').textContent === time, first.time);
  await phase(page, 'done');
  assert.equal(await moves(page), first.moves, 'no new search');
  await page.keyboard.press('Control+Shift+z');
  await page.waitForFunction((time) => document.querySelector('.compare tbody:last-of-type td.number').textContent === time, second.time);
  await phase(page, 'done');
  assert.equal(await moves(page), second.moves);
  await replanned(page, () => page.keyboard.press('k'));
  assert.ok((await moves(page)) > second.moves, 'moves of the search before are counted in');
});

test('a reload and a crash bring back the drawing, its decisions and its plan; one click forgets them', async (t) => {
  const { page, url } = await openPage(t, { hash: 'seconds=0.4', broken: true });
  await done(page, 'own.dxf', grid(60));
  await skip(page);
  await stored(page);
  const shown = { time: await jobTime(page), moves: await moves(page) };
  const isBack = async (page) => {
    await planned(page, 'own.dxf', 'done');
    assert.deepEqual({ time: await jobTime(page), moves: await moves(page) }, shown);
    assert.match(await page.locator('#sections').textContent(), /Skipped: 1 contour/);
  };
  await storedWith(page, 1);
  await page.reload();
  await isBack(page);
  await shot(page, 'back');
  const crashed = page.waitForEvent('crash');
  await page.goto('chrome://crash').catch(() => {});
  await crashed;
  const again = await page.context().newPage();
  await again.goto(url);
  await isBack(again);
  await again.locator('.notice').getByRole('button', { name: 'Forget it' }).click();
  await again.getByText('Forgotten: nothing').waitFor();
  await again.reload();
  await planned(again, 'sheet_500.dxf');
});

test('tabs with the same file keep a job each; a new tab begins with the newest', async (t) => {
  const { page, other } = await twoTabs(t);
  await skip(other);
  await storedWith(other, 1);
  await page.reload();
  await planned(page, 'own.dxf', 'done');
  assert.doesNotMatch(await page.locator('#sections').textContent(), /Skipped/);
  await other.reload();
  await planned(other, 'own.dxf', 'done');
  assert.match(await other.locator('#sections').textContent(), /Skipped: 1 contour/);
});

test('a project file holds everything: the page opens it again, and the command line writes its program', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(60));
  await skip(page);
  const [time, before] = [await jobTime(page), await moves(page)];
  const program = await download(page, () => page.locator('.dock-actions').getByRole('button', { name: 'G-code' }).click());
  const saved = await download(page, () => page.getByRole('button', { name: 'Project' }).click());
  assert.equal(saved.name, 'own.kerfway');
  await done(page, 'another.dxf', grid(9));
  await drop(page, saved.name, saved.bytes);
  await planned(page, 'own.dxf', 'done');
  await page.waitForFunction((time) => document.querySelector('.compare tbody:last-of-type td.number').textContent === time, time);
  assert.equal(await moves(page), before);
  const at = mkdtempSync(join(tmpdir(), 'kerfway-'));
  t.after(() => rmSync(at, { recursive: true }));
  writeFileSync(join(at, saved.name), saved.bytes);
  execFileSync(process.execPath, [CLI, 'plan', join(at, saved.name), '--gcode', join(at, 'own.nc'), '--quiet']);
  // All but the date and the file's name is the program of the page.
  const moving = (text) => text.toString().split('\n').filter((line) => /^[GMSX]/.test(line));
  assert.deepEqual(moving(readFileSync(join(at, 'own.nc'))), moving(program.bytes));
});

test('on a phone a refused file leaves room for the drawing, and can be closed', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(20));
  await drop(page, 'a long name of a letter to somebody.pdf', Buffer.from('%PDF-1.7'));
  await page.locator('.failure').waitFor();
  await shot(page, 'refused-phone');
  await tap(page.locator('.failure').getByRole('button', { name: 'Close' }));
  await page.locator('.failure').waitFor({ state: 'hidden' });
});

test('after a reload, the machine of a sample and the units of a drawing are not settings of later drawings', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.locator('.menu-item', { has: page.getByText('Perforated plate', { exact: true }) }).click();
  await planned(page, 'perforated.dxf', 'done');
  await page.reload();
  await planned(page, 'perforated.dxf', 'done');
  assert.equal((await plan(page)).machine.name, 'fibre-3kw-thin');

  const size = () => page.locator('.top .measure').textContent();
  await done(page, 'millimetres.dxf', grid(12));
  assert.equal((await plan(page)).machine.name, 'co2-100w');
  const before = await size();
  await drop(page, 'unknown.dxf', sample('no-units.dxf'));
  await planned(page, 'unknown.dxf', 'question');
  await page.locator('.card.question .choices button').nth(1).click();
  await phase(page, 'done');
  const inches = await size();
  await page.waitForFunction(() => location.hash.includes('units=in'));
  await storedWith(page, 0, 'in');
  await page.reload();
  await planned(page, 'unknown.dxf', 'done');
  assert.equal(await size(), inches, 'the drawing itself has its units again');
  await done(page, 'millimetres.dxf', grid(12));
  assert.equal(await size(), before);
});

test('a job that another tab has deleted, to keep its own, is kept again with its drawing when somebody comes back to it', async (t) => {
  const { page, url } = await openPage(t, { hash: 'seconds=0.4' });
  await done(page, 'own.dxf', grid(60));
  await stored(page);
  const other = await page.context().newPage();
  await other.goto(`${url}#seconds=0.4`);
  await done(other, 'other.dxf', grid(9));
  await stored(other);
  /** What is stored: the names of the jobs, and the keys of the drawings. `act` is done to the tables of both. */
  const kept = (act = '') => page.evaluate(async (act) => {
    const request = indexedDB.open('kerfway');
    const database = await new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    const tables = ['jobs', 'drawings'].map((name) => database.transaction(['jobs', 'drawings'], 'readwrite').objectStore(name));
    if (act === 'delete') for (const table of tables) table.delete(sessionStorage.getItem('kerfway.tab'));
    const [jobs, keys] = await Promise.all([tables[0].getAll(), tables[1].getAllKeys()].map((r) => new Promise((resolve) => (r.onsuccess = () => resolve(r.result)))));
    database.close();
    return [jobs.map((job) => job.name).sort(), keys.length];
  }, act);
  // The other tab does that when more than four are open.
  assert.deepEqual(await kept('delete'), [['other.dxf'], 1]);
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await until(page, 'the job is kept again', async () => (await kept())[0].includes('own.dxf'));
  assert.deepEqual(await kept(), [['other.dxf', 'own.dxf'], 2]);
  await page.reload();
  await planned(page, 'own.dxf', 'done');
});

test('what is forgotten in one tab is not said to be kept in another', async (t) => {
  const { page, other } = await twoTabs(t);
  await stored(other);
  await other.locator('.notice').getByRole('button', { name: 'Forget it' }).click();
  await other.getByText('Forgotten: nothing').waitFor();
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await page.waitForFunction(() => document.querySelector('.kept').hidden);
  await skip(page);
  await page.reload();
  await planned(page, 'sheet_500.dxf');
});

test('where the browser blocks site data, the page works, and says once that nothing is kept', async (t) => {
  const block = () => {
    for (const name of ['localStorage', 'sessionStorage', 'indexedDB']) {
      Object.defineProperty(window, name, { get: () => { throw new DOMException('Access is denied for this document.', 'SecurityError'); } });
    }
  };
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: block });
  await phase(page, 'done');
  const notice = page.locator('.notice');
  assert.equal(await notice.isVisible(), false, 'nothing of a sample is lost');
  await done(page, 'own.dxf', grid(20));
  await notice.getByText('This browser stores nothing for this page').waitFor();
  assert.equal(await page.locator('.kept').isVisible(), false);
  await page.evaluate(() => (document.querySelector('.notice').hidden = true));
  await done(page, 'another.dxf', grid(9));
  await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
  await nextFrames(page, 20);
  assert.equal(await notice.isVisible(), false, 'it is said once');
  const first = page.locator('.first-machine');
  await first.getByRole('button', { name: 'Keep this machine' }).click();
  assert.equal(await first.isVisible(), false);
});

test('where drawings cannot be stored, another language waits until the person reloads', async (t) => {
  const block = () => Object.defineProperty(window, 'indexedDB', { get: () => { throw new DOMException('The quota has been exceeded.', 'QuotaExceededError'); } });
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: block });
  await done(page, 'own.dxf', grid(20));
  await page.locator('.notice').getByText('stores nothing').waitFor();
  await page.evaluate(() => (document.querySelector('.notice').hidden = true));
  await page.locator('.top .settings').click();
  await page.getByRole('button', { name: 'Deutsch', exact: true }).click();
  await page.locator('.notice').getByText('Save the project to keep it').waitFor();
  assert.equal(await page.locator('.file-name').textContent(), 'own.dxf');
  await Promise.all([page.waitForEvent('load'), page.getByRole('button', { name: 'Reload now' }).click()]);
  await page.waitForFunction(() => document.documentElement.lang === 'de');
  await planned(page, 'sheet_500.dxf');
});

test('without a secure connection the job is kept, and the clipboard is said to be out of reach', async (t) => {
  const insecure = () => {
    delete Navigator.prototype.locks;
    delete Navigator.prototype.clipboard;
    delete Navigator.prototype.serviceWorker;
    delete Crypto.prototype.randomUUID;
  };
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: insecure });
  await done(page, 'own.dxf', grid(20));
  await stored(page);
  await page.waitForFunction(() => !document.querySelector('.preflight').hidden);
  await page.getByRole('button', { name: 'Copy', exact: true }).click();
  await page.getByText('This browser does not let the page write to the clipboard').waitFor();
  await page.reload();
  await planned(page, 'own.dxf', 'done');
});

test('where a question is open, a wrong file is not said to leave a plan', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await drop(page, 'no-units.dxf', sample('no-units.dxf'));
  await phase(page, 'question');
  await drop(page, 'letter.pdf', Buffer.from('%PDF-1.7 not a drawing'));
  const card = page.locator('.failure');
  await card.waitFor();
  assert.match(await card.textContent(), /Your current drawing has not changed\./);
  assert.doesNotMatch(await card.textContent(), /\bplan\b/);
});
