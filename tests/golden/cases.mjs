// The cases of cases.json with their drawings and the plans expected of them.

import { readFileSync } from 'node:fs';

const at = (path) => new URL(path, import.meta.url);

/** What the quotes of `quotes.json` are for. */
export const MATERIAL = { name: 'Mild steel', thickness: 3, density: 7.85 };

/** Name, drawing, options, expected plan JSON, and expected hashes of the quote and of the outputs of each case. */
export function cases() {
  const quotes = JSON.parse(readFileSync(at('quotes.json'), 'utf8'));
  const outputs = JSON.parse(readFileSync(at('outputs.json'), 'utf8'));
  return JSON.parse(readFileSync(at('cases.json'), 'utf8')).map(({ name, drawing, load, plan }) => ({
    name,
    file: drawing.split('/').at(-1),
    bytes: new Uint8Array(readFileSync(at(`../fixtures/${drawing}`))),
    load,
    plan,
    golden: readFileSync(at(`${name}.json`), 'utf8'),
    hash: quotes[name],
    outputs: outputs[name],
  }));
}
