/** Warnings and errors about drawings and plans on standard error: one line for each code, also with `--quiet`. */

import type { Finding, Loaded } from '../protocol.js';
import { plural } from '../words.js';
import { nameOf } from './io.js';
import { complain } from './safe-text.js';

/** A drawing as it is named on the command line, because those of several folders may have one name. */
export const asGiven = (file: string) => (file === '-' ? nameOf(file) : file);

/** Whether a person should look at it. */
export const isNotable = ({ severity }: Finding) => severity !== 'info';

/** The findings of a drawing that are printed even where a report counts all: they decide on what is cut. */
export const decides = (f: Finding) => f.code === 'layer-unknown' || f.code === 'sheet-outline' || (f.code === 'lettering' && isNotable(f));

/** The findings of a drawing that a command counts or prints after planning. What the options are doubtful about is none of the drawing's. */
export const ofDrawing = ({ findings }: Pick<Loaded, 'findings'>) => findings.filter((f) => isNotable(f) && f.code !== 'layer-unknown');

/** Prints the warnings and errors among findings: of several with one code the first, with their number. */
export function warn(file: string, findings: readonly Finding[]): void {
  const notable = findings.filter(isNotable);
  for (const code of new Set(notable.map((f) => f.code))) {
    const group = notable.filter((f) => f.code === code);
    const first = group[0]!;
    const kind = group.some(({ severity }) => severity === 'error') ? 'error' : 'warning';
    complain(`${asGiven(file)}: ${group.length === 1 ? '' : `${plural(group.length, kind)} ${code}, for example: `}${first.message}${placeOf(first)}`);
  }
  // Beyond some number the core only counts the findings of a code.
  if (notable.length > 0) for (const { message } of findings.filter(({ code }) => code === 'more')) complain(`${asGiven(file)}: ${message}`);
}

/** Where a finding is, in brackets. */
export function placeOf({ layer, handle, at }: Finding): string {
  const place = [
    layer === null ? '' : `layer ${layer}`,
    handle === null ? '' : `handle ${handle}`,
    at === null ? '' : `at ${at[0].toFixed(2)}, ${at[1].toFixed(2)}`,
  ].filter((s) => s !== '');
  return place.length > 0 ? ` (${place.join(', ')})` : '';
}
