// Brings in what is missing for building and testing, and nothing else; says in one line each what it does.
// Needs rustup and Node, and no more of the network than the package registries.

import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { quietly, together } from './together.mjs';
import { ask, ENV, firstOf, LOCAL_TOOLS, main, ROOT, run, Stop } from './tools.mjs';

const WASM_TARGET = 'wasm32-unknown-unknown';
const WASM_PACK = '0.15.1';

const say = (line) => console.log(`set-up: ${line}`);

/** Brings in everything a build needs; with `tests`, also what `npm test` needs. */
export async function setup({ tests = false } = {}) {
  await together(missing({ tests }));
}

/** The tasks that bring in what is missing; what takes no time is done at once. */
export function missing({ tests = false } = {}) {
  rust();
  const tasks = [...npmPackages(), ...wasmBindgen()];
  return tests ? [...tasks, ...wasmPack(), ...fromApt()] : tasks;
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

// Tools for building run for a second: they are compiled for a short build, not for a fast tool.
const QUICK_TO_COMPILE = { CARGO_PROFILE_RELEASE_OPT_LEVEL: '1', CARGO_PROFILE_RELEASE_LTO: 'off', CARGO_PROFILE_RELEASE_CODEGEN_UNITS: '16' };

function cargoInstall(name, version, usually, ...where) {
  const args = ['install', name, '--locked', '--version', version, ...where];
  const work = () => quietly('cargo', args, { env: { ...ENV, ...QUICK_TO_COMPILE } });
  return [{ name: `set-up: compiling ${name} ${version}`, usually, work }];
}

// wasm-bindgen writes the JavaScript beside the wasm and must be exactly the version the crate was built with. When
// the person has another one, theirs stays and ours goes into .setup.
function wasmBindgen() {
  const wanted = /name = "wasm-bindgen"\nversion = "(.*)"/.exec(read('Cargo.lock'))[1];
  const found = ask('wasm-bindgen', '--version');
  const runner = ask('wasm-bindgen-test-runner', '--version');
  if (found?.endsWith(` ${wanted}`) && runner !== null) return [];
  return cargoInstall('wasm-bindgen-cli', wanted, '2 to 4 minutes', ...(found === null ? [] : ['--root', LOCAL_TOOLS]));
}

/** Runs the wasm tests under Node. */
function wasmPack() {
  if (ask('wasm-pack', '--version') !== null) return [];
  return cargoInstall('wasm-pack', WASM_PACK, '2 to 4 minutes');
}

function npmPackages() {
  const stamp = join(ROOT, 'node_modules', '.kerfway-lock');
  const lock = createHash('sha256').update(read('package-lock.json')).digest('hex');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return [];
  const work = async () => {
    await quietly('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error']);
    writeFileSync(stamp, lock);
  };
  return [{ name: 'set-up: installing the npm packages of package-lock.json', usually: 'half a minute', work }];
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

const SHELL = 'chromium-headless-shell';

/** What follows where one of these cannot be installed. */
const WITHOUT = { [SHELL]: 'the browser tests take twice as long', 'redis-server': 'the test of the queue will be skipped' };

/** The Chromium or Chrome on this machine; CHROME_PATH names another. */
export function findBrowser() {
  const { CHROME_PATH } = process.env;
  return firstOf(CHROME_PATH === undefined ? BROWSERS : [CHROME_PATH]);
}

/**
 * The Chromium without a window, which the tests use where there is one: the same engine, but a page costs half as much of the processor, because
 * Chromium makes a window with all its controls for each page, also if nobody sees it. A browser that CHROME_PATH names goes first.
 */
export function findShell() {
  return process.env.CHROME_PATH === undefined ? firstOf([SHELL]) : undefined;
}

/** Chromium for the browser tests, and what they do without if it cannot be had: its shell, and a Redis for the test of the queue example. */
function fromApt() {
  const apt = process.getuid?.() === 0 && ask('apt-get', '--version') !== null;
  const chromium = findBrowser() === undefined;
  if (chromium && !apt) {
    throw new Stop('The browser tests need Chromium or Chrome. Run: sudo apt-get install chromium (or set CHROME_PATH).');
  }
  const redis = process.env.REDIS_URL === undefined && firstOf(['valkey-server', 'redis-server']) === undefined;
  const shell = process.env.CHROME_PATH === undefined && findShell() === undefined && (chromium || versionFromApt() !== null);
  const optional = apt ? [...(shell ? [SHELL] : []), ...(redis ? ['redis-server'] : [])] : [];
  const wanted = [...(chromium ? ['chromium'] : []), ...optional];
  if (wanted.length === 0) return [];
  const install = (name) => quietly('apt-get', ['install', '-y', '-q', '--no-install-recommends', name]);
  const work = async () => {
    const updated = quietly('apt-get', ['update', '-q']);
    if (chromium) await updated.then(() => install('chromium'));
    for (const name of optional) {
      // The shell is of the version of Chromium, which stays as it is.
      await updated.then(() => install(name === SHELL ? `${SHELL}=${versionFromApt()}` : name)).catch(() => say(`${name} cannot be installed: ${WITHOUT[name]}`));
    }
  };
  return [{ name: `set-up: installing ${wanted.join(' and ')} with apt-get, for the tests`, usually: 'a minute', work }];
}

/** The version of Chromium that apt-get has installed, if it has. */
const versionFromApt = () => ask('dpkg-query', '--show', '--showformat', '${Version}', 'chromium');

function read(name) {
  return readFileSync(join(ROOT, name), 'utf8');
}

function older(found, wanted) {
  const [a, b] = [found, wanted].map((v) => v.split('.').map(Number));
  return a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(async () => {
    await setup({ tests: process.argv.includes('--tests') });
    say('everything is there');
  });
}
