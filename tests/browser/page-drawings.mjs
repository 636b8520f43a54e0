// Drawings that are dropped on the page, and the programs that it gives, read back.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';

/** A file of the page's own samples. */
export const sample = (name) => readFileSync(join(ROOT, 'www', 'app', 'public', 'samples', name));

/** A DXF of circles and squares on a grid, `count` contours in all, mm; above and right of the origin, so on every bed. */
export function grid(count, { units = 4, step = 12 } = {}) {
  const columns = Math.ceil(Math.sqrt(count * 2));
  const text = ['0', 'SECTION', '2', 'HEADER', ...(units === null ? [] : ['9', '$INSUNITS', '70', units]), '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'];
  for (let i = 0; i < count; i += 1) {
    const x = (i % columns + 0.5) * step, y = (Math.floor(i / columns) + 0.5) * step;
    if (i % 3 > 0) text.push('0', 'CIRCLE', '8', 'HOLES', '10', x, '20', y, '40', step * (0.2 + (i % 5) * 0.04));
    else {
      text.push('0', 'LWPOLYLINE', '8', 'CUT', '90', 4, '70', 1);
      for (const [dx, dy] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) text.push('10', x + dx * step * 0.3, '20', y + dy * step * 0.3);
    }
  }
  text.push('0', 'ENDSEC', '0', 'EOF');
  return Buffer.from(`${text.join('\n')}\n`);
}

/**
 * Runs a G-code program as a controller would. Returns each unbroken stretch with the beam on: where it begins and
 * ends and its length, mm. Fails when the beam is on during a rapid.
 */
export function beamRuns(program) {
  const runs = [];
  let at = { x: 0, y: 0 };
  let motion = 0, power = 0, mode = 5, run = null;
  for (const line of program.split('\n')) {
    const words = [...line.replace(/;.*|\(.*?\)/g, '').matchAll(/([A-Z])\s*(-?[\d.]+)/g)].map(([, letter, value]) => [letter, Number(value)]);
    const word = Object.fromEntries(words);
    for (const [letter, value] of words) {
      if (letter === 'G' && value <= 3) motion = value;
      if (letter === 'M' && value >= 3 && value <= 5) mode = value;
      if (letter === 'S') power = value;
    }
    if (word.X === undefined && word.Y === undefined) continue;
    const to = { x: word.X ?? at.x, y: word.Y ?? at.y };
    const on = mode !== 5 && power > 0;
    if (motion === 0) {
      assert.ok(!on, `the beam is on during a rapid: ${line}`);
      run = null;
    } else if (on) {
      if (!run) runs.push((run = { from: at, to, length: 0 }));
      run.to = to;
      run.length += motion === 1 ? Math.hypot(to.x - at.x, to.y - at.y) : arcLength(at, to, { x: at.x + (word.I ?? 0), y: at.y + (word.J ?? 0) }, motion === 3);
    }
    at = to;
  }
  return runs;
}

function arcLength(from, to, center, ccw) {
  const a = Math.atan2(from.y - center.y, from.x - center.x), b = Math.atan2(to.y - center.y, to.x - center.x);
  const turn = (ccw ? b - a : a - b) % (2 * Math.PI);
  return Math.hypot(from.x - center.x, from.y - center.y) * (turn <= 1e-9 ? turn + 2 * Math.PI : turn);
}
