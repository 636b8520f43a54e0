// The methods of published papers, which are in the research build.

import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { bytes, kerfway, fixture, KEYBOARD } from './support.mjs';

/** A number of moves after which every method has begun to improve and none takes long. */
const MOVES = 200_000;

describe('methods from papers', () => {
  let planner, papers;
  before(async () => {
    planner = await createPlanner();
    papers = await planner.paperMethods();
  });
  after(() => planner.close());

  it('are listed with their citations and parameters', () => {
    const names = papers.map((m) => m.name);
    for (const name of ['lpspso', 'pso', 'aco-pso', 'k-pso', 'rlsga', 'sga', 'ofa', 'woa', 'hull-pso', 'dual-coding-ga', 'partition-tree', 'pfr', 'gtsp-lk']) {
      assert.ok(names.includes(name), `${name} among ${names}`);
    }
    // A construction has nothing to set, a tour its moves.
    const fewest = { pfr: 0, 'gtsp-lk': 1 };
    for (const { name, source, parameters } of papers) {
      assert.match(source, /\(20\d\d\)|20\d\d/, name);
      assert.ok(Object.keys(parameters).length >= (fewest[name] ?? 3), name);
    }
  });

  it('each plan a sheet with holes, report their state, and pass the plan checker', async () => {
    await planner.load(bytes('sheets/sheet_100.dxf'), 'sheet_100.dxf', { layers: [{ name: 'SHEET', operation: 'ignore' }] });
    for (const { name } of papers) {
      let insight;
      const plan = planner.plan({ method: name, moves: MOVES, seed: 5 }, (p) => (insight = p.insight ?? insight));
      const { method, progress } = await plan.done;
      assert.equal(method, name);
      assert.ok(progress.path.contours.length >= 100, name);
      assert.ok(insight.curves.length >= 2 && insight.curves.every((c) => Number.isFinite(c.value)), name);
      // Writing checks the plan.
      assert.equal(JSON.parse(await planner.output('json')).method, name);
    }
  });

  it('give the same plan for the same seed and another plan for another seed', async () => {
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const made = async (options) => {
      await planner.plan({ method: 'dual-coding-ga', moves: 50_000, ...options }).done;
      return JSON.parse(await planner.output('json'));
    };
    const [a, b, c] = [await made({ seed: 1 }), await made({ seed: 1 }), await made({ seed: 2 })];
    assert.deepEqual(a, b);
    assert.notDeepEqual(a.moves, c.moves);
  });

  it('take parameters, which the plan contains, and refuse unknown ones with a sentence', async () => {
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    await planner.plan({ method: 'rlsga', parameters: { population: 12 }, moves: 2000, seed: 1 }).done;
    assert.equal(JSON.parse(await planner.output('json')).parameters, '{"population":12}');
    const refused = (options) => planner.plan({ moves: 10, seed: 1, ...options }).done.then(() => 'planned', (e) => e.message);
    assert.match(await refused({ method: 'rlsga', parameters: { populace: 12 } }), /^The method has no parameter "populace"/);
    assert.match(await refused({ method: 'nobody' }), /^There is no method named "nobody"\. Choose one of: tour-tree, greedy, lpspso, /);
    assert.match(await refused({ method: 'rlsga', workers: 2 }), /use one worker/);
    assert.match(await refused({ parameters: { population: 12 } }), /^Only methods from papers have parameters/);
  });

  it('stop at once and keep the best plan', async () => {
    await planner.load(bytes('sheets/sheet_500.dxf'), 'sheet_500.dxf');
    for (const { name } of papers) {
      const plan = planner.plan({ method: name, seconds: 60, seed: 1 });
      await plan.started;
      plan.stop();
      const { reason, progress } = await plan.done;
      // PFr builds one path in a tenth of a second, and may have done so before it is stopped.
      assert.ok(reason === 'stopped' || (name === 'pfr' && reason === 'exhausted'), `${name}: ${reason}`);
      assert.ok(progress.path.contours.length >= 500, name);
    }
  });

  it('can be chosen and configured on the command line', async () => {
    const words = ['plan', fixture(KEYBOARD), '--method', 'lpspso', '--moves', '20000', '--seed', '3', '--json', '-'];
    const { code, stdout } = await kerfway(...words, '--set', 'particles=009', '--set', 'local_search=false');
    // A number with zeros before it ended in an error of the engine.
    assert.equal(code, 0);
    const { method, parameters } = JSON.parse(stdout);
    assert.deepEqual([method, JSON.parse(parameters)], ['lpspso', { particles: 9, local_search: false }]);
    assert.match((await kerfway('methods')).stdout, /rlsga .*alpha=0\.9/);
    const wrong = await kerfway(...words, '--set', 'particles');
    assert.deepEqual([wrong.code, wrong.stderr.split('\n')[0]], [2, 'kerfway: --set particles: write NAME=VALUE; kerfway methods lists the names.']);
  });
});
