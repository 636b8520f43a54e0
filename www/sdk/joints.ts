/**
 * Micro-joints in the form that people think of them: the same joints for all contours of some sizes. `jointRules` makes the rules of a machine
 * profile from that; profiles may have any other rules as well.
 */

import type { JointKind, JointRule, Joints, SizeTest } from './protocol.js';
import { withDefaults } from './rule-settings.js';

/** Whether the head stops at a joint. */
export const JOINT_KINDS: readonly JointKind[] = ['stop', 'flying'];
/** The contours that have joints. */
export const JOINT_SIDES = ['both', 'outer', 'hole'] as const;
/** Which contours have joints. */
export type JointSide = (typeof JOINT_SIDES)[number];
/** Whether the sizes in x and in y have to be within the limits, or one of them. */
export const SIZE_TESTS: readonly SizeTest[] = ['and', 'or'];

/** The same joints for all contours of some sizes. */
export interface JointPattern {
  /** Least number of joints of a contour. */
  count: number;
  /** Width of the material that holds, mm. */
  width: number;
  /** Greatest length that is cut without a joint, mm; 0 for any. */
  spacing: number;
  /** Least distance from corners, mm. */
  cornerClearance: number;
  side: JointSide;
  kind: JointKind;
  /** Contours are at least this large in x and y, mm; 0, 0 for any. */
  sizeMin: readonly [number, number];
  /** Contours are at most this large in x and y, mm; 0, 0 for any. */
  sizeMax: readonly [number, number];
  test: SizeTest;
}

/** What {@link jointRules} takes for settings that are not given. */
export const DEFAULT_JOINTS: Readonly<JointPattern> = {
  count: 2, width: 0.5, spacing: 0, cornerClearance: 2, side: 'outer', kind: 'stop', sizeMin: [0, 0], sizeMax: [0, 0], test: 'and',
};

const isAny = ([x, y]: readonly [number, number]) => x === 0 && y === 0;

/** The rule of a machine profile for these settings; what is not given has its default ({@link DEFAULT_JOINTS}). */
export function jointRules(settings: Partial<JointPattern> = {}): Joints {
  const s = withDefaults('A joint', DEFAULT_JOINTS, settings);
  const rule: JointRule = { count: s.count, width: s.width, corner_clearance: s.cornerClearance, kind: s.kind };
  if (s.spacing !== 0) rule.spacing = s.spacing;
  if (s.side !== 'both') rule.side = s.side;
  if (!isAny(s.sizeMin)) rule.size_min = [...s.sizeMin];
  if (!isAny(s.sizeMax)) rule.size_max = [...s.sizeMax];
  if (s.test !== 'and') rule.test = s.test;
  return { rules: [rule] };
}

/** The settings of rules that are one rule; `null` for several, and for a machine without joints. */
export function jointSettings(joints: Joints | null | undefined): JointPattern | null {
  const [rule, second] = Array.isArray(joints?.rules) ? joints.rules : [];
  if (rule == null || second !== undefined) return null;
  return {
    // These are the defaults of rules, which fit every contour.
    count: rule.count ?? 2, width: rule.width ?? 0.5, spacing: rule.spacing ?? 0, cornerClearance: rule.corner_clearance ?? 2,
    side: rule.side ?? 'both', kind: rule.kind ?? 'stop', sizeMin: rule.size_min ?? [0, 0], sizeMax: rule.size_max ?? [0, 0], test: rule.test ?? 'and',
  };
}
