// README, CONTRIBUTING and docs name files, tests and benches: what they name exists.

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, it } from 'node:test';
import { ROOT } from './support.mjs';

const within = (folder) => readdirSync(join(ROOT, folder), { recursive: true }).map((f) => join(folder, f));
const PAGES = ['README.md', 'CONTRIBUTING.md', 'benchmark/README.md', 'examples/README.md', 'benches/data/README.md', ...within('docs').filter((f) => f.endsWith('.md') && !f.startsWith(join('docs', 'api')))];
const read = (page) => readFileSync(join(ROOT, page), 'utf8');
/** The words of a page in `code` quotes, and its indented and fenced commands. */
const quoted = (page) => [...read(page).matchAll(/`([^`\n]+)`/g)].map(([, words]) => words);
const commands = (page, pattern) => [...read(page).matchAll(pattern)].map(([, words]) => words);

describe('the pages for people name what exists', () => {
  it('files of Rust, and folders', () => {
    const files = [...within('src'), ...within('tests'), ...within('benches'), ...within('www'), ...within('scripts')];
    const ends = new Set(files.flatMap((f) => f.split('/').map((_, k, parts) => parts.slice(k).join('/'))));
    const wrong = PAGES.flatMap((page) => quoted(page)
      // Paths, except patterns with a placeholder.
      .filter((words) => /^[\w./-]+$/.test(words) && (/\.rs$/.test(words) || /^(src|tests|benches|www|scripts|docs)\//.test(words)) && !/NAME|XX/.test(words))
      .filter((words) => !ends.has(words.replace(/\/$/, '')) && !existsSync(join(ROOT, words)) && !existsSync(join(ROOT, `${words}.rs`)) && !existsSync(join(ROOT, 'src', words)))
      .map((words) => `${page}: ${words}`));
    assert.deepEqual(wrong, []);
  });

  it('the modules of the tables and lists of docs/internals', () => {
    const modules = new Set(within('src').map((f) => f.split('/').at(-1).replace(/\.rs$/, '')));
    const page = join('docs', 'internals', 'intake.md');
    const rows = read(page).split('\n').filter((line) => /^\| \w+ \| `/.test(line) || /^\d\. \*\*/.test(line));
    // The second column of the table, and the words in brackets after the name of a step.
    const named = rows.flatMap((row) => [...(row.startsWith('|') ? row.split('|')[2] : /\(([^)]*)\)/.exec(row)?.[1] ?? '').matchAll(/`([\w/*]+)`/g)].map(([, name]) => name));
    assert.ok(named.length > 15, named.join());
    assert.deepEqual(named.filter((name) => !modules.has(name.split('/')[0])), []);
  });

  it('names in the code', () => {
    const code = ['src', 'www', 'tests/it', 'tests/testkit', 'scripts', 'benches'].flatMap(within)
      .filter((f) => /\.(rs|ts|mjs|json)$/.test(f) && !/node_modules|target/.test(f)).map(read).join('\n');
    const known = new Set(code.match(/\w+/g));
    const pages = PAGES.filter((page) => page === 'CONTRIBUTING.md' || page.startsWith(join('docs', 'internals')));
    const wrong = pages.flatMap((page) => quoted(page)
      .filter((words) => /^&?[A-Za-z_]\w*((::|\.)\w+)*(\(\w*\))?$/.test(words) && !/^(FOO|XX|NAME)$/.test(words))
      .filter((words) => words.match(/\w+/g).some((word) => !known.has(word)))
      .map((words) => `${page}: ${words}`));
    assert.deepEqual(wrong, []);
  });

  it('links to other pages', () => {
    const wrong = PAGES.flatMap((page) => commands(page, /\]\(([^)#:]+)(?:#[^)]*)?\)/g)
      .filter((target) => !existsSync(join(ROOT, dirname(page), target)))
      .map((target) => `${page}: ${target}`));
    assert.deepEqual(wrong, []);
  });

  it('headings of pages, by links with a #', () => {
    // As GitHub makes them of headings.
    const anchorsOf = (page) => commands(page, /^#+ (.*)$/gm).map((heading) => heading.toLowerCase().replace(/[^\p{L}\p{N}_\- ]/gu, '').replaceAll(' ', '-'));
    const wrong = PAGES.flatMap((page) => [...read(page).matchAll(/\]\(([^)#:]*)#([^)]+)\)/g)]
      .map(([, target, anchor]) => [target === '' ? page : join(dirname(page), target), anchor])
      .filter(([target, anchor]) => target.endsWith('.md') && !anchorsOf(target).includes(anchor))
      .map(([target, anchor]) => `${page}: ${target}#${anchor}`));
    assert.deepEqual(wrong, []);
  });

  it('every script of the project and every bench, in CONTRIBUTING', () => {
    const text = read('CONTRIBUTING.md');
    const { scripts } = JSON.parse(read('package.json'));
    for (const name of Object.keys(scripts).filter((name) => name !== 'setup')) assert.match(text, new RegExp(`npm (run )?${name}\\b`), name);
    const benches = readdirSync(join(ROOT, 'benches')).filter((file) => file.endsWith('.mjs') && file !== 'run.mjs').map((file) => file.slice(0, -4));
    const row = text.split('\n').find((line) => line.startsWith('| `npm run bench -- NAME`'));
    assert.deepEqual(benches.filter((name) => !row.includes(`\`${name}\``)), []);
  });

  it('commands of the benchmark', () => {
    const code = read(join('benchmark', 'run.mjs'));
    for (const page of PAGES) for (const name of commands(page, /npm run benchmark -- ([a-z]+)/g)) assert.ok(code.includes(`  async ${name}(`), `${page}: ${name}`);
  });

  it('no program of a stranger: npx would look for a package that is not installed on npm', () => {
    for (const page of PAGES) assert.doesNotMatch(read(page), /npx kerfway/, page);
  });

  it('no folder that a reader does not have, beside the repository', () => {
    for (const page of PAGES) for (const [, target] of read(page).matchAll(/(?:^| |=)((?:\.\.\/)+[\w/.-]+)/gm)) assert.ok(existsSync(join(ROOT, dirname(page), target)), `${page}: ${target}`);
  });

  it('commands: npm scripts, benches and native tests', () => {
    const { scripts } = JSON.parse(read('package.json'));
    const modules = read(join('tests', 'it', 'main.rs'));
    for (const page of PAGES) {
      for (const name of commands(page, /npm run ([a-z]+)/g)) assert.ok(name in scripts, `${page}: npm run ${name}`);
      for (const name of commands(page, /npm run bench -- ([a-z-]+)/g)) assert.ok(existsSync(join(ROOT, 'benches', `${name}.mjs`)), `${page}: bench ${name}`);
      for (const name of commands(page, /--test it\s+([a-z_]+)/g)) assert.ok(name === 'some_module' || modules.includes(`mod ${name};`), `${page}: test ${name}`);
      for (const name of commands(page, /node --test (tests\/[\w/.-]+\.mjs)/g)) assert.ok(/NAME/.test(name) || existsSync(join(ROOT, name)), `${page}: ${name}`);
    }
  });

  it('every figure of README in a table has its command', () => {
    const text = read('README.md');
    const results = text.slice(text.indexOf('## Results'), text.indexOf('## What is read'));
    // A table comes after a sentence with its command, or has a column of commands.
    for (const [, before, table] of results.matchAll(/\n([^|]*)\n((?:\|.*\n)+)/g)) {
      const rows = table.trim().split('\n').slice(2);
      assert.ok(/npm run bench -- /.test(before) || rows.every((row) => /`(npm run bench|cargo test)/.test(row)), table);
    }
  });
});
