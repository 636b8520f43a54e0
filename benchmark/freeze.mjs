// Makes the frozen instances: sheets read from drawings, sheets of hull parts, sheets made by seed, and those of GTSPLIB.

import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';
import { drawn } from '../benches/solve/grids.mjs';
import { ROOT } from '../scripts/tools.mjs';
import { contoursOf, polygon } from './drawing.mjs';
import { generated, LENGTH } from './generate.mjs';
import { HERE, listed, store } from './instances.mjs';
import { planned } from './solve.mjs';

const MADE = { licence: 'MIT', source: 'made by Kerfway' };
/** Seconds: the rapid moves of a belt-driven CO2 machine, rest to rest. */
const SECONDS = { unit: 's', speed: 400, acceleration: 3000, pierce: 0 };
const FORMAT = { format: 'cutting-benchmark/1', home: [0, 0], closed: true };

export async function freeze() {
  const kept = new Map(listed().instances.map((entry) => [entry.name, entry]));
  const all = [];
  const add = (instance, licence) => {
    const file = join('instances', `${instance.name}.json.gz`);
    const text = JSON.stringify(instance);
    mkdirSync(join(HERE, 'instances'), { recursive: true });
    writeFileSync(join(HERE, file), gzipSync(text, { level: 9 }));
    all.push(entry(instance.name, instance.track, instance.contours.length, file, text, licence));
  };
  for (const [name, contours] of await sheets()) {
    for (const [track, cost] of [['CCP', LENGTH], ['TIME', SECONDS]]) add({ ...FORMAT, name: `${name}-${track.toLowerCase()}`, track, cost, contours }, MADE);
  }
  for (const [name, contours] of hulls()) {
    for (const track of ['ECP', 'ICP']) add({ ...FORMAT, name: `${name}-${track.toLowerCase()}`, track, cost: LENGTH, contours }, MADE);
  }
  for (const track of ['ECP', 'ICP']) for (const seed of [1, 2, 3]) add(generated({ seed, count: 60, track }), MADE);
  const lib = join(ROOT, 'benches', 'data', 'gtsplib');
  for (const file of readdirSync(lib).filter((f) => f.endsWith('.gz')).sort((a, b) => a.localeCompare(b, 'en', { numeric: true }))) {
    const text = gunzipSync(readFileSync(join(lib, file))).toString();
    const [name, sets] = [file.replace('.gtsp.gz', ''), Number(/GTSP_SETS : (\d+)/.exec(text)[1])];
    const licence = { licence: 'TSPLIB95: free use in research, without a licence text', source: 'TSPLIB95 with the clusters of Fischetti, Salazar and Toth' };
    all.push(entry(name, 'GTSP', sets, join('..', 'benches', 'data', 'gtsplib', file), text, licence));
  }
  // A best plan stays as long as its instance is the same.
  store({ format: 'cutting-benchmark/1', instances: all.map((e) => (kept.get(e.name)?.sha256 === e.sha256 ? { ...e, best: kept.get(e.name).best } : e)) });
  console.log(`${all.length} instances`);
}

function entry(name, track, size, file, text, licence) {
  return { name, track, size, file: file.replaceAll('\\', '/'), sha256: createHash('sha256').update(text).digest('hex'), ...licence };
}

/** The nested sheets of tests/fixtures and perforated plates, as the reader of Kerfway joins their outlines. */
async function sheets() {
  const files = [100, 500, 2000, 10_000].map((n) => [`sheet-${n}`, join(ROOT, 'tests', 'fixtures', 'sheets', `sheet_${n}.dxf`)]);
  for (const pattern of ['staggered', 'slots']) files.push([`${pattern}-2500`, drawn(pattern, 50)]);
  const made = [];
  for (const [name, file] of files) {
    const options = { machine: 'length', moves: 1, seed: 1, layers: [{ name: 'MARK', operation: 'ignore' }] };
    made.push([name, contoursOf(await planned(readFileSync(file), options))]);
  }
  return made;
}

function* hulls() {
  for (const size of ['5-20', '10-45']) {
    const all = JSON.parse(readFileSync(join(ROOT, 'tests', 'fixtures', 'hull', `hull-${size}.json`), 'utf8'));
    for (const [k, { contours }] of all.entries()) yield [`hull-${size}-${k + 1}`, contours.map((corners) => polygon(corners))];
  }
}
