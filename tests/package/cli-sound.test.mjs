// Sound jobs that were refused, because the check of the plan or of its program counted otherwise than the machine works.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { folder, kerfway } from './support.mjs';

/** A page of 100 by 80 mm with these lines. */
const page = (body) => `<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 100 80"><g fill="none" stroke="#000">${body}</g></svg>`;

/** Writes files into a folder and plans the first; resolves to what the command said. */
async function planned(t, files, ...options) {
  const at = folder(t);
  for (const [name, text] of Object.entries(files)) writeFileSync(join(at, name), text);
  const said = await kerfway('plan', join(at, Object.keys(files)[0]), '--moves', '1000', '--seed', '1', ...options.map((word) => word.replace('AT', at)));
  return { at, ...said };
}

describe('A sound job was refused', () => {
  it('whose rounded corner is where the contour reaches farthest', async (t) => {
    const horn = page('<path d="M20 70 A60 60 0 0 1 60 70 L40 10 Z"/>');
    const { code, stderr } = await planned(t, { 'horn.svg': horn }, '--machine', 'fibre-6kw-plate', '--corners', 'round', '--json', 'AT/horn.json');
    assert.deepEqual([code, /own check/.test(stderr)], [0, false], stderr);
  });

  it('whose passes go on into one another, as nothing waits for the beam', async (t) => {
    const circles = Array.from({ length: 30 }, (_, k) => `<circle cx="${10 + 15 * (k % 6)}" cy="${10 + 15 * Math.floor(k / 6)}" r="3"/>`);
    for (const passes of [2, 3, 5]) {
      const { code, stderr } = await planned(t, { 'grid.svg': page(circles.join('')) }, '--machine', 'diode-hobby', '--layer', `#000000=mark,passes=${passes},speed=100`, '--gcode', 'AT/grid.nc');
      assert.equal(code, 0, stderr);
    }
  });

  it('whose overcut begins another round of a cut with a lowered head', async (t) => {
    const machine = {
      version: 1, name: 'plate', title: 'Plate', home: [0, 0], bed: [0, 0, 3000, 1500], return_home: true, travel: 'per-axis', rapid: { speed: [1666, 1666], accel: [9810, 9810] },
      cut: { speed: 15, accel: 3000, power: 0.9, z_step: 0.25 }, mark: { speed: 250, accel: 3000, power: 0.1 }, junction_deviation: 0.02, pierce_time: 2.5, pre_cut_time: 0.6, pre_cut_length: 4,
      sharp_corner: { angle: 1.6, time: 1 }, beam_on_delay: 0.2, beam_off_delay: 0.1, dialect: 'grbl-m4', max_s: 1000, z_speed: 10,
    };
    const square = page('<rect x="5" y="5" width="60" height="40"/>');
    const { code, stderr } = await planned(t, { 'square.svg': square, 'plate.json': JSON.stringify(machine) }, '--machine', 'AT/plate.json', '--overcut', '0.5', '--json', 'AT/a.json');
    assert.equal(code, 0, stderr);
  });

  it('that begins where the head stands, by kerfway check, as off the bed', async (t) => {
    const square = page('<rect x="5" y="5" width="60" height="40"/>');
    const { at, code, stderr } = await planned(t, { 'square.svg': square }, '--start', 'current', '--place', 'center@0,0', '--gcode', 'AT/a.nc');
    assert.equal(code, 0, stderr);
    const checked = await kerfway('check', join(at, 'a.nc'));
    assert.equal(checked.code, 0, checked.stdout + checked.stderr);
    // A job that is larger than the bed does not fit wherever it begins.
    const wide = page('<rect x="0" y="0" width="5000" height="40"/>');
    const large = await planned(t, { 'wide.svg': wide }, '--start', 'current', '--allow-off-bed', '--gcode', 'AT/a.nc');
    assert.equal(large.code, 0, large.stderr);
    assert.match((await kerfway('check', join(large.at, 'a.nc'))).stdout, /The head leaves the bed of the machine\./);
  });
});
