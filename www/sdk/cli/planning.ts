/** The common part of `plan` and `quote`: plans drawings one after the other with one planner. */

import { doubtAbout, hasProgram, stopIfRefusedOffBed } from '../doubt.js';
import { budgeted, type DefaultBudget } from '../functions.js';
import { checkOptions, DEFAULT_SECONDS, given } from '../options.js';
import { bounded } from '../bound.js';
import type { SavedPlan } from '../project.js';
import { createPlanner, type Planner, type PlanResult } from '../node.js';
import type { FindingCode, Loaded, PlanOptions, Proof, ProofBudget } from '../protocol.js';
import type { ProofHandle } from '../prover.js';
import { loadOptions, number, oneOf, parameters, placingOptions, seconds, text, whole, type Words } from './arguments.js';
import { machineFiles, machineOf } from './machine.js';
import { checkedAsWritten, leversAsWritten } from './as-written.js';
import { eachFile, type Requested, type Outlet, type Place } from './batch.js';
import { untilInterrupted } from './interrupt.js';
import { filesOf } from './glob.js';
import { nameOf, Unusable, usable, WrongUse } from './io.js';
import { type Decided, forProject, mayBeProject, ofProject, readingWith } from './of-project.js';
import { opened } from './opened.js';
import { progressLine } from './progress.js';
import { complain } from './safe-text.js';
import { asGiven, decides, ofDrawing, warn } from './warnings.js';

/** Moves of a search that take about as long as a million numbers of a proof. */
const MOVES_PER_WORK = 10_000;

/** What a doubt about the unit has said already. */
const UNITS: readonly FindingCode[] = ['units-guessed', 'units-doubtful'];

/** A planned drawing. */
export interface PlannedFile {
  file: string;
  place: Place;
  planner: Planner;
  loaded: Loaded;
  result: PlanResult;
  /** What was proven of the lower bound, if that was asked for. */
  proof: Proof | null;
  options: PlanOptions;
}

/** Plans all files and passes each result to `write`. */
export async function planFiles(words: Words, requested: Requested & { defaultBudget?: DefaultBudget }, write: (planned: PlannedFile, to: Outlet) => Promise<void>): Promise<void> {
  const { values } = words;
  const load = loadOptions(values);
  const [moves, workers, seed] = ['moves', 'workers', 'seed'].map((name) => whole(values, name));
  const budget = given({ seconds: seconds(values), moves, workers, seed });
  checkedAsWritten(values, () => checkOptions(budget, 'planning'));
  const quiet = values['quiet'] === true;
  const proving = proofBudget(words, requested.outputs, budget);
  const planner = await createPlanner();
  try {
    // A quote has a budget of its own. It may name a material that the machine has no setting for, which a program may not.
    const isQuote = requested.defaultBudget !== undefined;
    // Report wrong usage before reading any file, unless it may be right for the machine of a project.
    await choices(words, planner, !isQuote).catch((error: unknown) => {
      if (!(error instanceof WrongUse) || values['machine'] !== undefined || !filesOf(words.words).some(mayBeProject)) throw error;
    });
    await eachFile(words, { ...requested, inputs: [...(requested.inputs ?? []), ...machineFiles(words, planner)] }, async (file, place, to) => {
      const project = await opened(file);
      const loaded = await usable(file, planner.load(project.drawing, project.name, readingWith(project, load)));
      // What decides on what is cut is reported here and not only by `inspect`: misspelt layers, borders, lettering.
      for (const { message } of loaded.findings.filter(decides)) complain(`${asGiven(file)}: ${message}`);
      refuseDoubt(file, loaded, words, requested.outputs);
      // The report counts the others, unless there is none.
      if (quiet) warn(file, ofDrawing(loaded).filter((f) => !decides(f) && !(loaded.units.doubtful && UNITS.includes(f.code))));
      const { decided, plan, own } = await forProject(file, place, async () => {
        const counting = await ofProject(file, project, values, load, planner);
        return { ...counting, own: await choices(words, planner, !isQuote, counting.decided) };
      });
      const chosen = { ...decided, ...budget, ...own };
      // A quote starts without the plan of the project, because others must be able to make it from the drawing alone.
      const search = budgeted({ ...chosen, ...continuing(isQuote ? null : plan, budget) }, loaded, requested.defaultBudget);
      const planned = searched(planner, search, proving, { file, place, quiet, outputs: requested.outputs.map(({ kind }) => kind) });
      const { result, proof } = await usable(file, planned, (sentence) => leversAsWritten(values, sentence));
      // The report of a quote sums them up in its confidence, and where the job lies changes no figure of it.
      if (quiet || !isQuote) warn(file, isQuote ? result.findings.filter((f) => f.code !== 'off-bed') : result.findings);
      await write({ file, place, planner, loaded, result, proof, options: search }, to);
    });
  } finally {
    planner.close();
  }
}

/** Writes no program while the unit is in doubt, unless somebody accepts the guess. */
function refuseDoubt(file: string, loaded: Loaded, { values }: Words, outputs: Requested['outputs']): void {
  const doubt = doubtAbout(loaded);
  if (doubt === null) return;
  if (hasProgram(outputs.map(({ kind }) => kind)) && values['accept-guess'] !== true) {
    throw new Unusable(`${asGiven(file)}: ${doubt} Nothing is written while the unit is in doubt: state it by --units or --dpi, or accept this guess by --accept-guess.`);
  }
  complain(`${asGiven(file)}: ${loaded.units.reason}`);
}

/** How a search goes on from the plan of a project. Without a budget it keeps that plan as it is. */
function continuing(plan: SavedPlan | null, budget: PlanOptions): PlanOptions {
  if (plan === null) return {};
  const isFree = budget.seconds === undefined && budget.moves === undefined;
  return { warm: plan.path, seed: budget.seed ?? plan.seed, ...(isFree ? { moves: 0 } : {}) };
}

/** What the options choose. `requires`: a material must be a setting of the machine's library. `project`: what a project has chosen. */
async function choices({ values }: Words, planner: Planner, requires: boolean, project: Decided = {}): Promise<PlanOptions> {
  const options: PlanOptions = {};
  const method = text(values, 'method');
  const own = planner.methods.map((m) => m.name);
  const set = parameters(values);
  if (set !== undefined) options.parameters = set;
  if (method !== undefined) {
    const papers = own.includes(method) ? [] : (await planner.paperMethods()).map((m) => m.name);
    options.method = oneOf('--method', method, [...own, ...papers]);
  }
  const machine = await machineOf({ words: [], values }, planner, project.machine);
  options.machine = values['no-return'] === true ? { ...machine, return_home: false } : machine;
  const material = text(values, 'material');
  // A quote may name a material for a machine without a library: its report says so.
  if (material !== undefined && (requires || machine.materials?.length)) options.material = material;
  return { ...options, ...placingOptions(values, machine) };
}

/** How long the lower bound is worked on; `null`: only as the search itself does. */
function proofBudget({ values }: Words, outputs: Requested['outputs'], search: PlanOptions): ProofBudget | null {
  const seconds = number(values, 'bound');
  const work = whole(values, 'bound-work');
  if (seconds === undefined && work === undefined) {
    if (!outputs.some(({ kind }) => kind === 'certificate')) return null;
    // A search whose result is the same everywhere has a proof that is.
    return search.moves !== undefined && search.seconds === undefined ? { work: Math.max(1, Math.round(search.moves / MOVES_PER_WORK)) } : { seconds: search.seconds ?? DEFAULT_SECONDS };
  }
  const budget = given({ seconds, work });
  checkedAsWritten(values, () => checkOptions(budget, 'prove'), { seconds: 'bound' });
  return budget;
}

/** Whether a better path than that of the search is wanted: not one of another method, and not where moves and seed shall give the plan again. */
function mayBecomeBetter({ method, moves }: PlanOptions, planner: Planner): boolean {
  return moves === undefined && (method === undefined || method === planner.methods[0]?.name);
}

/** What a search is for. */
interface Purpose {
  file: string;
  place: Place;
  quiet: boolean;
  outputs: readonly string[];
}

async function searched(planner: Planner, options: PlanOptions, proving: ProofBudget | null, { file, place, quiet, outputs }: Purpose): Promise<{ result: PlanResult; proof: Proof | null }> {
  const show = process.stderr.isTTY && !quiet;
  const plan = planner.plan(options, (progress) => {
    if (show) process.stderr.write(`\r\x1b[K${progressLine(progress, options, nameOf(file), place)}`);
  });
  let prover: ProofHandle | null = null;
  let interrupted = false;
  const stop = () => {
    interrupted = true;
    plan.stop();
    prover?.stop();
  };
  try {
    return await untilInterrupted(stop, async () => {
      // Errors of the plan come first: what cannot be planned cannot be proven either.
      await stopIfRefusedOffBed(plan, outputs, options);
      prover = proving === null ? null : planner.prove(proving);
      if (interrupted) prover?.stop();
      const [result, proof] = await Promise.all([plan.done, prover?.done ?? null]);
      const better = proof?.path && mayBecomeBetter(options, planner) ? await planner.offer(proof.path) : null;
      const progress = better ?? result.progress;
      const summary = bounded(progress.summary, proof?.seconds ?? 0);
      return { result: { ...result, progress: { ...progress, summary } }, proof };
    });
  } finally {
    if (show) process.stderr.write('\r\x1b[K');
  }
}
