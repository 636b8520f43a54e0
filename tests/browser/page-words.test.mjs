// Languages and inches: what people read is in the language and the unit of lengths that they have chosen, and both choices are kept.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { wordsOf } from '../package/page-words.mjs';
import { circle, dxf, polygon, square, unitless } from '../package/support.mjs';
import { sample } from './page-drawings.mjs';
import { shot } from './page-pictures.mjs';
import { download, drop, openEverything, openPage, phase, planned, replanned, until } from './page-support.mjs';

const LANGUAGES = ['de', 'es', 'zh', 'ja'];

/** Texts that are not functions, with their places. */
const texts = (value, at = '') => (typeof value === 'string' ? [[at, value]] : value !== null && typeof value === 'object' ? Object.entries(value).flatMap(([key, inner]) => texts(inner, `${at}.${key}`)) : []);

/** Chooses an entry of the menu of settings; the page starts anew with it. */
async function choose(page, entry) {
  await page.locator('.top .settings').click();
  await Promise.all([page.waitForEvent('load'), page.getByRole('button', { name: entry, exact: true }).click()]);
}

/** Everything on the page that somebody reads or hears, except what the planner says. */
const read = (page) => page.evaluate(() => {
  const all = [];
  for (const element of document.querySelectorAll('body *')) {
    if (element.closest('[lang=en], noscript, script')) continue;
    for (const node of element.childNodes) if (node.nodeType === Node.TEXT_NODE && node.textContent.trim() !== '') all.push(node.textContent.trim());
    for (const name of ['aria-label', 'title', 'placeholder']) if (element.getAttribute(name)) all.push(element.getAttribute(name));
  }
  return all;
});

test('every language: the job stays, nothing is left in English, numbers and errors are in its form, and it works without a network', async (t) => {
  const { page, sent } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  assert.equal(sent.filter(({ file }) => file.includes('language-')).length, 0, 'a first visit in English loads no other language');
  await drop(page, 'careless.dxf', sample('gaps-and-copies.dxf'));
  await planned(page, 'careless.dxf', 'done');
  // From then on the service worker stores each language that is loaded.
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  const size = await page.locator('.top .measure').textContent();
  assert.match(size, /^\d+(\.\d)? × \d+(\.\d)? mm$/);
  const english = await wordsOf('en');
  for (const language of LANGUAGES) {
    const words = await wordsOf(language);
    await choose(page, { de: 'Deutsch', es: 'Español', zh: '简体中文', ja: '日本語' }[language]);
    await planned(page, 'careless.dxf', 'done');
    assert.equal(await page.evaluate(() => document.documentElement.lang), words.numbers.locale);
    await page.locator('details.more.grave > summary').first().click({ force: true });
    const findings = await page.locator('.findings').textContent();
    const n = await page.locator('.finding-group summary').first().textContent();
    assert.ok(Object.values(words.findingTitles).some((say) => n.includes(say(2, '#').split('#').sort((a, b) => b.length - a.length)[0].trim())), `${language}: ${n}`);
    assert.ok(findings.length > 50);
    // A text of the page that English has and this language has otherwise.
    const foreign = new Map(texts(english).filter(([at, text]) => text.length > 3 && !new Set(texts(words).map(([, own]) => own)).has(text) && at !== '.top.openFile').map(([at, text]) => [text, at]));
    const left = (await read(page)).filter((text) => foreign.has(text));
    assert.deepEqual([...new Set(left)], [], `${language} is complete on the page`);
    await drop(page, 'letter.pdf', Buffer.from('%PDF-1.7 not a drawing'));
    const card = page.locator('.failure');
    await card.waitFor();
    assert.ok((await card.textContent()).includes(words.sentences.isPdf), await card.textContent());
    await card.getByRole('button').click();
    await shot(page, `language-${language}`);
  }
  // Japanese is chosen now. Its words come from the store of the service worker.
  await until(page, 'the language is stored', () => page.evaluate(async () => {
    const stored = await Promise.all((await caches.keys()).map(async (name) => (await caches.open(name)).keys()));
    return ['language-ja', 'language-sentences'].every((name) => stored.flat().some(({ url }) => url.includes(name)));
  }));
  await page.context().setOffline(true);
  await page.reload();
  await planned(page, 'careless.dxf', 'done');
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'ja', 'kept, and there without a network');
  await page.context().setOffline(false);

  await choose(page, 'Deutsch');
  await planned(page, 'careless.dxf', 'done');
  assert.equal(await page.locator('.top .measure').textContent(), size.replaceAll('.', ','), 'numbers as the language writes them');
  const german = await wordsOf('de');
  const report = (await download(page, () => page.locator('.downloads').getByRole('button', { name: german.result.report, exact: true }).click())).bytes.toString();
  assert.match(report, /<html lang="de">[^]*<h2>Schneidreihenfolge<\/h2>/);
  assert.match(report, /<b>Warnung<\/b>/);
  assert.doesNotMatch(report, />(Time|Layers|Parts|Findings|None\.|cut|mark|Nearest first)</, 'the report is in the language of the page');
  await page.locator('.top .settings').click();
  assert.match(await page.locator('.popover:popover-open').textContent(), /noch niemand geprüft/, 'it says that it is a draft');
});

test('lengths in inches: shown, typed and kept, and the drawing and the program stay in millimetres', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const square = [[20, 20], [274, 20], [274, 147], [20, 147]].flatMap(([x, y]) => ['10', x, '20', y]);
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES', '0', 'LWPOLYLINE', '8', 'CUT', '90', 4, '70', 1, ...square, '0', 'ENDSEC', '0', 'EOF'];
  await drop(page, 'plate.dxf', Buffer.from(`${text.join('\n')}\n`));
  await planned(page, 'plate.dxf', 'done');
  assert.equal(await page.locator('.top .measure').textContent(), '254 × 127 mm');
  await choose(page, 'Inches');
  await planned(page, 'plate.dxf', 'done');
  assert.equal(await page.locator('.top .measure').textContent(), '10 × 5 in');
  await page.keyboard.press('t');
  await page.locator('.order-row').nth(1).waitFor();
  assert.match(await page.locator('.order-row').nth(1).textContent(), /30\.0 in/, 'the length of the contour');
  await page.keyboard.press('Home');
  assert.match(await page.locator('.card.contour').textContent(), /30\.0 in/);
  await page.keyboard.press('t');
  await page.locator('summary:has-text("Machine")').first().click();
  await page.locator('summary:has-text("Advanced settings")').click();
  const kerf = page.getByLabel('Kerf width');
  assert.deepEqual(await page.locator('.section .unit').evaluateAll((all) => all.filter((u) => /\bmm\b/.test(u.textContent)).map((u) => u.textContent)), [], 'no field is in millimetres');
  await replanned(page, () => kerf.fill('0.01'));
  // 0.254 mm around the outside: half the kerf on each side.
  const { bytes } = await download(page, () => page.locator('.downloads').getByRole('button', { name: 'G-code' }).click());
  const program = bytes.toString();
  assert.match(program, /^G21\b/m, 'millimetres');
  assert.match(program, /X274\.127\b/);
  const report = (await download(page, () => page.locator('.downloads').getByRole('button', { name: 'Report', exact: true }).click())).bytes.toString();
  assert.match(report, /<dt>Size<\/dt><dd>10(\.0\d*)? × 5(\.0\d*)? in, read in mm/);
  assert.match(report, /<th>Entry, in<\/th>/);
  await shot(page, 'inches');
  await page.reload();
  await planned(page, 'plate.dxf', 'done');
  assert.equal(await page.locator('.top .measure').textContent(), '10 × 5 in', 'kept');
});

test('in German, a border is asked about in German, and numbers of the bed, the budget, the chart and the calibration have a comma', async (t) => {
  // What is written on canvases cannot be read from the page.
  const prepare = () => {
    localStorage.setItem('kerfway.language', 'de');
    window.written = [];
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      window.written.push(text);
      fillText.call(this, text, ...rest);
    };
  };
  const { page } = await openPage(t, { hash: 'machine=diode-hobby&seconds=0.4&units=mm', prepare });
  await phase(page, 'planning', 'done');
  const box = (x, y, w, h) => polygon([[x, y], [x + w, y], [x + w, y + h], [x, y + h]]);
  await drop(page, 'frame.dxf', Buffer.from(dxf(box(10, 10, 310, 215), box(30, 30, 270, 175), circle(110, 110, 20))));
  await phase(page, 'question');
  const question = await page.locator('.question').textContent();
  assert.match(question, /vielleicht die Tafel und kein Schnitt: 1 Teil liegt darin\. Es wird/);
  // With holes enough for a search to find something, so that there is a chart.
  const holes = Array.from({ length: 16 }, (_, k) => circle(-15 + ((37 * k) % 41), 14 + ((23 * k) % 43), 0.5));
  await drop(page, 'off.dxf', Buffer.from(dxf(square(-20.5, 10, 50), ...holes)));
  await planned(page, 'off.dxf', 'done');
  await openEverything(page);
  assert.match(await page.locator('.advice').textContent(), /von x -20,5 bis 29,5 und y 10 bis 60 mm, über den Arbeitsbereich hinaus/);
  assert.equal(await page.locator('select', { hasText: '0,4 s' }).count(), 1, 'the budget');
  await page.waitForFunction(() => window.written.includes('0,01 s'));
  assert.deepEqual(await page.evaluate(() => window.written.filter((text) => /\d\.\d/.test(text))), [], 'the chart and the stage');
  await page.getByPlaceholder('gemessen').fill('200');
  await page.getByRole('button', { name: 'Diesen Auftrag hinzufügen' }).click();
  await page.getByRole('button', { name: 'Maschine anpassen' }).click();
  await page.locator('.calibrated').getByText('off.dxf').waitFor();
  const cells = (await page.locator('.calibrated td').allTextContents()).filter((text) => /\d[.,]\d/.test(text));
  assert.ok(cells.length > 2 && cells.every((text) => !/\d\.\d/.test(text)), cells.join('; '));
  await page.keyboard.press('t');
  await page.locator('.order-row').nth(1).waitFor();
  assert.match(await page.locator('.order-row').nth(1).textContent(), /-?\d+,\d; -?\d+,\d/, 'a comma does not also separate two numbers');
});

test('in German and in inches, why a drawing has its unit is said in German, with its size in inches', async (t) => {
  const chosen = () => {
    localStorage.setItem('kerfway.language', 'de');
    localStorage.setItem('kerfway.lengths', 'in');
  };
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: chosen });
  await phase(page, 'planning', 'done');
  await drop(page, 'plate.dxf', Buffer.from(unitless(polygon([[0, 0], [37, 0], [37, 20], [0, 20]]))));
  await planned(page, 'plate.dxf', 'question');
  const reason = 'Die Datei nennt keine Einheit: Angenommen sind Millimeter (1,46 in), denn die meisten Schneidzeichnungen sind in Millimetern.';
  assert.equal(await page.locator('.card.question p').first().textContent(), reason);
  await shot(page, 'units-german-inches');
  await page.locator('.card.question button').first().click();
  await planned(page, 'plate.dxf', 'done');
  assert.equal(await page.locator('.top .source').locator('..').getAttribute('title'), 'Gewählt: Millimeter.');
});

for (const language of ['de', 'es']) {
  test(`the unit of the entries was cut off in the head of the table in Spanish (${language})`, async (t) => {
    const { page } = await openPage(t, { size: { width: 1280, height: 720 }, hash: 'seconds=0.4', prepare: `localStorage.setItem('kerfway.language', '${language}')` });
    await phase(page, 'done');
    await page.keyboard.press('t');
    await page.locator('.rows .order-row').first().waitFor();
    // But for the layer, whose name may be any length.
    const cut = (all) => all.filter((cell) => cell.textContent !== '' && cell.scrollWidth > cell.clientWidth).map((cell) => cell.textContent);
    assert.deepEqual(await page.locator('.order .order-row > :not(:nth-child(3))').evaluateAll(cut), []);
  });
}

test('what is set for a layer is written as its field is: a German noun had a small letter', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: `localStorage.setItem('kerfway.language', 'de')` });
  await phase(page, 'done');
  await openEverything(page);
  await page.locator('.layer').first().getByRole('button').last().click();
  await replanned(page, () => page.locator('.layer-settings').first().getByLabel('Blasluft').check());
  assert.equal(await page.locator('.layer-set').first().textContent(), 'Blasluft');
});

test('in German, of two settings that exclude each other it was not said which, and the methods had English names', async (t) => {
  // A plate that reaches beyond the bed has no sheet to cut up.
  const { page } = await openPage(t, { hash: 'seconds=0.4&machine=co2-100w&units=mm', prepare: `localStorage.setItem('kerfway.language', 'de')` });
  await phase(page, 'done');
  await drop(page, 'square.dxf', Buffer.from(dxf(square(-20, 10, 50))));
  await planned(page, 'square.dxf', 'done');
  const words = await wordsOf('de');
  for (const title of [words.plan.title, words.machine.title]) await page.locator('details.section', { has: page.getByRole('heading', { name: title, exact: true }) }).evaluate((d) => (d.open = true));
  await page.getByLabel(words.plan.method).selectOption({ label: words.result.greedy });
  await page.getByText(words.sentences.goesToNearest).waitFor();
  await page.getByLabel(words.skeleton.on).check();
  await phase(page, 'ready');
  assert.match(await page.locator('.dock-head').textContent(), /^Zwei Einstellungen schließen einander aus\. \(Skeleton cuts are not possible: the job reaches beyond the sheet/);
});
