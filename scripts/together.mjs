// Long tasks side by side, with a line every few seconds that says which are at work and how long they usually take.

import { spawn } from 'node:child_process';
import { ENV, ROOT, Stop } from './tools.mjs';

/** Seconds between two lines. */
const EVERY = 5;
/** Lines of a failed command's output that are shown. */
const TAIL = 40;

/**
 * @typedef {object} Task
 * @property {string} name what is being done, as in "compiling the core"
 * @property {string} usually how long it takes on a machine with two cores, as in "2 to 3 minutes"
 * @property {() => Promise<void>} work does it
 */

/** Runs tasks at the same time; when one fails, its reason is thrown once all have ended. */
export async function together(tasks) {
  if (tasks.length === 0) return;
  const begun = Date.now();
  const seconds = () => Math.round((Date.now() - begun) / 1000);
  const open = new Set(tasks);
  for (const { name, usually } of tasks) console.log(`${name} (usually ${usually})`);
  const beat = setInterval(() => {
    console.log(`${String(seconds()).padStart(4)} s  ${[...open].map((t) => t.name).join('; ')}`);
  }, EVERY * 1000);
  const ended = await Promise.allSettled(
    tasks.map(async (task) => {
      await task.work().finally(() => open.delete(task));
      console.log(`${String(seconds()).padStart(4)} s  done: ${task.name}`);
    }),
  );
  clearInterval(beat);
  const failed = ended.find((e) => e.status === 'rejected');
  if (failed !== undefined) throw failed.reason;
}

/** Runs a command quietly; when it fails, the end of what it printed is part of the sentence. */
export function quietly(command, args, options = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      ...{ env: ENV, cwd: ROOT, stdio: ['ignore', 'pipe', 'pipe'], shell: process.platform === 'win32' },
      ...options,
    });
    let text = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (d) => (text += d));
    child.on('error', (error) => reject(new Stop(`${command} could not be started: ${error.message}`)));
    child.on('close', (code, signal) => {
      if (code === 0) return resolve(text);
      const end = text.trimEnd().split('\n').slice(-TAIL).join('\n');
      reject(new Stop(`${end}\n${command} ${args.join(' ')} ended with ${code ?? signal}`));
    });
  });
}

/** Hours, minutes and seconds since this process began, for the last line of a script. */
export function sinceStart() {
  const seconds = Math.round(process.uptime());
  return seconds < 60 ? `${seconds} s` : `${Math.floor(seconds / 60)} min ${seconds % 60} s`;
}
