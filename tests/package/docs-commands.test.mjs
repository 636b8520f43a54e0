// Every command for a drawing in the README, the guides and the help does what its text says: it is run, with a short search, in a folder with
// the files that it names.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { COMMANDS } from '../../dist/sdk/cli/commands.js';
import { circle, CLI, dxf, folder, ROOT, square } from './support.mjs';

const GUIDES = ['README.md', ...readdirSync(join(ROOT, 'docs')).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`)];

/** The commands of a guide, in lines of code and between backquotes, without comments. */
function commandsOf(text) {
  const lines = [...text.matchAll(/^ {4}(?=kerfway )(.*)$/gm), ...text.matchAll(/`(kerfway [^`]+)`/g)].map(([, line]) => line);
  return lines.map((line) => line.replace(/ +#.*$/, '').replace(/\s+/g, ' ').trim());
}

/** Commands that read drawings and end by themselves. A project is made by the page, and - is what another program writes. */
const isForDrawings = (line) => /^kerfway (plan|inspect|quote) [^-.<]*\.dxf/.test(line) && !/\.\.\.|--watch|\| |[A-Z]{4}/.test(line.replace(/--layer "[^"]*"/g, ''));

/** The same with a search of a moment. */
const short = (line) => (line.startsWith('kerfway inspect') ? line : `${line.replace(/ --(seconds|moves) \S+/g, '')} --moves 10`);

/** Six parts with holes, 10 mm apart. */
const SHEET = dxf(...[0, 1, 2, 3, 4, 5].flatMap((k) => [square(160 + 70 * (k % 3), 120 + 70 * Math.floor(k / 3), 60, 'OUTER'), circle(190 + 70 * (k % 3), 150 + 70 * Math.floor(k / 3), 12, 'ENGRAVE')]));

/** A folder with all files that the commands name. */
async function workshop(t) {
  const at = folder(t);
  mkdirSync(join(at, 'orders'));
  for (const name of ['plate', 'box', 'nest', 'grid', 'a', 'bracket', 'orders/b']) writeFileSync(join(at, `${name}.dxf`), SHEET);
  symlinkSync(join(ROOT, 'tests'), join(at, 'tests'));
  const planner = await createPlanner();
  const [machine] = planner.machines;
  writeFileSync(join(at, 'my.json'), JSON.stringify({ ...planner.dialects[0], name: 'my' }));
  planner.close();
  const materials = [{ name: '3 mm birch ply', cut: { speed: 7, power: 0.9, passes: 2 } }];
  for (const name of ['shop', 'workshop']) writeFileSync(join(at, `${name}.json`), JSON.stringify({ ...machine, kerf_width: 0.15, materials }));
  return at;
}

function run(line, cwd) {
  return new Promise((resolve) => {
    const child = spawn('sh', ['-c', `kerfway() { "${process.execPath}" "${CLI}" "$@"; }\n${line}`], { cwd, stdio: ['ignore', 'ignore', 'pipe'] });
    let stderr = '';
    child.stderr.on('data', (text) => (stderr += text));
    child.on('close', (code) => resolve({ code, stderr }));
  });
}

describe('commands of the documentation', () => {
  const help = Object.values(COMMANDS).flatMap(({ examples }) => examples.map(([line]) => line));
  for (const [where, all, least] of [['guides', GUIDES.flatMap((guide) => commandsOf(readFileSync(join(ROOT, guide), 'utf8'))), 15], ['help', help, 8]]) {
    const lines = [...new Set(all.filter(isForDrawings))];
    it(`of the ${where} do their work`, async (t) => {
      assert.ok(lines.length >= least, lines.join('\n'));
      const at = await workshop(t);
      for (const line of lines) {
        const { code, stderr } = await run(short(line), at);
        assert.equal(code, 0, `${line}\n${stderr}`);
      }
    });
  }
});
