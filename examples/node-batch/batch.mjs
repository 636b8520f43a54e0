// Plans every DXF file of a folder on all processors, writes G-code, and prints a table of the time saved:
//
//     node batch.mjs drawings programs [seconds for each]

import { mkdir, readdir, readFile, writeFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { createPool } from 'kerfway';

const [from, to, seconds = '5'] = process.argv.slice(2);
if (to === undefined) {
  console.error('Say where the drawings are and where the programs go: node batch.mjs drawings programs');
  process.exit(2);
}

await mkdir(to, { recursive: true });
const names = (await readdir(from)).filter((name) => /\.dxf$/i.test(name)).sort();
const pool = createPool();

/** Plans one file and returns its row of the table. */
async function planned(name) {
  try {
    // The file is read when its turn comes, so that only the files being planned are in memory.
    const { summary, baselines, outputs } = await pool.plan(() => readFile(join(from, name)), {
      name,
      seconds: Number(seconds),
      seed: 1,
      // Each job lies in the corner of the machine's bed; one that is larger is refused.
      place: { at: [0, 0] },
      outputs: ['gcode'],
    });
    await writeFile(join(to, `${basename(name, name.slice(-4))}.nc`), outputs.gcode);
    const saved = baselines.drawing.total_time - summary.total_time;
    return { name, contours: summary.contours, seconds: summary.total_time.toFixed(1), saved: saved.toFixed(1) };
  } catch (error) {
    process.exitCode = 1;
    return { name, problem: error.message };
  }
}

console.table(await Promise.all(names.map(planned)));
pool.close();
