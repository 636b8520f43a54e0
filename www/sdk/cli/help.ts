/** The help texts: an overview of the commands, and a manual page for each. */

import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { loadedFile } from '../wasm-file.js';
import { COMMANDS, type Command } from './commands.js';
import type { Options } from './option-groups.js';

const WIDTH = 100;
const EXIT = 'Exit code: 0 done, 1 the input is unusable, 2 wrong usage, 3 an output cannot be written, 4 some of several files failed, 5 all of several failed.';

/** `kerfway --help`. */
export function overview(): string {
  const rows = Object.entries(COMMANDS).map(([name, { words, about }]) => [`kerfway ${name}${words && ` ${words}`}`, about] as const);
  const [example] = (COMMANDS['plan'] as Command).examples;
  return [
    'Kerfway plans the path of a laser cutter.\n',
    ...inColumns(rows, ''),
    `\nkerfway help COMMAND shows its options, with examples. The most common use:\n\n  ${example?.[0]}\n`,
    `${EXIT}\n`,
  ].join('\n');
}

/** `kerfway help COMMAND`. */
export function manual(name: string, { about, words, text, options, examples }: Command): string {
  const sections = Object.entries(options).map(([title, of]) => [`${title}:`, ...inColumns(optionRows(of), '  '), ''].join('\n'));
  return [
    `kerfway ${name}: ${about}\n`,
    `Usage: kerfway ${name}${words && ` ${words}`}${sections.length > 0 ? ' [options]' : ''}\n`,
    `${wrapped(text, WIDTH).join('\n')}\n`,
    ...sections,
    'Examples:',
    ...examples.flatMap(([line, what]) => [`  # ${what}`, `  ${line}`]),
    `\n${EXIT}\n`,
  ].join('\n');
}

function optionRows(options: Options): (readonly [string, string])[] {
  return Object.entries(options).map(([name, { value, about, repeat, choices }]) => {
    const more = [Array.isArray(choices) ? `one of ${choices.join(', ')}` : '', repeat ? 'may be repeated' : ''].filter(Boolean);
    return [`--${name}${value === undefined ? '' : ` ${value}`}`, [about, ...more].join('; ')] as const;
  });
}

function inColumns(rows: (readonly [string, string])[], indent: string): string[] {
  const left = Math.max(...rows.map(([name]) => name.length)) + 2;
  return rows.flatMap(([name, about]) =>
    wrapped(about, WIDTH - left - indent.length).map((line, k) => `${indent}${(k === 0 ? name : '').padEnd(left)}${line}`),
  );
}

function wrapped(text: string, width: number): string[] {
  const lines = [''];
  for (const word of text.split(' ')) {
    const last = lines.at(-1) ?? '';
    if (last !== '' && last.length + 1 + word.length > width) lines.push(word);
    else lines[lines.length - 1] = last === '' ? word : `${last} ${word}`;
  }
  return lines;
}

/** The version of this package. */
export async function packageVersion(): Promise<string> {
  const file = await readFile(new URL('../../../package.json', import.meta.url), 'utf8');
  return (JSON.parse(file) as { version: string }).version;
}

/** The version of this package, and the hashes of the wasm files that plan: the same hashes make the same plans. */
export async function version(): Promise<string> {
  const hashes = ['kerfway', 'kerfway_research'].map(async (name) => {
    const wasm = await loadedFile(name, () => readFile(new URL(`../pkg/${name}_bg.wasm`, import.meta.url)));
    return `${name}_bg.wasm sha256 ${createHash('sha256').update(wasm).digest('hex')}`;
  });
  return [await packageVersion(), ...(await Promise.all(hashes))].join('\n');
}
