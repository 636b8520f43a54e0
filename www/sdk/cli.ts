#!/usr/bin/env node
/** The command line. `cli/commands.ts` lists its commands and options. `EXIT` in `cli/io.ts` lists the exit codes. */

import { COMMANDS, commandsInWords, type Command } from './cli/commands.js';
import { manual, overview, version } from './cli/help.js';
import { EXIT, failureDocument, print, readerLeft, Unusable, WrongUse } from './cli/io.js';
import { complain } from './cli/safe-text.js';
import { isKerfwayError, KerfwayError } from './errors.js';

/** Loads what runs a command: it needs little of what the others do, and help needs nothing of it. */
const RUNS: Record<string, () => Promise<(words: string[]) => Promise<void>>> = {
  plan: async () => (await import('./cli/plan.js')).plan,
  inspect: async () => (await import('./cli/inspect.js')).inspect,
  quote: async () => (await import('./cli/quote.js')).quote,
  check: async () => (await import('./cli/check.js')).check,
  calibrate: async () => (await import('./cli/calibrate.js')).calibrate,
  serve: async () => (await import('./cli/serve.js')).serve,
  work: async () => (await import('./cli/serve.js')).work,
  methods: async () => (await import('./cli/methods.js')).methods,
  solve: async () => (await import('./cli/solve.js')).solve,
  verify: async () => (await import('./cli/verify.js')).verify,
  completion: async () => (await import('./cli/completion.js')).completion,
};

async function main([command, ...rest]: string[]): Promise<void> {
  if (command === undefined) throw new WrongUse(`Name a command: kerfway ${commandsInWords()}.`);
  if (command === '--help' || command === '-h' || command === 'help') {
    const [about] = atMost(rest, 1);
    await print(about === undefined ? overview() : manual(about, known(about)));
  } else if (command === '--version' || command === '-v') {
    atMost(rest, 0);
    await print(`${await version()}\n`);
  } else {
    const about = known(command);
    // What follows -- are names of files.
    const options = rest.slice(0, rest.includes('--') ? rest.indexOf('--') : undefined);
    if (options.includes('--help') || options.includes('-h')) await print(manual(command, about));
    else await (await RUNS[command]?.())?.(rest);
  }
}

/** The words, of which there are no more than `most`. */
function atMost(words: string[], most: number): string[] {
  if (words.length > most) throw new WrongUse(`${words[most]} is one too many.`);
  return words;
}

function known(name: string): Command {
  const command = Object.hasOwn(COMMANDS, name) ? COMMANDS[name] : undefined;
  if (command === undefined) throw new WrongUse(`There is no command ${name}: there are ${commandsInWords().replace(' or ', ' and ')}.`);
  return command;
}

// Errors other than EPIPE are reported by the call that writes.
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code === 'EPIPE') readerLeft();
});

// When the reader of messages and of the log has gone, nobody can be told. The work goes on, and a service keeps answering.
process.stderr.on('error', () => {});

try {
  await main(process.argv.slice(2));
} catch (thrown) {
  // What is no fault of the input, such as a file of the package that is missing, has a sentence, too.
  const error = isKerfwayError(thrown) ? new Unusable(thrown.message, thrown.toJSON()) : thrown;
  if (!(error instanceof WrongUse) && !(error instanceof Unusable)) throw error;
  complain(error.message);
  const [command = '', ...words] = process.argv.slice(2);
  // A program that reads JSON gets the reason as JSON, too.
  if (words.some((word, k) => word === '--json=-' || (word === '--json' && words[k + 1] === '-'))) {
    const report = error instanceof Unusable ? error.report : new KerfwayError('wrong-usage', error.message).toJSON();
    if (report !== null) await print(failureDocument(null, report)).catch(() => {});
  }
  if (error instanceof WrongUse) process.stderr.write(Object.hasOwn(COMMANDS, command) ? `Run kerfway help ${command} for its options.\n` : 'Run kerfway help for the commands.\n');
  process.exitCode = error instanceof Unusable ? error.exit : EXIT.wrongUse;
}
