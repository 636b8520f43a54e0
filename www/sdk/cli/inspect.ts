/** `kerfway inspect`: what a drawing holds, in words or as JSON. */

import { basename } from 'node:path';
import { createPlanner } from '../node.js';
import type { Finding, Loaded } from '../protocol.js';
import { loadOptions, READING, text, words } from './arguments.js';
import { bytesOf, put, usable } from './io.js';
import { meters, plural, size } from './words.js';

export async function inspect(args: string[]): Promise<void> {
  const { file, values } = words(args, { ...READING, json: { type: 'string' } });
  const options = loadOptions(values);
  const bytes = await bytesOf(file);
  const planner = await createPlanner();
  try {
    const loaded = await usable(file, planner.load(bytes, basename(file), options));
    const json = text(values, 'json');
    if (json !== undefined) await put(json, `${JSON.stringify(report(loaded))}\n`);
    if (json !== '-') await put('-', told(loaded));
  } finally {
    planner.close();
  }
}

/** Contours without their geometry, and the sums people ask for first. */
function report({ geometry: _, ignored, ...loaded }: Loaded): object {
  const closed = loaded.contours.filter((c) => c.closed).length;
  const totals = {
    closed,
    open: loaded.contours.length - closed,
    ignored: ignored.layers.length,
    cut_length: lengthOf(loaded, 'cut'),
    mark_length: lengthOf(loaded, 'mark'),
  };
  return { schema: 'kerfway.inspect/1', totals, ...loaded };
}

function lengthOf({ contours }: Pick<Loaded, 'contours'>, operation: string): number {
  return contours.filter((c) => c.operation === operation).reduce((sum, c) => sum + c.length, 0);
}

function told(loaded: Loaded): string {
  const { units, contours, parts, layers, entities, findings } = loaded;
  const open = contours.filter((c) => !c.closed).length;
  const marks = lengthOf(loaded, 'mark');
  const lines = [
    `${loaded.name}${loaded.version === null ? '' : `, ${loaded.version}`}, ${size(loaded.bounds)}`,
    `Units      ${units.unit} (${units.source}): ${units.reason}`,
    `Contours   ${contours.length}: ${contours.length - open} closed, ${open} open`,
    `Parts      ${parts.length}`,
    `Length     ${meters(lengthOf(loaded, 'cut'))} to cut${marks > 0 ? `, ${meters(marks)} to mark` : ''}`,
    `Entities   ${entities.map((e) => `${e.count} ${e.kind}${e.supported ? '' : ' (not cut)'}`).join(', ') || 'none'}`,
    'Layers',
    ...layers.map((l) => `  ${l.name}: ${l.operation}, ${plural(l.contours, 'contour')}${suggested(l.suggestion)}`),
    findings.length === 0 ? 'Findings   none' : 'Findings',
    ...findings.map(finding),
  ];
  return `${lines.join('\n')}\n`;
}

function suggested(operation: string | null): string {
  return operation === null ? '' : `; by its name rather ${operation}`;
}

function finding({ severity, code, message, layer, handle, at, count }: Finding): string {
  const place = [
    layer === null ? '' : `layer ${layer}`,
    handle === null ? '' : `handle ${handle}`,
    at === null ? '' : `at ${at[0].toFixed(2)}, ${at[1].toFixed(2)}`,
  ].filter((s) => s !== '');
  const times = count > 1 ? ` [${count}]` : '';
  return `  ${severity} ${code}${times}: ${message}${place.length > 0 ? ` (${place.join(', ')})` : ''}`;
}
