// Figures on the page agree with the drawing and with each other, and lines do not run through them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { grid, sample } from './page-drawings.mjs';
import { shot, still } from './page-pictures.mjs';
import { drop, machineSection, nextFrames, openPage, openPlanned, phase, plan, planned, replanned, SIZES } from './page-support.mjs';

/** A DXF of a rectangle, mm. */
function rectangle(x, y, width, height) {
  const corners = [[x, y], [x + width, y], [x + width, y + height], [x, y + height]].flatMap(([cx, cy]) => ['10', cx, '20', cy]);
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES', '0', 'LWPOLYLINE', '8', 'CUT', '90', 4, '70', 1, ...corners, '0', 'ENDSEC', '0', 'EOF'];
  return Buffer.from(`${text.join('\n')}\n`);
}

/** The text of a section of the panel once it says something. */
async function sectionText(page, title, wanted) {
  const section = page.locator('details.section', { has: page.getByRole('heading', { name: title, exact: true }) });
  await section.evaluate((d) => (d.open = true));
  await section.getByText(wanted).first().waitFor();
  return section.textContent();
}

test('a quote shows the width of holes as they were drawn', async (t) => {
  // Its holes have diameters of 24 and more, the plates lie 20 mm apart: measured along chords 23.99 and 19.99 mm.
  const page = await openPlanned(t, 'co2-100w', 'tips.dxf', sample('tips-and-skeleton.dxf'));
  const text = await sectionText(page, 'Quote', 'Narrowest hole');
  assert.match(text, /Narrowest hole24 mm/);
  assert.match(text, /Narrowest web20 mm/);
  await page.getByLabel(/^Thickness/).fill('15');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => document.querySelector('#sections').textContent.includes('× thickness'));
  assert.match(await sectionText(page, 'Quote', 'Narrowest hole'), /Narrowest hole24 mm · 1\.6 × thickness/);
});

test('a narrow web had three decimals, although it is not measured so exactly', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'web.dxf', dxf(square(0, 0, 100), square(10, 10, 20), square(30.1234, 10, 20)));
  assert.match(await sectionText(page, 'Quote', 'Narrowest web'), /Narrowest web0\.12 mm/);
});

test('the check of the program counts outlines, which may be fewer than the parts', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  // Two of its rectangles share a side, which is cut once: only one of them is cut as a whole.
  await drop(page, 'careless.dxf', sample('gaps-and-copies.dxf'));
  await planned(page, 'careless.dxf', 'done');
  assert.match(await sectionText(page, 'Drawing', /parts/), /6 parts/);
  const check = page.locator('.preflight');
  await check.getByText('closed outlines').waitFor();
  assert.match(await check.textContent(), /5 closed outlines\s· 9 contours, each cut once/);
  assert.doesNotMatch(await check.textContent(), /parts/);
});

test('the check of the program counted the cuts between micro-joints as contours, and closed outlines that have joints', async (t) => {
  const page = await openPlanned(t, 'fibre-3kw-thin', 'grid.dxf', grid(9));
  const check = page.locator('.preflight');
  await check.getByText('9 contours, each cut once').waitFor();
  const machine = await machineSection(page, SIZES.desktop);
  const joints = machine.locator('details.more', { hasText: 'Micro-joints' });
  await joints.evaluate((d) => (d.open = true));
  await replanned(page, () => joints.getByRole('checkbox').first().check());
  await check.getByText('read back').waitFor();
  const { summary } = await plan(page);
  assert.ok(summary.joints > 0);
  assert.match(await check.textContent(), /check\d+ cuts\s· beam/);
  assert.doesNotMatch(await check.textContent(), /contours|outlines/);
});

test('the width of the sheet interrupts the edge of the bed', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&machine=co2-100w' });
  await phase(page, 'done');
  // The edge of the bed, y = 0, is where the middle of the text is: 26 pixels below the drawing. It is red, because the drawing is left of the bed.
  const scale = await page.evaluate(() => {
    const { clientWidth, clientHeight } = document.querySelector('#canvas');
    return 0.94 * Math.min((clientWidth - 40 - 60) / 400, (clientHeight - 60 - 40) / 200);
  });
  await drop(page, 'edge.dxf', rectangle(-100, 26 / scale, 400, 200));
  await planned(page, 'edge.dxf', 'done');
  await still(page);
  await shot(page, 'size-on-bed-edge');
  const struck = await page.evaluate((scale) => {
    const canvas = document.querySelector('#canvas');
    const pen = document.createElement('canvas').getContext('2d');
    pen.fillStyle = getComputedStyle(document.body).getPropertyValue('--red-mark').match(/#\w+/)[0];
    pen.fillRect(0, 0, 1, 1);
    const line = [...pen.getImageData(0, 0, 1, 1).data];
    const middle = { x: 40 + (canvas.clientWidth - 100) / 2, y: 60 + (canvas.clientHeight - 100) / 2 + 100 * scale + 26 };
    /** Pixels with the colour of the edge, from one distance right of the middle to another. */
    const edge = (from, to) => {
      const { data } = canvas.getContext('2d').getImageData(Math.round(middle.x + from), Math.round(middle.y) - 3, to - from, 7);
      let n = 0;
      for (let i = 0; i < data.length; i += 4) if ([0, 1, 2].every((k) => Math.abs(data[i + k] - line[k]) < 24)) n += 1;
      return n;
    };
    return { at: edge(-22, 22), beside: edge(60, 150) };
  }, scale);
  assert.ok(struck.beside > 30, `the edge of the bed is drawn: ${struck.beside} pixels`);
  assert.ok(struck.at < 8, `and not through the text: ${struck.at} pixels`);
});

const jobOf = (page) => page.locator('.compare .solid td').first().textContent();
const wholeOf = (page) => page.locator('#playback .whole').textContent();

test('the same time was written as 0:19:47 and 19:46.5, and as 48.8 s and 0:48.7', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&seed=1' });
  await phase(page, 'done');
  for (const [name, form] of [['sheet_500.dxf', /^0:\d\d:\d\d$/], ['grid.dxf', /^\d\d\.\d s$/]]) {
    if (name === 'grid.dxf') {
      await drop(page, name, grid(20));
      await planned(page, name, 'done');
    }
    const job = await jobOf(page);
    assert.match(job, form);
    assert.equal(await wholeOf(page), `/ ${job}`);
    assert.equal(await page.locator('#playback .now').textContent(), job);
    await page.keyboard.press('t');
    await page.locator('.order-row').nth(1).waitFor();
    const begins = await page.locator('.order-row').nth(1).locator('.number').nth(2).textContent();
    assert.match(begins, name === 'grid.dxf' ? /^\d\.\d s$/ : form);
    await page.keyboard.press('t');
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press('Home');
    const card = await page.getByRole('region', { name: 'Selected contour' }).textContent();
    assert.ok(card.includes(`cut begins at ${begins}`), card);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Show side by side with the plan' }).click();
    await page.waitForFunction(() => /Nearest first · /.test(document.querySelector('.second-label')?.textContent));
    assert.equal(await page.locator('.first-label').textContent(), `Now · ${job}`);
    await page.getByRole('button', { name: 'Show side by side with the plan' }).click();
  }
});

test('the form of a time changed between the table and the playback when only the order of the drawing took longer than 1,000 s', async (t) => {
  // As drawn the head goes from one end of the bed to the other and back, 800 times.
  const rows = Array.from({ length: 800 }, (_, i) => [(i % 2) * 1450 + 10 + (i % 40) * 2.4, 10 + Math.floor(i / 2) * 2.4]);
  const page = await openPlanned(t, 'co2-100w', 'far.dxf', dxf(...rows.map(([x, y]) => square(x, y, 2))), { prepare: watchChart });
  const job = await jobOf(page);
  assert.match(job, /^0:0\d:\d\d$/);
  assert.equal(await wholeOf(page), `/ ${job}`);
  await nextFrames(page, 60);
  const marks = await page.evaluate(() => window.written.filter((text) => text !== '' && !/^(0\.01|0\.1|1|10) s$/.test(text)));
  for (const mark of marks) assert.match(mark, /^\d:\d\d:\d\d$/);
});

test('a job in which nothing can be saved had "0 s saved, 0 % of the job"', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'one.dxf', rectangle(10, 10, 100, 50));
  assert.equal(await page.locator('.large').textContent(), 'No time saved');
  assert.match(await sectionText(page, 'Result', 'No time saved'), /No time savedAs long as nearest first, the order of most programs; as long as drawn/);
});

/** Runs in the page before anything else: records what is written on the chart since it was last cleared, and what of it begins left of it. */
const watchChart = () => {
  window.written = [];
  window.clipped = [];
  const { fillText, clearRect } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
    if (this.canvas.closest('.chart')) window.written.push(text);
    if (this.canvas.closest('.chart') && this.textAlign === 'right' && place[0] < this.measureText(text).width) window.clipped.push(text);
    return fillText.call(this, text, ...place);
  };
  CanvasRenderingContext2D.prototype.clearRect = function (...box) {
    if (this.canvas.closest('.chart')) [window.written, window.clipped] = [[], []];
    return clearRect.call(this, ...box);
  };
};

test('the marks of the chart are apart by steps in which people count time', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&seed=1', prepare: watchChart });
  await phase(page, 'done');
  await still(page);
  await nextFrames(page, 60);
  const labels = await page.evaluate(() => window.written.filter((text) => text.includes(':')));
  const times = labels.map((text) => text.split(':').reduce((sum, part) => 60 * sum + Number(part), 0)).sort((a, b) => a - b);
  assert.ok(times.length >= 2, String(times));
  const steps = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600];
  for (let i = 1; i < times.length; i += 1) assert.ok(steps.includes(times[i] - times[i - 1]), String(times));
  assert.ok(times.every((s) => s % (times[1] - times[0]) === 0), String(times));
});

test('the chart of a job of more than ten hours cut off its marks', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'slow.dxf', grid(400), { prepare: watchChart });
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings', { exact: true }).click();
  await replanned(page, () => machine.getByLabel('Cutting speed').fill('0.2'));
  await page.waitForFunction(() => window.written.some((text) => /^\d\d:\d\d:\d\d$/.test(text)));
  assert.deepEqual(await page.evaluate(() => window.clipped), []);
});

test('a search that ended at once had a chart without a line', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'one.dxf', rectangle(10, 10, 100, 50));
  await page.locator('.chart').waitFor({ state: 'hidden' });
  await drop(page, 'grid.dxf', grid(20));
  await planned(page, 'grid.dxf', 'done');
  await page.locator('.chart').waitFor();
});

test('a drawing of 1.75 mm was 1.8 mm large', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&units=mm' });
  await phase(page, 'done');
  for (const [width, height, text] of [[0.95, 1.75, '0.95 × 1.75 mm'], [6.17, 197.06, '6.2 × 197.1 mm'], [0.5, 0.25, '0.500 × 0.250 mm'], [0.04, 20, '0.040 × 20 mm']]) {
    await drop(page, `${width}.dxf`, rectangle(10, 10, width, height));
    await page.waitForFunction((text) => document.querySelector('.measure').textContent === text, text);
  }
});

/** Runs in the page before anything else: records what is written beyond the right edge of the sheet. */
const watchEdge = () => {
  window.beyond = [];
  const { fillText } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.fillText = function (text, x, ...more) {
    if (this.canvas.id === 'canvas') {
      const { e } = this.getTransform();
      const right = e + x + (this.textAlign === 'right' ? 0 : this.textAlign === 'center' ? this.measureText(text).width / 2 : this.measureText(text).width);
      if (/bed/.test(text) && right > this.canvas.width) window.beyond.push(`${text} at ${right} of ${this.canvas.width}`);
    }
    return fillText.call(this, text, x, ...more);
  };
};

test('the size of the bed was cut off beside a high drawing', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'high.dxf', rectangle(0, 0, 404, 1400), { prepare: watchEdge });
  await still(page);
  assert.deepEqual(await page.evaluate(() => window.beyond), []);
});

test('a difference of minutes is written like the times that it is the difference of', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&seed=1' });
  await phase(page, 'done');
  assert.match(await page.locator('details.section', { has: page.getByRole('heading', { name: 'Result', exact: true }) }).textContent(), /; 0:1\d:\d\d less than as drawn/);
});

test('the check of the program counted the sides of a grid, and what is cut in one go, as contours', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.locator('.menu-item', { hasText: 'Perforated plate' }).click();
  await planned(page, 'perforated.dxf', 'done');
  assert.match(await sectionText(page, 'Drawing', /1 part/), /363 contours/);
  const check = page.locator('.preflight');
  await check.getByText('read back').waitFor();
  assert.match(await check.textContent(), /1 closed outline\s· 693 cuts\s· beam/);
});

test('the sheet is as large on the stage as in the top bar: beyond ten metres, too', async (t) => {
  // What is written on the canvas.
  const { page } = await openPage(t, { hash: 'seconds=0.4&units=mm', prepare: () => {
    window.written = new Set();
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...place) {
      window.written.add(text);
      return fillText.call(this, text, ...place);
    };
  } });
  await phase(page, 'done');
  await drop(page, 'large.dxf', dxf(square(0, 0, 4000), square(20_000, 4000, 4000)));
  await planned(page, 'large.dxf', 'done');
  await page.getByText('24.0 × 8.00 m').first().waitFor();
  await page.waitForFunction(() => window.written.has('24.0 m') && window.written.has('8.00 m'));
});
