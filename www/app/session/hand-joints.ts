/** Micro-joints that a person places on contours: each is a fraction of the length of its contour. */

import type { JointChoice, LoadOptions } from 'kerfway';
import { chainLength, distance2, STRIDE, type Shapes } from '../stage/shapes.js';

/** The joint at the place of a contour that is nearest to a point, mm. */
export function jointAt(shapes: Shapes, contour: number, x: number, y: number): JointChoice {
  const whole = chainLength(shapes, contour);
  let at = 0, best = 0, least = Infinity;
  for (let e = shapes.offsets[contour]!; e < shapes.offsets[contour + 1]!; e += 1) {
    const d = distance2(shapes, e, x, y);
    if (d < least) {
      least = d;
      best = at + shapes.lengths[e]! * partAt(shapes, e, x, y);
    }
    at += shapes.lengths[e]!;
  }
  return { contour, at: whole > 0 ? Math.min(1, best / whole) : 0 };
}

/** The part of an element, 0 to 1, that is nearest to a point. */
function partAt(shapes: Shapes, e: number, x: number, y: number): number {
  const s = shapes.segments;
  const i = e * STRIDE;
  const sweep = s[i + 6]!;
  if (sweep === 0) {
    const dx = s[i + 2]! - s[i]!, dy = s[i + 3]! - s[i + 1]!;
    const square = dx * dx + dy * dy;
    return square > 0 ? Math.min(1, Math.max(0, ((x - s[i]!) * dx + (y - s[i + 1]!) * dy) / square)) : 0;
  }
  const round = 2 * Math.PI;
  const turn = (Math.atan2(y - s[i + 5]!, x - s[i + 4]!) - shapes.arcs[e * 2 + 1]!) * Math.sign(sweep);
  const ahead = ((turn % round) + round) % round;
  // Beyond its ends, an arc is nearest at one of them.
  if (ahead > Math.abs(sweep)) return ahead - Math.abs(sweep) < round - ahead ? 1 : 0;
  return ahead / Math.abs(sweep);
}

/** The options with a joint added, or with those of its contour removed that are at most `reach` mm away. */
export function withJoint({ joints = [] }: LoadOptions, joint: JointChoice, whole: number, reach: number): Pick<LoadOptions, 'joints'> {
  const apart = (a: number, b: number) => Math.min(Math.abs(a - b), 1 - Math.abs(a - b)) * whole;
  const rest = joints.filter((j) => j.contour !== joint.contour || apart(j.at, joint.at) > reach);
  return { joints: rest.length < joints.length ? rest : [...joints, joint] };
}
