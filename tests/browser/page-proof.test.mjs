// What is left to gain: the proof goes on after the search, in a worker of its own, once somebody uses the page.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { beamRuns, grid } from './page-drawings.mjs';
import { download, drop, openPage, phase, planned } from './page-support.mjs';

const isProof = ({ file }) => file.includes('kerfway_research');

/** Plans a drawing for next to no time, and returns its program and a function that gives that of the page. */
async function plannedAtOnce(t, hash, contours) {
  const { page } = await openPage(t, { hash });
  await phase(page, 'done');
  await drop(page, 'grid.dxf', grid(contours));
  await planned(page, 'grid.dxf', 'done');
  const program = async () => (await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click())).bytes.toString();
  return { page, program, first: await program() };
}

/** Runs in the page: what is asked of the planner begins so many milliseconds later, as on a slow machine; `asked` lists what was. */
const slowAnswers = () => {
  const { postMessage } = Worker.prototype;
  [window.take, window.asked] = [{}, []];
  Worker.prototype.postMessage = function (message, ...rest) {
    window.asked.push(message.type);
    const late = window.take[message.type] ?? 0;
    if (late === 0) return postMessage.call(this, message, ...rest);
    setTimeout(() => postMessage.call(this, message, ...rest), late);
  };
};

const facts = (page) => page.locator('.preflight').textContent();

// Each waits for ten seconds until the proof begins: side by side.
describe('a proof after the search', { concurrency: true }, () => {
  it('proves the path optimal, and there is nothing more to improve', async (t) => {
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

  it('makes a better path that it finds the plan, and its program is checked again', async (t) => {
    const { page, program, first } = await plannedAtOnce(t, 'seconds=0.001', 24);
    await page.locator('.preflight').getByText('The program passes its check').waitFor();
    const before = await facts(page);
    await page.evaluate(() => {
      window.lost = 0;
      const check = document.querySelector('.preflight');
      new MutationObserver(() => (window.lost += Number(check.hidden || check.matches('.unchecked')))).observe(check, { attributes: true, childList: true, subtree: true });
    });
    await page.waitForFunction(() => document.querySelector('.dock-head').textContent === 'Optimal: no better path exists.');
    assert.notEqual(await program(), first);
    await page.waitForFunction((old) => ![old, ''].includes(document.querySelector('.preflight:not([aria-busy=true])')?.textContent ?? ''), before);
    assert.match(await facts(page), /24 contours/);
    assert.equal(await page.evaluate(() => window.lost), 0, 'the verdict stays until there is one on the better path');
    assert.deepEqual(beamRuns(await program()).length, 24);
  });

  it('keeps what was worked out about what saves what, which disappeared with every better path', async (t) => {
    const { page } = await plannedAtOnce(t, 'seconds=0.001', 24);
    await page.evaluate(() => [...document.querySelectorAll('details.more')].find((d) => d.textContent.startsWith('What saves what')).setAttribute('open', ''));
    await page.getByRole('button', { name: 'Work it out' }).click();
    await page.getByText('Plans without a decision were searched').waitFor();
    const order = () => page.locator('.savings dd').first().textContent({ timeout: 1000 });
    const before = await order();
    await page.waitForFunction(() => document.querySelector('.dock-head').textContent === 'Optimal: no better path exists.');
    assert.notEqual(await order(), before);
    assert.equal(await order(), `saves ${(await page.locator('.large').textContent()).replace(' saved', '')}`);
  });

  it('leaves the plan of another method as it is', async (t) => {
    const { page, program, first } = await plannedAtOnce(t, 'seconds=1&method=greedy', 12);
    const left = page.locator('.parts .gap + dd');
    await left.getByText(/^at most/).waitFor();
    // The proof takes a second, and tells of a better path at its end at the latest.
    let [before, now] = ['', await left.textContent()];
    while (now !== before) {
      await page.waitForTimeout(3000);
      [before, now] = [now, await left.textContent()];
    }
    assert.equal(await program(), first);
  });
});

describe('a better path that a proof finds', { concurrency: true }, () => {
  it('left the report on the path before in place, as if it were of the better one', async (t) => {
    const { page } = await openPage(t, { hash: 'seconds=0.001', prepare: slowAnswers });
    await phase(page, 'done');
    await drop(page, 'grid.dxf', grid(24));
    await planned(page, 'grid.dxf', 'done');
    await page.locator('.preflight').getByText('24 contours').waitFor();
    await page.evaluate(() => (window.take = { check: 2000 }));
    const job = () => document.querySelector('.compare tbody:last-of-type td').textContent;
    const before = await page.evaluate(job);
    await page.waitForFunction((before) => document.querySelector('.compare tbody:last-of-type td').textContent !== before, before);
    assert.match(await facts(page), /^The program passes its check\s*A better path was found\. Its program is being checked\.$/);
    await page.locator('.preflight').getByText('24 contours').waitFor();
    const now = await page.evaluate(job);
    assert.notEqual(now, before);
    assert.ok((await facts(page)).replaceAll('\u00a0', ' ').includes(now.replaceAll('\u00a0', ' ')), now);
  });

  it('with a better path ended the reading of another file for the page', async (t) => {
    const { page } = await openPage(t, { hash: 'seconds=0.001', prepare: slowAnswers });
    await phase(page, 'done');
    await drop(page, 'grid.dxf', grid(24));
    await planned(page, 'grid.dxf', 'done');
    const job = await page.evaluate(() => document.querySelector('.compare tbody:last-of-type td').textContent);
    await page.evaluate(() => (window.take = { offer: 1000, load: 4000 }));
    await page.waitForFunction(() => window.asked.includes('offer'));
    await drop(page, 'other.dxf', grid(9));
    await phase(page, 'reading');
    await page.waitForFunction((job) => document.querySelector('.compare tbody:last-of-type td').textContent !== job, job);
    assert.equal(await page.evaluate(() => document.body.dataset.phase), 'reading');
    await planned(page, 'other.dxf', 'done');
  });
});
