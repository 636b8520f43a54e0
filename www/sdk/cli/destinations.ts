/**
 * Where outputs go: one drawing has one file for each output; several drawings need a folder, or write lines of JSON to
 * standard output. An output must not be a file that is read, or the file of another output; this is checked before planning.
 */

import { accessSync, constants, mkdirSync } from 'node:fs';
import { basename, dirname, extname, join, resolve, sep } from 'node:path';
import { text, type Words } from './arguments.js';
import { checkWritable, writeAll } from './atomic.js';
import { goesOnWithoutReader, Unwritable, WrongUse } from './io.js';
import { identityOf, identityOfInput, lookAt, STANDARD_INPUT, STANDARD_OUTPUT } from './target.js';

/** A requested output. */
export interface Output<Kind extends string = string> {
  kind: Kind;
  out: string;
}

/** The data of an output. */
export interface Written {
  output: Output;
  data: string | Uint8Array;
}

/** The outputs of these kinds that the arguments request. */
export function outputsOf<Kind extends string>({ values }: Words, kinds: readonly Kind[]): Output<Kind>[] {
  return kinds.flatMap((kind) => {
    const out = text(values, kind);
    return out === undefined ? [] : [{ kind, out }];
  });
}

const ENDINGS: Record<string, string> = { gcode: '.nc', json: '.json', svg: '.svg', dxf: '.dxf', png: '.png', lbrn2: '.lbrn2', rd: '.rd', remainder: '.remainder.dxf', report: '.html', certificate: '.certificate.json' };

export class Destinations {
  private begun = false;

  /** `inputs`: files that are read in addition to the drawings. */
  constructor(
    private readonly outputs: readonly Output[],
    private readonly inputs: readonly string[] = [],
  ) {
    const [first, second] = outputs.filter((o) => o.out === STANDARD_OUTPUT);
    if (first !== undefined && second !== undefined) {
      throw new WrongUse(`--${first.kind} and --${second.kind} cannot both go to standard output.`);
    }
    if (outputs.some((o) => o.out !== STANDARD_OUTPUT)) goesOnWithoutReader();
  }

  /** Whether standard output has data for a program. Text for people then goes to standard error. */
  get piped(): boolean {
    return this.outputs.some((o) => o.out === STANDARD_OUTPUT);
  }

  /** Checks that the outputs of all these drawings can be written, before any is planned. */
  begin(files: readonly string[]): void {
    if (files.length > 1) {
      for (const { kind, out } of this.outputs) {
        if (out === STANDARD_OUTPUT && kind !== 'json') throw new WrongUse(`--${kind} - is for one drawing, and there are ${files.length}: name a folder, ending in /.`);
        if (out !== STANDARD_OUTPUT && !isFolder(out)) throw new WrongUse(`--${kind} ${out} is one file, and there are ${files.length} drawings: name a folder, ending in /.`);
      }
    }
    this.refuseClashes(files);
    // Once: while files are watched, a folder may go and come back.
    if (this.begun) return;
    this.begun = true;
    const named = this.outputs.filter(({ out }) => out !== STANDARD_OUTPUT);
    const missing = named.map(({ out }) => out).filter((out) => lookAt(out) === null && isFolder(out));
    missing.forEach(refuseNoFolder);
    const toMake = missing.map((out) => resolve(out));
    const [first, second] = files;
    for (const place of first === undefined ? [] : named.map((output) => placeOf(output, first))) {
      const folder = dirname(resolve(place));
      // Of several drawings, one whose own files are protected does not keep the others from theirs.
      if (!toMake.some((made) => made === folder || made.startsWith(`${folder}${sep}`))) checkWritable(place, second !== undefined);
    }
  }

  /** Writes all outputs of a drawing, or none of them. */
  async write(file: string, written: readonly Written[]): Promise<void> {
    // Links may have changed during planning.
    this.refuseClashes([file]);
    for (const { output: { out } } of written) if (out !== STANDARD_OUTPUT && isFolder(out)) makeFolder(out);
    await writeAll(written.map(({ output, data }) => ({ out: placeOf(output, file), data })));
  }

  /** Output files that exist from an earlier plan of this drawing. */
  existing(file: string): string[] {
    const places = this.outputs.filter(({ out }) => out !== STANDARD_OUTPUT).map((output) => placeOf(output, file));
    return places.filter((place) => lookAt(place)?.isFile() === true);
  }

  private refuseClashes(files: readonly string[]): void {
    const taken = new Map<string | null, string>();
    for (const input of [...files, ...this.inputs]) taken.set(identityOfInput(input), `${input}, which is read`);
    // The JSON of all drawings goes to the same standard output.
    const standard = this.outputs.find(({ out }) => out === STANDARD_OUTPUT);
    const places = this.outputs.filter((output) => output !== standard).flatMap((output) => files.map((file) => ({ output, file })));
    for (const { output, file } of standard === undefined ? places : [{ output: standard, file: '' }, ...places]) {
      const place = placeOf(output, file);
      const identity = identityOf(place);
      const other = identity === null ? undefined : taken.get(identity);
      const whose = files.length > 1 && output !== standard ? ` for ${file}` : '';
      if (other !== undefined) throw new WrongUse(`--${output.kind} ${place}${whose} is the same file as ${other}. Name another file or folder.`);
      taken.set(identity, `--${output.kind} ${place}${whose}`);
    }
  }
}

/** The file that an output of a drawing goes to. */
function placeOf({ kind, out }: Output, file: string): string {
  return out !== STANDARD_OUTPUT && isFolder(out) ? join(out, (file === STANDARD_INPUT ? 'standard-input' : basename(file, extname(file))) + (ENDINGS[kind] ?? '')) : out;
}

function makeFolder(folder: string): void {
  try {
    mkdirSync(folder, { recursive: true });
  } catch {
    throw noFolder(folder);
  }
}

const noFolder = (folder: string) => new Unwritable(`${folder} cannot be made: the system does not allow this folder. Name another folder.`);

/** Refuses a folder that is not there and cannot be made. */
function refuseNoFolder(folder: string): void {
  let above = resolve(folder);
  while (lookAt(above) === null && above !== dirname(above)) above = dirname(above);
  try {
    accessSync(`${above}${sep}.`, constants.W_OK);
  } catch {
    throw noFolder(folder);
  }
}

function isFolder(out: string): boolean {
  return /[/\\]$/.test(out) || lookAt(out)?.isDirectory() === true;
}
