// The contract for machines: one error with a code, params and a sentence, everywhere; bytes of all kinds; deadlines; plans as JSON.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { createPlanner, createPool, inspect, isKerfwayError, KerfwayError, plan, quote, render } from 'kerfway';
import { SHAPES } from '../../dist/sdk/fields.js';
import { statusOf } from '../../dist/sdk/server/status.js';
import { bytes, circle, dxf, KEYBOARD, ROOT, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { seed: 1, moves: 200 };

async function refusal(promise) {
  const error = await promise.then(() => assert.fail('accepted'), (e) => e);
  assert.ok(isKerfwayError(error), String(error));
  assert.ok(error instanceof KerfwayError && error instanceof Error);
  assert.deepEqual(Object.keys(error.toJSON()), ['code', 'message', 'params', 'retryable']);
  assert.match(error.message, /[.?]$/);
  return error;
}

describe('an error has a code and names the field', () => {
  const machine = (change) => {
    const profile = structuredClone(MACHINE);
    change(profile);
    return profile;
  };
  let MACHINE;
  it('of options, machines, materials and limits', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    [MACHINE] = planner.machines;
    for (const [options, code, params] of [
      [{ secnds: 1 }, 'unknown-field', { field: 'secnds', near: 'seconds' }],
      [{ seconds: -1 }, 'out-of-range', { field: 'seconds', value: '-1', least: 0, most: 604800, unit: 's' }],
      [{ seconds: NaN }, 'out-of-range', { field: 'seconds', value: 'NaN', least: 0, most: 604800, unit: 's' }],
      [{ seconds: '5' }, 'wrong-type', { field: 'seconds', value: '5' }],
      [{ units: 'parsec' }, 'not-a-choice', { field: 'units', value: 'parsec', choices: SHAPES.reading.fields[0].kind.choice }],
      [{ machine: machine((m) => delete m.cut.speed) }, 'missing-field', { field: 'cut.speed' }],
      [{ machine: machine((m) => (m.kerf_witdh = 1)) }, 'unknown-field', { field: 'kerf_witdh', near: 'kerf_width' }],
      [{ layers: [{ name: '0', operation: 'melt' }] }, 'not-a-choice', { field: 'layers[0].operation', value: 'melt', choices: ['cut', 'mark', 'ignore'] }],
      [{ material: { thicknes: 1 } }, 'unknown-field', { field: 'material.thicknes', near: 'material.thickness' }],
      [{ limits: { smallest_hole: 0 } }, 'out-of-range', { field: 'limits.smallest_hole', value: '0', least: 0.001, most: 100000, unit: 'mm' }],
      [{ first: [99] }, 'unknown-contour', { contour: 99, count: 2 }],
    ]) {
      const error = await refusal(quote(PLATE, { ...SHORT, ...options }));
      assert.deepEqual([error.code, error.params, error.retryable], [code, params, false], error.message);
    }
    // What only the core knows arrives with the same members.
    const error = await refusal(quote(PLATE, { ...SHORT, machine: 'co2-10w' }));
    assert.deepEqual([error.code, error.params.field, error.params.near], ['not-a-choice', 'machine', 'co2-100w']);
    const method = await refusal(plan(PLATE, { ...SHORT, method: 'rlsag' }));
    assert.deepEqual([method.code, method.params.field, method.params.near], ['not-a-choice', 'method', 'rlsga']);
  });

  it('of drawings and states', async (t) => {
    assert.equal((await refusal(inspect(new Uint8Array(0)))).code, 'not-a-drawing');
    assert.equal((await refusal(inspect(new TextEncoder().encode('AC1032\0\0')))).code, 'not-a-drawing');
    assert.equal((await refusal(plan(PLATE, { ...SHORT, exclude: [0, 1] }))).code, 'nothing-to-cut');
    const planner = await createPlanner();
    await planner.load(PLATE, 'plate.dxf');
    assert.equal((await refusal(planner.output('gcode'))).code, 'no-plan');
    planner.close();
    const closed = await refusal(planner.output('gcode'));
    assert.deepEqual([closed.code, closed.retryable], ['closed', false]);
    assert.equal(new KerfwayError('busy', 'Wait.').retryable, true);
  });

  it('never speaks of dropping files or with the words of a library', async () => {
    for (const file of ['', 'AC1032\0\0', '%PDF-1.7', 'PK\x03\x04', '{}', '<svg', 'G1 X1\nG1 X2\n']) {
      const says = await inspect(new TextEncoder().encode(file)).then(() => 'read.', (e) => e.message);
      assert.doesNotMatch(says, /drop it|serde|invalid type|expected/i, says);
    }
  });

  it('has an HTTP status for every code that Rust knows', () => {
    const types = readFileSync(join(ROOT, 'www', 'sdk', 'generated', 'types.ts'), 'utf8');
    const codes = [.../export type ErrorCode =([^;]+);/.exec(types)[1].matchAll(/"([a-z-]+)"/g)].map(([, code]) => code);
    assert.ok(codes.length > 30);
    for (const code of codes) assert.ok(statusOf(code) >= 400, code);
    const rust = readFileSync(join(ROOT, 'src', 'job', 'code.rs'), 'utf8');
    const kebab = (name) => name.replace(/([a-z])([A-Z])/g, '$1-$2').toLowerCase();
    const retryable = [.../pub fn is_retryable[\s\S]*$/.exec(rust)[0].matchAll(/Self::(\w+)/g)].map(([, name]) => kebab(name));
    for (const code of codes) assert.equal(new KerfwayError(code, '').retryable, retryable.includes(code), code);
  });
});

describe('bytes', () => {
  const own = PLATE;
  const shared = (() => {
    const buffer = new SharedArrayBuffer(own.length);
    new Uint8Array(buffer).set(own);
    return new Uint8Array(buffer);
  })();
  const inside = (() => {
    const large = new Uint8Array(own.length + 64);
    large.set(own, 32);
    return new DataView(large.buffer, 32, own.length);
  })();

  it('may be an ArrayBuffer, a view, a Buffer, a Blob, a File, a Response or a Request, or a function that gives one', async () => {
    for (const [kind, source] of Object.entries({
      Uint8Array: own, ArrayBuffer: own.slice().buffer, Buffer: Buffer.from(own), DataView: inside, shared,
      Blob: new Blob([own]), File: new File([own], 'shelf.dxf'), Response: new Response(own), Request: new Request('http://x', { method: 'POST', body: own }),
      function: () => new Blob([own]),
    })) {
      const loaded = await inspect(source);
      assert.equal(loaded.contours.length, 2, kind);
      assert.equal(loaded.name, kind === 'File' ? 'shelf.dxf' : 'drawing.dxf', kind);
    }
    assert.equal((await inspect(new File([own], 'shelf.dxf'), { name: 'other.dxf' })).name, 'other.dxf');
  });

  it('of any other kind are a TypeError with a code', async () => {
    const given = own.slice();
    structuredClone(given.buffer, { transfer: [given.buffer] });
    for (const source of [5, 'text', null, undefined, [1, 2], {}, new Map(), Promise.resolve(own), given, given.buffer]) {
      const what = Object.prototype.toString.call(source);
      const error = await inspect(source).then(() => assert.fail(what), (e) => e);
      assert.ok(error instanceof TypeError, what);
      assert.deepEqual([error.code, error.retryable], ['not-bytes', false]);
      assert.match(error.message, /not given as bytes/);
    }
  });

  it('of a response that is an error, or of a file that is too large, are refused before they are read', async () => {
    const missing = await refusal(inspect(new Response('no', { status: 404 })));
    assert.deepEqual([missing.code, missing.params.status], ['download-failed', 404]);
    const used = new Response(own);
    await used.text();
    assert.equal((await refusal(inspect(used))).code, 'download-failed');
    const large = { size: 2 ** 40, arrayBuffer: () => assert.fail('it was read') };
    assert.equal((await refusal(inspect(large))).code, 'too-large');
  });
});

describe('deadlines', () => {
  it('end a call of a pool, and the next one is served', async (t) => {
    const pool = createPool({ size: 1, deadline: 0.4 });
    t.after(() => pool.close());
    // A search in moves has no end in time of its own.
    const error = await refusal(pool.plan(bytes(KEYBOARD), { moves: 2 ** 40, seed: 1 }));
    assert.deepEqual([error.code, error.retryable, error.params.seconds], ['deadline', true, 0.4]);
    const later = createPool({ size: 1, deadline: 60 });
    t.after(() => later.close());
    assert.equal((await later.plan(PLATE, SHORT)).summary.contours, 2);
  });

  it('count from the turn of a call and beside the seconds of its search', async (t) => {
    const pool = createPool({ size: 1, deadline: 20 });
    t.after(() => pool.close());
    const [a, b] = await Promise.all([pool.plan(PLATE, { seconds: 0.3 }), pool.plan(PLATE, { seconds: 0.3 })]);
    assert.deepEqual([a.summary.contours, b.summary.contours], [2, 2]);
  });

  it('and sizes that make no sense are refused by name', () => {
    for (const [options, field] of [[{ deadline: 0 }, 'deadline'], [{ deadline: NaN }, 'deadline'], [{ size: 0 }, 'size'], [{ size: 1.5 }, 'size'], [{ queue: -1 }, 'queue'], [{ sise: 1 }, 'sise']]) {
      assert.throws(() => createPool(options), (error) => isKerfwayError(error) && error.params.field === field);
    }
  });
});

describe('a finished plan', () => {
  it('survives JSON: it can be rendered and continued from', async () => {
    const planned = await plan(bytes(KEYBOARD), { ...SHORT, allowOffBed: true, outputs: ['gcode'] });
    for (const copy of [JSON.parse(JSON.stringify(planned)), JSON.parse(JSON.stringify(structuredClone(planned)))]) {
      assert.equal(await render(bytes(KEYBOARD), copy, 'gcode'), planned.outputs.gcode);
      const again = await plan(bytes(KEYBOARD), { seed: 1, moves: 0, allowOffBed: true, warm: copy.path });
      assert.equal(again.summary.total_time, planned.summary.total_time);
    }
    const json = JSON.parse(JSON.stringify(planned));
    assert.deepEqual(json.path.contours, Array.from(planned.path.contours));
    assert.deepEqual(json.loaded.geometry.offsets, Array.from(planned.loaded.geometry.offsets));
    assert.deepEqual(structuredClone(planned), { ...planned });
    assert.equal((await refusal(render(bytes(KEYBOARD), {}, 'gcode'))).params.field, 'planned');
  });
});

describe('names', () => {
  it('follow one rule: options of the package in camel case, reports, files and what goes into them in snake case', () => {
    const types = readFileSync(join(ROOT, 'www', 'sdk', 'generated', 'types.ts'), 'utf8');
    const camel = ['LoadOptions', 'StartOptions', 'Budget', 'LayerChoice', 'QuoteTerms'];
    let seen = 0;
    for (const [, name, body] of types.matchAll(/export interface (\w+) \{\n([\s\S]*?)\n\}/g)) {
      for (const [, field] of body.matchAll(/^ {2}(\w+)\??:/gm)) {
        seen += 1;
        const strange = camel.includes(name) ? /_/ : /[A-Z]/;
        assert.doesNotMatch(field, strange, `${name}.${field}`);
      }
    }
    assert.ok(seen > 150, String(seen));
  });
});
