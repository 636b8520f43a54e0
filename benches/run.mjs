// npm run bench -- NAME: runs one of the benches beside this file.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { main, ROOT, Stop } from '../scripts/tools.mjs';

main(async () => {
  const names = readdirSync(join(ROOT, 'benches'))
    .filter((f) => f.endsWith('.mjs') && f !== 'run.mjs')
    .map((f) => f.slice(0, -'.mjs'.length));
  const [name, ...args] = process.argv.slice(2);
  if (!names.includes(name)) throw new Stop(`Which bench? npm run bench -- ${names.join('|')}`);
  const { bench } = await import(`./${name}.mjs`);
  await bench(args);
});
