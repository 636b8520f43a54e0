// inspect, plan and render in Node: promises, progress, signals. Browsers share this code.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { describe, it } from 'node:test';
import { createPlanner, inspect, plan, render } from 'kerfway';
import { createFunctions } from '../../dist/sdk/functions.js';
import { abortable, withNewPlanner } from '../../dist/sdk/with-planner.js';
import { bytes, circle, dxf, KEYBOARD, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const keyboard = () => bytes(KEYBOARD);
/** Twelve circles, of which a short search finds a better order. */
const TWELVE = dxf(...Array.from({ length: 12 }, (_, k) => circle(20 + ((k * 67) % 200), 20 + ((k * 91) % 180), 3)));
const SHORT = { units: 'mm', seed: 1, moves: 2_000 };

describe('inspect', () => {
  it('describes a drawing', async () => {
    const loaded = await inspect(PLATE, { units: 'in', name: 'plate.dxf' });
    assert.equal(loaded.name, 'plate.dxf');
    assert.deepEqual(loaded.contours.map((c) => c.inside), [null, 0]);
    assert.equal(loaded.bounds[2], 2540);
  });

  it('reads the bytes that a function returns', async () => {
    assert.equal((await inspect(async () => PLATE)).contours.length, 2);
    await assert.rejects(inspect(() => Promise.reject(new Error('no such file'))), /no such file/);
  });

  it('refuses other files, and unknown options', async () => {
    await assert.rejects(inspect(new Uint8Array(0)), /empty/);
    await assert.rejects(inspect(PLATE, { tolerence: 1 }), /inspect has no option "tolerence"\. Did you mean "tolerance"\?/);
    await assert.rejects(inspect(PLATE, { seconds: 1 }), /no option "seconds"/);
  });
});

describe('plan', () => {
  const options = { units: 'mm', seed: 5, moves: 20_000, name: 'keyboard.dxf', allowOffBed: true };

  it('gives the same bytes as a planner', async () => {
    const { outputs, summary, path, seed, loaded } = await plan(keyboard(), { ...options, outputs: ['json', 'gcode', 'png'] });
    const planner = await createPlanner();
    await planner.load(keyboard(), 'keyboard.dxf', { units: 'mm' });
    await planner.plan({ seed: 5, moves: 20_000, allowOffBed: true }).done;
    assert.ok(outputs.json === (await planner.output('json')), 'another plan');
    assert.ok(outputs.gcode === (await planner.output('gcode')), 'another program');
    planner.close();
    assert.deepEqual([...outputs.png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.equal(seed, 5);
    assert.equal(path.contours.length, loaded.contours.length);
    assert.deepEqual(JSON.parse(outputs.json).summary.total_time, summary.total_time);
  });

  it('works in a script that is given to Node as text', () => {
    const drawing = `new TextEncoder().encode(${JSON.stringify(new TextDecoder().decode(PLATE))})`;
    const script = `import { plan } from 'kerfway'; console.log((await plan(${drawing}, { seed: 1, moves: 10 })).summary.contours);`;
    const { stdout, stderr } = spawnSync(process.execPath, ['--max-old-space-size=500', '--input-type=module', '--eval', script], { encoding: 'utf8' });
    assert.equal(stdout, '2\n', stderr);
  });

  it('reports progress to a callback and to a loop', async () => {
    const heard = [];
    const run = plan(keyboard(), { ...options, moves: 400_000, onProgress: (p) => heard.push(p.moves) });
    const looped = [];
    for await (const { moves, summary, path } of run) looped.push({ moves, total: summary.total_time, path });
    const { summary } = await run;
    assert.ok(looped.length > 0 && looped.every(({ moves }) => heard.includes(moves)));
    assert.deepEqual(looped.map((p) => p.total), looped.map((p) => p.total).toSorted((a, b) => b - a));
    assert.equal(looped.at(-1).total, summary.total_time);
    assert.ok(looped[0].path !== null);
  });

  // A search that ends within a frame reports nothing between its beginning and its end.
  it('told neither a callback nor a loop of the last improvement', async () => {
    const [heard, looped] = [[], []];
    const run = plan(TWELVE, { ...SHORT, onProgress: (p) => heard.push(p) });
    for await (const p of run) looped.push(p);
    const { baselines, summary, path } = await run;
    assert.ok(summary.total_time < baselines.greedy.total_time);
    for (const last of [heard.at(-1), looped.at(-1)]) assert.deepEqual([last.summary.total_time, last.path.times], [summary.total_time, path.times]);
  });

  it('fails when its callback refuses the last improvement', async () => {
    const [heard, refused] = [[], new Error('refused')];
    const onProgress = ({ summary }) => {
      if (heard.push(summary.total_time) > 1) throw refused;
    };
    await assert.rejects(plan(TWELVE, { ...SHORT, onProgress }), refused);
    assert.ok(heard[1] < heard[0] && heard.length === 2);
  });

  it('stops when the loop is left, and keeps the best plan', async () => {
    const run = plan(keyboard(), { seed: 1, seconds: 60, allowOffBed: true, outputs: ['gcode'] });
    for await (const { moves } of run) if (moves > 5_000) break;
    const { reason, outputs } = await run;
    assert.ok(['stopped', 'exhausted'].includes(reason));
    assert.match(outputs.gcode, /^; Kerfway/);
  });

  it('can be stopped before it has begun, and still has a path', async () => {
    const run = plan(keyboard(), { seed: 1, seconds: 60 });
    run.stop();
    const { reason, path, loaded } = await run;
    assert.equal(reason, 'stopped');
    assert.equal(new Set(path.contours).size, loaded.contours.length);
  });

  it('throws its error into the loop', async () => {
    const control = new AbortController();
    const looping = async () => {
      for await (const _ of plan(keyboard(), { seconds: 60, signal: control.signal })) control.abort();
    };
    await assert.rejects(looping(), { name: 'AbortError' });
    const reason = new Error('changed my mind');
    await assert.rejects(plan(keyboard(), { signal: AbortSignal.abort(reason) }), reason);
    const late = plan(keyboard(), { seconds: 60, signal: AbortSignal.timeout(300) });
    await assert.rejects(late, { name: 'TimeoutError' });
    await assert.rejects((async () => { for await (const _ of late); })(), { name: 'TimeoutError' });
  });

  it('rejects with one sentence that names the unknown option', async () => {
    await assert.rejects(plan(new Uint8Array(0)), /empty/);
    await assert.rejects(plan(PLATE, { machine: 'plasma-9000' }), /no machine named "plasma-9000"/);
    await assert.rejects(plan(PLATE, { second: 5 }), /plan has no option "second"\. Did you mean "seconds"\?/);
  });
});

describe('render', () => {
  it('writes a plan later with the same bytes as at once', async () => {
    const kinds = ['gcode', 'svg', 'dxf'];
    const planned = await plan(keyboard(), { machine: 'diode-hobby', units: 'mm', seed: 2, moves: 20_000, workers: 2, place: { at: [5, 5] }, turn: 90, outputs: kinds });
    for (const kind of kinds) assert.equal(await render(keyboard(), structuredClone(planned), kind), planned.outputs[kind]);
    const png = await render(keyboard(), planned, 'png', { width: 320 });
    assert.equal(new DataView(png.buffer, png.byteOffset).getUint32(16), 320);
  });

  it('refuses another drawing', async () => {
    const planned = await plan(PLATE, { units: 'mm', moves: 10 });
    await assert.rejects(render(keyboard(), planned, 'svg'), /not the drawing that was planned/);
    // It had the budget of no search, not that of the plan.
    await assert.rejects(render(keyboard(), planned, 'json'), (error) => error.code === 'not-a-choice' && error.params.field === 'kind');
  });
});

describe('jobs that share one planner, as those of an element do', () => {
  it('an aborted job whose file is read late does not take the place of the next one', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const functions = createFunctions((work, signal) => abortable(work(planner), signal));
    for (const late of ['plan', 'quote', 'inspect']) {
      const control = new AbortController();
      let read;
      const older = functions[late](() => new Promise((resolve) => (read = resolve)), { name: 'older.dxf', signal: control.signal });
      control.abort();
      await assert.rejects(older, { name: 'AbortError' });
      const newer = functions.plan(keyboard(), { name: 'newer.dxf', moves: 200_000, seed: 1, outputs: ['json'], onLoaded: () => read(PLATE) });
      const { loaded, path, outputs, reason, moves } = await newer;
      const document = JSON.parse(outputs.json);
      assert.deepEqual([loaded.name, document.input.name, reason, moves], ['newer.dxf', 'newer.dxf', 'budget', 200_000], late);
      assert.deepEqual([path.contours.length, loaded.contours.length], [60, 60], late);
    }
  });

  it('an aborted job whose drawing has been loaded does not begin its search', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const functions = createFunctions((work, signal) => abortable(work(planner), signal));
    const control = new AbortController();
    const older = functions.plan(PLATE, { moves: 10, signal: control.signal, onLoaded: () => control.abort() });
    await assert.rejects(older, { name: 'AbortError' });
    await new Promise((resolve) => setTimeout(resolve, 100));
    await assert.rejects(planner.output('json'), /no plan yet/);
  });
});

describe('a planner that is still starting', () => {
  it('kept a call that was aborted waiting, and read its file', async () => {
    const calls = [];
    let start;
    const opening = new Promise((resolve) => (start = resolve));
    const functions = createFunctions(withNewPlanner(() => opening));
    const control = new AbortController();
    const inspected = functions.inspect(() => (calls.push('read'), PLATE), { signal: control.signal });
    await new Promise((resolve) => setTimeout(resolve, 1));
    const reason = new Error('changed my mind');
    control.abort(reason);
    await assert.rejects(inspected, reason);
    start({ close: () => calls.push('close'), load: async () => calls.push('load') });
    await new Promise((resolve) => setTimeout(resolve, 1));
    assert.deepEqual(calls, ['close']);
  });
});

it('require gives all functions too', async () => {
  const required = createRequire(import.meta.url)('kerfway');
  assert.equal((await required.inspect(PLATE)).contours.length, 2);
});
