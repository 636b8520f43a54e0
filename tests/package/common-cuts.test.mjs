// Contours with common cuts, on machines with and without pre-cuts.

import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';

/** Rectangles of 20 by 10 in rows, each a closed polyline. */
function row(count, rows = 1) {
  const corners = (x, y) => [[x, y], [x + 20, y], [x + 20, y + 10], [x, y + 10]].map(([a, b]) => `10\n${a}\n20\n${b}\n`).join('');
  const shape = (k) => `0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n${corners(20 * (k % count), 10 * Math.floor(k / count))}`;
  const shapes = Array.from({ length: count * rows }, (_, k) => shape(k)).join('');
  return new TextEncoder().encode(`0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n${shapes}0\nENDSEC\n0\nEOF\n`);
}

describe('contours with common cuts', () => {
  let planner, thick;
  before(async () => {
    planner = await createPlanner();
    thick = { ...planner.machines.find((m) => m.name === 'fibre-6kw-thick'), pre_cut_time: 0.3 };
  });
  after(() => planner.close());

  const planned = async (options = {}) => {
    const run = planner.plan({ machine: thick, seed: 1, moves: 20_000, ...options });
    const { findings } = await run.started;
    const { reason, progress } = await run.done;
    return { findings, reason, progress, document: JSON.parse(await planner.output('json')) };
  };

  it('are pierced once if the machine makes pre-cuts, and a finding reports it', async () => {
    await planner.load(row(3), 'row.dxf');
    const { findings, document, progress } = await planned();
    assert.equal(document.summary.pierces, 1);
    assert.ok(Math.abs(document.summary.cut_length - (6 * 20 + 4 * 10)) < 1e-6);
    assert.ok(document.moves.some((m) => m.kind === 'cut' && Array.isArray(m.contour)));
    assert.deepEqual(findings.map((f) => [f.code, f.count]), [['common-cut', 3]]);
    assert.ok(document.findings.some((f) => f.code === 'common-cut'));
    assert.equal(progress.path.times.length, 2 * progress.path.contours.length);
  });

  it('are cut separately on another machine, and with the option off', async () => {
    await planner.load(row(3), 'row.dxf');
    const thin = await planned({ machine: 'fibre-6kw-thick' });
    assert.equal(thin.document.summary.pierces, 3);
    assert.deepEqual(thin.findings, []);
    await planner.reload({ commonCuts: 'off' });
    assert.equal((await planned()).document.summary.pierces, 3);
    await planner.reload({});
    assert.equal((await planned()).document.summary.pierces, 1);
  });

  it('are cut by the insertion heuristic of a paper, which planning without workers refuses', async (t) => {
    const seconds = {};
    for (const commonCuts of ['best', 'insertion']) {
      await planner.load(row(5, 5), 'rows.dxf', { commonCuts });
      seconds[commonCuts] = (await planned()).document.summary.total_time;
    }
    assert.ok(seconds.insertion > seconds.best, JSON.stringify(seconds));
    const here = await createPlanner({ worker: false });
    t.after(() => here.close());
    await here.load(row(5, 5), 'rows.dxf', { commonCuts: 'insertion' });
    await assert.rejects(here.plan({ machine: thick, moves: 1 }).done, { code: 'not-in-this-build' });
  });

  it('end with a path when stopped at once', async () => {
    await planner.load(row(4), 'row.dxf');
    const run = planner.plan({ machine: thick, seed: 1, seconds: 60 });
    run.stop();
    const { reason, progress } = await run.done;
    assert.equal(reason, 'stopped');
    assert.ok(progress.path.contours.length > 0);
  });

  it('give the same plan with three workers and a budget in moves', async () => {
    await planner.load(row(4), 'row.dxf');
    const { document } = await planned({ workers: 3, moves: 60_000 });
    assert.equal(document.summary.pierces, 1);
  });
});
