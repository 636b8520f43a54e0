// The class `Planner` in Node: proofs of a lower bound, and paths from elsewhere.

import assert from 'node:assert/strict';
import { after, before, beforeEach, describe, it } from 'node:test';
import { createPlanner, plan, PROVEN, verifyQuote } from 'kerfway';
import { bytes, circle, dxf, KEYBOARD, LONG, square } from './support.mjs';

let planner;
before(async () => (planner = await createPlanner()));
after(() => planner.close());

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));

describe('a proof', () => {
  before(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  /** Begins a search and a proof, and ends the proof in one way or the other after its first bound. */
  async function ended(how) {
    const plan = planner.plan(LONG);
    await plan.started;
    const bounds = [];
    const proof = planner.prove({ seconds: 60 }, (seconds) => {
      bounds.push(seconds);
      proof[how]();
    });
    const done = await proof.done;
    plan.stop();
    await plan.done;
    return { done, first: bounds[0], last: bounds.at(-1) };
  }

  it('that is stopped has a certificate of what is proven', async () => {
    const { done, first } = await ended('stop');
    assert.ok(done.seconds >= first && first > 0);
    assert.equal(JSON.parse(done.certificate).schema, 'kerfway.certificate/1');
  });

  it('fails with the error of its callback, and the plan goes on', async () => {
    const plan = planner.plan({ ...LONG, moves: 1e9 });
    await plan.started;
    for (const throwing of [() => { throw new Error('my callback'); }, async () => { throw new Error('my callback'); }]) {
      await assert.rejects(planner.prove({ seconds: 60 }, throwing).done, /^Error: my callback$/);
    }
    plan.stop();
    assert.equal((await plan.done).reason, 'stopped');
  });

  it('is refused once the planner is closed', async () => {
    const other = await createPlanner();
    await other.load(PLATE, 'plate.dxf');
    await other.plan({ moves: 10, seed: 1 }).done;
    other.close();
    assert.throws(() => other.prove({ seconds: 1 }), { name: 'KerfwayError', code: 'closed', message: 'The planner was closed.' });
  });

  it('that is closed ends with its last bound, without a certificate', async () => {
    const { done, last } = await ended('close');
    assert.deepEqual({ ...done, path: null }, { seconds: last, certificate: null, path: null, hindrance: null });
    assert.ok(last > 0);
  });
});

describe('a path from elsewhere', () => {
  const seconds = ({ summary }) => summary.total_time;
  const holes = () => dxf(...Array.from({ length: 12 }, (_, k) => circle(20 + 31 * (k % 4), 20 + 29 * Math.floor(k / 4), 4 + ((5 * k) % 7))));
  beforeEach(() => planner.load(holes(), 'holes.dxf'));

  it('that a proof has found is taken over after the search, and proven optimal', async () => {
    const plan = planner.plan({ moves: 1, seed: 1 });
    await plan.started;
    const proof = await planner.prove({ work: 2000 }).done;
    const { progress } = await plan.done;
    const better = await planner.offer(proof.path);
    assert.ok(seconds(better) < seconds(progress) - 0.01, `${seconds(better)} s after ${seconds(progress)} s`);
    assert.ok(better.summary.gap <= PROVEN, `a gap of ${better.summary.gap}`);
    assert.deepEqual([better.moves, better.path.contours.length], [progress.moves, progress.path.contours.length]);
    const document = JSON.parse(await planner.output('json'));
    assert.equal(document.summary.total_time, seconds(better));
    // Seed and moves alone do not give it again, and nobody is told so.
    assert.equal(document.budget.from_path, true);
    const quote = await planner.quote();
    assert.equal(quote.from_path, true);
    const { valid, differences } = await verifyQuote(holes(), quote);
    assert.deepEqual([valid, differences.includes('from_path'), differences.includes('input')], [false, true, false], String(differences));
    // What is no better changes nothing, and the search goes on from the better path.
    assert.equal(await planner.offer(progress.path), null);
    const { progress: later } = await planner.continue({ moves: 100 }).done;
    assert.ok(seconds(later) <= seconds(better));
  });

  it('waits for the search, whose result is its own', async () => {
    const alone = await planner.plan({ moves: 2000, seed: 1 }).done;
    assert.equal('from_path' in JSON.parse(await planner.output('json')).budget, false);
    const best = (await planner.plan({ moves: 200_000, seed: 1 }).done).progress;
    const plan = planner.plan({ moves: 2000, seed: 1 });
    const offered = planner.offer(best.path);
    assert.equal(seconds((await plan.done).progress), seconds(alone.progress));
    assert.equal(seconds((await offered) ?? alone.progress), Math.min(seconds(best), seconds(alone.progress)));
  });

  it('of another drawing is refused, and so is one without a plan', async () => {
    await assert.rejects(planner.offer({}), { code: 'no-plan' });
    await planner.plan({ moves: 1 }).done;
    const path = { contours: Uint32Array.of(0), along: Float64Array.of(0), reversed: Uint8Array.of(0) };
    await assert.rejects(planner.offer(path), { code: 'unfit-path' });
    await assert.rejects(planner.offer({}), { code: 'unfit-path' });
  });

  it('is dropped when another plan has begun', async () => {
    const first = planner.plan({ moves: 1, seed: 1 });
    const offered = first.done.then(({ progress }) => planner.offer(progress.path));
    await first.done;
    const second = planner.plan({ moves: 1, seed: 2 });
    assert.equal(await offered, null);
    await second.done;
  });
});

/** The pieces of contours at which the bound lost least were halved without end after a million moves, and the worker was given up. */
it('a search of a square with two equal circles goes on past its bound', async () => {
  const run = await plan(dxf(square(0, 0, 100), circle(30, 50, 10), circle(70, 50, 10)), { units: 'mm', seed: 1, moves: 2_000_000 });
  assert.deepEqual([run.moves, run.reason], [2_000_000, 'budget']);
  assert.ok(run.summary.lower_bound <= run.summary.total_time && run.summary.gap < 1e-3, `${run.summary.gap}`);
});
