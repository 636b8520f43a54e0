/** What is given twice on the command line, where only the last one would count and nobody would hear of the other. */

import { WrongUse } from './io.js';

/** Refuses an output that is named twice. Of other options the last one counts, so that a script can add to the options it is given. */
export function namedOnce(tokens: readonly { kind: string; name?: string; value?: unknown }[], outputs: ReadonlySet<string>): void {
  const given = new Map<string, unknown>();
  for (const { kind, name, value } of tokens) {
    if (kind !== 'option' || name === undefined || !outputs.has(name)) continue;
    if (given.has(name) && given.get(name) !== value) throw new WrongUse(`--${name} ${String(given.get(name))} and --${name} ${String(value)}: give one of them.`);
    given.set(name, value);
  }
}

/** Refuses two different choices for the same layer, group, contour or parameter, whose name is found in a choice by `nameOf`. */
export function chosenOnce(option: string, choices: readonly string[], nameOf: (choice: string) => string): void {
  const given = new Map<string, string>();
  for (const choice of choices) {
    const name = nameOf(choice);
    const before = given.get(name);
    if (before !== undefined && before !== choice) throw new WrongUse(`--${option} ${before} and --${option} ${choice}: write all that is chosen for ${name} in one of them.`);
    given.set(name, choice);
  }
}
