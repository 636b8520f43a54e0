// Starts the Chromium of this machine, for browser tests, pictures and benches.

import { chromium } from 'playwright-core';
import { findBrowser } from './setup.mjs';
import { Stop } from './tools.mjs';

/**
 * No sandbox, because Chromium cannot make one as root, as which CI often runs, nor on every Linux for others, and the pages are our own. No GPU, because
 * machines without a screen often have none. Nothing that Chromium fetches by itself, because tests count requests.
 */
const ARGUMENTS = ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

/** The options of V8 that tests run with (scripts/test.mjs). */
const OF_TESTS = process.env.KERFWAY_V8 === undefined ? [] : [`--js-flags=${process.env.KERFWAY_V8}`];

/** Starts Chromium, with further arguments if there are any. */
export function launchBrowser(...more) {
  const executablePath = findBrowser();
  if (executablePath === undefined) throw new Stop('This needs Chromium or Chrome. Run: npm run setup -- --tests');
  return chromium.launch({ executablePath, args: [...ARGUMENTS, ...OF_TESTS, ...more] });
}
