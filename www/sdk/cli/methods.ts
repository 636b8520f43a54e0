/** `kerfway methods`: lists the planning methods. */

import { createPlanner } from '../node.js';
import { print, WrongUse } from './io.js';

export async function methods(args: string[]): Promise<void> {
  if (args.length > 0) throw new WrongUse(`methods takes no arguments, not ${args[0]}.`);
  const planner = await createPlanner();
  const papers = await planner.paperMethods();
  planner.close();
  const all = [...planner.methods, ...papers];
  const width = Math.max(...all.map((m) => m.name.length));
  const lines: string[] = [];
  for (const { name, title, about, source } of all) {
    const cited = source === null ? '' : ` ${source}`;
    lines.push(`${name.padEnd(width)}  ${title}. ${about}${cited}`);
  }
  lines.push('', 'Parameters of the methods from papers, for --set:');
  for (const { name, parameters } of papers) {
    const given = Object.entries(parameters).map(([key, value]) => `${key}=${String(value)}`);
    if (given.length > 0) lines.push(`${name.padEnd(width)}  ${given.join(' ')}`);
  }
  lines.push('', 'Presets (--set preset=NAME), with the parameters that they change:');
  for (const { name, presets } of papers) {
    for (const [preset, changed] of Object.entries(presets)) {
      const given = Object.entries(changed).map(([key, value]) => `${key}=${String(value)}`);
      if (given.length > 0) lines.push(`${name.padEnd(width)}  ${preset}: ${given.join(' ')}`);
    }
  }
  await print(lines.join('\n'));
}
