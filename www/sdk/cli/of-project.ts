/** What of a project counts beside the options of a command, which overrule it. A drawing is a project in which nothing is decided. */

import { KerfwayError } from '../errors.js';
import type { Planner } from '../node.js';
import { given } from '../options.js';
import type { Project, SavedPlan } from '../project.js';
import type { LoadOptions, MachineProfile, PlanOptions } from '../protocol.js';
import type { Words } from './arguments.js';
import type { Place } from './batch.js';
import { Unusable, WrongUse } from './io.js';
import { machineOf } from './machine.js';
import { complain } from './safe-text.js';
import { STANDARD_INPUT } from './target.js';
import { asGiven } from './warnings.js';

type Values = Words['values'];

/** What was decided for the plan, with the machine as a profile. */
export type Decided = PlanOptions & { machine?: MachineProfile };

/** Of two of these only one can be chosen. */
const CONTRARY = [['units', 'dpi'], ['keepBorder', 'ignoreOutline']] as const;
/** A contour can be in one of two of these. */
const LISTS = [['first', 'last'], ['exclude', 'mark']] as const;

/** How the drawing of a project is read: as the project says, and as the options say, which overrule it. */
export function readingWith({ reading }: Project, load: LoadOptions): LoadOptions {
  const own = { ...reading };
  for (const [one, other] of CONTRARY.flatMap(both)) if (load[one] !== undefined) delete own[other];
  for (const [one, other] of LISTS.flatMap(both)) {
    const left = own[other]?.filter((contour) => load[one]?.includes(contour) !== true);
    if (left !== undefined) own[other] = left;
  }
  return { ...own, ...load };
}

const both = <T>([one, other]: readonly [T, T]): (readonly [T, T])[] => [[one, other], [other, one]];

/** What the options leave of a project: what was decided about planning, and its plan, if that is still one of the same job. */
export async function ofProject(file: string, project: Project, values: Values, load: LoadOptions, planner: Planner): Promise<{ decided: Decided; plan: SavedPlan | null }> {
  const { seconds: _, moves: __, ...planning } = project.planning;
  const machine = machineOfProject(file, planning.machine, planner);
  const decided: Decided = given({ ...planning, machine }) as Decided;
  // Parameters are those of one method, and a material is one of a machine's library.
  if (values['method'] !== undefined) delete decided.parameters;
  if (decided.material !== undefined && values['machine'] !== undefined && values['material'] === undefined) {
    const { name, materials } = await machineOf({ words: [], values }, planner);
    if (materials?.some((m) => m.name === decided.material) !== true) {
      complain(`${asGiven(file)}: the machine ${name} has no setting for the project's material ${decided.material}. Its own speed and power are used.`);
      delete decided.material;
    }
  }
  if (project.plan === null) return { decided, plan: null };
  const isOther = Object.keys(load).length > 0 || ['material', 'method', 'set'].some((option) => values[option] !== undefined);
  const isOfSameJob = !isOther && (await keepsMachine(values, planner, machine));
  return { decided, plan: isOfSameJob ? project.plan : null };
}

/** The machine of a project. The page saves a whole profile; others may name a preset. */
function machineOfProject(file: string, machine: PlanOptions['machine'], { machines }: Planner): MachineProfile | undefined {
  if (typeof machine !== 'string') return machine;
  const preset = machines.find((m) => m.name === machine);
  if (preset === undefined) throw new Unusable(`${asGiven(file)}: its machine ${machine} is none of the presets, which are ${machines.map((m) => m.name).join(', ')}.`);
  return preset;
}

/** Whether the options leave the machine as it is, but for its dialect, which changes no path. A machine that no option changes is handed on as it is. */
async function keepsMachine({ dialect: _, ...values }: Values, planner: Planner, own: MachineProfile | undefined): Promise<boolean> {
  if (values['machine'] !== undefined || values['no-return'] === true) return false;
  const [changed, same] = await Promise.all([values, {}].map((of) => machineOf({ words: [], values: of }, planner, own)));
  return changed === same;
}

/** Whether a file may be a project, by its name. */
export const mayBeProject = (file: string) => file === STANDARD_INPUT || file.endsWith('.kerfway');

/** Work for one of some files. What is wrong usage for the machine of one is a fault of that one, and the others go on. */
export async function forProject<T>(file: string, { of }: Place, work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (error) {
    if (of === 1 || !(error instanceof WrongUse)) throw error;
    throw new Unusable(`${asGiven(file)}: ${error.message}`, new KerfwayError('wrong-usage', error.message).toJSON());
  }
}
