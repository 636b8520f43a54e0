/** `kerfway serve` and `kerfway work`: the HTTP service, and the workers of its queue. */

import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { reportOf } from '../errors.js';
import { keysIn } from '../server/keys.js';
import { jsonLog } from '../server/log.js';
import { poolBackend } from '../server/pool-backend.js';
import { queueBackend, queueWorker } from '../server/queue.js';
import { serve as serving } from '../server/serve.js';
import { DEFAULTS, type ServerSettings } from '../server/settings.js';
import { parsedOptions, positive, text, whole, type Words } from './arguments.js';
import { packageVersion } from './help.js';
import { goesOnWithoutReader, Unusable, WrongUse } from './io.js';

export async function serve(args: string[]): Promise<void> {
  const settings = await settingsOf(parsedOptions('serve', args));
  const backend = settings.queue === null ? poolBackend(settings) : await started(queueBackend(settings.queue, settings, jsonLog));
  const service = await started(serving(settings, backend, await packageVersion(), jsonLog));
  await untilStopped(`Kerfway listens on ${service.url}`, () => service.stop());
}

export async function work(args: string[]): Promise<void> {
  const settings = await settingsOf(parsedOptions('work', args));
  if (settings.queue === null) throw new WrongUse('Say where the queue is: --queue redis://HOST:6379.');
  const worker = await started(queueWorker(settings.queue, settings, jsonLog));
  await untilStopped('Kerfway takes jobs from the queue', () => worker.stop());
  // A connection to a queue that does not answer would keep the process.
  process.exit();
}

/** The signals that stop a service, with the exit code of a second one. */
const ENDS = { SIGINT: 130, SIGTERM: 143 } as const;

/** Prints the sentence that it runs, and waits for the signal to stop. A second one ends the process at once. */
async function untilStopped(sentence: string, stop: () => Promise<void>): Promise<void> {
  goesOnWithoutReader();
  await new Promise<void>((resolve) => {
    let stopping = false;
    for (const signal of ['SIGINT', 'SIGTERM'] as const) {
      process.on(signal, () => {
        if (stopping) process.exit(ENDS[signal]);
        stopping = true;
        resolve();
      });
    }
    // Whoever reads the sentence may send the signal at once.
    process.stdout.write(`${sentence}\n`);
  });
  await stop();
}

async function started<T>(work: Promise<T>): Promise<T> {
  try {
    return await work;
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    if (code === 'EADDRINUSE') throw new Unusable('The port is in use. Choose another with --port.');
    if (code === 'EACCES') throw new Unusable('The system does not allow this port. Choose one above 1023 with --port.');
    if (code === 'EADDRNOTAVAIL' || code === 'ENOTFOUND') throw new Unusable('This computer has no such address. Choose another with --host.');
    throw new Unusable(reportOf(error).message);
  }
}

/** The longest time that a timer can wait, in seconds: 2^31 - 1 milliseconds. */
const LONGEST_TIMER = 2_147_000;
/** The longest time for which results are kept: a year, in seconds. */
const MOST_EXPIRES = 31_536_000;

async function settingsOf({ values }: Words): Promise<ServerSettings> {
  const number = (name: string, fallback: number) => positive(values, name) ?? fallback;
  const seconds = (name: string, fallback: number) => {
    const n = number(name, fallback);
    if (n > LONGEST_TIMER) throw new WrongUse(`--${name} ${n}: give at most ${LONGEST_TIMER} seconds, which are 24 days.`);
    return n;
  };
  const port = whole(values, 'port') ?? DEFAULTS.port;
  if (port > 65_535) throw new WrongUse(`--port ${port}: give a number from 0 to 65535.`);
  const queue = text(values, 'queue') ?? null;
  if (queue !== null && !/^rediss?:\/\/\S+$/.test(queue)) throw new WrongUse(`--queue ${queue}: give an address like redis://localhost:6379.`);
  const keys = text(values, 'keys');
  const waiting = whole(values, 'waiting') ?? DEFAULTS.waiting;
  if (queue !== null && waiting === 0) throw new WrongUse('--waiting 0: in a queue every job waits for a worker at first. Give at least 1.');
  const expires = whole(values, 'expires') ?? DEFAULTS.expires;
  if (expires < 1 || expires > MOST_EXPIRES) throw new WrongUse(`--expires ${expires}: give a whole number of seconds from 1 to ${MOST_EXPIRES}.`);
  const workers = whole(values, 'workers') ?? availableParallelism();
  if (workers < 1 || workers > 256) throw new WrongUse(`--workers ${workers}: give a number from 1 to 256.`);
  return {
    host: text(values, 'host') ?? DEFAULTS.host,
    port,
    workers,
    waiting,
    largest: number('largest', DEFAULTS.largest / 2 ** 20) * 2 ** 20,
    upload: seconds('upload-seconds', DEFAULTS.upload),
    deadline: number('deadline', DEFAULTS.deadline),
    mostSeconds: number('most-seconds', DEFAULTS.mostSeconds),
    mostMoves: whole(values, 'most-moves') ?? DEFAULTS.mostMoves,
    grace: seconds('grace', DEFAULTS.grace),
    cors: ((values['cors'] as string[] | undefined) ?? []).map(origin),
    keys: keys === undefined ? DEFAULTS.keys : await keysOf(keys),
    queue,
    expires,
  };
}

function origin(word: string): string {
  if (word === '*' || (URL.canParse(word) && new URL(word).origin === word)) return word;
  throw new WrongUse(`--cors ${word}: give an origin like https://shop.example, or *.`);
}

async function keysOf(file: string): Promise<ReadonlyMap<string, string>> {
  const content = await readFile(file, 'utf8').catch(() => {
    throw new Unusable(`${file} cannot be read. Give a file with one key per line.`);
  });
  try {
    return keysIn(content);
  } catch (error) {
    throw new Unusable(`${file}: ${(error as Error).message}`);
  }
}
