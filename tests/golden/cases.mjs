// The cases of cases.json with their drawings and the plans expected of them.

import { readFileSync } from 'node:fs';

const at = (path) => new URL(path, import.meta.url);

/** Name, drawing, options and expected plan JSON of each case. */
export function cases() {
  return JSON.parse(readFileSync(at('cases.json'), 'utf8')).map(({ name, drawing, load, plan }) => ({
    name,
    file: drawing.split('/').at(-1),
    bytes: new Uint8Array(readFileSync(at(`../fixtures/${drawing}`))),
    load,
    plan,
    golden: readFileSync(at(`${name}.json`), 'utf8'),
  }));
}
