// The Content-Security-Policy of www/policy.json in one line.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './tools.mjs';

export const POLICY = Object.entries(JSON.parse(readFileSync(join(ROOT, 'www', 'policy.json'), 'utf8')))
  .map(([what, from]) => `${what} ${from}`)
  .join('; ');
