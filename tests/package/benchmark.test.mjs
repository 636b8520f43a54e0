// The reference checker of the benchmark: our plans, plans made wrong, and plans of other programs.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { gunzipSync, gzipSync } from 'node:zlib';
import { generated } from '../../benchmark/generate.mjs';
import { HERE, instances, listed } from '../../benchmark/instances.mjs';
import { isPossible, keep } from '../../benchmark/keep.mjs';
import { plot } from '../../benchmark/plot.mjs';
import { solved } from '../../benchmark/solve.mjs';
import { along, checked, NEEDS_PYTHON, pierce } from './reference-checker.mjs';

const best = (name) => {
  const { best: found } = listed().instances.find((e) => e.name === name);
  return { value: found.value, plan: JSON.parse(gunzipSync(readFileSync(join(HERE, found.plan))).toString()) };
};

const cuts = (plan) => plan.moves.flatMap((m, k) => (m.kind === 'cut' ? [k] : []));
const SHEET = 'sheet-100-ccp';

/** Each changes a sound plan for the sheet, and the fault has this name. */
const WRONG = {
  'a contour left out': ['not-cut', (p) => p.moves.splice(cuts(p)[40] - 2, 3)],
  'a contour cut twice': ['cut-twice', (p) => p.moves.splice(cuts(p)[40] + 1, 0, { kind: 'pierce' }, p.moves[cuts(p)[40]])],
  'an outer contour before what is inside': ['order', (p) => p.moves.unshift(...p.moves.splice(-4, 3))],
  'a move left out': ['off-contour', (p) => p.moves.splice(p.moves.findIndex((m, k) => k > 9 && m.kind === 'air'), 1)],
  'no piercing': ['no-pierce', (p) => p.moves.splice(p.moves.findIndex((m) => m.kind === 'pierce'), 1)],
  'a start that is 0.01 mm off': ['off-contour', (p) => (p.moves[0].to[0] += 0.01)],
  'a chord instead of an arc': ['off-contour', (p) => withArc(p, (piece) => ({ line: piece.arc }))],
  'an arc the other way round': ['off-contour', (p) => withArc(p, (piece) => ({ ...piece, ccw: !piece.ccw }))],
  'a contour that is not closed': ['not-whole', (p) => p.moves[cuts(p)[0]].path.length > 1 ? p.moves[cuts(p)[0]].path.pop() : p.moves[longest(p)].path.pop()],
  'a head that does not return': ['no-return', (p) => p.moves.pop()],
  'a coordinate that is no number': ['not-a-number', (p) => (p.moves[0].to[1] = 'NaN')],
  'a claim that is too good': ['claim', (p) => (p.value = 2000)],
  'a move of an unknown kind': ['not-a-plan', (p) => (p.moves[5].kind = 'jump')],
  'an air move to nowhere': ['not-a-plan', (p) => delete p.moves[0].to],
  'an arc without a center': ['not-a-plan', (p) => withArc(p, ({ center, ...piece }) => piece)],
  'a piece that is a number': ['not-a-plan', (p) => (p.moves[cuts(p)[3]].path[0] = 3)],
  'a coordinate that no number can hold': ['not-a-number', (p) => ({ text: JSON.stringify(p).replace(/"to":\[[^,]+/, `"to":[1${'0'.repeat(400)}`) })],
  'text that is no JSON': ['not-a-plan', () => ({ text: '[' })],
  'lists in lists without end': ['not-a-plan', () => ({ text: '['.repeat(200_000) })],
  'an outer contour before what is inside, which a cut of no length is to finish again': ['not-a-plan', outerFirst],
};

function outerFirst(plan) {
  const [air, pierce, cut] = plan.moves.splice(-4, 3);
  plan.moves.unshift(air, pierce, cut);
  plan.moves.splice(-1, 0, air, pierce, { kind: 'cut', path: [{ line: air.to }] });
}

/** Two slots that touch at a corner of the second, for which any of the tracks may be asked. */
const TOUCHING = {
  ...{ home: [0, 0], closed: false, cost: { unit: 'mm', pierce: 5 } },
  contours: [[0, 0, 10, 0], [10, 0, 10, 10]].map(([x, y, u, v]) => ({ start: [x, y], closed: false, inside: null, path: [{ line: [u, v] }] })),
};

function longest(plan) {
  return cuts(plan).find((k) => plan.moves[k].path.length > 2);
}

/** Replaces an arc that is no full turn. */
function withArc(plan, change) {
  const at = cuts(plan).find((k) => plan.moves[k].path.length > 1 && plan.moves[k].path.some((piece) => piece.arc));
  const path = plan.moves[at].path;
  const k = path.findIndex((piece) => piece.arc);
  path[k] = change(path[k]);
}

describe('the reference checker', NEEDS_PYTHON, () => {
  it('gives the value of the best plan', (t) => {
    const { value, plan } = best(SHEET);
    const { text, status } = checked(t, SHEET, plan);
    assert.equal(status, 0, text);
    assert.ok(Math.abs(Number(text) - value) < 1e-5, text);
  });

  for (const [what, [name, change]] of Object.entries(WRONG)) {
    it(`rejects ${what} by name`, (t) => {
      const { plan } = best(SHEET);
      const { text: written } = Object(change(plan));
      const { text, status } = checked(t, SHEET, written ?? plan);
      assert.equal(status, 1);
      assert.match(text, new RegExp(`^WRONG  ${name}: `));
    });
  }

  it('rejects a second contour that is begun where a cut of the first ends, without a piercing', (t) => {
    const instance = { ...TOUCHING, track: 'CCP' };
    assert.equal(Number(checked(t, instance, { moves: [pierce, along([10, 0]), pierce, along([10, 10])] }).text), 10);
    assert.match(checked(t, instance, { moves: [pierce, along([10, 0]), along([10, 10])] }).text, /^WRONG {2}no-pierce: move 2 /);
  });

  it('rejects a contour that ten thousand cuts of no length are to have cut', (t) => {
    const at = { kind: 'air', to: [10, 0] };
    const moves = [pierce, ...Array(10_000).fill(along([0, 0])), at, pierce, along([10, 10])];
    assert.match(checked(t, { ...TOUCHING, track: 'ICP' }, { moves }).text, /^WRONG {2}not-a-plan: move 1 .* a cut is longer than 0.002 mm/);
  });

  it('rejects a contour of which a piece between two cuts is left', (t) => {
    const rest = [pierce, along([10, 10])];
    const moves = (from) => [pierce, along([5, 0]), { kind: 'air', to: [from, 0] }, pierce, along([10, 0]), ...rest];
    const instance = { ...TOUCHING, track: 'ICP' };
    assert.equal(Number(checked(t, instance, { moves: moves(5) }).text), 15);
    assert.match(checked(t, instance, { moves: moves(5.004) }).text, /^WRONG {2}not-cut: contour 0/);
    assert.match(checked(t, instance, { moves: moves(4.996) }).text, /^WRONG {2}cut-twice: /);
  });

  it('tells contours that lie on each other apart by what is cut already', (t) => {
    const instance = { ...TOUCHING, track: 'CCP', contours: [TOUCHING.contours[0], TOUCHING.contours[0]] };
    assert.equal(checked(t, instance, { moves: [pierce, along([10, 0]), pierce, along([0, 0])] }).text, '10.000000');
    assert.match(checked(t, instance, { moves: [...Array(3)].flatMap((_, k) => [pierce, along([k % 2 ? 0 : 10, 0])]) }).text, /^WRONG {2}cut-twice: /);
  });

  it('says in a sentence, with exit code 2, that there is nothing to check', (t) => {
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
    t.after(() => rmSync(folder, { recursive: true }));
    const plan = join(folder, 'plan.txt');
    writeFileSync(plan, '{}');
    for (const given of [[folder], [join(folder, 'none')], [plan], [plan, plan], ['--instance', SHEET, join(folder, 'none')]]) {
      const { status, stdout, stderr } = spawnSync('python3', [join(HERE, 'check.py'), ...given], { encoding: 'utf8' });
      assert.deepEqual([status, stdout], [2, ''], given.join(' '));
      assert.match(stderr, /^check\.py: [^\n]+\.\n$/);
    }
    writeFileSync(join(folder, `${SHEET}.json.gz`), 'no gzip');
    writeFileSync(join(folder, '31pr152.json'), '{"tour": [true]}');
    const { status, stdout } = spawnSync('python3', [join(HERE, 'check.py'), folder], { encoding: 'utf8' });
    assert.equal(status, 1);
    const said = stdout.trim().split('\n');
    assert.match(said[0], /^31pr152 +WRONG {2}not-a-plan: True is not a node /);
    assert.match(said[1], /^sheet-100-ccp +WRONG {2}not-a-plan: .* is not a gzip file: /);
  });

  it('a plan that Python reads and others do not ended keep with a stack trace', (t) => {
    const at = mkdtempSync(join(tmpdir(), 'kerfway-'));
    t.after(() => rmSync(at, { recursive: true, force: true }));
    const lines = [];
    t.mock.method(console, 'log', (line) => lines.push(line));
    const list = readFileSync(join(HERE, 'instances.json'), 'utf8');
    for (const text of [JSON.stringify(best(SHEET).plan).replace('{', '{"note":NaN,'), Buffer.from(JSON.stringify(best(SHEET).plan), 'utf16le')]) {
      writeFileSync(join(at, `${SHEET}.json`), text);
      keep(at);
      assert.match(lines.pop(), /^sheet-100-ccp: \S+ is not JSON in UTF-8: /);
    }
    assert.equal(readFileSync(join(HERE, 'instances.json'), 'utf8'), list);
  });

  it('unpacked whatever was in a gzip file', (t) => {
    const at = mkdtempSync(join(tmpdir(), 'kerfway-'));
    t.after(() => rmSync(at, { recursive: true, force: true }));
    writeFileSync(join(at, `${SHEET}.json.gz`), gzipSync(Buffer.concat([JSON.stringify(best(SHEET).plan), Buffer.alloc(2 ** 26, ' ')].map((part) => Buffer.from(part)))));
    const { status, stdout } = spawnSync('python3', [join(HERE, 'check.py'), at], { encoding: 'utf8' });
    assert.deepEqual([status, /WRONG {2}not-a-plan: \S+ has more than 67108864 bytes$/m.test(stdout)], [1, true], stdout);
  });

  it('took seeds and counts that are no whole numbers, and showed a stack trace for folders that cannot be made', () => {
    for (const [words, sentence] of [
      [['generate', '/dev/null', '--count', '1.5'], '--count needs a whole number, not 1.5.'],
      [['generate', '/dev/null', '--seed', '0.5'], '--seed needs a whole number, not 0.5.'],
      [['generate', '/dev/null'], '/dev/null cannot be made (EEXIST): name another folder.'],
      [['site', '/dev/null'], '/dev/null cannot be made (EEXIST): name another folder.'],
    ]) {
      const { status, stderr } = spawnSync(process.execPath, [join(HERE, 'run.mjs'), ...words], { encoding: 'utf8' });
      assert.deepEqual([status, stderr.trim()], [1, sentence]);
    }
  });

  it('called the instances of generate unknown when their plans were checked', (t) => {
    const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
    t.after(() => rmSync(folder, { recursive: true }));
    const command = (...words) => spawnSync(process.execPath, [join(HERE, 'run.mjs'), ...words], { encoding: 'utf8' });
    const made = command('generate', folder, '--seed', '7', '--count', '12', '--seconds', '0.2');
    assert.equal(made.status, 0, made.stderr);
    const lines = () => spawnSync('python3', [join(HERE, 'check.py'), folder], { encoding: 'utf8' });
    const [, ccp, icp] = /(\d+\.\d+)\n[^]*?(\d+\.\d+)\n/.exec(made.stdout);
    const { status, stdout } = lines();
    const said = stdout.trim().split('\n').map((text) => text.split(/ +/));
    assert.deepEqual([status, said], [0, [['generated-ccp-12-7', Number(ccp).toFixed(3)], ['generated-icp-12-7', Number(icp).toFixed(3)]]]);
    // A plan of somebody else takes the place of ours, packed or not.
    writeFileSync(join(folder, 'generated-ccp-12-7.json'), '{"moves": []}');
    assert.match(lines().stdout, /^generated-ccp-12-7 +WRONG {2}not-cut: /);
    writeFileSync(join(folder, 'unknown.json'), '{"moves": []}');
    assert.match(lines().stdout, /^unknown +WRONG {2}not-a-plan: there is no instance named unknown$/m);
    writeFileSync(join(folder, 'generated-ccp-12-7.instance.json'), '{}');
    assert.match(lines().stdout, /^generated-ccp-12-7 +not checked: .*generated-ccp-12-7\.instance\.json is not an instance: /);
  });

  it('rejects a tour that visits a set twice, or not at all', (t) => {
    const { plan } = best('31pr152');
    assert.match(checked(t, '31pr152', { tour: [...plan.tour, plan.tour[0]] }).text, /^WRONG {2}visited-twice: /);
    assert.match(checked(t, '31pr152', { tour: plan.tour.slice(1) }).text, /^WRONG {2}not-visited: /);
  });

  it('measures air between places on contours, so that a plan gains nothing by standing a hair beside them', (t) => {
    const slot = { start: [5, 0], closed: false, inside: null, path: [{ line: [10, 0] }] };
    const instance = { ...TOUCHING, track: 'ECP', contours: [slot] };
    const plan = (begin, end) => ({ moves: [{ kind: 'air', to: [begin, 0] }, pierce, along([end, 0])] });
    assert.equal(Number(checked(t, instance, plan(5, 10)).text), 10);
    assert.equal(Number(checked(t, instance, plan(4.9995, 10.0005)).text), 10);
  });

  it('rejects a cut that leaves out a tooth which is shorter than the distance of its samples', (t) => {
    const slot = { start: [0, 0], closed: false, inside: null, path: [[5.05, 0], [5.25, 0.02], [5.45, 0], [10, 0]].map((line) => ({ line })) };
    const instance = { ...TOUCHING, track: 'ECP', contours: [slot] };
    assert.match(checked(t, instance, { moves: [pierce, along([10, 0])] }).text, /^WRONG {2}off-contour/);
    assert.equal(checked(t, instance, { moves: [pierce, along([5.05, 0], [5.25, 0.02], [5.45, 0], [10, 0])] }).status, 0);
  });

  it('accepts a circle that ends a hair beyond its start', (t) => {
    const ring = { start: [10, 0], closed: true, inside: null, path: [{ arc: [10, 0], center: [20, 0], ccw: true }] };
    const instance = { ...TOUCHING, track: 'ECP', contours: [ring] };
    for (const angle of [-1e-8, 0, 1e-8]) {
      const end = [20 - 10 * Math.cos(angle), -10 * Math.sin(angle)];
      const plan = { moves: [{ kind: 'air', to: [10, 0] }, pierce, { kind: 'cut', path: [{ arc: end, center: [20, 0], ccw: true }] }] };
      assert.equal(Number(checked(t, instance, plan).text).toFixed(6), '15.000000');
    }
  });

  it('accepts a path that another program found: sides of hull parts by HiGHS', (t) => {
    const { plan, value } = best('hull-5-20-1-ecp');
    assert.ok(Math.abs(Number(checked(t, 'hull-5-20-1-ecp', plan).text) - value) < 1e-5);
    // The same walk begins in the middle of a side: allowed where a contour may be left anywhere, not where only at its ends.
    const away = structuredClone(plan);
    const first = away.moves.findIndex((m) => m.kind === 'cut');
    const [from, to] = [away.moves[first - 2].to, away.moves[first].path[0].line];
    away.moves[first].path.unshift({ line: from.map((v, k) => (v + to[k]) / 2) });
    const middle = away.moves[first].path.splice(0, 1);
    away.moves.splice(first, 0, { kind: 'cut', path: middle });
    assert.match(checked(t, 'hull-5-20-1-ecp', away).text, /^WRONG {2}not-an-endpoint: /);
    assert.ok(Math.abs(Number(checked(t, 'hull-5-20-1-icp', away).text) - value) < 1e-5);
  });

  for (const track of ['CCP', 'ECP', 'ICP']) {
    it(`accepts our plan for a fresh instance of ${track}`, async (t) => {
      const instance = generated({ seed: 7, count: 30, track });
      const { plan, bound } = await solved(instance, { moves: 20_000 });
      const { text, status } = checked(t, instance, plan);
      assert.equal(status, 0, text);
      assert.ok(Number(text) >= bound, `${text} is at least the bound ${bound}`);
    });
  }

  it('is given a higher bound where a thread of its own works on it', async (t) => {
    const instance = generated({ seed: 7, count: 30, track: 'ICP' });
    const [alone, beside] = [await solved(instance, { moves: 20_000 }), await solved(instance, { moves: 20_000, prove: { work: 100 } })];
    const value = Number(checked(t, instance, beside.plan).text);
    assert.ok(beside.bound > 1.2 * alone.bound && beside.bound <= value, `${alone.bound}, ${beside.bound} of ${value}`);
    // The trace: each value is below the one before, each bound above it, and the last ones are those of the plan.
    const { values, bounds } = beside.trace;
    for (const [list, sign] of [[values, -1], [bounds, 1]]) {
      assert.ok(list.length > 1);
      for (const [k, [seconds, v]] of list.entries()) assert.ok(k === 0 || (seconds >= list[k - 1][0] && sign * (v - list[k - 1][1]) > 0), JSON.stringify(list));
    }
    assert.ok(Math.abs(values.at(-1)[1] - value) < 1e-5 && bounds.at(-1)[1] === beside.bound);
  });
});

it('is given a bound for slots that stand closer to each other than they are long, whose first numbers are below 0', async () => {
  const [{ instance }] = instances({ only: 'slots-2500-ccp' });
  const contours = instance.contours.slice(1).filter(({ start: [x, y] }) => x < 385 && y < 155).map((c) => ({ ...c, inside: null }));
  assert.ok(contours.length > 220, 'more than have a bound by walks');
  const { trace, bound } = await solved({ ...instance, contours }, { moves: 100_000, prove: { work: 300 } });
  const value = trace.values.at(-1)[1];
  assert.ok(bound > 0.4 * value && bound <= value, `${bound} of ${value}`);
});

it('plots a trace on logarithmic scales, up to the end of its run', () => {
  const svg = plot('two-steps', { seconds: 10, values: [[0.1, 200], [1, 100]], bounds: [[0.1, 0], [1, 99]] }, 100);
  const lines = [...svg.matchAll(/<path class="line (\w+)" d="([^"]+)"/g)].map(([, what, d]) => [what, d]);
  // Seconds from 0.01 to 100 are at 50 to 400, per cent from 100 to 0.01 at 20 to 230.
  assert.deepEqual(lines, [['value', 'M137.5 20H225V230H312.5'], ['bound', 'M137.5 20H225V125H312.5']]);
});

it('instances made by seed are the same everywhere', () => {
  const { contours } = generated({ seed: 7, count: 30 });
  assert.equal(contours.length, 30);
  assert.deepEqual(contours[0].start, generated({ seed: 7, count: 30 }).contours[0].start);
});

it('names of instances that there are not are refused, where nothing was done and nothing said', () => {
  assert.throws(() => [...instances({ only: 'no-such' })], /No instance has "no-such" in its name/);
  assert.throws(() => [...instances({ track: 'XX' })], /No instance of the track XX/);
});

it('a plan could bring a lower bound above the best value into the list', () => {
  assert.deepEqual([99, 100, 101, '99', null, undefined, NaN].map((bound) => isPossible(bound, 100)), [true, true, false, false, false, false, false]);
});

it('a folder without plans has nothing to keep, and the command says so', () => {
  assert.throws(() => keep('/no/such/folder'), /No plan in \/no\/such\/folder is named after an instance/);
});
