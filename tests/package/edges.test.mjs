// The public functions at their edges: nothing, and values of other types, are refused with one sentence that names what is wrong.

import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import * as kerfway from 'kerfway';
import { circle, dxf, square } from './support.mjs';

const { activeContours, basket, check, createPlanner, DEFAULT_JOINTS, DEFAULT_LEADS, given, isProject, jobReport, jointRules, jointSettings, LEVERS, leadRules, leadSettings, leverSavings, partThumbnail, plan, pointOf, priceBreaks, quote, tooLarge, verifyQuote, withoutLever } = kerfway;

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { units: 'mm', moves: 100, seed: 1 };
const NOTHING = [null, undefined, 5, 'text', [], true];

let planner, planned, report;
before(async () => {
  planner = await createPlanner();
  [planned, report] = await Promise.all([plan(PLATE, { ...SHORT, outputs: ['svg'] }), quote(PLATE, SHORT)]);
});
after(() => planner.close());

/** The refusal of a call: a `KerfwayError` with a whole sentence. */
async function refusal(call) {
  const error = await (async () => call())().then(() => assert.fail('accepted'), (thrown) => thrown);
  assert.equal(error.name, 'KerfwayError', String(error));
  assert.match(error.message, /^\S.*[.?]$/);
  assert.doesNotMatch(error.message, /Cannot|not iterable|undefined \(/);
  return error;
}

const refused = async (call, code, field) => {
  const error = await refusal(call);
  assert.deepEqual([error.code, error.params.field], [code, field], error.message);
  return error.message;
};

describe('a report of a job', () => {
  const job = () => ({ ...planned, quote: report, svg: planned.outputs.svg });

  it('is refused without what it is made of', async () => {
    for (const nothing of NOTHING) await refused(() => jobReport(nothing), 'wrong-type', 'loaded');
    for (const [field, ...values] of [
      ['loaded', null, {}, { contours: [] }],
      ['summary', undefined, {}],
      ['baselines', undefined, { greedy: {} }],
      ['path', null, {}, { contours: [] }],
      ['quote', null, {}],
      ['svg', undefined, new Uint8Array(3)],
      ['findings', null, 'none'],
      ['date', null, '2026-11-29', new Date('soon')],
      ['beam', 5, 'x', {}],
    ]) for (const value of values) await refused(() => jobReport({ ...job(), [field]: value }), 'wrong-type', field);
    assert.equal(await refused(() => jobReport({ ...job(), path: null }), 'wrong-type', 'path'), 'The field "path" of the report is null. Give what plan and quote return, the plan as SVG, and a valid date.');
  });

  it('may be made of a plan that has been JSON', () => {
    assert.equal(jobReport({ ...JSON.parse(JSON.stringify(planned)), quote: report, svg: planned.outputs.svg }), jobReport(job()));
  });

  it('takes no severity of a finding for markup', () => {
    const findings = [{ ...planned.findings[0], code: 'x', severity: '"><b onclick=x>', message: 'x', count: 1, at: null }];
    assert.doesNotMatch(jobReport({ ...job(), findings }), /<b onclick/);
  });
});

describe('drawings that were read', () => {
  it('are needed for thumbnails and contours', async () => {
    for (const nothing of NOTHING) {
      await refused(() => partThumbnail(nothing, 0), 'wrong-type', 'loaded');
      await refused(() => activeContours(nothing), 'wrong-type', 'loaded');
      await refused(() => activeContours({ contours: nothing === null ? {} : null }), 'wrong-type', 'loaded');
    }
    // What the command line and the service write of a drawing is without geometry.
    const { geometry: _, ...described } = planned.loaded;
    assert.equal(await refused(() => partThumbnail(described, 0), 'wrong-type', 'loaded'), 'This is no drawing that was read: give what load or inspect returns.');
    assert.equal(partThumbnail(JSON.parse(JSON.stringify(planned)).loaded, 0), partThumbnail(planned.loaded, 0));
  });

  it('and nothing is no project', () => {
    for (const nothing of NOTHING) assert.equal(isProject(nothing), false);
  });
});

describe('machines', () => {
  it('are needed for levers, whose names are known', async () => {
    const [machine] = planner.machines;
    for (const nothing of NOTHING) await refused(() => withoutLever(nothing, 'fly'), 'wrong-type', 'machine');
    for (const nothing of NOTHING) await refused(() => withoutLever(machine, nothing), 'not-a-choice', 'lever');
    for (const lever of LEVERS) assert.equal(withoutLever(machine, lever), null);
    await refusal(() => leverSavings(planner, null, 1).next());
    await refused(() => leverSavings(planner, { secnds: 1 }, 1).next(), 'unknown-field', 'secnds');
  });

  it('without leads and joints have no settings, and what is undefined has its default', () => {
    for (const none of [null, undefined, {}, { rules: [] }, { rules: null }, { rules: 5 }]) assert.deepEqual([leadSettings(none), jointSettings(none)], [null, null]);
    assert.deepEqual(leadRules({ length: undefined, kind: 'line' }), leadRules({ kind: 'line' }));
    assert.deepEqual(jointRules({ sizeMin: undefined, count: 3 }), jointRules({ count: 3 }));
    assert.deepEqual([leadSettings(leadRules()), jointSettings(jointRules())], [DEFAULT_LEADS, DEFAULT_JOINTS]);
    assert.deepEqual([given(null), given({ a: undefined, b: 0 })], [{}, { b: 0 }]);
  });

  it('took settings of rules that there are not, or of another type', async () => {
    for (const rules of [leadRules, jointRules]) for (const nothing of [null, 5, 'text', []]) await refusal(() => rules(nothing));
    assert.equal(await refused(() => leadRules({ lenght: 3 }), 'unknown-field', 'lenght'), 'A lead has no setting "lenght". Did you mean "length"?');
    // An angle of null was one of 0.
    assert.equal(await refused(() => leadRules({ angle: null }), 'wrong-type', 'angle'), 'The setting "angle" is null. Give a number.');
    await refused(() => leadRules({ kind: 5 }), 'wrong-type', 'kind');
    await refused(() => jointRules({ count: '2' }), 'wrong-type', 'count');
    for (const size of [null, 5, [1]]) await refused(() => jointRules({ sizeMin: size }), 'wrong-type', 'sizeMin');
  });

  it('are calibrated with plans and seconds', async () => {
    const [machine] = planner.machines;
    for (const nothing of NOTHING) await refused(() => planner.calibrate(nothing, []), 'wrong-type', 'machine');
    for (const nothing of [null, undefined, 5, {}]) await refused(() => planner.calibrate(machine, nothing), 'wrong-type', 'measured');
    for (const job of [...NOTHING, { plan: {}, seconds: 1 }, { plan: '{}', seconds: '1' }]) await refused(() => planner.calibrate(machine, [job]), 'wrong-type', 'measured[0]');
    await refusal(() => planner.calibrate(machine, []));
    await refusal(() => planner.calibrate(machine, [{ plan: 'no JSON', seconds: 1 }]));
  });

  it('have nine points', async () => {
    const box = [0, 10, 20, 40];
    assert.deepEqual([pointOf('lower-left', box), pointOf('center', box), pointOf('upper-right', box)], [[0, 10], [10, 25], [20, 40]]);
    // Any other name was the upper right corner.
    for (const anchor of [null, undefined, 'middle', 4]) await refused(() => pointOf(anchor, box), 'not-a-choice', 'anchor');
    for (const nothing of [null, undefined, 5, [1, 2]]) await refused(() => pointOf('center', nothing), 'wrong-type', 'box');
  });
});

describe('quotes', () => {
  it('are multiplied by any list of quantities', async () => {
    const total = report.times.total;
    for (const quantities of [[1, 10], new Uint16Array([1, 10])]) {
      assert.deepEqual(priceBreaks(report, quantities).map(({ quantity, times }) => [quantity, times.total]), [[1, total], [10, 10 * total]]);
    }
    for (const nothing of [null, undefined, 5, {}]) {
      await refused(() => priceBreaks(report, nothing), 'wrong-type', 'quantities');
      await refused(() => basket(nothing), 'wrong-type', 'items');
    }
    await refused(() => priceBreaks(null, [1]), 'not-a-quote', 'report');
    await refused(() => verifyQuote(PLATE, null), 'not-a-quote', 'report');
    await refusal(() => verifyQuote(PLATE, report, null));
  });
});

describe('programs', () => {
  it('are texts or bytes, and not drawings', async () => {
    for (const nothing of [null, undefined, 5, [], {}]) {
      assert.equal(await refused(() => check(nothing), 'wrong-type', 'program'), 'The program is not given as text. Give a string, or the bytes of a file.');
    }
    for (const nothing of [undefined, 5, [], {}]) await refused(() => planner.check(nothing ?? 5), 'wrong-type', 'program');
    const text = 'G21\nG0 X1\n';
    const shared = new Uint8Array(new SharedArrayBuffer(text.length));
    shared.set(new TextEncoder().encode(text));
    const expected = await check(text);
    for (const program of [new TextEncoder().encode(text), Buffer.from(text), shared, new Blob([text])]) assert.deepEqual(await check(program), expected);
  });
});

describe('a sample program for nothing', () => {
  it('was refused in the name of another function', async () => {
    assert.equal((await refusal(() => planner.sampleProgram(null))).message, 'sampleProgram is null. Give an object with named options.');
    assert.match((await refusal(() => planner.sampleProgram({ machin: 'k40' }))).message, /^sampleProgram .*"machin"/);
  });
});

describe('the size of a file that is no number', () => {
  it('was written as NaN MB', async () => {
    for (const [nothing, shown] of [['x', '"x"'], ['5', '"5"'], [undefined, 'undefined'], [null, 'null'], [NaN, 'NaN'], [-1, '-1'], [{}, 'an object']]) {
      const message = await refused(() => tooLarge(nothing), 'wrong-type', 'bytes');
      assert.equal(message, `The size of the file is ${shown}. Give the number of its bytes.`);
    }
    assert.deepEqual([tooLarge(0), tooLarge(2 ** 28)], [null, null]);
    assert.match(tooLarge(2 ** 28 + 1), /^The file has 257 MB; up to 256 MB can be read/);
  });
});

describe('callbacks that are none', () => {
  before(() => planner.load(PLATE, 'plate.dxf', { units: 'mm' }));

  it('are refused before a plan or a proof begins', async () => {
    const running = planner.plan({ seconds: 60, seed: 1, moves: 1e9 });
    await running.started;
    for (const callback of [null, 5, {}]) {
      await refused(() => planner.plan({ moves: 1 }, callback).done, 'wrong-type', 'onProgress');
      await refused(() => planner.continue({ moves: 1 }, callback).done, 'wrong-type', 'onProgress');
      await refused(() => planner.prove({ seconds: 1 }, callback), 'wrong-type', 'onBound');
    }
    // The plan that runs was not ended by any of them.
    running.stop();
    assert.equal((await running.done).reason, 'stopped');
  });

  it('are refused by the functions, too', async () => {
    for (const name of ['onLoaded', 'onProgress', 'signal']) await refused(() => plan(PLATE, { ...SHORT, [name]: 5 }), 'wrong-type', name);
  });
});

describe('a planner that was closed, also twice', () => {
  it('refuses every call as closed', async () => {
    const closed = await createPlanner();
    const [machine] = closed.machines;
    closed.close();
    closed.close();
    for (const call of [
      () => closed.load(PLATE, 'plate.dxf'), () => closed.reload({}), () => closed.plan().done, () => closed.plan().started, () => closed.continue({ moves: 1 }).done, () => closed.prove(), () => closed.offer({}),
      () => closed.output('svg'), () => closed.quote(), () => closed.check(), () => closed.sampleProgram(), () => closed.paperMethods(), () => closed.calibrate(machine, [{ plan: '{}', seconds: 1 }]),
    ]) {
      const { code, message } = await refusal(call);
      assert.deepEqual([code, message], ['closed', 'The planner was closed.']);
    }
  });
});

describe('where planners run', () => {
  it('is not forgotten for options that are undefined', async (t) => {
    t.after(() => kerfway.configure({ workerUrl: new URL('../../dist/sdk/node-worker.js', import.meta.url) }));
    kerfway.configure({ workerUrl: new URL('./no-such-worker.js', import.meta.url) });
    for (const options of [{}, { workerUrl: undefined }]) await assert.rejects(createPlanner(options), { code: 'not-started' });
    kerfway.configure({ workerUrl: undefined });
    await assert.rejects(createPlanner(), { code: 'not-started' });
  });

  it('is said by an object', async () => {
    for (const nothing of [null, 5, 'text', []]) {
      await refusal(() => createPlanner(nothing));
      await refusal(() => kerfway.createPool(nothing));
      await refusal(() => kerfway.configure(nothing));
    }
  });
});

describe('options that cannot be read', () => {
  /** Their promise is the only place where a caller looks for errors. */
  it('threw before there was a promise, where their path could not be read', async () => {
    const own = new Error('mine');
    const options = { get warm() { throw own; } };
    for (const call of [plan, quote]) {
      const run = call(PLATE, options);
      await assert.rejects(run, own);
    }
  });

  it('ended in an error of the engine for a signal that cannot be asked, as those of old replacements for AbortSignal', async () => {
    const { signal } = new AbortController();
    const old = { aborted: false, addEventListener: signal.addEventListener.bind(signal) };
    for (const call of [plan, quote]) await refused(() => call(PLATE, { signal: old }), 'wrong-type', 'signal');
    assert.equal((await plan(PLATE, { ...SHORT, signal })).reason, 'budget');
  });
});

describe('bytes', () => {
  it('that only look like a buffer, or are behind a proxy, were refused by their size, or by the engine', async () => {
    for (const bytes of [new Proxy(new ArrayBuffer(8), {}), { [Symbol.toStringTag]: 'ArrayBuffer' }, { [Symbol.toStringTag]: 'SharedArrayBuffer', byteLength: 8 }]) {
      await assert.rejects(plan(bytes, SHORT), (error) => error instanceof TypeError && error.code === 'not-bytes');
    }
  });

  it('were taken for those of whatever a holder of bytes returns', async () => {
    for (const held of ['text', null, [1, 2], new Proxy(new ArrayBuffer(8), {})]) {
      const holder = { arrayBuffer: async () => held };
      await assert.rejects(plan(holder, SHORT), (error) => error instanceof TypeError && error.code === 'not-bytes');
      await refused(() => check(holder), 'wrong-type', 'program');
      await assert.rejects(kerfway.readProject(holder), (error) => error instanceof TypeError && error.code === 'not-bytes');
    }
    assert.equal((await plan({ arrayBuffer: async () => new Uint8Array(PLATE) }, SHORT)).loaded.name, 'drawing.dxf');
  });
});
