/** `kerfway inspect`: describes drawings, as text or as JSON. */

import { createPlanner } from '../node.js';
import type { Finding, Loaded } from '../protocol.js';
import { activeContours } from '../contours.js';
import { inspectReport, lengthOf } from '../inspect-report.js';
import { loadOptions, parsed } from './arguments.js';
import { eachFile } from './batch.js';
import { outputsOf } from './destinations.js';
import { usable } from './io.js';
import { readingWith } from './of-project.js';
import { opened } from './opened.js';
import type { Column } from './report.js';
import { placeOf, warn } from './warnings.js';
import { meters, plural, size, unitOf } from '../words.js';

export async function inspect(args: string[]): Promise<void> {
  const given = parsed('inspect', args);
  const options = loadOptions(given.values);
  const outputs = outputsOf(given, ['json']);
  const piped = outputs.some((output) => output.out === '-');
  const planner = await createPlanner();
  try {
    await eachFile(given, { outputs, columns: COLUMNS }, async (file, place, to) => {
      const project = await opened(file);
      const loaded = await usable(file, planner.load(project.drawing, project.name, readingWith(project, options)));
      // The report lists them.
      if (given.values['quiet'] === true) warn(file, loaded.findings);
      const data = `${JSON.stringify(inspectReport(loaded))}\n`;
      await to.write(file, outputs.map((output) => ({ output, data })));
      // When a program reads the report of a single drawing, no second report is needed.
      if (!piped || place.of > 1) await to.report(place, () => lines(loaded), () => row(file, loaded));
    });
  } finally {
    planner.close();
  }
}

const COLUMNS: readonly Column[] = [
  { title: 'Contours', width: 8, right: true },
  { title: 'Open', width: 5, right: true },
  { title: 'Parts', width: 5, right: true },
  { title: 'To cut', width: 10, right: true },
  { title: 'Size', width: 20, right: true },
  { title: 'Units', width: 12 },
  { title: 'Findings', width: 8, right: true },
];

function row(file: string, loaded: Loaded): string[] {
  const contours = activeContours(loaded);
  const open = contours.filter((c) => !c.closed).length;
  return [
    ...[file, String(contours.length), String(open), String(loaded.parts.length), meters(lengthOf(loaded, 'cut'))],
    ...[size(loaded.bounds), `${unitOf(loaded.units)}, ${loaded.units.source}`, String(loaded.findings.length)],
  ];
}

function lines(loaded: Loaded): string[] {
  const { units, parts, layers, entities, findings } = loaded;
  const contours = activeContours(loaded);
  const open = contours.filter((c) => !c.closed).length;
  const marks = lengthOf(loaded, 'mark');
  return [
    `${loaded.name}${loaded.version === null ? '' : `, ${loaded.version}`}, ${size(loaded.bounds)}`,
    `Units      ${unitOf(units)} (${units.source === 'given' ? 'chosen by you' : units.source}): ${units.reason}`,
    `Contours   ${contours.length}: ${contours.length - open} closed, ${open} open`,
    `Parts      ${parts.length}`,
    `Length     ${meters(lengthOf(loaded, 'cut'))} to cut${marks > 0 ? `, ${meters(marks)} to mark` : ''}`,
    `Entities   ${entities.map((e) => `${e.count} ${e.kind}${e.supported ? '' : ' (not cut)'}`).join(', ') || 'none'}`,
    'Layers',
    ...layers.map((l) => `  ${l.name}: ${l.operation}, ${plural(l.contours, 'contour')}${suggested(l.suggestion)}`),
    findings.length === 0 ? 'Findings   none' : 'Findings',
    ...findings.map(finding),
  ];
}

function suggested(operation: string | null): string {
  return operation === null ? '' : `; its name suggests ${operation}`;
}

function finding(f: Finding): string {
  const times = f.count > 1 ? ` [${f.count}]` : '';
  return `  ${f.severity} ${f.code}${times}: ${f.message}${placeOf(f)}`;
}
