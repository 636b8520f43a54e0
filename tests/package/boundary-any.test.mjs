// Any options at all: values made at random from the tables of fields, whole or damaged, end in time with a result or a sentence.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { createPool, inspect, isKerfwayError, KerfwayError, plan, quote } from 'kerfway';
import { SHAPES } from '../../dist/sdk/fields.js';
import { mulberry32 } from '../../benchmark/generate.mjs';
import { form, serve } from './serving.mjs';
import { circle, dxf, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { units: 'mm', seed: 1, moves: 500 };

/** Whole numbers below n. */
function random(seed) {
  const next = mulberry32(seed);
  return (n) => next() % n;
}

/** Any value, often close to one that a field accepts. */
function junk(draw, deep = 3) {
  const one = (list) => list[draw(list.length)];
  switch (draw(deep === 0 ? 5 : 7)) {
    case 0: return one([null, undefined, true, false]);
    case 1: return one([NaN, Infinity, -Infinity, -1, -0, 0, 0.5, 1e300, 2 ** 53, 1e-300]);
    case 2: return one(['', 'mm', 'cut', 'co2-100w', '__proto__', 'x'.repeat(10_000), '\u001b[2J']);
    case 3: return one([5n, Symbol('s'), () => 1, new Date(0), new Map([[1, 2]]), /x/, new Float64Array([NaN, 1]), new Uint8Array(3), new DataView(new ArrayBuffer(2))]);
    case 4: return one([1, 2, 3, 10]);
    case 5: return Array.from({ length: draw(4) }, () => junk(draw, deep - 1));
    default: return Object.fromEntries(Array.from({ length: draw(4) }, (_, k) => [one(['speed', 'name', 'contours', `k${k}`]), junk(draw, deep - 1)]));
  }
}

/** A value that a field accepts, sometimes damaged. */
function near(draw, kind) {
  if (draw(14) === 0) return junk(draw);
  const one = (list) => list[draw(list.length)];
  if (kind === 'flag') return draw(2) === 0;
  if (kind === 'text') return one(['a.dxf', 'co2-100w', 'lpspso', 'greedy']);
  if (kind === 'parameters') return one([{}, { particles: 3 }, { particles: 1e9 }, { populace: 1 }]);
  if (kind.choice) return one(kind.choice);
  const range = kind.number ?? kind.whole;
  if (range) return one([range.least, range.most, range.least + 1]);
  if (kind.pair) return [near(draw, kind.pair), near(draw, kind.pair)];
  if (kind.four) return Array.from({ length: 4 }, () => near(draw, kind.four));
  if (kind.list) return Array.from({ length: draw(3) }, () => near(draw, kind.list));
  if (kind.object) return object(draw, kind.object);
  return draw(2) === 0 ? 'co2-100w' : object(draw, kind.nameOr.fields);
}

function object(draw, fields) {
  const made = {};
  for (const f of fields) {
    if (!(f.required && draw(60) > 0) && draw(4) > 0) continue;
    made[draw(60) === 0 ? `${f.name}s` : f.name] = near(draw, f.kind);
  }
  return made;
}

describe('any options at all', () => {
  const CASES = 10_000;
  const DEADLINE = 20_000;
  const names = ['inspect', 'plan', 'quote'];

  it(`end in time, with a result or an error that names a field: functions, pool and HTTP (${CASES} cases)`, { timeout: 600_000 }, async (t) => {
    const draw = random(22);
    const pool = createPool({ size: 2 });
    t.after(() => pool.close());
    const service = await serve(t, '--workers', '2', '--waiting', '100');
    const counts = { taken: 0, refused: 0, http: 0 };
    const { reading, planning, material, limits } = SHAPES;
    /** The same over HTTP: the options as JSON in a form. */
    const overHttp = async (name, options) => {
      const json = JSON.stringify(options, (_, value) => (typeof value === 'bigint' ? String(value) : value));
      const response = await service.send(`/${name}`, form(PLATE, 'plate.dxf', json === undefined ? {} : { options: json }));
      const body = await response.json();
      counts.http += 1;
      if (response.status === 200) return 'taken';
      assert.ok(response.status >= 400 && response.status < 500, `${response.status} ${JSON.stringify(body)}`);
      return KerfwayError.of(body.error);
    };
    const one = async (k) => {
      const name = names[k % 3];
      const own = name === 'inspect' ? [] : planning.fields.filter((f) => f.name !== 'workers' && f.name !== 'member');
      const options = draw(10) === 0 ? junk(draw) ?? {} : object(draw, [...reading.fields, ...own]);
      if (typeof options === 'object' && options !== null && !Array.isArray(options) && name !== 'inspect') {
        // A valid budget could be long, so here it is short or invalid.
        if (draw(4) > 0) [options.moves, options.seconds] = [200, undefined];
        else options.seconds = [0.01, NaN, null, Infinity, -1, '1'][draw(6)];
        if (name === 'quote' && draw(2) === 0) options.material = object(draw, material.fields);
        if (name === 'quote' && draw(4) === 0) options.limits = object(draw, limits.fields);
      }
      // Most cases use the pool, because a new worker for each call takes so long that one in fifty would take as long as all the rest.
      const on = k % 250 === 0 ? { inspect, plan, quote } : pool;
      const deadline = wait(DEADLINE, 'late', { ref: false });
      const call = k % 4 === 3 ? overHttp(name, options) : on[name](PLATE, options).then(() => 'taken', (error) => error);
      const result = await Promise.race([deadline, call]);
      assert.notEqual(result, 'late', `${name} does not end`);
      if (result === 'taken') return void (counts.taken += 1);
      counts.refused += 1;
      assert.ok(isKerfwayError(result), String(result));
      const says = result.message;
      // A value that is no object at all has no field, and a drawing of which nothing is left has none either.
      const whole = /^(inspect|plan|quote|Reading|Planning|The field "options") is /.test(says);
      const ofDrawing = ['nothing-to-cut', 'unknown-contour', 'unfit-path', 'far-from-origin', 'off-bed'].includes(result.code);
      const said = () => `${JSON.stringify(result)} for ${JSON.stringify(options, (_, v) => (typeof v === 'bigint' ? String(v) : v))}`;
      assert.ok(typeof result.params.field === 'string' || whole || ofDrawing, said());
      assert.match(says, /[.?]$/, says);
      assert.ok(!/[\n\u001b]|undefined is|of undefined|memory access|unreachable|broke down|Cannot/.test(says), says);
    };
    let next = 0;
    await Promise.all(Array.from({ length: 8 }, async () => {
      while (next < CASES) await one(next++);
    }));
    assert.ok(counts.taken > CASES / 20 && counts.refused > CASES / 4 && counts.http >= CASES / 4, JSON.stringify(counts));
    assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
  });
});
