// Options for leads and micro-joints on machines that have rules for them already.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { createPlanner, jointRules, leadRules } from 'kerfway';
import { circle, dxf, folder, kerfway, shared, square } from './support.mjs';

const RULES = {
  leads: { clearance: 0.7, rules: [{ side: 'hole', lead_in: { kind: 'arc', radius: 1 }, max_share: 0.3 }, { lead_in: { kind: 'line', length: 4 }, position: 'corner' }] },
  joints: { rules: [{ side: 'hole', count: 1 }, { count: 3, width: 0.8 }] },
};

describe('options for leads and joints, on a machine that has its own', () => {
  const at = shared(async (t) => {
    const path = folder(t);
    const planner = await createPlanner();
    const preset = structuredClone(planner.machines.find((m) => m.name === 'fibre-3kw-thin'));
    planner.close();
    writeFileSync(join(path, 'plate.dxf'), dxf(square(0, 0, 100), circle(50, 50, 20)));
    writeFileSync(join(path, 'simple.json'), JSON.stringify({ ...preset, leads: leadRules({ kind: 'arc', radius: 2 }), joints: jointRules({ count: 4, width: 0.8, side: 'both' }) }));
    writeFileSync(join(path, 'rules.json'), JSON.stringify({ ...preset, ...RULES }));
    return { path };
  });

  /** The leads and joints of the machine that a plan was made for. */
  const planned = async (machine, ...options) => {
    const out = join(at.path, 'plan.json');
    const { code, stderr } = await kerfway('plan', join(at.path, 'plate.dxf'), '--machine', join(at.path, `${machine}.json`), '--moves', '10', '--seed', '1', '--allow-off-bed', '--quiet', '--json', out, ...options);
    assert.equal(code, 0, stderr);
    const { leads, joints } = JSON.parse(readFileSync(out, 'utf8')).machine;
    return { clearance: leads.clearance, leads: leads.rules, joints: joints.rules };
  };
  const ins = ({ leads }) => leads.map(({ lead_in: { kind, length, radius } }) => [kind, length, radius]);

  it('left the lead-ins out where only an overcut or a clearance was asked for, so that the beam pierced on the outlines', async () => {
    const before = await planned('simple');
    assert.deepEqual(ins(before).map(([kind]) => kind), ['center', 'arc']);
    const { leads, clearance } = await planned('simple', '--overcut', '0.3', '--lead-clearance', '2');
    assert.deepEqual(leads, before.leads.map((rule) => ({ ...rule, overcut: 0.3 })));
    assert.equal(clearance, 2);
    const rules = await planned('rules', '--overcut=-0.2');
    assert.deepEqual(rules.leads.map(({ lead_in: { kind }, overcut, side, max_share }) => [kind, overcut, side, max_share]), [['arc', -0.2, 'hole', 0.3], ['line', -0.2, undefined, 0.4]]);
  });

  it('change the sizes, the way out and the small holes of the rules that there are', async () => {
    const { leads } = await planned('rules', '--lead-length', '5', '--lead-out', 'line', '--lead-position', 'side');
    assert.deepEqual(leads.map(({ lead_in, lead_out, position }) => [lead_in.kind, lead_in.length, lead_out.kind, lead_out.length, position]), [['arc', 5, 'line', 5, 'side'], ['line', 5, 'line', 5, 'side']]);
    const small = await planned('rules', '--lead-center-below', '9');
    assert.deepEqual(small.leads.map(({ lead_in: { kind }, diameter_below }) => [kind, diameter_below]), [['center', 9], ['arc', undefined], ['line', undefined]]);
    assert.deepEqual(ins(await planned('simple', '--lead-center-below', '0')).map(([kind]) => kind), ['arc']);
    // Its own leads are replaced by those of --lead.
    assert.deepEqual(ins(await planned('rules', '--lead', 'line-arc')), [['center', 3, 1.5], ['line-arc', 3, 1.5]]);
  });

  it('replaced the joints by two of the default width where only their width or their kind was asked for', async () => {
    const before = await planned('simple');
    assert.deepEqual((await planned('simple', '--joint-kind', 'flying', '--joint-spacing', '50')).joints, before.joints.map((rule) => ({ ...rule, kind: 'flying', spacing: 50 })));
    const { joints } = await planned('rules', '--joint-width', '0.4');
    assert.deepEqual(joints.map(({ side, count, width }) => [side, count, width]), [['hole', 1, 0.4], [undefined, 3, 0.4]]);
    assert.deepEqual((await planned('simple', '--joint-side', 'outer')).joints.map(({ side, count }) => [side, count]), [['outer', 4]]);
    assert.deepEqual((await planned('simple', '--joints', '7')).joints.map(({ side, count, width }) => [side, count, width]), [['outer', 7, 0.5]]);
  });

  it('cannot say for which contours several rules are', async () => {
    const { code, stderr } = await kerfway('plan', join(at.path, 'plate.dxf'), '--machine', join(at.path, 'rules.json'), '--joint-size-min', '5');
    assert.equal(code, 2);
    assert.match(stderr, /^kerfway: --joint-size-min: the machine has joints of several kinds, each for contours of its own\. Give --joints as well, to replace them\.\n/);
  });
});
