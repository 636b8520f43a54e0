/** Micro-joints that a person places on contours: each is a fraction of the length of its contour. */

import type { JointChoice, LoadOptions } from 'kerfway';
import { chainLength, distance2, partAt, type Shapes } from '../stage/shapes.js';

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

/** The options with a joint added, or with those of its contour removed that are at most `reach` mm away. */
export function withJoint({ joints = [] }: LoadOptions, joint: JointChoice, whole: number, reach: number): Pick<LoadOptions, 'joints'> {
  const apart = (a: number, b: number) => Math.min(Math.abs(a - b), 1 - Math.abs(a - b)) * whole;
  const rest = joints.filter((j) => j.contour !== joint.contour || apart(j.at, joint.at) > reach);
  return { joints: rest.length < joints.length ? rest : [...joints, joint] };
}
