// Starts the queue, the server and the workers with one command. A worker that dies is replaced.
//
//     node start.mjs          PORT (3000), WORKERS (as many as processors), REDIS_URL (a Redis or Valkey that is there;
//                             otherwise valkey-server or redis-server is started, for as long as this runs)

import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { createServer } from 'node:net';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';

const children = new Set();
let ending = false;

function start(command, args, onExit, env = process.env) {
  const child = spawn(command, args, { env, stdio: ['ignore', 'inherit', 'inherit'] });
  children.add(child);
  child.on('exit', (code, signal) => {
    children.delete(child);
    if (!ending) onExit(signal ?? code);
  });
  return child;
}

function end(code) {
  if (ending) return;
  ending = true;
  process.exitCode = code;
  // The queue is closed last, because workers that finish report to it.
  const others = [...children].filter((child) => child !== redis);
  for (const child of others) child.kill('SIGTERM');
  void Promise.all(others.map((child) => once(child, 'exit'))).then(() => redis?.kill('SIGTERM'));
}

let redis = null;

async function ownRedis() {
  const command = ['valkey-server', 'redis-server'].find((name) => spawnSync(name, ['--version']).status === 0);
  if (command === undefined) {
    console.error('There is no Redis. Install valkey-server or redis-server (apt-get install redis-server, brew install valkey), or set REDIS_URL.');
    process.exit(1);
  }
  const free = createServer().listen(0, '127.0.0.1');
  await once(free, 'listening');
  const { port } = free.address();
  free.close();
  await once(free, 'close');
  // Jobs are in memory only. Set REDIS_URL to use a server that stores them.
  const settings = ['--bind', '127.0.0.1', '--port', String(port), '--save', '', '--appendonly', 'no', '--maxmemory-policy', 'noeviction', '--loglevel', 'warning'];
  redis = start(command, settings, () => end(1));
  return `redis://127.0.0.1:${port}`;
}

const env = { ...process.env, REDIS_URL: process.env.REDIS_URL ?? (await ownRedis()) };
const at = (file) => fileURLToPath(new URL(file, import.meta.url));

function startWorker() {
  const worker = start(process.execPath, [at('worker.mjs')], (why) => {
    console.log(`Worker ${worker.pid} ended (${why}): another takes its place.`);
    // Wait first, because a worker that cannot start would keep the computer busy.
    setTimeout(() => !ending && startWorker(), 500);
  }, env);
}

console.log(`Queue at ${env.REDIS_URL}`);
start(process.execPath, [at('server.mjs')], () => end(1), env);
for (let k = 0; k < Number(process.env.WORKERS ?? availableParallelism()); k++) startWorker();
process.on('SIGINT', () => end(0));
process.on('SIGTERM', () => end(0));
