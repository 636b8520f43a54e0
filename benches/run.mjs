// npm run bench -- NAME: runs one of the benches beside this file.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { setup } from '../scripts/setup.mjs';
import { main, ROOT, Stop } from '../scripts/tools.mjs';

main(async () => {
  const names = readdirSync(join(ROOT, 'benches'))
    .filter((f) => f.endsWith('.mjs') && f !== 'run.mjs')
    .map((f) => f.slice(0, -'.mjs'.length));
  const [name, ...args] = process.argv.slice(2);
  if (!names.includes(name)) throw new Stop(`Which bench? npm run bench -- ${names.join('|')}`);
  // Benches import npm packages, which a fresh clone does not have yet.
  await setup();
  const { bench } = await import(`./${name}.mjs`);
  await bench(args);
});
