#!/usr/bin/env node
/** The command line: `kerfway plan`, `inspect`, `quote`, `solve` and `methods`. Exit 0 done, 1 unusable input, 2 wrong usage. */

import { HELP, version } from './cli/help.js';
import { inspect } from './cli/inspect.js';
import { Unusable, WrongUse } from './cli/io.js';
import { methods } from './cli/methods.js';
import { plan } from './cli/plan.js';
import { quote } from './cli/quote.js';
import { solve } from './cli/solve.js';

const COMMANDS = new Map(Object.entries({ plan, inspect, quote, methods, solve }));

async function main([command, ...rest]: string[]): Promise<void> {
  if (command === undefined) throw new WrongUse('Say what to do: kerfway plan, inspect, quote, solve or methods.');
  if (command === '--help' || command === '-h' || command === 'help') {
    process.stdout.write(HELP);
  } else if (command === '--version' || command === '-v') {
    process.stdout.write(`${await version()}\n`);
  } else {
    const run = COMMANDS.get(command);
    if (run === undefined) throw new WrongUse(`There is no command ${command}: there are plan, inspect, quote, solve and methods.`);
    if (rest.includes('--help') || rest.includes('-h')) process.stdout.write(HELP);
    else await run(rest);
  }
}

// Whoever reads our output may stop reading (`| head`): that is no failure.
process.stdout.on('error', (error: NodeJS.ErrnoException) => {
  if (error.code !== 'EPIPE') throw error;
  process.exit(0);
});

try {
  await main(process.argv.slice(2));
} catch (error) {
  const message = error instanceof Error ? error.message : String(error);
  if (error instanceof WrongUse) {
    process.stderr.write(`kerfway: ${message}\nRun kerfway --help for the options.\n`);
    process.exitCode = 2;
  } else if (error instanceof Unusable) {
    process.stderr.write(`kerfway: ${message}\n`);
    process.exitCode = 1;
  } else {
    throw error;
  }
}
