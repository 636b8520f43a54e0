/**
 * Leads in the form that people think of them: one lead for all contours, and small holes from their centres. `leadRules` makes the rules of a
 * machine profile from that; profiles may have any other rules as well.
 */

import type { LeadKind, LeadPosition, LeadShape, Leads } from './protocol.js';
import { withDefaults } from './rule-settings.js';

/** The forms of a lead that joins a contour anywhere. */
export const LEAD_KINDS: readonly LeadKind[] = ['none', 'line', 'arc', 'line-arc'];
/** Where leads may join a contour. */
export const LEAD_POSITIONS: readonly LeadPosition[] = ['any', 'corner', 'side'];

/** One lead for all contours, and small holes from their centres. */
export interface LeadChoice {
  /** The lead-in. */
  kind: LeadKind;
  /** The lead-out. */
  out: LeadKind;
  /** Length of the line, mm. */
  length: number;
  /** Radius of the arc, mm. */
  radius: number;
  /** Of a line the angle to the contour, of an arc its sweep, degrees. */
  angle: number;
  position: LeadPosition;
  /** Length that is cut again after the start, mm; negative for a gap. */
  overcut: number;
  /** Least distance from everything that is not scrap, mm. */
  clearance: number;
  /** Holes smaller than this begin at their centres, mm; 0 for none. */
  centerBelow: number;
}

/** What {@link leadRules} takes for settings that are not given. */
export const DEFAULT_LEADS: Readonly<LeadChoice> = {
  kind: 'arc', out: 'none', length: 3, radius: 1.5, angle: 90, position: 'any', overcut: 0, clearance: 0.5, centerBelow: 6,
};

/** The rules of a machine profile for these settings; what is not given has its default ({@link DEFAULT_LEADS}). */
export function leadRules(settings: Partial<LeadChoice> = {}): Leads {
  const s = withDefaults('A lead', DEFAULT_LEADS, settings);
  const shape = (kind: LeadKind): LeadShape => ({ kind, length: s.length, radius: s.radius, angle: (s.angle * Math.PI) / 180 });
  const small = s.centerBelow !== 0 && s.kind !== 'none'
    ? [{ side: 'hole' as const, diameter_below: s.centerBelow, lead_in: shape('center'), overcut: s.overcut }] : [];
  return { clearance: s.clearance, rules: [...small, { lead_in: shape(s.kind), lead_out: shape(s.out), position: s.position, overcut: s.overcut }] };
}

/** The settings that these rules were made from; `null` for rules of another form, and for a machine without leads. */
export function leadSettings(leads: Leads | null | undefined): LeadChoice | null {
  const last = Array.isArray(leads?.rules) ? leads.rules.at(-1) : undefined;
  if (leads == null || last?.lead_in == null) return null;
  const { length, radius, angle } = { ...DEFAULT_LEADS, ...last.lead_in };
  const small = leads.rules.length > 1 ? leads.rules[0]! : undefined;
  const settings: LeadChoice = {
    kind: last.lead_in.kind, out: last.lead_out?.kind ?? 'none', length, radius,
    angle: last.lead_in.angle === undefined ? DEFAULT_LEADS.angle : Math.round((angle * 180) / Math.PI * 1e6) / 1e6,
    position: last.position ?? 'any', overcut: last.overcut ?? 0, clearance: leads.clearance, centerBelow: small?.diameter_below ?? 0,
  };
  return same(leadRules(settings), leads) ? settings : null;
}

/** Angles come from degrees, so that their last digits may differ. */
function same(a: unknown, b: unknown): boolean {
  if (typeof a === 'number' && typeof b === 'number') return Math.abs(a - b) < 1e-9;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b;
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...names].every((name) => same((a as Record<string, unknown>)[name], (b as Record<string, unknown>)[name]));
}
