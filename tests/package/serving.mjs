// Starts `kerfway serve` and `kerfway work` for tests, on the loopback address.

import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { CLI } from './support.mjs';

/** Starts the service on a free port. `log` collects its log, one object per line. */
export async function serve(t, ...args) {
  const child = spawn(process.execPath, [CLI, 'serve', '--port', '0', ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
  const log = [];
  let rest = '';
  child.stderr.on('data', (data) => {
    const lines = (rest + data).split('\n');
    rest = lines.pop();
    log.push(...lines.map((line) => JSON.parse(line)));
  });
  const exited = once(child, 'exit');
  t.after(async () => {
    child.kill('SIGKILL');
    await exited;
  });
  const [said] = await Promise.race([once(child.stdout, 'data'), exited.then(() => [''])]);
  const url = /http:\S+/.exec(String(said))?.[0];
  if (url === undefined) throw new Error(`The service did not start: ${JSON.stringify(log)}`);
  const send = (path, body, { headers = {}, ...rest } = {}) => fetch(`${url}${path}`, { method: 'POST', body, ...rest, headers: { ...(body instanceof FormData ? {} : { 'content-type': 'image/vnd.dxf' }), ...headers } });
  const metric = async (name, headers = {}) => {
    const text = await (await fetch(`${url}/metrics`, { headers })).text();
    return [...text.matchAll(new RegExp(`^${name}(?:\\{[^}]*\\})? (\\S+)$`, 'gm'))].reduce((sum, [, n]) => sum + Number(n), 0);
  };
  return { child, url, log, send, metric, stop: () => (child.kill('SIGTERM'), exited) };
}

/** A form with a drawing. */
export function form(bytes, name, fields = {}) {
  const made = new FormData();
  made.set('drawing', new Blob([bytes]), name);
  for (const [field, value] of Object.entries(fields)) made.set(field, typeof value === 'string' ? value : JSON.stringify(value));
  return made;
}
