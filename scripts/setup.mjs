// Brings in what is missing for building and testing, and nothing else; says in one line each what it does.
// Needs rustup and Node, and no more of the network than the package registries.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ask, firstOf, LOCAL_TOOLS, main, ROOT, run, Stop } from './tools.mjs';

const WASM_TARGET = 'wasm32-unknown-unknown';
const WASM_PACK = '0.15.1';

const say = (line) => console.log(`set-up: ${line}`);

/** Everything a build needs; with `browser`, also what the browser tests and the test of the queue need. */
export function setup({ browser = false } = {}) {
  rust();
  wasmPack();
  wasmBindgen();
  npmPackages();
  if (!browser) return;
  chromium();
  redis();
}

function rust() {
  if (ask('rustup', '--version') === null) {
    throw new Stop('Rust is missing. Install it with rustup from https://rustup.rs, then run this again.');
  }
  const wanted = /^rust-version = "(.*)"/m.exec(read('Cargo.toml'))[1];
  const found = /^rustc (\d+\.\d+)/.exec(ask('rustc', '--version') ?? '')?.[1];
  if (found === undefined || older(found, wanted)) {
    throw new Stop(`Rust ${wanted} or later is needed, this is ${found ?? 'none'}. Run: rustup update stable`);
  }
  const targets = ask('rustup', 'target', 'list', '--installed') ?? '';
  if (!targets.split('\n').includes(WASM_TARGET)) {
    say(`adding the Rust target ${WASM_TARGET}`);
    run('rustup', ['target', 'add', WASM_TARGET]);
  }
  const components = ask('rustup', 'component', 'list', '--installed') ?? '';
  for (const name of ['rustfmt', 'clippy']) {
    if (components.split('\n').some((c) => c.startsWith(name))) continue;
    say(`adding the Rust component ${name}`);
    run('rustup', ['component', 'add', name]);
  }
}

function wasmPack() {
  if (ask('wasm-pack', '--version') !== null) return;
  say(`installing wasm-pack ${WASM_PACK} with cargo (2 to 5 minutes)`);
  run('cargo', ['install', 'wasm-pack', '--locked', '--version', WASM_PACK]);
}

// wasm-bindgen writes the JavaScript beside the wasm and must be exactly the version the crate was built with. When
// the person has another one, theirs stays and ours goes into .setup.
function wasmBindgen() {
  const wanted = /name = "wasm-bindgen"\nversion = "(.*)"/.exec(read('Cargo.lock'))[1];
  const found = ask('wasm-bindgen', '--version');
  const runner = ask('wasm-bindgen-test-runner', '--version');
  if (found?.endsWith(` ${wanted}`) && runner !== null) return;
  say(`installing wasm-bindgen-cli ${wanted} with cargo (3 to 8 minutes)`);
  const where = found === null ? [] : ['--root', LOCAL_TOOLS];
  run('cargo', ['install', 'wasm-bindgen-cli', '--locked', '--version', wanted, ...where]);
}

function npmPackages() {
  const stamp = join(ROOT, 'node_modules', '.kerfway-lock');
  const lock = createHash('sha256').update(read('package-lock.json')).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return;
  say('installing the npm packages of package-lock.json');
  run('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']);
  writeFileSync(stamp, lock);
}

const BROWSERS = [
  'chromium',
  'chromium-browser',
  'google-chrome',
  'google-chrome-stable',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
];

/** The Chromium or Chrome on this machine; CHROME_PATH names another. */
export function findBrowser() {
  return process.env.CHROME_PATH ?? firstOf(BROWSERS);
}

function chromium() {
  if (findBrowser() !== undefined) return;
  const root = process.getuid?.() === 0;
  if (root && ask('apt-get', '--version') !== null) {
    say('installing Chromium with apt-get, for the browser tests');
    run('apt-get', ['update', '-q']);
    run('apt-get', ['install', '-y', '-q', '--no-install-recommends', 'chromium']);
    if (findBrowser() !== undefined) return;
  }
  throw new Stop(
    'The browser tests need Chromium or Chrome. Run: sudo apt-get install chromium (or set CHROME_PATH).',
  );
}

/** The queue example needs one; where there is none, its test says so and is left out. */
function redis() {
  if (process.env.REDIS_URL !== undefined || firstOf(['valkey-server', 'redis-server']) !== undefined) return;
  if (process.getuid?.() !== 0 || ask('apt-get', '--version') === null) return;
  say('installing redis-server with apt-get, for the test of the queue');
  if (ask('apt-get', 'update', '-q') === null || ask('apt-get', 'install', '-y', '-q', '--no-install-recommends', 'redis-server') === null) {
    say('redis-server cannot be installed: the test of the queue will be left out');
  }
}

function read(name) {
  return readFileSync(join(ROOT, name), 'utf8');
}

function older(found, wanted) {
  const [a, b] = [found, wanted].map((v) => v.split('.').map(Number));
  return a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(() => {
    setup({ browser: process.argv.includes('--browser') });
    say('all there');
  });
}
