// Shell completion: what each shell offers for an incomplete line.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { folder, kerfway } from './support.mjs';

const has = (shell) => spawnSync(shell, ['-c', 'exit 0']).status === 0;
const missing = (shell) => (has(shell) ? false : `there is no ${shell} here`);

/** The script of a shell, in a file. */
async function script(t, shell) {
  const { code, stdout } = await kerfway('completion', shell);
  assert.equal(code, 0);
  const path = join(folder(t), '_kerfway');
  writeFileSync(path, stdout);
  return path;
}

function output(shell, text) {
  const { status, stdout, stderr } = spawnSync(shell, ['-c', text], { encoding: 'utf8' });
  assert.deepEqual([status, stderr], [0, '']);
  return stdout.split('\n').filter(Boolean);
}

describe('kerfway completion', () => {
  it('bash offers commands, options and values, and files where they are needed', { skip: missing('bash') }, async (t) => {
    const path = await script(t, 'bash');
    const offered = (line) => {
      const words = line.split(' ');
      const array = words.map((w) => `'${w}'`).join(' ');
      return output('bash', `source ${path}; COMP_WORDS=(${array}); COMP_CWORD=${words.length - 1}; _kerfway; printf '%s\\n' "\${COMPREPLY[@]}"`);
    };
    assert.deepEqual(offered('kerfway '), ['plan', 'inspect', 'quote', 'check', 'calibrate', 'serve', 'work', 'methods', 'solve', 'verify', 'completion', 'help']);
    assert.deepEqual(offered('kerfway pl'), ['plan']);
    assert.deepEqual(offered('kerfway plan --wa'), ['--watch']);
    assert.deepEqual(offered('kerfway inspect --sec'), []);
    assert.deepEqual(offered('kerfway quote a.dxf --thick'), ['--thickness']);
    assert.deepEqual(offered('kerfway plan --units mi'), ['mil', 'microinch']);
    assert.ok(offered('kerfway plan --machine ').includes('co2-100w'));
    assert.ok(offered('kerfway quote --method ').includes('lpspso'));
    assert.deepEqual(offered('kerfway plan --gcode '), []);
    assert.deepEqual(offered('kerfway completion '), ['bash', 'zsh', 'fish']);
  });

  it('fish offers the same', { skip: missing('fish') }, async (t) => {
    const path = await script(t, 'fish');
    const offered = (line) => output('fish', `source ${path}; complete -C '${line}'`).map((l) => l.split('\t')[0]);
    assert.deepEqual(offered('kerfway pl'), ['plan']);
    assert.deepEqual(offered('kerfway plan --wa'), ['--watch']);
    assert.ok(offered('kerfway plan --machine co2').includes('co2-100w'));
    assert.deepEqual(offered('kerfway plan --units micro'), ['microinch']);
  });

  it('zsh reads its script', { skip: missing('zsh') }, async (t) => {
    const path = await script(t, 'zsh');
    assert.deepEqual(output('zsh', `autoload -Uz compinit; compinit -D -u; source ${path}; print $_comps[kerfway]`), ['_kerfway']);
  });
});
