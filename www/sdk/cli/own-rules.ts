/**
 * The rules for leads and for micro-joints that a machine has of its own, changed by options. `--lead` and `--joints` ask for other rules instead; without
 * them, the other options change what the machine has.
 */

import { given } from '../options.js';
import { DEFAULT_JOINTS, jointRules, type JointPattern } from '../joints.js';
import { leadRules, type LeadChoice } from '../leads.js';
import type { JointRule, Joints, LeadRule, LeadShape, Leads } from '../protocol.js';
import { WrongUse } from './io.js';

/** The leads of a machine with these settings. What is not set stays as it is. */
export function changedLeads(leads: Leads, set: Partial<Omit<LeadChoice, 'kind'>>): Leads {
  const { out, position, overcut, clearance = leads.clearance, centerBelow } = set;
  const sizes = given({ length: set.length, radius: set.radius, angle: set.angle === undefined ? undefined : (set.angle * Math.PI) / 180 }) as Partial<LeadShape>;
  const changed = (rule: LeadRule): LeadRule => {
    const lead_in = { ...rule.lead_in, ...sizes };
    // What begins at its centre has neither a place on the contour nor a way out.
    const own = isFromCenter(rule) ? {} : given({ position, lead_out: out === undefined && rule.lead_out === undefined ? undefined : { ...lead_in, ...rule.lead_out, ...sizes, ...given({ kind: out }) } });
    return { ...rule, lead_in, ...own, ...given({ overcut }) } as LeadRule;
  };
  const rules = leads.rules.map(changed);
  if (centerBelow === undefined) return { clearance, rules };
  const others = rules.filter((rule) => !isFromCenter(rule));
  const { rules: [small] } = leadRules({ ...given({ length: set.length, radius: set.radius, angle: set.angle, overcut }), centerBelow: centerBelow || undefined });
  return { clearance, rules: centerBelow === 0 ? others : [small!, ...others] };
}

const isFromCenter = ({ lead_in }: LeadRule) => lead_in.kind === 'center';

/** The joints of a machine with these settings. What is not set stays as it is. */
export function changedJoints(joints: Joints, set: Partial<JointPattern>): Joints {
  const [asked] = jointRules(set).rules;
  // Each setting has one field of a rule, which is not there for some values.
  const fields = Object.keys(set).map((name) => FIELDS[name as keyof JointPattern]);
  const which = fields.find((field) => CONDITIONS.has(field));
  if (joints.rules.length > 1 && which !== undefined) {
    throw new WrongUse(`--joint-${which.replaceAll('_', '-')}: the machine has joints of several kinds, each for contours of its own. Give --joints as well, to replace them.`);
  }
  const rules = joints.rules.map((rule) => {
    const kept = Object.entries(rule).filter(([field]) => !fields.includes(field as keyof JointRule));
    return { ...Object.fromEntries(kept), ...Object.fromEntries(Object.entries(asked ?? {}).filter(([field]) => fields.includes(field as keyof JointRule))) };
  });
  return { rules };
}

/** The field of a rule that each setting has. */
const FIELDS: Record<keyof typeof DEFAULT_JOINTS, keyof JointRule> = {
  count: 'count', width: 'width', spacing: 'spacing', cornerClearance: 'corner_clearance', side: 'side', kind: 'kind', sizeMin: 'size_min', sizeMax: 'size_max', test: 'test',
};

/** The fields that say which contours a rule fits. */
const CONDITIONS: ReadonlySet<keyof JointRule> = new Set(['side', 'size_min', 'size_max', 'test']);
