// npm run benchmark -- COMMAND: the public benchmark of cutting paths. README.md says what it is.
//
//     check FOLDER                       checks the plans of a folder with check.py, which needs Python and nothing else
//     solve FOLDER [--seconds S]         writes Kerfway's plans into a folder [--only NAME] [--seed N] [--track T] [--prove S]
//     trace [--only NAME] [--seconds S]  writes how our values and bounds change over the seconds into `traces`, for the plots of the site
//     compare FOLDER [--only NAME]       writes the plans of other programs into folders below, those that are installed [--by PROGRAM]
//     keep FOLDER                        takes the plans of a folder that are sound and better into `best`
//     generate FOLDER --seed N           writes fresh instances, NAME.instance.json, and our plans for them, NAME.json [--count K] [--seconds S]
//     freeze                             makes the instances again, for the maintainers of the benchmark
//     site [FOLDER]                      writes the static pages (default target/benchmark-site)

import { writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { main, run, ROOT, Stop } from '../scripts/tools.mjs';
import { HERE, instances, made } from './instances.mjs';

const COMMANDS = {
  async check({ folder }) {
    run('python3', [join(HERE, 'check.py'), needed(folder)]);
  },
  async solve({ folder, only, track, seconds, seed, prove }) {
    const { solved } = await import('./solve.mjs');
    made(needed(folder));
    for (const { entry, instance } of instances({ only, track })) {
      const { plan, bound } = await solved(instance, { seconds, prove: prove && { seconds: prove } }, seed);
      writeFileSync(join(folder, `${entry.name}.json.gz`), gzipSync(JSON.stringify({ ...plan, bound }), { level: 9 }));
      console.log(`${entry.name.padEnd(24)} ${plan.by}, ${seconds} s, lower bound ${bound.toFixed(3)}`);
    }
  },
  async trace({ only, track, seconds, seed }) {
    const { solved } = await import('./solve.mjs');
    made(join(HERE, 'traces'));
    for (const { entry, instance } of instances({ only, track })) {
      const { trace } = await solved(instance, { seconds, prove: { seconds } }, seed);
      // Tours of GTSPLIB have none.
      if (trace === undefined) continue;
      writeFileSync(join(HERE, 'traces', `${entry.name}.json`), `${JSON.stringify({ seconds, ...trace })}\n`);
      console.log(`${entry.name}: ${trace.values.length} values, ${trace.bounds.length} bounds`);
    }
  },
  async compare({ folder, only, by, seconds }) {
    run('python3', [join(HERE, 'compare.py'), needed(folder), '--seconds', String(seconds), '--only', only, '--by', by]);
  },
  async keep({ folder }) {
    const { keep } = await import('./keep.mjs');
    keep(needed(folder));
  },
  async generate({ folder, seed, count, seconds }) {
    const { generated } = await import('./generate.mjs');
    const { solved } = await import('./solve.mjs');
    made(needed(folder));
    for (const track of ['CCP', 'ICP']) {
      const instance = generated({ seed, count, track });
      const [file, answer] = [join(folder, `${instance.name}.instance.json`), join(folder, `${instance.name}.json`)];
      writeFileSync(file, JSON.stringify(instance));
      writeFileSync(answer, JSON.stringify((await solved(instance, { seconds }, seed)).plan));
      console.log(instance.name);
      run('python3', [join(HERE, 'check.py'), file, answer]);
    }
  },
  async freeze() {
    const { freeze } = await import('./freeze.mjs');
    await freeze();
  },
  async site({ folder }) {
    const { site } = await import('./site.mjs');
    await site(folder ?? join(ROOT, 'target', 'benchmark-site'));
  },
};

const OPTIONS = ['only', 'by', 'track', 'seconds', 'seed', 'count', 'prove'];

main(async () => {
  const { values, positionals } = options();
  const [name, folder, another] = positionals;
  const command = Object.hasOwn(COMMANDS, name ?? '') ? COMMANDS[name] : undefined;
  if (command === undefined) throw new Stop(`Which command? npm run benchmark -- ${Object.keys(COMMANDS).join('|')}`);
  if (another !== undefined) throw new Stop(`One folder at a time: ${another} is too many.`);
  await command({
    ...{ folder: folder && resolve(folder), only: values.only ?? '', by: values.by ?? '', track: values.track },
    ...{ seconds: positive('seconds', values.seconds, 10), seed: whole('seed', values.seed, 1), count: whole('count', values.count, 50), prove: positive('prove', values.prove) },
  });
});

function options() {
  try {
    return parseArgs({ allowPositionals: true, options: Object.fromEntries(OPTIONS.map((name) => [name, { type: 'string' }])) });
  } catch (error) {
    throw new Stop(`${error.message.split(/[.\n]/)[0]}. The options are --${OPTIONS.join(', --')}.`);
  }
}

function needed(folder) {
  if (folder === undefined) throw new Stop('Which folder? Name it after the command.');
  return folder;
}

function positive(name, text, otherwise) {
  if (text === undefined) return otherwise;
  const value = Number(text);
  if (!(value > 0 && Number.isFinite(value))) throw new Stop(`--${name} needs a number above 0, not ${text}.`);
  return value;
}

function whole(name, text, otherwise) {
  const value = positive(name, text, otherwise);
  if (!Number.isSafeInteger(value)) throw new Stop(`--${name} needs a whole number, not ${text}.`);
  return value;
}
