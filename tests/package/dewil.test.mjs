// The sheets of the bench `dewil`: the generator reproduces the stored files, with the paper's numbers of elements.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { contours, dxf, SHEETS } from '../../benches/dewil/sheets.mjs';

const KEPT = new URL('../../benches/dewil/sheets/', import.meta.url);

test('the generator reproduces the stored files byte for byte', () => {
  assert.deepEqual(readdirSync(KEPT).sort(), SHEETS.map(([name]) => `${name}.dxf`).sort());
  for (const [name] of SHEETS) assert.equal(readFileSync(new URL(`${name}.dxf`, KEPT), 'utf8'), dxf(name), name);
});

test('every sheet has the number of elements of the paper', () => {
  for (const [name, , elements] of SHEETS) {
    assert.equal(contours(name).reduce((sum, c) => sum + c.length, 0), elements, name);
  }
});

test('sides coincide exactly in set 3 only', () => {
  for (const [name, set] of SHEETS) {
    const sides = new Set();
    let shared = 0;
    // The two halves of a circle join the same two points.
    for (const contour of contours(name).filter((c) => c.length > 2)) {
      contour.forEach((corner, k) => {
        const side = [corner, contour[(k + 1) % contour.length]].map(([x, y]) => `${x},${y}`).sort().join(' ');
        shared += Number(sides.has(side));
        sides.add(side);
      });
    }
    assert.equal(shared > 0, set === 3, `${name}: ${shared}`);
  }
});
