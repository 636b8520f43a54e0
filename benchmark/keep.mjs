// Takes plans that are sound and better than the best known into the benchmark.

import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync, gzipSync } from 'node:zlib';
import { Stop } from '../scripts/tools.mjs';
import { HERE, listed, made, store } from './instances.mjs';

/** Values closer than this share are the same. */
const SAME = 1e-9;

export function keep(folder) {
  const list = listed();
  let found = 0;
  made(join(HERE, 'best'));
  for (const entry of list.instances) {
    const file = [`${entry.name}.json.gz`, `${entry.name}.json`].map((name) => join(folder, name)).find(existsSync);
    if (file === undefined) continue;
    found += 1;
    const { status, stdout } = spawnSync('python3', [join(HERE, 'check.py'), '--instance', entry.name, file], { encoding: 'utf8' });
    if (status !== 0) {
      console.log(`${entry.name}: ${stdout.trim()}`);
      continue;
    }
    const value = Number(stdout);
    const read = planIn(file);
    if (read === null) {
      console.log(`${entry.name}: ${file} is not JSON in UTF-8: Python reads more than that, such as NaN`);
      continue;
    }
    const { bound, by, ...plan } = read;
    const best = entry.best;
    if (value < (best?.bound ?? 0) * (1 - SAME)) {
      console.log(`${entry.name}: ${rounded(value)} is below the proven bound ${best.bound}, so that one of them is wrong: it is not taken`);
      continue;
    }
    const possible = isPossible(bound, Math.min(value, best?.value ?? value));
    if (bound !== undefined && !possible) console.log(`${entry.name}: the bound ${bound} cannot be right, and is left out`);
    const known = Math.max(possible ? bound : 0, best?.bound ?? 0);
    if (best === undefined || value < best.value * (1 - SAME)) {
      const stored = `best/${entry.name}.json.gz`;
      writeFileSync(join(HERE, stored), gzipSync(JSON.stringify(plan), { level: 9 }));
      entry.best = { value: rounded(value), plan: stored, by: typeof by === 'string' ? by : 'unknown', bound: known > 0 ? rounded(known) : null };
      console.log(`${entry.name}: ${rounded(value)}${best === undefined ? '' : ` instead of ${best.value}`}`);
    } else if (known > (best.bound ?? 0)) {
      best.bound = rounded(known);
    }
  }
  if (found === 0) throw new Stop(`No plan in ${folder} is named after an instance: a plan for the instance NAME is named NAME.json or NAME.json.gz.`);
  store(list);
}

/** The plan in a file that check.py has accepted; null if others could not read it. */
function planIn(file) {
  const bytes = readFileSync(file);
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(file.endsWith('.gz') ? gunzipSync(bytes) : bytes));
  } catch {
    return null;
  }
}

/** A bound is taken on trust, but one above a value that is known to be reached is wrong. */
export const isPossible = (bound, reached) => typeof bound === 'number' && bound <= reached * (1 + SAME);

const rounded = (value) => Number(value.toFixed(6));
