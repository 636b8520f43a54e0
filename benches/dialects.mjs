// Every dialect over every drawing, read by gcode-toolpath (npm, MIT). A program that fails our own check is not written at all:
//
//     npm run bench -- dialects [--data FOLDER]... [--only NAME]
//
// Drawings are those of tests/fixtures (dxf-dev, sheets) and the samples of the page; `--data FOLDER` names a folder with more DXF
// files. For each drawing: cuts, the largest distance between a plan and what is read back, over all dialects, and the programs that are
// refused by a dialect or fail. Ends with 1 if one fails.

import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST, ROOT } from '../scripts/tools.mjs';
import { compared } from '../tests/package/toolpath.mjs';
import { drawings } from './common/drawings.mjs';
import { table } from './common/table.mjs';

const FOLDERS = [...['dxf-dev', 'sheets'].map((folder) => join(ROOT, 'tests', 'fixtures', folder)), join(ROOT, 'www', 'app', 'public', 'samples')];
/** Largest distance between a program and its plan, mm. */
const DEVIATION = 0.002;
/** The programs of first paths are as long as those of the best. */
const PLANNED = { moves: 0, seed: 1 };

export async function bench(args) {
  const { values } = parseArgs({ args, options: { only: { type: 'string' }, data: { type: 'string', multiple: true } } });
  await setup();
  await build({ quick: true });
  const { createPlanner } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  const planner = await createPlanner();
  const [preset] = planner.machines;
  const lines = [];
  const sum = { programs: 0, failed: 0, off: 0 };
  for (const file of drawings([...FOLDERS, ...(values.data ?? [])], values.only)) {
    const name = basename(file);
    const loaded = await planner.load(readFileSync(file), name).catch((error) => error);
    const why = loaded instanceof Error ? loaded.message : loaded.contours.every((c) => c.operation === 'ignore') ? 'nothing to cut' : null;
    if (why !== null) {
      lines.push([name, '', '', '', '', `no plan: ${why}`.slice(0, 100)]);
      continue;
    }
    // The dialect changes nothing in the plan.
    await planner.plan({ ...PLANNED, machine: machineWith(preset, preset.dialect) }).done;
    const document = JSON.parse(await planner.output('json'));
    const faults = [];
    let [most, cuts, passed] = [0, 0, 0];
    for (const { name: dialect } of planner.dialects) {
      sum.programs += 1;
      const fault = await one(planner, machineWith(preset, dialect), document).then(({ off, ...found }) => {
        [most, cuts] = [Math.max(most, off), found.planned];
        return found.fault;
      }, (error) => error.message);
      if (fault === null) passed += 1;
      else faults.push(`${dialect}: ${fault}`);
    }
    sum.failed += faults.length;
    sum.off = Math.max(sum.off, most);
    console.error(`${name}: ${passed} of ${planner.dialects.length} dialects`);
    lines.push([name, String(loaded.contours.length), String(cuts), most.toFixed(6), `${passed} of ${planner.dialects.length}`, faults.join('; ')]);
  }
  planner.close();
  table('Programs of all dialects, read back', ['', 'contours', 'cuts', 'off, mm', 'dialects right', 'otherwise'], lines);
  console.log(`${sum.programs} programs, ${sum.failed} not right, at most ${sum.off.toFixed(6)} mm off`);
  if (sum.failed > 0) process.exitCode = 1;
}

/** A machine that pierces and has no bed, so that every drawing has a program. */
const machineWith = (preset, dialect) => ({ ...preset, bed: null, pierce_time: 0.25, beam_off_delay: 0, dialect });

/** Plans a drawing that is loaded, for a machine, and compares the program with the plan. */
async function one(planner, machine, document) {
  await planner.plan({ ...PLANNED, machine }).done;
  const { cuts, planned, off, length, expected } = compared(await planner.output('gcode'), document);
  const fault = cuts !== planned ? `${cuts} cuts, ${planned} planned`
    : off > DEVIATION ? `${off} mm off`
      : Math.abs(length - expected) >= 0.004 * planned + 1e-4 * length ? `${length} mm, ${expected} planned`
        : null;
  return { planned, off, fault };
}
