// From a dropped drawing to its G-code, as a person would.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { beamRuns, grid, sample } from './page-drawings.mjs';
import { changedFrom, still } from './page-pictures.mjs';
import { download, drop, nextFrames, openPage, phase, planned, steady } from './page-support.mjs';

/** The job's time as the panel shows it, s. */
const best = (page) => page.locator('.compare .solid td').first().textContent();

test('the page opens with a sample already being planned', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning', 'done');
  assert.equal(await page.locator('.file-name').textContent(), 'sheet_500.dxf');
  assert.equal(await page.locator('#hint').textContent(), 'Drop a DXF or SVG anywhere');
  await page.waitForFunction(() => document.querySelector('.section .gist').textContent.startsWith('500 contours'));
  assert.equal(await page.locator('.measure').textContent(), '1500 × 1000 mm');
});

test('a dropped drawing is planned, improves, stops at once and gives G-code that cuts each contour once', async (t) => {
  const { page } = await openPage(t, {
    // Counts the numbers the search reports while it runs.
    prepare: () => {
      window.reports = new Set();
      document.addEventListener('DOMContentLoaded', () => {
        const now = () => document.body.dataset.phase === 'planning' && document.querySelector('.file-name')?.textContent === 'mine.dxf';
        new MutationObserver(() => now() && window.reports.add(document.querySelector('.budget').getAttribute('aria-valuenow')))
          .observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
      });
    },
  });
  await phase(page, 'planning');
  await drop(page, 'mine.dxf', sample('sheet_500.dxf'));
  await planned(page, 'mine.dxf', 'planning');
  // The sheet's border is recognised and ignored without a question.
  await page.waitForFunction(() => document.querySelector('.section .gist').textContent.startsWith('500 contours'));
  await page.evaluate(() => window.reports.clear());
  await page.waitForFunction(() => window.reports.size >= 3);
  assert.equal(await page.locator('#hint').isVisible(), false);

  // From the click to the end as the page sees them: a busy machine takes its time to bring the click about.
  await page.evaluate(() => {
    document.querySelector('.dock').addEventListener('click', () => (window.pressed = performance.now()), { capture: true, once: true });
    new MutationObserver(() => document.body.dataset.phase === 'done' && (window.ended ??= performance.now())).observe(document.body, { attributeFilter: ['data-phase'] });
  });
  await page.getByRole('button', { name: 'Stop' }).click();
  await phase(page, 'done');
  const waited = await page.evaluate(() => window.ended - window.pressed);
  assert.ok(waited < 3000, `stop takes effect at once, not after ${waited} ms`);
  assert.match(await page.locator('.dock-head').textContent(), /^Stopped/);
  await page.waitForFunction(() => / s saved$|min.* saved$/.test(document.querySelector('.large').textContent));

  const { name, bytes: program } = await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
  assert.equal(name.replace(/\d{4}-\d\d-\d\d/, 'DATE'), 'mine-co2-100w-DATE.nc');
  const runs = beamRuns(program.toString());
  assert.equal(runs.length, 500);
  for (const run of runs) assert.ok(Math.hypot(run.from.x - run.to.x, run.from.y - run.to.y) < 0.01, 'a closed contour ends where it began');
  const length = runs.reduce((sum, run) => sum + run.length, 0);
  assert.ok(Math.abs(length / 35_811.62 - 1) < 1e-3, `all of the cut length, got ${length}`);
});

/** The name of a download of the first sample: file, machine, today's date. */
const named = (suffix) => {
  const now = new Date();
  return `sheet_500-co2-100w-${now.getFullYear()}-${String(now.getMonth() + 1).padStart(2, '0')}-${String(now.getDate()).padStart(2, '0')}${suffix}`;
};

test('the other downloads are what they say', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await page.keyboard.press('s');
  await phase(page, 'done');
  const get = (label) => download(page, () => page.locator('.downloads').getByRole('button', { name: label, exact: true }).click());
  const plan = await get('Plan (JSON)');
  assert.equal(plan.name, named('.plan.json'));
  const document = JSON.parse(plan.bytes.toString());
  assert.equal(document.schema, 'kerfway.plan/1');
  assert.equal(document.summary.contours, 500);
  const svg = await get('SVG');
  assert.equal(svg.name, named('.svg'));
  assert.match(svg.bytes.toString().slice(0, 200), /<svg/);
  const dxf = await get('DXF');
  assert.equal(dxf.name, named('-ordered.dxf'));
  assert.match(dxf.bytes.toString().slice(-40), /EOF\s*$/);
  const png = await get('PNG');
  assert.equal(png.name, named('.png'));
  assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
  const report = await get('Report');
  assert.equal(report.name, named('-report.html'));
  assert.match(report.bytes.toString(), /<h1>sheet_500\.dxf<\/h1>/);
});

test('pause holds the search, resume goes on, keep improving adds to it', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
  await phase(page, 'paused');
  // While it searches, the number of moves changes several times a second.
  await steady(page, '.dock .soft');
  await page.getByRole('button', { name: 'Resume' }).click();
  await phase(page, 'planning', 'done');
  await page.keyboard.press('s');
  await phase(page, 'done');
  const before = await best(page);
  await page.getByRole('button', { name: 'Keep improving' }).click();
  await phase(page, 'planning');
  await page.keyboard.press('s');
  await phase(page, 'done');
  assert.ok(Number.parseFloat(await best(page)) <= Number.parseFloat(before));
});

test('an ignored layer is neither planned nor in the G-code', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await drop(page, 'grid.dxf', grid(30));
  await planned(page, 'grid.dxf');
  await page.locator('.section summary').first().click();
  const choice = page.getByLabel('Operation for layer HOLES');
  if (!(await choice.isVisible())) await page.locator('.section summary').first().click();
  await choice.selectOption('ignore');
  await page.waitForFunction(() => document.querySelector('.section .gist').textContent.startsWith('10 contours'));
  await phase(page, 'planning', 'done');
  await page.keyboard.press('s');
  await phase(page, 'done');
  const { bytes } = await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
  assert.equal(beamRuns(bytes.toString()).length, 10);
});

test('units can be overridden with one click, and the size follows', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await drop(page, 'grid.dxf', grid(8));
  await planned(page, 'grid.dxf');
  const size = async () => (await page.locator('.measure').textContent()).match(/[\d.]+/g).map(Number);
  const millimetres = await size();
  await page.locator('.units').click();
  await page.getByRole('button', { name: /^inches/ }).click();
  await page.waitForFunction(() => document.querySelector('.units').textContent.includes('chosen by you'));
  await phase(page, 'planning', 'done');
  const inches = await size();
  assert.ok(Math.abs(inches[0] / millimetres[0] - 25.4) < 0.05, `${inches} against ${millimetres}`);
});

test('the page asks about uncertain units before it plans', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  // 8 contours within 0.1 by 0.1 units, no units in the header: nothing speaks for any unit.
  await drop(page, 'doubt.dxf', grid(8, { units: null, step: 0.012 }));
  await phase(page, 'question');
  const card = page.getByRole('region', { name: 'How large is this drawing?' });
  await page.waitForFunction(() => document.activeElement.matches('.card.question'));
  const answers = await card.getByRole('button').evaluateAll((all) => all.map((b) => [b.lastElementChild.textContent, b.className]));
  assert.deepEqual(answers, [['in millimetres', ''], ['in inches, guessed', ''], ['in centimetres', ''], ['in metres', '']], 'none is proposed');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Space');
  await nextFrames(page, 10);
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'question', 'no key answers before an answer is chosen');
  assert.equal(await page.locator('.dock').getByRole('button', { name: /G-code/ }).isVisible(), false);
  await card.getByRole('button', { name: /inches/ }).click();
  await phase(page, 'planning', 'done');
  assert.match(await page.locator('.units').textContent(), /in.*chosen by you/);
  assert.equal(await card.isVisible(), false);
  await page.keyboard.press('Control+z');
  await card.waitFor();
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'question', 'it is asked again when the answer is taken back');
});

test('findings are listed by kind, and one click shows their place', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await drop(page, 'flawed.dxf', flawed());
  await planned(page, 'flawed.dxf');
  await page.keyboard.press('s');
  await phase(page, 'done');
  await page.locator('.section').first().evaluate((section) => {
    for (const details of [section, ...section.querySelectorAll('details')]) details.open = true;
  });
  const list = page.locator('.findings');
  assert.match(await list.textContent(), /lies on top of another/);
  assert.match(await list.textContent(), /does not close/);
  assert.match(await list.textContent(), /TEXT/);
  const before = await still(page);
  await list.getByRole('button', { name: /show/ }).first().click();
  await changedFrom(page, before);
});

/** Two copies of a circle, a line that meets nothing, a word. */
function flawed() {
  const circle = ['0', 'CIRCLE', '8', 'CUT', '10', '200', '20', '200', '40', '8'];
  const line = ['0', 'LINE', '8', 'CUT', '10', '220', '20', '220', '11', '240', '21', '220'];
  const word = ['0', 'TEXT', '8', 'CUT', '10', '0', '20', '0', '40', '5', '1', 'PART 7'];
  const extra = [...circle, ...circle, ...line, ...word].join('\n');
  return Buffer.from(grid(30).toString().replace('0\nENDSEC\n0\nEOF', `${extra}\n0\nENDSEC\n0\nEOF`));
}
