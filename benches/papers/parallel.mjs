// Runs of a native bench, some at a time.

import { spawn } from 'node:child_process';
import { ENV, Stop } from '../../scripts/tools.mjs';

/** The rows each list of arguments gives, in their order. */
export async function parallel(command, jobs, workers) {
  const results = [];
  let next = 0;
  const work = async () => {
    while (next < jobs.length) {
      const job = next++;
      results[job] = await one(command, jobs[job]);
    }
  };
  await Promise.all(Array.from({ length: Math.min(workers, jobs.length) }, work));
  return results;
}

function one(command, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { env: ENV });
    let [text, wrong] = ['', ''];
    child.stdout.on('data', (d) => (text += d));
    child.stderr.on('data', (d) => (wrong += d));
    child.on('error', reject);
    child.on('close', (code) => {
      if (code === 0) resolve(text.trim().split('\n').map((line) => JSON.parse(line)));
      else reject(new Stop(`${command} ${args.join(' ')} failed:\n${wrong}`));
    });
  });
}
