// Which paths are proven optimal.

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';
import { asDxf } from '../../benchmark/drawing.mjs';
import { generated } from '../../benchmark/generate.mjs';
import { median, table } from '../common/table.mjs';
import { boundsOf, natively } from './runs.mjs';

/** Share of the travel that may be left below a path that is proven optimal: known values have three decimals, and entries anywhere are proven to a ten-millionth. */
const PROVEN = 5e-7;
/** Generated sheets: how many, and the least and the greatest number of contours. */
const GENERATED = { sheets: 40, least: 20, most: 60 };
/** Machines whose axes and corners take time, on which every so many of them are proven, too; and the moves of the search for the known path. */
const REAL = { machines: ['co2-100w', 'fibre-3kw-thin'], every: 4, moves: 3_000_000 };

const COLUMNS = ['', 'contours', 'path', 'best', 'proven', 'seconds'];

/**
 * What is proven within some seconds, natively in one thread: the 43 contours in all variants (`--only qu-du`), generated sheets, whose known path is that
 * of a search of ten seconds, and some of them on real machines (`--only machines`).
 */
export function proofs({ seconds, only = '', instances }) {
  if ('qu-du'.includes(only)) quDu(seconds, instances);
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  const { sheets: count, least, most } = GENERATED;
  const seeds = Array.from({ length: count }, (_, k) => k + 1);
  const drawn = (seed) => {
    const file = join(folder, `generated-${seed}.dxf`);
    writeFileSync(file, asDxf(generated({ seed, count: least + Math.round(((seed - 1) * (most - least)) / (count - 1)) })));
    return file;
  };
  show('Generated sheets', seconds, seeds.filter((seed) => `generated-${seed}`.includes(only)).map((seed) => {
    const file = drawn(seed);
    const [{ runs }] = natively(file, { seconds: 10, seeds: 1, cpu: true });
    return line(last(file, seconds, '--upper', String(runs[0].value))[0]);
  }));
  for (const machine of 'machines'.includes(only) ? REAL.machines : []) {
    const some = seeds.filter((seed) => seed % REAL.every === 1);
    show(`Generated sheets on ${machine}`, seconds, some.map((seed) => line(last(drawn(seed), seconds, '--machine', machine, '--search', String(REAL.moves))[0])));
  }
  rmSync(folder, { recursive: true });
}

function quDu(seconds, instances) {
  const anywhere = join(ROOT, 'tests', 'fixtures', 'qu-du-43', 'qu_du_43.dxf');
  const variants = [
    ...last(instances.file('qu-du-43/qu_du_43.json'), seconds),
    ...['2782.5805', '2496.053'].map((upper, open) => {
      const [row] = last(anywhere, seconds, '--upper', upper, ...(open ? ['--open'] : []));
      return { ...row, instance: `entries anywhere, ${open ? 'open' : 'closed'}` };
    }),
  ];
  table(`43 contours: what is proven within ${seconds} s`, COLUMNS, variants.map((row) => line(row).row));
}

/** The last row of each problem in a file. */
const last = (file, seconds, ...more) => [...new Map(boundsOf(file, '--seconds', String(seconds), ...more).map((row) => [row.instance, row])).values()];

/** `best`: of the path that is known and one with its best entries, which the proof may have found itself. */
function line({ instance, items, known, best, bound, seconds }) {
  const optimal = bound >= best * (1 - PROVEN);
  const row = [instance, String(items), known.toFixed(4), best.toFixed(4), optimal ? 'optimal' : `${((100 * bound) / best).toFixed(3)} %`, seconds.toFixed(1)];
  console.log(row.join('  '));
  return { row, optimal, seconds };
}

function show(what, seconds, lines) {
  if (lines.length === 0) return;
  table(`${what}: what is proven within ${seconds} s`, COLUMNS, lines.map((l) => l.row));
  const done = lines.filter((l) => l.optimal);
  console.log(`proven optimal: ${done.length} of ${lines.length}${done.length > 0 ? `, in ${median(done.map((l) => l.seconds)).toFixed(1)} s in the median` : ''}`);
}
