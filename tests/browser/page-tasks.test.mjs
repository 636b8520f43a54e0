// Twenty tasks of a maker, a shop operator and a quoting engineer, each done with the mouse, with the keyboard alone, and with a finger on a phone.
// docs/page.md lists them. The number of clicks, keys or taps of each is printed.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { canvasShot, changedFrom } from './page-pictures.mjs';
import { download, openPage, phase, planned, replanned, searchFor, SIZES, tap } from './page-support.mjs';

/** Nine plates with two holes each, an open line, and a note on a layer of its own. The middle of the sheet is inside the plate in the middle. */
function plates() {
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'];
  const polyline = (layer, closed, points) => text.push('0', 'LWPOLYLINE', '8', layer, '90', points.length, '70', closed, ...points.flatMap(([x, y]) => ['10', x, '20', y]));
  for (let i = 0; i < 9; i += 1) {
    const [x, y] = [10 + 100 * (i % 3), 10 + 100 * Math.floor(i / 3)];
    polyline('CUT', 1, [[x, y], [x + 90, y], [x + 90, y + 90], [x, y + 90]]);
    for (const [dx, dy] of [[12, 12], [78, 78]]) text.push('0', 'CIRCLE', '8', 'CUT', '10', x + dx, '20', y + dy, '40', 4);
  }
  polyline('CUT', 0, [[30, 40], [80, 40], [80, 60]]);
  polyline('PLAN', 0, [[230, 240], [270, 240]]);
  text.push('0', 'ENDSEC', '0', 'EOF');
  return Buffer.from(`${text.join('\n')}\n`);
}

/** Somebody who uses the page with a mouse, a keyboard or a finger, and how often they pressed something. */
class Person {
  pressed = 0;

  constructor(page, by) {
    Object.assign(this, { page, by });
  }

  async key(name) {
    this.pressed += 1;
    await this.page.keyboard.press(name);
  }

  /** On a phone the panel is a sheet that is opened and closed. */
  async reach(locator) {
    if (this.by !== 'touch') return;
    const [inside, open] = await locator.evaluate((e) => [e.closest('#sections') !== null, document.body.classList.contains('sheet-open')]);
    if (inside !== open && !(await locator.evaluate((e) => e.closest('.dock, .top') !== null))) await this.tap(this.page.locator('.sheet-toggle'));
  }

  async tap(locator) {
    this.pressed += 1;
    await tap(locator);
  }

  /** Moves the focus to a control, by Tab. */
  async focus(locator) {
    const target = await locator.elementHandle();
    for (let k = 0; k < 200; k += 1) {
      const way = await this.page.evaluate((e) => (document.activeElement === e ? null : document.activeElement !== document.body && document.activeElement.compareDocumentPosition(e) & Node.DOCUMENT_POSITION_PRECEDING ? 'Shift+Tab' : 'Tab'), target);
      if (way === null) return;
      await this.key(way);
    }
    assert.fail(`the keyboard does not reach ${locator}`);
  }

  /** Presses a control. `shortcut`: the key that does the same. */
  async use(locator, shortcut) {
    if (this.by === 'keyboard') {
      if (shortcut === undefined) await this.focus(locator);
      else if (await this.page.evaluate(() => /^(INPUT|SELECT)$/.test(document.activeElement.tagName))) await this.key('Tab');
      return this.key(shortcut ?? 'Enter');
    }
    await this.reach(locator);
    if (this.by === 'touch') return this.tap(locator);
    this.pressed += 1;
    await locator.click();
  }

  /** Opens a section of the panel. */
  async open(title) {
    const summary = this.page.locator(`.section > summary:has(h2:text-is("${title}"))`);
    if (!(await summary.evaluate((e) => e.parentElement.open))) await this.use(summary);
  }

  /** Chooses from a list. The browser's own list cannot be pressed by a test, so that counts as two presses. */
  async choose(locator, label) {
    await this.reach(locator);
    this.pressed += 2;
    if (this.by !== 'keyboard') return locator.selectOption({ label });
    await this.focus(locator);
    await this.page.keyboard.type(label);
  }

  async type(locator, text) {
    if (this.by === 'keyboard') await this.focus(locator);
    else await this.use(locator);
    this.pressed += text.length;
    await this.page.keyboard.type(text);
    await this.key('Tab');
  }

  /** Selects the plate in the middle, or with the keyboard the one that is cut first. */
  async selectPart() {
    if (this.by === 'keyboard') {
      if (await this.page.evaluate(() => /^(INPUT|SELECT)$/.test(document.activeElement.tagName))) await this.key('Tab');
      await this.key('Home');
      await this.key('w');
      return;
    }
    const canvas = this.page.locator('#canvas');
    await this.use(button(this.page, /^Fit the sheet/, '#stage'));
    const { width, height } = await canvas.boundingBox();
    this.pressed += 1;
    const position = { x: width / 2, y: height / 2 };
    await (this.by === 'touch' ? canvas.tap({ position }) : canvas.click({ position }));
  }
}

/** A button by its name, also in the sheet of a phone while that is closed. */
const button = (page, name, within = 'body') => page.locator(within).getByRole('button', { name, exact: typeof name === 'string', includeHidden: true });
const sections = (page) => page.locator('#sections').textContent();
const says = (page, text) => page.waitForFunction((text) => document.querySelector('#sections').textContent.includes(text), text);
const card = (page) => page.locator('.card.contour');

/** Each task with what is pressed, and how to tell that it is done. */
const TASKS = [
  ['maker', 'open a drawing', async ({ person, page, file }) => {
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), person.use(button(page, /Open a DXF/, '.top'), 'o')]);
    await chooser.setFiles(file);
    await planned(page, 'plates.dxf', 'done');
  }],
  ['maker', 'see what the plan saves', async ({ person, page }) => {
    await person.open('Result');
    await person.reach(page.locator('.large'));
    assert.match(await page.locator('.large').textContent(), /saved|longer/);
    assert.equal(await page.locator('.large').isVisible(), true);
  }],
  ['maker', 'mark a layer instead of cutting it', async ({ person, page }) => {
    await person.open('Drawing');
    await replanned(page, () => person.choose(page.getByLabel('Operation for layer PLAN'), 'Mark'));
    await page.waitForFunction(() => document.querySelector('select.operation.mark') !== null);
  }],
  ['maker', 'see where a warning is', async ({ person, page }) => {
    const list = page.locator('details.more.grave').first();
    if (!(await list.evaluate((e) => e.open))) await person.use(list.locator('> summary'));
    const before = await canvasShot(page);
    await person.use(page.locator('button.finding').first());
    await changedFrom(page, before);
  }],
  ['maker', 'skip a part', async ({ person, page }) => {
    await person.selectPart();
    await card(page).waitFor();
    await replanned(page, () => person.use(button(page, 'Skip', '.card.contour'), 'x'));
    await page.waitForFunction(() => /Skipped: \d contours?/.test(document.querySelector('#sections').textContent));
  }],
  ['maker', 'take that back', async ({ person, page }) => {
    await replanned(page, () => person.use(button(page, /^Undo/, '.top'), 'Control+z'));
    await page.waitForFunction(() => !document.querySelector('#sections').textContent.includes('Skipped: '));
  }],
  ['maker', 'play the cut and pause it', async ({ person, page }) => {
    if (await card(page).isVisible()) await person.use(button(page, /^Close/, '.card.contour'), 'Escape');
    await page.evaluate(() => document.activeElement.blur());
    await person.use(page.locator('#playback button').first(), ' ');
    await page.waitForFunction(() => Number(document.querySelector('#playback input').value) > 100);
    await person.use(page.locator('#playback button').first(), ' ');
    assert.match(await page.locator('#playback input').getAttribute('aria-valuetext'), /contour \d+ of/);
  }],

  ['operator', 'choose the machine', async ({ person, page }) => {
    const list = page.locator('#sections select').first();
    const label = await list.evaluate((e) => [...e.options].find((o) => !o.selected).textContent);
    await person.choose(list, label);
    await page.waitForFunction((label) => document.querySelector('#sections').textContent.includes(label), label);
    await phase(page, 'planning', 'done');
  }],
  ['operator', 'keep it as one\'s own', async ({ person, page }) => {
    await person.use(button(page, 'Keep this machine'));
    await page.waitForFunction(() => document.querySelector('#sections').innerText.includes('Keep this machine') === false);
    await phase(page, 'done');
  }],
  ['operator', 'turn the job and put it into the corner', async ({ person, page }) => {
    await person.open('On the bed');
    await person.use(button(page, 'Turn left'));
    await says(page, 'turned 90°');
    await phase(page, 'done', 'ready');
    await person.use(button(page, 'Move to the corner'));
    await says(page, 'placed, turned 90°');
    await phase(page, 'done');
  }],
  ['operator', 'cut a part first', async ({ person, page }) => {
    await person.selectPart();
    await card(page).waitFor();
    // A Stop before the drawing was read again would end the search of before, and the one that follows would run for its minute.
    await replanned(page, () => person.use(button(page, 'Cut first', '.card.contour'), '1'));
    await page.waitForFunction(() => /Cut first: /.test(document.querySelector('#sections').textContent));
  }],
  ['operator', 'search longer, and stop when it is enough', async ({ person, page }) => {
    // A search of 0.4 s would end by itself before the slowest of these people has stopped it.
    await searchFor(page, 60);
    await phase(page, 'planning');
    await page.locator('.dock').getByRole('button', { name: 'Stop' }).evaluate((stop) => stop.click());
    await phase(page, 'done');
    await person.use(button(page, 'Keep improving', '.dock'), 'k');
    await phase(page, 'planning');
    await person.use(button(page, 'Stop', '.dock'), 's');
    await phase(page, 'done');
    await button(page, /^Undo/, '.top').evaluate((undo) => undo.click());
    await page.waitForFunction(() => location.hash.includes('seconds=0.4') && document.body.dataset.phase === 'done');
  }],
  ['operator', 'download the program', async ({ person, page }) => {
    const { name, bytes } = await download(page, () => person.use(page.locator('.dock-actions .primary:visible'), 'g'));
    assert.match(name, /^plates-.*\d{4}-\d\d-\d\d\./);
    assert.ok(bytes.length > 500);
  }],
  ['operator', 'download the report for the machine', async ({ person, page }) => {
    await person.open('Result');
    const { name, bytes } = await download(page, () => person.use(button(page, 'Report')));
    assert.match(name, /report\.html$/);
    assert.match(bytes.toString(), /<svg/);
  }],

  ['quoting engineer', 'see what a price needs', async ({ person, page }) => {
    await person.open('Quote');
    await page.getByText('Part area').waitFor({ state: 'attached' });
    assert.match(await sections(page), /9 parts/);
  }],
  ['quoting engineer', 'enter the thickness', async ({ person, page }) => {
    await person.type(page.getByLabel(/^Thickness/), '3');
    await page.waitForFunction(() => document.querySelector('#sections').textContent.includes('× thickness'));
  }],
  ['quoting engineer', 'download the quote', async ({ person, page }) => {
    const { name, bytes } = await download(page, () => person.use(button(page, 'Download the report')));
    assert.match(name, /\.quote\.json$/);
    assert.equal(JSON.parse(bytes).part_count, 9);
  }],
  ['quoting engineer', 'read the cutting order', async ({ person, page }) => {
    await person.use(button(page, 'Cutting order', '.top'), 't');
    const table = page.getByRole('table', { name: 'Cutting order' });
    await table.waitFor();
    assert.equal(await table.getAttribute('aria-rowcount'), '30', 'twenty-seven contours, two lines and the head');
    await person.use(button(page, 'Close the table'), 't');
    await table.waitFor({ state: 'hidden' });
  }],
  ['quoting engineer', 'compare with the order as drawn', async ({ person, page }) => {
    await person.use(button(page, 'As drawn', '#stage'));
    await page.waitForFunction(() => [...document.querySelectorAll('#stage button')].some((b) => b.textContent === 'As drawn' && b.getAttribute('aria-pressed') === 'true'));
    await person.use(button(page, 'Now', '#stage'));
  }],
  ['quoting engineer', 'save the project', async ({ person, page }) => {
    await person.open('Result');
    const { name, bytes } = await download(page, () => person.use(button(page, 'Project', '#sections'), 'Control+s'));
    assert.equal(name, 'plates.kerfway');
    assert.equal(JSON.parse(bytes).schema, 'kerfway.project/1');
  }],
];

const WAYS = { mouse: {}, keyboard: {}, touch: { size: SIZES.phone, touch: true } };
const presses = Object.fromEntries(Object.keys(WAYS).map((by) => [by, []]));

for (const [by, options] of Object.entries(WAYS)) {
  test(`twenty tasks by ${by}`, async (t) => {
    assert.equal(TASKS.length, 20);
    const { page } = await openPage(t, { hash: 'seconds=0.4', ...options });
    // A person clicks when the view stands still, which a test cannot see.
    await page.emulateMedia({ reducedMotion: 'reduce' });
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-tasks-'));
    t.after(() => rmSync(folder, { recursive: true }));
    const file = join(folder, 'plates.dxf');
    writeFileSync(file, plates());
    await phase(page, 'planning', 'done');
    for (const [who, what, act] of TASKS) {
      const person = new Person(page, by);
      await assert.doesNotReject(act({ person, page, file }), `${by}: ${who}, ${what}`);
      presses[by].push(person.pressed);
      // Nobody should look for a control for long. Keys count each step of Tab.
      assert.ok(person.pressed <= (by === 'keyboard' ? 90 : 6), `${by}: ${what} takes ${person.pressed}`);
    }
  });
}

test('the number of clicks, keys and taps of each task', (t) => {
  TASKS.forEach(([who, what], k) => t.diagnostic(`${who.padEnd(17)}${what.padEnd(46)}${Object.keys(WAYS).map((by) => `${by} ${String(presses[by][k] ?? '-').padStart(2)}`).join('  ')}`));
  assert.deepEqual(Object.values(presses).map((list) => list.length), [20, 20, 20]);
});
