// What a price needs besides one report: confirmed reports, baskets, quantities with an estimate of sheets, pictures of parts.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { basket, inspect, isKerfwayError, partThumbnail, priceBreaks, quote, verifyQuote } from 'kerfway';
import { sheetsFor } from '../../dist/sdk/sheets.js';
import { planningOf } from '../../dist/sdk/verify-quote.js';
import { bytes, circle, dxf, fixture, folder, KEYBOARD, kerfway, line, square } from './support.mjs';

const OPTIONS = { name: 'keyboard.dxf', moves: 1000, seed: 1, units: 'mm', material: { name: 'Steel', thickness: 3, density: 7.85 }, limits: { smallest_hole: 5, hole_to_edge: 3 } };
const close = (a, b) => Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b));

describe('verifyQuote', () => {
  it('accepts its own report, under another name, from JSON, and in any order of its fields', async () => {
    for (const options of [OPTIONS, { moves: 500, seed: 3, machine: 'fibre-3kw-thin', partByPart: true, layers: [] }, { moves: 500, seed: 1, workers: 2 }, { moves: 300, seed: 1, method: 'rlsga', parameters: { population: 12 } }]) {
      const report = JSON.parse(JSON.stringify(await quote(bytes(KEYBOARD), options)));
      const shuffled = Object.fromEntries(Object.entries(report).reverse());
      shuffled.input = { ...shuffled.input, name: 'renamed.dxf' };
      const { valid, differences, report: again } = await verifyQuote(bytes(KEYBOARD), shuffled);
      assert.deepEqual([valid, differences, again?.hash], [true, [], report.hash], JSON.stringify(options));
    }
  });

  it('rejects a changed byte of the drawing, and a changed figure of the report even if its hash is untouched', async () => {
    const report = await quote(bytes(KEYBOARD), OPTIONS);
    const drawing = bytes(KEYBOARD);
    const at = drawing.lastIndexOf('5'.charCodeAt(0));
    drawing[at] = '6'.charCodeAt(0);
    assert.deepEqual(await verifyQuote(drawing, report), { valid: false, differences: ['input'], report: null });
    for (const [field, change] of [
      ['times', (r) => (r.times.total /= 2)], ['weight', (r) => (r.weight = 1)], ['hash', (r) => (r.hash = '0'.repeat(64))], ['parts', (r) => (r.parts[0].items[0].times.cut = 0)],
      ['confidence', (r) => (r.confidence = { level: 'low', reasons: [] })], ['version', (r) => (r.version = '9.9.9')], ['price', (r) => (r.price = 5)],
    ]) {
      const forged = structuredClone(report);
      change(forged);
      const { valid, differences, report: again } = await verifyQuote(bytes(KEYBOARD), forged);
      assert.deepEqual([valid, differences, again.hash], [false, [field], report.hash], field);
    }
    // Another machine is another plan, so many fields differ.
    const slower = structuredClone(report);
    slower.machine.cut.speed /= 2;
    assert.equal((await verifyQuote(bytes(KEYBOARD), slower)).valid, false);
  });

  it('refuses what is no report, an old one, and one that would keep the server busy', async () => {
    const report = await quote(bytes(KEYBOARD), OPTIONS);
    for (const [given, code] of [
      [null, 'not-a-quote'], [{}, 'not-a-quote'], [{ schema: 'kerfway.quote/1' }, 'not-a-quote'], [{ ...report, options: 5 }, 'not-a-quote'], [{ ...report, input: null }, 'not-a-quote'],
      [{ ...report, moves: 1e12 }, 'out-of-range'], [{ ...report, moves: NaN }, 'out-of-range'], [{ ...report, machine: { name: 'x' } }, 'missing-field'], [{ ...report, seed: 'x' }, 'wrong-type'],
    ]) {
      const error = await verifyQuote(bytes(KEYBOARD), given).then(() => assert.fail(code), (e) => e);
      assert.ok(isKerfwayError(error), String(error));
      assert.equal(error.code, code, error.message);
    }
    // The number of workers stood on both sides of the limit, so that it had none.
    for (const [given, field] of [[{ ...report, workers: 64, moves: 1 }, 'workers'], [{ ...report, workers: 16, moves: 200_000_000 }, 'moves'], [{ ...report, workers: 0 }, 'workers']]) {
      const error = await verifyQuote(bytes(KEYBOARD), given).then(() => assert.fail(field), (e) => e);
      assert.deepEqual([error.code, error.params.field], ['out-of-range', field], error.message);
    }
    const old = await verifyQuote(bytes(KEYBOARD), { schema: 'kerfway.quote/1' }).catch((e) => e.message);
    assert.match(old, /reads kerfway\.quote\/2\. Make the quote again\./);
  });
});

describe('reports of small drawings', () => {
  it('were refused when their search had lasted a second', async () => {
    const plate = dxf(square(0, 0, 100), circle(50, 50, 10));
    const report = await quote(plate, { moves: 6_000_000, seed: 1 });
    assert.equal(report.moves, 6_000_000);
    assert.deepEqual((await verifyQuote(plate, report)).differences, []);
  });

  it('may have 500 million moves, and those of large drawings 250,000 for each contour', () => {
    const report = { workers: null, seed: 1, method: 'tour-tree', machine: {}, setting: null, placement: null, parameters: null };
    const loaded = (count) => ({ contours: Array.from({ length: count }, () => ({ operation: 'cut' })) });
    for (const [count, workers, most] of [[3, null, 500_000_000], [3, 4, 125_000_000], [2_000, null, 500_000_000], [10_000, null, 2_500_000_000]]) {
      assert.equal(planningOf({ ...report, workers, moves: most }, loaded(count)).moves, most);
      const message = `The report's field "moves" is ${most + 1}. Up to ${most} are verified for this drawing.`;
      assert.throws(() => planningOf({ ...report, workers, moves: most + 1 }, loaded(count)), { code: 'out-of-range', message });
    }
  });
});

it('reports without some field were TypeErrors without a code', async () => {
  const report = await quote(dxf(square(0, 0, 100), circle(50, 50, 10)), { moves: 10, seed: 1 });
  const drawing = dxf(square(0, 0, 100), circle(50, 50, 10));
  const without = (field) => Object.fromEntries(Object.entries(report).filter(([name]) => name !== field));
  for (const field of ['placement', 'input', 'options', 'machine', 'setting', 'method', 'parameters', 'workers', 'material', 'checks']) {
    for (const [given, said] of [[without(field), `The report lacks the field "${field}".`], [{ ...report, [field]: 5 }, `The report's field "${field}" is not as in a report of a quote.`]]) {
      if (field === 'workers' && given.workers === 5) continue;
      const error = await verifyQuote(drawing, given).then(() => assert.fail(field), (e) => e);
      assert.deepEqual([error.code, error.params?.field, error.message], ['not-a-quote', `report.${field}`, said]);
    }
  }
  for (const field of ['input', 'hash', 'part_count', 'times', 'net_area', 'weight', 'parts']) {
    assert.throws(() => basket([{ report: without(field) }]), (e) => e.code === 'not-a-quote' && e.params.field === `items[0].report.${field}`, field);
    assert.throws(() => priceBreaks(without(field), [1]), (e) => e.code === 'not-a-quote' && e.params.field === `report.${field}`, field);
  }
  for (const [call, code] of [
    [() => basket([{ report: { schema: 'kerfway.quote/2' } }]), 'not-a-quote'], [() => basket([null]), 'wrong-type'], [() => basket([], null), 'wrong-type'],
    [() => priceBreaks(report, [1], null), 'wrong-type'], [() => priceBreaks(report, [1], { stok: {} }), 'unknown-field'],
  ]) assert.throws(call, (e) => isKerfwayError(e) && e.code === code, String(call));
});

describe('baskets and price breaks', () => {
  it('multiply and add up what the reports say', async () => {
    const [a, b] = await Promise.all([quote(dxf(square(0, 0, 100), circle(50, 50, 10)), { moves: 200, seed: 1, units: 'mm', material: { thickness: 2, density: 8 } }), quote(bytes(KEYBOARD), OPTIONS)]);
    const made = basket([{ report: a, quantity: 10 }, { report: b }], { stock: { width: 3000, height: 1500 } });
    assert.equal(made.schema, 'kerfway.basket/1');
    assert.deepEqual(made.items.map((i) => [i.name, i.quantity, i.hash]), [[a.input.name, 10, a.hash], ['keyboard.dxf', 1, b.hash]]);
    for (const kind of Object.keys(a.times)) assert.ok(close(made.times[kind], 10 * a.times[kind] + b.times[kind]), kind);
    assert.ok(close(made.weight, 10 * a.weight + b.weight) && close(made.net_area, 10 * a.net_area + b.net_area));
    assert.equal(made.part_count, 10 * a.part_count + b.part_count);
    assert.deepEqual([made.sheets.count, made.sheets.estimate], [1, true]);
    const breaks = priceBreaks(a, [1, 10, 1000], { stock: { width: 1000, height: 1000, gap: 5, margin: 10 } });
    assert.deepEqual(breaks.map((p) => p.quantity), [1, 10, 1000]);
    // 9 squares of 100 mm with gaps of 5 fit beside each other in 980 mm: 9 * 9 on a sheet.
    assert.deepEqual(breaks.map((p) => p.sheets.count), [1, 1, Math.ceil(1000 / 81)]);
    assert.ok(close(breaks[2].times.total, 1000 * a.times.total));
    assert.equal(basket([{ report: { ...a, weight: null } }, { report: b }]).weight, null);
    assert.equal(basket([]).sheets, null);
  });

  it('name what is wrong', async () => {
    const report = await quote(dxf(square(0, 0, 10)), { moves: 10, seed: 1 });
    for (const [call, code, field] of [
      [() => basket([{ report: {} }]), 'not-a-quote', 'items[0].report'], [() => basket([{ report, quantity: 0 }]), 'out-of-range', 'items[0].quantity'], [() => basket([{ report, quantity: Object.create(null) }]), 'wrong-type', 'items[0].quantity'],
      [() => basket([{ report }, { report, qty: 10 }]), 'unknown-field', 'items[1].qty'], [() => basket([{ report, quantiy: 10 }]), 'unknown-field', 'items[0].quantiy'],
      [() => basket(null), 'wrong-type', 'items'], [() => priceBreaks(report), 'wrong-type', 'quantities'],
      [() => priceBreaks(report, [1.5]), 'out-of-range', 'quantities[0]'], [() => priceBreaks(report, [1], { stock: { width: 5 } }), 'missing-field', 'height'],
      [() => priceBreaks(report, [1], { stock: { width: 100, height: 100, gpa: 1 } }), 'unknown-field', 'gpa'],
    ]) assert.throws(call, (e) => isKerfwayError(e) && e.code === code && e.params.field === field, field);
  });

  it('are printed on the command line, with the limits of the shop', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'limits.json'), '{ "smallest_hole": 25 }');
    writeFileSync(join(at, 'plate.dxf'), dxf(square(0, 0, 100), circle(50, 50, 10)));
    const words = ['quote', join(at, 'plate.dxf'), '--units', 'mm', '--moves', '200', '--seed', '1'];
    const { code, stdout, stderr } = await kerfway(...words, '--quantity', '1', '--quantity', '1000', '--sheet', '1000x1000', '--limits', join(at, 'limits.json'));
    assert.equal(code, 0, stderr);
    assert.match(stdout, /^1 copy +\S+ s, about 1 sheet$/m);
    assert.match(stdout, /^1000 copies .* about 13 sheets$/m);
    assert.match(stdout, /^Limit +The hole is (19\.99|20\.00) mm wide; the least is 25 mm\. At 50\.0, 50\.0\.$/m);
    for (const [wrong, exit] of [[['--quantity', '0'], 2], [['--sheet', '100'], 2], [['--gap', '5'], 2], [['--limits', join(at, 'plate.dxf')], 1]]) {
      assert.equal((await kerfway(...words, ...wrong)).code, exit, wrong.join(' '));
    }
  });

  it('were refused without a gap between the parts, which the package takes', async (t) => {
    const file = join(folder(t), 'plate.dxf');
    writeFileSync(file, dxf(square(0, 0, 100)));
    // 10 x 10 of them fill the sheet within its edge of 10 mm.
    const sheets = async (gap) => /^100 copies .* about (\d+) sheets?$/m.exec((await kerfway('quote', file, '--units', 'mm', '--moves', '10', '--seed', '1', '--quantity', '100', '--sheet', '1020x1020', '--gap', gap)).stdout)?.[1];
    assert.deepEqual([await sheets('0'), await sheets('0.5')], ['1', '2']);
  });
});

describe('the estimate of sheets', () => {
  it('looked through all shelves again for each of many equal boxes', () => {
    const stock = { width: 3000, height: 1500 };
    // The same part at another place has other last digits.
    const boxes = Array.from({ length: 20_000 }, (_, k) => ({ width: (30 + k) - k + (k % 3) * 1e-12, height: 30, count: 10_000 }));
    const begun = performance.now();
    const { count, covered } = sheetsFor(boxes, stock);
    assert.ok(performance.now() - begun < 10_000, 'an hour before');
    // 85 boxes of 30 mm with gaps of 5 beside each other in 2980 mm, 42 above each other in 1480.
    assert.equal(count, Math.ceil(2e8 / (85 * 42)));
    assert.ok(Math.abs(covered - (2e8 * 900) / (count * 3000 * 1500)) < 1e-9);
    const apart = [{ width: 50, height: 40, count: 3 }, { width: 20, height: 10, count: 7 }, { width: 40, height: 50, count: 4 }, { width: 20, height: 10, count: 500 }];
    const together = [{ width: 50, height: 40, count: 7 }, { width: 20, height: 10, count: 507 }];
    assert.deepEqual(sheetsFor(apart, { width: 200, height: 150 }), sheetsFor(together, { width: 200, height: 150 }));
  });

  it('puts no box over another or over the edge, whatever the boxes are', () => {
    // The shelves are checked by their areas: no sheet may hold more than it has.
    let seed = 1;
    const random = (n) => ((seed = (seed * 48271) % 2147483647), seed % n);
    for (let k = 0; k < 300; k += 1) {
      const stock = { width: 200 + random(3000), height: 200 + random(2000), gap: random(10), margin: random(30) };
      const boxes = Array.from({ length: 1 + random(12) }, () => ({ width: 1 + random(900), height: 1 + random(900), count: 1 + random(50) }));
      const { count, covered, too_large } = sheetsFor(boxes, stock);
      const [w, h] = [stock.width - 2 * stock.margin, stock.height - 2 * stock.margin];
      const fits = (b) => (b.width <= w && b.height <= h) || (b.height <= w && b.width <= h);
      const fitting = boxes.filter(fits);
      assert.equal(too_large, boxes.filter((b) => !fits(b)).reduce((n, b) => n + b.count, 0));
      const area = fitting.reduce((sum, b) => sum + b.width * b.height * b.count, 0);
      const boxesInAll = fitting.reduce((n, b) => n + b.count, 0);
      assert.ok(covered <= 1 && count <= boxesInAll, JSON.stringify({ stock, boxes }));
      assert.ok(count >= area / (w * h) - 1e-9);
      // First-fit decreasing height needs no more than three times the area, and one more sheet for each kind that stands upright.
      assert.ok(count <= Math.ceil((4 * fitting.reduce((sum, b) => sum + (b.width + stock.gap) * (b.height + stock.gap) * b.count, 0)) / (w * h)) + fitting.length);
      assert.deepEqual(sheetsFor([...boxes].reverse(), stock), sheetsFor(boxes, stock));
    }
  });

  it('counted twice the sheets when width and height of the stock were given the other way round', () => {
    const counts = (box, count, [w, h]) => [[w, h], [h, w]].map(([width, height]) => sheetsFor([{ ...box, count }], { width, height }).count);
    // Four plates stand beside each other on a sheet of 3000 x 1500 mm; lying, there are two.
    assert.deepEqual(counts({ width: 1000, height: 740 }, 120, [3000, 1500]), [30, 30]);
    for (let width = 50; width <= 1450; width += 100) {
      for (let height = 40; height <= 1450; height += 70) {
        for (const sheet of [[3000, 1500], [1250, 1250], [2500, 1250]]) {
          const [given, other] = counts({ width, height }, 37, sheet);
          assert.equal(given, other, `${width} x ${height} on ${sheet.join(' x ')}`);
          assert.equal(given, counts({ width: height, height: width }, 37, sheet)[0], 'nor does it matter how the part is drawn');
        }
      }
    }
    const mixed = [{ width: 1000, height: 740, count: 9 }, { width: 300, height: 1200, count: 5 }, { width: 4000, height: 10, count: 2 }];
    const [a, b] = [[3000, 1500], [1500, 3000]].map(([width, height]) => sheetsFor(mixed, { width, height }));
    assert.deepEqual([a.count, a.covered, a.too_large], [b.count, b.covered, b.too_large]);
    assert.equal(a.too_large, 2);
  });

  it('is quick for a million boxes', () => {
    const boxes = Array.from({ length: 100 }, (_, k) => ({ width: 10 + k, height: 20 + ((k * 7) % 50), count: 10_000 }));
    assert.ok(sheetsFor(boxes, { width: 3000, height: 1500 }).count > 500);
  });
});

describe('thumbnails', () => {
  it('show a part with its holes and marks, without planning', async () => {
    const loaded = await inspect(dxf(square(0, 0, 100), circle(50, 50, 10), line(10, 10, 30, 10, 'MARK')), { units: 'mm', layers: [{ name: 'MARK', operation: 'mark' }] });
    const svg = partThumbnail(loaded, loaded.parts[0].outer, { size: 100 });
    assert.match(svg, /^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg" width="100" height="100" viewBox="0 0 108 108" role="img"><path d="M[^"]+Z" fill="currentColor"/);
    // The circle in two arcs of its radius, and the mark as a line of its own that is not filled.
    assert.equal([...svg.matchAll(/A10 10 0 0 [01] /g)].length % 2, 0);
    assert.match(svg, /<path d="M14 94L34 94" fill="none"/);
    assert.throws(() => partThumbnail(loaded, 1), { code: 'unknown-contour' });
    assert.throws(() => partThumbnail(loaded, 0, { size: NaN }), { code: 'out-of-range' });
    assert.throws(() => partThumbnail(loaded, 0, null), { code: 'wrong-type' });
    assert.throws(() => partThumbnail(loaded, Object.create(null)), { code: 'unknown-contour', message: 'Contour an object is not the outer contour of a part.' });
    assert.throws(() => partThumbnail(null, 0), { code: 'wrong-type' });
    assert.ok(!/NaN|undefined|Infinity/.test(svg));
    for (const name of ['dxf-dev/mozman_ezdxf__forms.dxf', KEYBOARD]) {
      const real = await inspect(bytes(name));
      for (const { outer } of real.parts) assert.ok(!/NaN|undefined|Infinity/.test(partThumbnail(real, outer)), name);
    }
  });
});
