// npm run docs: writes docs/api, the reference of the package, with TypeDoc. `--check` compares it with what would be written.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { DIST, main, ROOT, Stop } from './tools.mjs';

const FOLDER = join(ROOT, 'docs', 'api');

/** Writes the pages into a folder; stops when a name that the package exports has no sentence, or a link leads nowhere. */
function write(folder) {
  if (!existsSync(join(DIST, 'sdk', 'index.d.ts'))) throw new Stop('The package is not built: npm run build comes first.');
  const { status, stdout, stderr } = spawnSync(process.execPath, [join(ROOT, 'scripts', 'docs', 'write.mjs'), folder], { encoding: 'utf8' });
  if (stderr.includes('ERR_MODULE_NOT_FOUND')) throw new Stop('TypeDoc is not installed in scripts/docs: npm install comes first.');
  if (status !== 0) throw new Stop(`TypeDoc did not write the reference:\n${stdout}${stderr}`);
}

const pages = (folder) => new Map(readdirSync(folder).map((file) => [file, readFileSync(join(folder, file), 'utf8')]));

function check() {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-docs-'));
  try {
    write(folder);
    const [written, kept] = [pages(folder), pages(FOLDER)];
    const changed = [...new Set([...written.keys(), ...kept.keys()])].filter((file) => written.get(file) !== kept.get(file));
    if (changed.length > 0) throw new Stop(`docs/api is out of date (${changed.join(', ')}): run npm run docs and commit it.`);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

main(() => {
  const { values } = parseArgs({ options: { check: { type: 'boolean' } } });
  if (values.check) return check();
  write(FOLDER);
  console.log(`docs/api: ${[...pages(FOLDER)].map(([file, text]) => `${file} ${text.split('\n').length}`).join(', ')} lines`);
});
