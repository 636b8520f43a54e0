/** What the command line says about itself. */

import { readFile } from 'node:fs/promises';

export const HELP = `Kerfway plans the path of a laser cutter.

kerfway plan FILE.dxf [options]      plan the path and write it
kerfway inspect FILE.dxf [options]   tell what the drawing holds, without planning
kerfway quote FILE.dxf [options]     plan, and tell what a shop asks before it names a price
kerfway methods                      list the methods of planning
kerfway solve FILE [options]         solve a benchmark instance: .tsp, .gtsp or .pcglns

Outputs of plan; - is standard output:
  --gcode OUT          G-code for the machine
  --json OUT           the plan (kerfway.plan/1)
  --svg OUT            picture with order and direction
  --dxf OUT            contours in cutting order
  --png OUT            picture as pixels

How to plan, for plan and quote:
  --machine NAME|FILE  a preset's name, or a machine profile as JSON
  --method NAME        see kerfway methods
  --set NAME=VALUE     a parameter of a method from a paper; may be repeated
  --seconds S          how long to search (default 10)
  --moves N            how many moves to search: the same result everywhere
  --workers N          searches side by side that share the best path (default 1)
  --seed N             decides every random choice
  --no-return          stay where the last cut ends

How to read, for plan, quote and inspect:
  --units UNIT         mm, in, cm, m, ... when the file says nothing or lies
  --layer NAME=cut|mark|ignore   what to do with a layer; may be repeated
  --order-by-layer     layer after layer, in the order of --layer
  --part-by-part       a part wholly, with all in its holes, before the next
  --first ID, --last ID          a contour before or after all others; may be repeated

Of quote:
  --material NAME      for people
  --thickness MM       of the sheet
  --density G          g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19
  --json OUT           the report (kerfway.quote/1)

Of inspect:
  --json OUT           the whole report

Of solve, besides --seconds, --moves and --seed:
  --json OUT           length, tour, seconds, moves, lower_bound

Exit code: 0 done, 1 the input is unusable, 2 wrong usage.
`;

/** Version of this package. */
export async function version(): Promise<string> {
  const file = await readFile(new URL('../../../package.json', import.meta.url), 'utf8');
  return (JSON.parse(file) as { version: string }).version;
}
