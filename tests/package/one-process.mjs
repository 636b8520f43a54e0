// Runs the command line several times in one process, which needs to start only once. Its arguments are those of each run, as JSON; it prints what
// each run came to.

import { pathToFileURL } from 'node:url';
import { CLI } from './support.mjs';

const results = [];
const written = {};
for (const stream of ['stdout', 'stderr']) {
  written[stream] = process[stream].write.bind(process[stream]);
  process[stream].setMaxListeners(0);
  process[stream].write = (text, done) => {
    results.at(-1)[stream] += text;
    done?.();
    return true;
  };
}
for (const [k, words] of process.argv.slice(2).map((json) => JSON.parse(json)).entries()) {
  process.argv.splice(2, Infinity, ...words);
  process.exitCode = 0;
  results.push({ stdout: '', stderr: '' });
  await import(`${pathToFileURL(CLI)}?${k}`);
  results.at(-1).code = process.exitCode;
}
process.exitCode = 0;
written.stdout(JSON.stringify(results));
