// npm run fuzz: feeds damaged and invented files to the reader and to the whole intake, 60 seconds each.
//
//   npm run fuzz -- --seconds 600     longer
//   npm run fuzz -- intake            one target only
//   npm run fuzz -- --keep            then adds what reached new code to the corpus that is kept
//
// Starts from the corpus in tests/fuzz/corpus and the fixtures of the oracle. A crash leaves its input in
// tests/fuzz/artifacts and fails the run; make it a fixture and a test named after it.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, ENV, main, ROOT, run, Stop } from './tools.mjs';

const FOLDER = join('tests', 'fuzz');
// Each target with its words and the files it starts from.
const TARGETS = { dxf_reader: ['dxf.dict', 'oracle'], svg_reader: ['svg.dict', 'svg'], intake: ['dxf.dict', 'oracle'] };
const NAMES = Object.keys(TARGETS);
const CARGO_FUZZ = '0.13.2';
// A second per input is far beyond what one of this size takes: 5 s is a hang. The longest input is a file of some
// thousand lines; longer ones only slow the search down.
const LIMITS = ['-timeout=5', '-rss_limit_mb=2048', '-max_len=65536'];

main(() => {
  const { seconds, keep, targets } = options(process.argv.slice(2));
  setup();
  for (const target of targets) {
    console.log(`\n== ${target}, ${seconds} s`);
    const found = join(FOLDER, 'target', 'found', target);
    const kept = join(FOLDER, 'corpus', target);
    for (const folder of [found, kept]) mkdirSync(join(ROOT, folder), { recursive: true });
    const [dictionary, fixtures] = TARGETS[target];
    const words = `-dict=${join(FOLDER, dictionary)}`;
    fuzz(target, [found, kept, join('tests', 'fixtures', fixtures)], [`-max_total_time=${seconds}`, words, '-print_final_stats=1']);
    if (keep) fuzz(target, [kept, found], ['-merge=1']);
  }
  console.log('\nno crash');
});

// Without a sanitizer: the crate has no unsafe code for one to watch, and so stable Rust suffices.
function fuzz(target, folders, flags) {
  const args = ['fuzz', 'run', '--fuzz-dir', FOLDER, '--sanitizer', 'none', target, ...folders];
  run('cargo', [...args, '--', ...LIMITS, ...flags], { env: { ...ENV, RUSTC_BOOTSTRAP: '1' } });
}

function options(args) {
  const at = args.indexOf('--seconds');
  const seconds = at < 0 ? 60 : Number(args[at + 1]);
  const rest = args.filter((_, i) => at < 0 || (i !== at && i !== at + 1));
  const named = rest.filter((name) => name !== '--keep');
  if (!(seconds > 0) || named.some((name) => !NAMES.includes(name))) {
    throw new Stop(`Usage: npm run fuzz -- [--seconds N] [--keep] [${NAMES.join('|')}]`);
  }
  return { seconds, keep: rest.length > named.length, targets: named.length > 0 ? named : NAMES };
}

function setup() {
  if (ask('cargo', 'fuzz', '--version') === null) {
    console.log(`set-up: installing cargo-fuzz ${CARGO_FUZZ} with cargo (1 to 3 minutes)`);
    run('cargo', ['install', 'cargo-fuzz', '--locked', '--version', CARGO_FUZZ]);
  }
  if (ask('c++', '--version') === null) {
    throw new Stop('Fuzzing needs a C++ compiler. Run: sudo apt-get install g++');
  }
}
