// Calm and exact: what is shown before the page is built, views of the sheet, the bottom sheet, targets for fingers, keyboard alone, less motion, wide screens.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { changedFrom, shot, still } from './page-pictures.mjs';
import { drop, openPage, phase, planned, replanned, SIZES, tap } from './page-support.mjs';

test('the frame of the page is visible before its script runs', async (t) => {
  const { page, url } = await openPage(t);
  await phase(page, 'planning', 'done');
  await page.context().route(/\.js$/, () => {});
  const blocked = await page.context().newPage();
  await blocked.goto(url, { waitUntil: 'commit' });
  await blocked.locator('.skeleton-sheet').waitFor();
  assert.equal(await blocked.locator('.skeleton-rows i').count(), 5);
  await blocked.close();
  await page.context().unroute(/\.js$/);
  // Once the page is built, nothing of it is left.
  assert.equal(await page.locator('.skeleton-sheet').isVisible(), false);
  assert.equal(await page.locator('.skeleton-rows').count(), 0);
});

test('the hint stays as long as there is nothing of one\'s own', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  assert.equal(await page.locator('#hint').isVisible(), true);
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.getByRole('button', { name: /^Layers/ }).click();
  await planned(page, 'layers.dxf');
  assert.equal(await page.locator('#hint').isVisible(), true, 'a sample is not of one\'s own');
  await drop(page, 'own.dxf', grid(20));
  await planned(page, 'own.dxf');
  assert.equal(await page.locator('#hint').isVisible(), false);
});

test('contours are shown in the colours of their layers, and one view at a time', async (t) => {
  // Ten seconds after a search, the proof may find a better path, which is drawn at once. It does not replace the path of another method.
  const { page } = await openPage(t, { hash: 'seconds=0.4&method=greedy' });
  await phase(page, 'planning', 'done');
  await drop(page, 'layers.dxf', sample('layers.dxf'));
  await planned(page, 'layers.dxf', 'done');
  const plain = await still(page);
  const pressed = (name) => page.getByRole('button', { name }).getAttribute('aria-pressed');
  await page.keyboard.press('v');
  await changedFrom(page, plain);
  await still(page);
  await shot(page, 'layer-colours');
  await page.keyboard.press('c');
  assert.deepEqual([await pressed(/^Colours of layers/), await pressed(/^Colour by order/)], ['false', 'true']);
  await page.keyboard.press('v');
  assert.deepEqual([await pressed(/^Colours of layers/), await pressed(/^Colour by order/)], ['true', 'false']);
  await page.keyboard.press('v');
  assert.ok((await still(page)).equals(plain), 'as before');
});

test('distances are measured between ends and centres, to which clicks snap', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const square = [[0, 0], [120, 0], [120, 90], [0, 90]].flatMap(([x, y]) => ['10', x, '20', y]);
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES', '0', 'LWPOLYLINE', '8', 'CUT', '90', 4, '70', 1, ...square, '0', 'ENDSEC', '0', 'EOF'];
  await drop(page, 'square.dxf', Buffer.from(`${text.join('\n')}\n`));
  await planned(page, 'square.dxf', 'done', 'question');
  await page.keyboard.press('d');
  // The rectangle fills the stage: its corners are found where the pointer finds its outline, a few pixels off.
  const box = await page.locator('#canvas').boundingBox();
  const stage = await page.evaluate(() => ({ w: document.querySelector('#canvas').clientWidth, h: document.querySelector('#canvas').clientHeight }));
  const [left, right, top, bottom] = [40, 24 + 36, 60, 40];
  const scale = 0.94 * Math.min((stage.w - left - right) / 120, (stage.h - top - bottom) / 90);
  const [cx, cy] = [box.x + left + (stage.w - left - right) / 2, box.y + top + (stage.h - top - bottom) / 2];
  await page.mouse.click(cx - 60 * scale + 3, cy - 45 * scale + 3);
  await page.mouse.click(cx + 60 * scale - 3, cy + 45 * scale - 3);
  // The sheet shows it, and screen readers hear it; the notice that said what to click is gone.
  await page.locator('#announcer').getByText('150 mm (x 120, y 90)').waitFor();
  assert.equal(await page.locator('.notice').isVisible(), false);
  await shot(page, 'measured');
  await page.keyboard.press('Escape');
  assert.equal(await page.getByRole('button', { name: /^Measure/ }).getAttribute('aria-pressed'), 'false');
});

test('on a phone the bottom sheet is dragged to other heights and closed by dragging', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4' });
  await phase(page, 'done');
  const client = await page.context().newCDPSession(page);
  const touch = (type, points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const drag = async (by) => {
    const box = await page.locator('.dock-state').boundingBox();
    const [x, y] = [box.x + 60, box.y + 10];
    await touch('touchStart', [[x, y]]);
    for (let k = 1; k <= 8; k += 1) await touch('touchMove', [[x, y - (by * k) / 8]]);
    await touch('touchEnd', []);
  };
  const height = () => page.evaluate(() => (document.body.classList.contains('sheet-open') ? document.querySelector('#sections').offsetHeight / innerHeight : 0));
  const near = (share) => page.waitForFunction((s) => Math.abs((document.body.classList.contains('sheet-open') ? document.querySelector('#sections').offsetHeight / innerHeight : 0) - s) < 0.02, share);
  assert.equal(await height(), 0);
  await drag(280);
  await near(0.36);
  await drag(240);
  await near(0.62);
  await shot(page, 'sheet-dragged');
  await drag(-480);
  await near(0);
  // A tap still opens it.
  await tap(page.locator('.sheet-toggle'));
  await page.waitForFunction(() => document.body.classList.contains('sheet-open'));
});

test('on a phone every target is at least 44 pixels high and wide', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4' });
  await phase(page, 'done');
  const small = () => page.evaluate(() => [...document.querySelectorAll('button, select, input:not([type=checkbox]), summary')]
    .filter((e) => e.checkVisibility() && e.getClientRects().length > 0 && !e.closest('.hidden'))
    .map((e) => [e, e.getBoundingClientRect()]).filter(([, b]) => b.height < 43.5 || b.width < 43.5)
    .map(([e, b]) => `${e.tagName} ${e.className} "${e.getAttribute('aria-label') ?? e.textContent.trim().slice(0, 30)}" ${Math.round(b.width)} x ${Math.round(b.height)}`));
  assert.deepEqual(await small(), [], 'the stage');
  await page.keyboard.press('Home');
  assert.deepEqual(await small(), [], 'with the card');
  await page.keyboard.press('Escape');
  await page.keyboard.press('t');
  await page.locator('.order-row').nth(1).waitFor();
  assert.deepEqual(await small(), [], 'with the table');
  await page.keyboard.press('t');
  await tap(page.locator('.sheet-toggle'));
  await page.evaluate(() => document.querySelectorAll('.section, .section details').forEach((d) => (d.open = true)));
  assert.deepEqual([...new Set(await small())], [], 'with the panel');
});

test('from opening a file to its program by keyboard alone', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.locator('.open').press('Enter')]);
  await chooser.setFiles({ name: 'keys.dxf', mimeType: 'image/vnd.dxf', buffer: grid(30) });
  await planned(page, 'keys.dxf', 'done');
  await page.keyboard.press('Home');
  await replanned(page, async () => {
    await page.keyboard.press('l');
    await page.keyboard.press('0');
  });
  await page.waitForFunction(() => /^Cut last: /.test(document.querySelector('.pins')?.textContent ?? ''));
  const [file] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('g')]);
  assert.match(file.suggestedFilename(), /^keys-co2-100w-.*\.nc$/);
});

test('with less motion nothing glides or glows', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await phase(page, 'done');
  const before = await still(page);
  await page.keyboard.press('+');
  // One frame later the view is where it ends.
  await changedFrom(page, before);
  const next = await still(page);
  await page.keyboard.press('f');
  await changedFrom(page, next);
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector('.budget span')).animationName), 'none');
});

test('a 4k window has larger text, on the sheet too', async (t) => {
  const { page } = await openPage(t, { size: { width: 3840, height: 2160 }, hash: 'seconds=0.4' });
  await phase(page, 'done');
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).fontSize), '18px');
  await still(page);
  await shot(page, 'wide');
});

test('the start lies over a finding, air moves are grey while colours show the order, and rows stay while planning', async (t) => {
  // No proof replaces the path of another method, and its colours, while they are compared.
  const { page } = await openPage(t, { hash: 'seconds=0.4&method=greedy' });
  await phase(page, 'planning', 'done');
  // The ends of the outline are 0.3 mm apart at the origin, where the head starts.
  const points = [[0, 0], [240, 0], [240, 180], [0, 180], [0, 0.3]].flatMap(([x, y]) => ['10', x, '20', y]);
  const circles = Array.from({ length: 12 }, (_, i) => ['0', 'CIRCLE', '8', 'CUT', '10', 30 + 60 * (i % 4), '20', 30 + 60 * Math.floor(i / 4), '40', 5 + i]).flat();
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES', '0', 'LWPOLYLINE', '8', 'CUT', '90', 5, '70', 0, ...points, ...circles, '0', 'ENDSEC', '0', 'EOF'];
  await drop(page, 'open.dxf', Buffer.from(`${text.join('\n')}\n`));
  await planned(page, 'open.dxf', 'done', 'question');
  await still(page);
  const seen = await page.evaluate(() => {
    const canvas = document.querySelector('#canvas');
    const [left, right, top, bottom] = [40, 24 + 36, 60, 40];
    const scale = 0.94 * Math.min((canvas.width - left - right) / 240, (canvas.height - top - bottom) / 180);
    const [x, y] = [left + (canvas.width - left - right) / 2 - 120 * scale, top + (canvas.height - top - bottom) / 2 + 90 * scale];
    const at = (dx, dy) => [...canvas.getContext('2d').getImageData(Math.round(x + dx), Math.round(y + dy), 1, 1).data].slice(0, 3);
    const isAmber = ([r, g, b]) => r > 150 && g > 80 && g < r - 30 && b < 90;
    const around = [];
    for (let dx = -9; dx <= 9; dx += 1) for (let dy = -9; dy <= 9; dy += 1) if (isAmber(at(dx, dy))) around.push([dx, dy]);
    return { badge: around.length, within: around.filter(([dx, dy]) => Math.abs(dx) < 3 && Math.abs(dy) < 3).length };
  });
  assert.ok(seen.badge > 10, 'the finding has its badge there');
  assert.equal(seen.within, 0, 'the start is in front of it');

  const accent = () => page.evaluate(() => {
    const { width, height } = document.querySelector('#canvas');
    const { data } = document.querySelector('#canvas').getContext('2d').getImageData(0, 0, width, height);
    let n = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 2] > data[i] + 90 && data[i] < 110) n += 1;
    return n;
  });
  const plain = await accent();
  await page.keyboard.press('c');
  await still(page);
  await page.keyboard.press('a');
  await still(page);
  const without = await accent();
  await page.keyboard.press('a');
  await still(page);
  const grey = await accent();
  assert.ok(plain - grey > 100 && Math.abs(grey - without) < 20, `air moves have no accent then: ${plain}, ${grey}, ${without} without them`);
  await page.keyboard.press('c');

  // The rows of the plan before stay until there is a new path.
  await page.keyboard.press('t');
  await page.locator('.order-row').nth(1).waitFor();
  await page.evaluate(() => {
    window.least = Infinity;
    const look = () => {
      window.least = Math.min(window.least, document.querySelectorAll('.order-row').length);
      requestAnimationFrame(look);
    };
    look();
  });
  await page.keyboard.press('Home');
  await page.keyboard.press('0');
  await page.waitForFunction(() => /Cut last: /.test(document.querySelector('#sections').textContent));
  await phase(page, 'done');
  assert.ok((await page.evaluate(() => window.least)) > 10, 'the table is never empty');
});

test('what is left to gain survives a reload', async (t) => {
  // The bound begins after a million moves, however long a slow machine takes for them.
  const { page } = await openPage(t, { hash: 'seconds=600' });
  await drop(page, 'bound.dxf', grid(60));
  await planned(page, 'bound.dxf', 'planning');
  await page.waitForFunction(() => /at most|optimal/.test(document.querySelector('.parts .gap + dd')?.textContent));
  await page.keyboard.press('s');
  await phase(page, 'done');
  await page.waitForFunction(() => document.querySelector('.kept') !== null && !document.querySelector('.kept').hidden);
  // The language menu stores the job before the page starts anew.
  await page.locator('.top .settings').click();
  // Not before: on a slow machine a proof beside the search may end a moment after it.
  const before = await page.evaluate(() => document.querySelector('.parts .gap + dd').textContent);
  await Promise.all([page.waitForEvent('load'), page.getByRole('button', { name: 'Inches' }).click()]);
  await planned(page, 'bound.dxf', 'done');
  await page.waitForFunction((text) => document.querySelector('.parts .gap + dd')?.textContent === text, before);
});
