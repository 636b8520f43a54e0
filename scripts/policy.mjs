// The Content-Security-Policy of www/policy.json in one line.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './tools.mjs';

const DIRECTIVES = JSON.parse(readFileSync(join(ROOT, 'www', 'policy.json'), 'utf8'));

/** The policy with some directives changed. */
export function policyWith(directives = {}) {
  return Object.entries({ ...DIRECTIVES, ...directives })
    .map(([what, from]) => `${what} ${from}`)
    .join('; ');
}
