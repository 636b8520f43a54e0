// The frozen instances: instances.json names each with its checksum, licence, source and best plan.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { ROOT, Stop } from '../scripts/tools.mjs';

export const HERE = join(ROOT, 'benchmark');
const LIST = join(HERE, 'instances.json');

/** Makes a folder for what is written, unless it is there. */
export function made(folder) {
  try {
    mkdirSync(folder, { recursive: true });
  } catch ({ code }) {
    throw new Stop(`${folder} cannot be made (${code}): name another folder.`);
  }
}

/** The list as it is stored. */
export function listed() {
  return JSON.parse(readFileSync(LIST, 'utf8'));
}

/** Stores the list, an instance a line. */
export function store({ instances: all, ...rest }) {
  const lines = all.map((entry) => `    ${JSON.stringify(entry)}`).join(',\n');
  writeFileSync(LIST, `${JSON.stringify(rest, null, 2).slice(0, -2)},\n  "instances": [\n${lines}\n  ]\n}\n`);
}

/** The entries of instances.json with what is in their files. */
export function* instances({ only = '', track } = {}) {
  const chosen = listed().instances.filter((entry) => entry.name.includes(only) && (track === undefined || entry.track === track));
  if (chosen.length === 0) throw new Stop(`No instance${track === undefined ? '' : ` of the track ${track}`} has ${only === '' ? 'been found' : `"${only}" in its name`}: instances.json lists them.`);
  for (const entry of chosen) {
    const file = join(HERE, entry.file);
    yield { entry, instance: entry.track === 'GTSP' ? { gtsplib: entry.file } : JSON.parse(gunzipSync(readFileSync(file)).toString()) };
  }
}
