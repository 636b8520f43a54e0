// Wasm files that cannot be loaded: the call that needs one is refused with a sentence, and no other plan takes its place.

import assert from 'node:assert/strict';
import { cpSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';
import * as kerfway from 'kerfway';
import { circle, dxf, folder, ran, ROOT, square } from './support.mjs';

const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { units: 'mm', seed: 1, moves: 500 };
const FILES = ['kerfway', 'kerfway_outputs', 'kerfway_png', 'kerfway_research'];

/** A copy of the package in which `change` is done to some wasm files. */
async function copy(t, names, change) {
  const at = folder(t);
  cpSync(join(ROOT, 'dist', 'sdk'), at, { recursive: true });
  writeFileSync(join(at, 'package.json'), '{ "type": "module" }');
  for (const name of names) change(join(at, 'pkg', `${name}_bg.wasm`));
  return import(pathToFileURL(join(at, 'node.js')));
}

const damaged = { missing: (file) => rmSync(file), damaged: (file) => writeFileSync(file, 'not wasm') };

for (const [what, change] of Object.entries(damaged)) {
  describe(`a wasm file that is ${what}`, () => {
    it('is named where it is needed, and everything else goes on', async (t) => {
      const { createPlanner } = await copy(t, ['kerfway_png', 'kerfway_research'], change);
      const planner = await createPlanner();
      t.after(() => planner.close());
      await planner.load(PLATE, 'plate.dxf', { units: 'mm' });
      const advice = 'Check that all files of the package are there and can be reached, then try again\\.$';
      const research = new RegExp(`^KerfwayError: The file kerfway_research_bg\\.wasm cannot be loaded: .*\\. ${advice}`);
      await assert.rejects(planner.plan({ ...SHORT, units: undefined, method: 'lpspso' }).done, research);
      await assert.rejects(planner.paperMethods(), research);
      const { progress } = await planner.plan({ seed: 1, moves: 500 }).done;
      assert.equal(progress.summary.contours, 2);
      await assert.rejects(planner.output('png'), new RegExp(`^KerfwayError: The file kerfway_png_bg\\.wasm cannot be loaded: .*\\. ${advice}`));
      assert.match(await planner.output('gcode'), /M5/);
      assert.equal(planner.replaced, null);
    });

    it('is named where a program is asked for, and the plan stays', async (t) => {
      const { createPlanner } = await copy(t, ['kerfway_outputs'], change);
      const planner = await createPlanner();
      t.after(() => planner.close());
      await planner.load(PLATE, 'plate.dxf', { units: 'mm' });
      await planner.plan({ seed: 1, moves: 500 }).done;
      const refused = { code: 'not-started', message: /^The file kerfway_outputs_bg\.wasm cannot be loaded: .*\. Check that all files of the package are there and can be reached, then try again\.$/ };
      for (const ask of [() => planner.output('gcode'), () => planner.output('rd'), () => planner.check(), () => planner.check('G0 X0'), () => planner.sampleProgram()]) await assert.rejects(ask(), refused);
      assert.equal(JSON.parse(await planner.output('json')).summary.contours, 2);
      assert.equal((await planner.output('png'))[0], 0x89);
      assert.equal(planner.replaced, null);
    });
  });
}

it('writers that are back are loaded by the next call', async (t) => {
  let there;
  const { createPlanner } = await copy(t, ['kerfway_outputs'], (file) => renameSync((there = file), `${file}.away`));
  const planner = await createPlanner();
  t.after(() => planner.close());
  await planner.load(PLATE, 'plate.dxf', { units: 'mm' });
  await planner.plan({ seed: 1, moves: 500 }).done;
  await assert.rejects(planner.output('gcode'), { code: 'not-started' });
  renameSync(`${there}.away`, there);
  assert.match(await planner.output('gcode'), /M5/);
});

it('a core that is damaged is refused at once', async (t) => {
  const { plan, quote, inspect } = await copy(t, ['kerfway'], damaged.damaged);
  for (const work of [plan(PLATE, SHORT), quote(PLATE, SHORT), inspect(PLATE)]) await assert.rejects(work, /WebAssembly/);
});

it('a core that is missing, as in a bundle, is replaced by the one in inline.js', async (t) => {
  const { quote } = await copy(t, ['kerfway'], damaged.missing);
  assert.equal((await quote(PLATE, SHORT)).hash, (await kerfway.quote(PLATE, SHORT)).hash);
});

it('every wasm file there is reports its panics', async () => {
  const pkg = join(ROOT, 'dist', 'sdk', 'pkg');
  assert.deepEqual(readdirSync(pkg).filter((f) => f.endsWith('.wasm')).sort(), FILES.map((name) => `${name}_bg.wasm`));
  for (const name of FILES) assert.equal(typeof (await import(pathToFileURL(join(pkg, `${name}.js`)))).lastPanic, 'function', name);
});

it("the planner's own file is named, whether it is damaged, elsewhere or given as bytes", async (t) => {
  const refused = { name: 'KerfwayError', code: 'not-started', message: /^The file kerfway_bg\.wasm cannot be loaded: .*\. Check that all files of the package are there and can be reached, then try again\.$/ };
  const { createPlanner } = await copy(t, ['kerfway'], damaged.damaged);
  await assert.rejects(createPlanner(), refused);
  const nowhere = join(folder(t), 'nowhere.wasm');
  for (const options of [{ wasmUrl: nowhere }, { wasmUrl: pathToFileURL(nowhere) }, { wasm: new Uint8Array([1, 2, 3]) }, { wasm: 'kerfway.wasm' }]) {
    for (const worker of [true, false]) await assert.rejects(kerfway.createPlanner({ ...options, worker }), refused, JSON.stringify(options));
  }
});

it('the command line says so in one sentence, and not by a list of calls', async (t) => {
  const at = folder(t);
  cpSync(join(ROOT, 'dist', 'sdk'), at, { recursive: true });
  writeFileSync(join(at, 'package.json'), '{ "type": "module" }');
  writeFileSync(join(at, 'plate.dxf'), PLATE);
  writeFileSync(join(at, 'a.tsp'), 'NAME: a\nTYPE: TSP\nDIMENSION: 1\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\nEOF\n');
  damaged.damaged(join(at, 'pkg', 'kerfway_bg.wasm'));
  damaged.missing(join(at, 'pkg', 'kerfway_research_bg.wasm'));
  for (const [name, ...args] of [['kerfway', 'inspect', join(at, 'plate.dxf')], ['kerfway', 'plan', join(at, 'plate.dxf')], ['kerfway_research', 'solve', join(at, 'a.tsp')], ['kerfway_research', 'verify', join(at, 'a.tsp'), join(at, 'plate.dxf')]]) {
    const { code, stderr } = await ran([join(at, 'cli.js'), ...args]);
    assert.equal(code, 1, stderr);
    assert.match(stderr, new RegExp(`^kerfway: The file ${name}_bg\\.wasm cannot be loaded: .*\\. Check that all files of the package are there and can be reached, then try again\\.\\n$`));
  }
  const { code, stdout } = await ran([join(at, 'cli.js'), 'inspect', join(at, 'plate.dxf'), '--json', '-']);
  assert.deepEqual([code, JSON.parse(stdout).schema, JSON.parse(stdout).error.code], [1, 'kerfway.error/1', 'not-started']);
});
