/** API keys: a file has one per line, with an optional name before it. */

import { createHash } from 'node:crypto';
import type { IncomingMessage } from 'node:http';
import { KerfwayError } from '../errors.js';

/** Shorter keys can be guessed. */
const SHORTEST = 16;

/** Reads a file of keys. Keys are kept as hashes only. Lines that begin with # are comments. */
export function keysIn(text: string): Map<string, string> {
  const keys = new Map<string, string>();
  for (const [k, line] of text.split('\n').entries()) {
    const words = line.trim().split(/\s+/);
    const key = words.at(-1) ?? '';
    if (key === '' || line.trim().startsWith('#')) continue;
    if (words.length > 2) throw new KerfwayError('wrong-usage', `Line ${k + 1} of the keys has ${words.length} words. Write KEY, or NAME KEY.`);
    if (key.length < SHORTEST) throw new KerfwayError('wrong-usage', `The key in line ${k + 1} has ${key.length} characters. Give at least ${SHORTEST}.`);
    if (keys.has(hashed(key))) throw new KerfwayError('wrong-usage', `The key in line ${k + 1} is in a line before, too. Give each key once.`);
    keys.set(hashed(key), words.length === 2 ? (words[0] ?? '') : `line ${k + 1}`);
  }
  if (keys.size === 0) throw new KerfwayError('wrong-usage', 'The file of keys has no key.');
  return keys;
}

/** The name of the key in a request. Throws unless it is known; looking up a hash takes the same time for every key. */
export function keyOf(request: IncomingMessage, keys: ReadonlyMap<string, string>): string | null {
  if (keys.size === 0) return null;
  const bearer = /^Bearer\s+(\S+)$/i.exec(request.headers.authorization ?? '')?.[1];
  const header = request.headers['x-api-key'];
  const given = bearer ?? (typeof header === 'string' ? header : undefined);
  const name = given === undefined ? undefined : keys.get(hashed(given));
  if (name !== undefined) return name;
  throw new KerfwayError('unauthorized', given === undefined ? 'This service needs a key: send the header "Authorization: Bearer KEY".' : 'The key is not known.');
}

function hashed(key: string): string {
  return createHash('sha256').update(key).digest('hex');
}
