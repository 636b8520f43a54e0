// Programs as gcode-toolpath (cncjs, MIT) reads them, compared with their plans.

import Toolpath from 'gcode-toolpath';

/** What rounding to 0.001 mm moves a place by, and a little more, mm. */
const NEAR = 0.00075;

/** The cuts of a program: what is run by G1, G2 and G3 between two rapids. */
function cutsOf(program) {
  const cuts = [];
  let open = false;
  const add = ({ motion }, from, to, center = null) => {
    if (motion === 'G0') {
      open = false;
      return;
    }
    if (!open) cuts.push([]);
    open = true;
    cuts.at(-1).push({ from, to, center, ccw: motion === 'G3' });
  };
  new Toolpath({
    addLine: (modal, from, to) => add(modal, from, to),
    addArcCurve: (modal, from, to, center) => add(modal, from, to, center),
  }).loadFromStringSync(program);
  return cuts;
}

/** The cuts of a plan. A rapid to where the head stands, in the decimals of a program, is not written: such cuts are one. */
function plannedCuts(moves) {
  const cuts = [];
  const rounded = ([x, y]) => `${Math.round(x * 1000)} ${Math.round(y * 1000)}`;
  let at = null;
  let moved = true;
  for (const move of moves) {
    if (move.kind === 'air') moved ||= at === null || rounded(move.to) !== rounded(at);
    if (move.kind !== 'cut') continue;
    if (moved) cuts.push([]);
    moved = false;
    for (const step of move.path) {
      at = step.line ?? step.arc;
      cuts.at(-1).push(at);
    }
  }
  return cuts;
}

const distance = ([x, y], p) => Math.hypot(x - p.x, y - p.y);

/** Largest distance of the places where planned elements end from the elements of the program. */
function offOf(planned, run) {
  let off = 0;
  let from = 0;
  for (const to of planned) {
    let least = Infinity;
    // Elements come in the order of the plan: the search goes on where the last one was found.
    for (let k = 0; k < run.length; k += 1) {
      const e = run[(from + k) % run.length];
      least = Math.min(least, distance(to, e.to), distance(to, e.from));
      if (least <= NEAR) {
        from = (from + k) % run.length;
        break;
      }
      if (e.center !== null) {
        const radius = Math.hypot(e.from.x - e.center.x, e.from.y - e.center.y);
        least = Math.min(least, Math.abs(Math.hypot(to[0] - e.center.x, to[1] - e.center.y) - radius));
      }
    }
    off = Math.max(off, least);
  }
  return off;
}

const lengthOf = (run) => run.reduce((sum, { from, to, center, ccw }) => {
  if (center === null) return sum + Math.hypot(to.x - from.x, to.y - from.y);
  const [a, b] = [from, to].map((p) => Math.atan2(p.y - center.y, p.x - center.x));
  const turn = (((ccw ? b - a : a - b) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
  return sum + Math.hypot(from.x - center.x, from.y - center.y) * (turn || 2 * Math.PI);
}, 0);

/** How many cuts a program has and its plan, their lengths, and the largest distance between them, mm. */
export function compared(program, { moves, summary }) {
  const [runs, planned] = [cutsOf(program), plannedCuts(moves)];
  const off = runs.length === planned.length ? runs.reduce((most, run, k) => Math.max(most, offOf(planned[k], run)), 0) : Infinity;
  const length = runs.reduce((sum, run) => sum + lengthOf(run), 0);
  return { cuts: runs.length, planned: planned.length, off, length, expected: summary.cut_length };
}
