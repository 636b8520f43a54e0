// The class `Planner` in Node: plans that are continued, and options that their caller changes or cannot send.

import assert from 'node:assert/strict';
import { after, before, beforeEach, describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { createPlanner } from 'kerfway';
import { asJson } from '../../dist/sdk/plain-data.js';
import { bytes, KEYBOARD, LONG, PLATE, PLATE_OPTIONS } from './support.mjs';

let planner;
before(async () => (planner = await createPlanner()));
after(() => planner.close());

describe('a plan is continued', () => {
  /** The result of a promise that must not take longer than some seconds. */
  const soon = (promise) => Promise.race([promise, wait(10_000, null, { ref: false }).then(() => assert.fail('it is still pending'))]);
  beforeEach(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  it('that was begun before its drawing had been read', async () => {
    const ways = [() => planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS), () => planner.reload(PLATE_OPTIONS)];
    for (const [k, read] of ways.entries()) {
      const reading = read();
      const plan = planner.plan({ moves: 1000, seed: 5, allowOffBed: true });
      await reading;
      assert.equal((await plan.done).progress.path.contours.length, 3);
      const { seed, reason, progress } = await soon(planner.continue({ moves: 500 }).done);
      assert.deepEqual([seed, reason, progress.path.contours.length], [5, 'budget', 3], `way ${k}`);
      assert.equal(await planner.offer(progress.path), null);
    }
  });

  it('although it has not begun yet', async () => {
    const plan = planner.plan({ moves: 1_000_000, seed: 6 });
    const more = planner.continue({ moves: 1000 });
    assert.equal((await soon(plan.done)).reason, 'stopped');
    const { seed, reason, progress, baselines } = await soon(more.done);
    assert.deepEqual([seed, reason, progress.path.contours.length], [6, 'budget', 60]);
    assert.ok(progress.summary.total_time <= baselines.drawing.total_time);
    assert.equal((await more.started).seed, 6);
  });

  it('unless it failed', async () => {
    const plan = planner.plan({ method: 'no-such-method', moves: 1 });
    const more = planner.continue({ moves: 1000 });
    await assert.rejects(plan.done, /no-such-method/);
    await assert.rejects(soon(more.done), { code: 'no-plan' });
  });

  it('unless another drawing has been read', async () => {
    await planner.plan({ moves: 10 }).done;
    await planner.load(PLATE, 'plate.dxf');
    await assert.rejects(soon(planner.continue({ moves: 10 }).done), { code: 'no-plan' });
    await assert.rejects(planner.offer({}), { code: 'no-plan' });
  });
});

describe('options of a call', () => {
  /** What `reactive()` of Vue makes: a proxy of the object and of all objects in it, which no message can carry. */
  const reactive = (object) =>
    new Proxy(object, {
      get: (target, name) => {
        const value = Reflect.get(target, name);
        return typeof value === 'object' && value !== null ? reactive(value) : value;
      },
    });
  const machine = () => ({ ...structuredClone(planner.machines[0]), name: 'my-laser' });

  it('may be changed by the caller afterwards', async () => {
    const reading = { units: 'mm' };
    const loading = planner.load(PLATE, 'plate.dxf', reading);
    reading.units = 'in';
    assert.equal((await loading).bounds[2], 155);
    const planning = { machine: machine(), seed: 3, moves: 10 };
    const plan = planner.plan(planning);
    planning.seed = 4;
    planning.machine.name = 'another';
    const terms = { material: { name: 'mild steel' } };
    const quoting = plan.done.then(() => planner.quote(terms));
    assert.equal((await plan.done).seed, 3);
    terms.material.name = 'glass';
    const { material } = await quoting;
    assert.equal(material.name, 'mild steel');
    assert.equal(JSON.parse(await planner.output('json')).machine.name, 'my-laser');
    const budget = { moves: 20 };
    const more = planner.continue(budget);
    budget.moves = 1;
    assert.equal((await more.done).progress.moves, 30);
  });

  it('may be behind proxies', async () => {
    const texts = [];
    for (const given of [(o) => o, reactive]) {
      await planner.load(PLATE, 'plate.dxf', given(PLATE_OPTIONS));
      const { progress } = await planner.plan(given({ machine: machine(), seed: 3, moves: 1000 })).done;
      await planner.plan(given({ machine: machine(), seed: 3, moves: 1000, warm: JSON.parse(JSON.stringify(asJson(progress.path))) })).done;
      await planner.continue(given({ moves: 1000 })).done;
      await planner.reload(given(PLATE_OPTIONS));
      await planner.plan(given({ machine: machine(), seed: 3, moves: 1000, warm: progress.path })).done;
      texts.push(await planner.output('json'));
      assert.equal((await planner.check(null, given({ machine: machine() }))).passed, true);
    }
    assert.equal(texts[0], texts[1]);
  });

  it('that cannot be sent reject their call alone', async () => {
    await planner.load(PLATE, 'plate.dxf');
    const plan = planner.plan({ ...LONG, moves: 1e9 });
    await plan.started;
    plan.stop();
    assert.equal((await plan.done).reason, 'stopped');
    const { path } = (await plan.done).progress;
    await assert.rejects(planner.offer({ ...path, f() {} }), { name: 'KerfwayError', code: 'wrong-type', message: /^This cannot be sent/ });
    assert.equal(await planner.offer(path), null);
    assert.equal(planner.replaced, null);
  });
});
