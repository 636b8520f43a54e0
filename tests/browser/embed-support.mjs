// Helpers of the tests of embedding: pages of a host under the strict policy, served together with the files of dist/sdk.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { launchBrowser } from '../../scripts/browser.mjs';
import { serve } from '../../scripts/serve.mjs';
import { DIST } from '../../scripts/tools.mjs';

/** Milliseconds anything may take on a busy machine. */
const PATIENCE = 30_000;

/** One browser and one server of dist/sdk for a test file. */
export function embedding() {
  const at = { server: null, browser: null };
  before(async () => {
    at.server = await serve(join(DIST, 'sdk'));
    // Pages that Playwright answers have no address, and count as foreign to the servers on this machine.
    at.browser = await launchBrowser('--disable-features=LocalNetworkAccessChecks');
  });
  after(async () => {
    await at.browser.close();
    await at.server.close();
  });
  return at;
}

/**
 * Opens a host's page, `embedder.html` beside the files of dist/sdk, with its script in a file of its own, as the policy
 * wants it. Errors on the page and breaches of the policy fail the test, but for those `allowed` matches.
 */
export async function openHost(t, { server, browser }, { html, script = '', policy, allowed = /^$/, size = { width: 900, height: 700 } }) {
  const context = await browser.newContext({ viewport: size, acceptDownloads: true });
  t.after(() => context.close());
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  const requests = [];
  const wrong = [];
  context.on('request', (request) => requests.push(request.url()));
  page.on('pageerror', (error) => wrong.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && wrong.push(message.text()));
  t.after(() => assert.deepEqual(wrong.filter((text) => !allowed.test(text)), []));
  const header = policy ?? (await (await fetch(`${server.url}index.js`)).headers.get('content-security-policy'));
  const headers = { 'content-security-policy': header };
  const body = `<!doctype html><meta charset="utf-8"><title>Host</title>${html}<script type="module" src="embedder.js"></script>`;
  await page.route('**/embedder.html', (route) => route.fulfill({ contentType: 'text/html', body, headers }));
  await page.route('**/embedder.js', (route) => route.fulfill({ contentType: 'text/javascript', body: script, headers }));
  await page.goto(`${server.url}embedder.html`);
  return { page, requests, url: server.url };
}

/** A drawing as text that a page can be handed. */
export const base64 = (bytes) => Buffer.from(bytes).toString('base64');
