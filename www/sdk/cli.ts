#!/usr/bin/env node
/** The command line. `cli/commands.ts` lists its commands and options. `EXIT` in `cli/io.ts` lists the exit codes. */

import { check } from './cli/check.js';
import { COMMANDS, commandsInWords, type Command } from './cli/commands.js';
import { completion } from './cli/completion.js';
import { manual, overview, version } from './cli/help.js';
import { inspect } from './cli/inspect.js';
import { EXIT, failureDocument, print, readerLeft, Unusable, WrongUse } from './cli/io.js';
import { methods } from './cli/methods.js';
import { plan } from './cli/plan.js';
import { quote } from './cli/quote.js';
import { calibrate } from './cli/calibrate.js';
import { complain } from './cli/safe-text.js';
import { KerfwayError } from './errors.js';
import { serve, work } from './cli/serve.js';
import { solve } from './cli/solve.js';
import { verify } from './cli/verify.js';

const RUNS = new Map(Object.entries({ plan, inspect, quote, check, calibrate, serve, work, methods, solve, verify, completion }));

async function main([command, ...rest]: string[]): Promise<void> {
  if (command === undefined) throw new WrongUse(`Name a command: kerfway ${commandsInWords()}.`);
  if (command === '--help' || command === '-h' || command === 'help') {
    const [about] = rest;
    await print(about === undefined ? overview() : manual(about, known(about)));
  } else if (command === '--version' || command === '-v') {
    await print(`${await version()}\n`);
  } else {
    const about = known(command);
    if (rest.includes('--help') || rest.includes('-h')) await print(manual(command, about));
    else await RUNS.get(command)?.(rest);
  }
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
} catch (error) {
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
