/**
 * Where outputs go: one file for one drawing; a folder, or lines of JSON on standard output, for several. Nothing is written
 * over a drawing that was named, nor over what another one just wrote.
 */

import { mkdirSync, statSync } from 'node:fs';
import { basename, extname, join, resolve } from 'node:path';
import { text, type Words } from './arguments.js';
import { put, Unusable, WrongUse } from './io.js';

/** An output that is asked for. */
export interface Output<Kind extends string = string> {
  kind: Kind;
  out: string;
}

/** Those of these kinds that the words ask for. */
export function outputsOf<Kind extends string>({ values }: Words, kinds: readonly Kind[]): Output<Kind>[] {
  return kinds.flatMap((kind) => {
    const out = text(values, kind);
    return out === undefined ? [] : [{ kind, out }];
  });
}

const ENDINGS: Record<string, string> = { gcode: '.nc', json: '.json', svg: '.svg', dxf: '.dxf', png: '.png' };

export class Destinations {
  /** Which drawing wrote which file. */
  private readonly written = new Map<string, string>();
  private files: readonly string[] = [];

  constructor(private readonly outputs: readonly Output[]) {
    const [first, second] = outputs.filter((o) => o.out === '-');
    if (first !== undefined && second !== undefined) {
      throw new WrongUse(`--${first.kind} and --${second.kind} cannot both go to standard output.`);
    }
  }

  /** True when standard output is for a program: what people read goes to the other one. */
  get piped(): boolean {
    return this.outputs.some((o) => o.out === '-');
  }

  /** Refuses what cannot hold the outputs of all these drawings, before any is planned. */
  begin(files: readonly string[]): void {
    this.files = files.map((file) => resolve(file));
    if (files.length < 2) return;
    for (const { kind, out } of this.outputs) {
      if (out === '-' && kind !== 'json') throw new WrongUse(`--${kind} - is for one drawing, and there are ${files.length}: name a folder, ending in /.`);
      if (out !== '-' && !isFolder(out)) throw new WrongUse(`--${kind} ${out} is one file, and there are ${files.length} drawings: name a folder, ending in /.`);
    }
  }

  async write({ kind, out }: Output, file: string, data: string | Uint8Array): Promise<void> {
    const target = out === '-' ? out : isFolder(out) ? this.within(out, file, ENDINGS[kind] ?? '') : out;
    if (target !== '-') this.claim(target, file);
    await put(target, data);
  }

  private within(folder: string, file: string, ending: string): string {
    try {
      mkdirSync(folder, { recursive: true });
    } catch {
      throw new Unusable(`${folder} cannot be made: there is no place for that folder.`);
    }
    return join(folder, basename(file, extname(file)) + ending);
  }

  private claim(target: string, file: string): void {
    const path = resolve(target);
    if (this.files.includes(path)) throw new Unusable(`${file}: ${target} is a drawing itself and is not written over. Name another folder.`);
    const before = this.written.get(path);
    if (before !== undefined && before !== file) throw new Unusable(`${file}: ${target} was written for ${before} already. Give one of the two another name.`);
    this.written.set(path, file);
  }
}

function isFolder(out: string): boolean {
  return /[/\\]$/.test(out) || statSync(out, { throwIfNoEntry: false })?.isDirectory() === true;
}
