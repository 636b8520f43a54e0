// The report of a quote: from the package, from the command line, by its schema.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, createPool, quote } from 'kerfway';
import { quoteBudget } from '../../dist/sdk/quote-budget.js';
import { bytes, circle, dxf, fixture, folder, KEYBOARD, kerfway, square } from './support.mjs';

/** Seconds, from `npm run bench -- quote`: the air of 160 million moves, ten times the default. */
const AIR_OF_LONGER_SEARCH = 15.588;

const schema = createRequire(import.meta.url).resolve('kerfway/quote.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));

describe('quote', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  const quoted = async (drawing, material) => {
    await planner.load(drawing, 'drawing.dxf');
    await planner.plan({ moves: 500, seed: 1 }).done;
    return planner.quote(material === undefined ? {} : { material });
  };

  it('matches the published schema, with and without a material', async () => {
    for (const drawing of [bytes(KEYBOARD), bytes('dxf-dev/mozman_ezdxf__forms.dxf'), dxf(circle(0, 0, 5))]) {
      for (const material of [undefined, { name: 'Steel', thickness: 2, density: 7.85 }]) {
        const report = await quoted(drawing, material);
        assert.ok(validate(report), JSON.stringify(validate.errors, null, 1));
      }
    }
  });

  it('is right for a square with a hole', async () => {
    const { part_count, net_area, weight, smallest_hole } = await quoted(dxf(square(0, 0, 100), circle(50, 50, 10)), { thickness: 2, density: 8 });
    const area = 100 * 100 - Math.PI * 100;
    assert.equal(part_count, 1);
    assert.ok(Math.abs(net_area - area) < 1e-6);
    assert.ok(Math.abs(weight - area * 0.016) < 1e-6);
    assert.ok(Math.abs(smallest_hole.width - 20) < 0.03 && Math.abs(smallest_hole.over_thickness - 10) < 0.02);
  });

  it('refuses an impossible material with one sentence', async () => {
    await assert.rejects(quoted(bytes(KEYBOARD), { thickness: -1 }), /^KerfwayError: The option "material\.thickness" is -1\. Give a number from 0\.001 to 1000 mm, or null: /);
    await assert.rejects(quoted(bytes(KEYBOARD), { colour: 'red' }), /^KerfwayError: The quote has no option "material\.colour"\. There are: name, thickness, density\./);
  });

  it('is one call, and has the same hash from a pool', async () => {
    const options = { moves: 500, seed: 1, material: { thickness: 2, density: 7.85 }, name: 'drawing.dxf' };
    const report = await quoted(bytes(KEYBOARD), options.material);
    assert.deepEqual(await quote(bytes(KEYBOARD), options), report);
    const pool = createPool({ size: 1 });
    assert.equal((await pool.quote(() => bytes(KEYBOARD), options)).hash, report.hash);
    pool.close();
    await assert.rejects(quote(bytes(KEYBOARD), { outputs: ['gcode'] }), /^KerfwayError: quote has no option "outputs"/);
  });

  it('searches longer by default when there are more contours', () => {
    const moves = (count) => quoteBudget({ contours: Array.from({ length: count }, () => ({ operation: 'cut' })) }).moves;
    assert.deepEqual([1, 40, 100, 1_000, 10_000].map(moves), [250_000, 10_000_000, 25_000_000, 25_000_000, 250_000_000]);
  });

  // The command line gave `moves: undefined`, which hid the default: it searched for ten seconds and gave another hash.
  it('plans the same on the command line by default', async (t) => {
    const plate = dxf(square(10, 10, 30), circle(25, 25, 5), circle(60, 25, 5));
    const file = join(folder(t), 'plate.dxf');
    writeFileSync(file, plate);
    const { hash, moves } = await quote(plate, { name: 'plate.dxf' });
    const { stdout } = await kerfway('quote', file, '--json', '-');
    const other = JSON.parse(stdout);
    assert.deepEqual([other.hash, other.moves], [hash, moves]);
  });

  // With 5,000 moves for each contour, this drawing had 5 % more air.
  it('is by default within 1 % of the air of a search ten times as long', async () => {
    const report = await quote(bytes('dxf-dev/gtips_reviung__reviung53_2mm_450x300_ver1.1.dxf'));
    assert.ok(report.times.air <= 1.01 * AIR_OF_LONGER_SEARCH, `${report.times.air} s`);
    assert.equal(report.seed, 1);
  });

  it('is printed on the command line, with the same hash', async () => {
    const words = ['quote', fixture(KEYBOARD), '--moves', '500', '--seed', '1', '--thickness', '1.5', '--density', '7.85'];
    const { code, stdout, stderr } = await kerfway(...words, '--json', '-');
    assert.equal(code, 0);
    const report = JSON.parse(stdout);
    assert.ok(validate(report));
    assert.match(stderr, new RegExp(`Hash +${report.hash}`));
    assert.equal((await kerfway(...words)).stdout, stderr);
    const wrong = await kerfway('quote', fixture(KEYBOARD), '--thickness', '0');
    assert.deepEqual([wrong.code, wrong.stderr.split('\n')[0]], [2, 'kerfway: --thickness 0: give a number above 0.']);
  });
});
