/** `kerfway methods`: what there is to plan with. */

import { createPlanner } from '../node.js';
import { WrongUse } from './io.js';

export async function methods(args: string[]): Promise<void> {
  if (args.length > 0) throw new WrongUse(`methods takes no more words, not ${args[0]}.`);
  const planner = await createPlanner();
  planner.close();
  const width = Math.max(...planner.methods.map((m) => m.name.length));
  for (const { name, title, about, source } of planner.methods) {
    const cited = source === null ? '' : ` ${source}`;
    process.stdout.write(`${name.padEnd(width)}  ${title}. ${about}${cited}\n`);
  }
}
