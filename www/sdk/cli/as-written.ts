/**
 * Refusals in the words of the command line. The checks of the package name the fields of options and machines; here they are replaced by
 * the option and the value that were typed, and angles are in degrees.
 */

import { isKerfwayError, type KerfwayError } from '../errors.js';
import type { Words } from './arguments.js';
import { WrongUse } from './io.js';

/** The option that sets each field. Fields are written without the indexes of lists. */
const OPTIONS: Readonly<Record<string, string>> = {
  seconds: 'seconds', moves: 'moves', workers: 'workers', seed: 'seed', work: 'bound-work',
  dpi: 'dpi', joinTolerance: 'join-tolerance', tolerance: 'curve-tolerance', copyTolerance: 'copy-tolerance',
  'layers.speed': 'layer', 'layers.power': 'layer', 'layers.minPower': 'layer', 'layers.passes': 'layer', 'layers.zStep': 'layer',
  'place.from': 'place', 'place.at': 'place',
  'material.thickness': 'thickness', 'material.density': 'density', width: 'sheet', height: 'sheet', gap: 'gap',
  'leads.clearance': 'lead-clearance', 'leads.rules.diameter_below': 'lead-center-below', 'leads.rules.overcut': 'overcut',
  'leads.rules.lead_in.length': 'lead-length', 'leads.rules.lead_in.radius': 'lead-radius', 'leads.rules.lead_in.angle': 'lead-angle',
  'joints.rules.count': 'joints', 'joints.rules.width': 'joint-width', 'joints.rules.spacing': 'joint-spacing', 'joints.rules.corner_clearance': 'joint-corners',
  'joints.rules.size_min': 'joint-size-min', 'joints.rules.size_max': 'joint-size-max',
  'levers.moving_pierce.overcut': 'moving-pierce', 'levers.lift.height': 'lift', 'levers.lift.stay_down': 'stay-down', z_speed: 'z-speed', kerf_width: 'kerf-width',
  'levers.fly.reach': 'fly', 'levers.fly.overcut': 'fly-overcut', 'levers.chains.reach': 'chains', 'levers.chains.clearance': 'chain-clearance',
  'levers.bridges.reach': 'bridges', 'levers.bridges.width': 'bridge-width', 'levers.bridges.clearance': 'bridge-clearance', 'levers.bridges.most': 'bridge-most',
  'levers.corners.loop_radius': 'loop-radius', 'levers.corners.clearance': 'loop-clearance', 'levers.corners.round_radius': 'round-radius', 'levers.corners.deviation': 'corner-deviation',
  'levers.tips.nozzle_radius': 'nozzle-radius', 'levers.tips.margin': 'tip-margin', 'levers.tips.slats.pitch': 'slats', 'levers.tips.slats.angle': 'slats',
  'levers.tips.tips_below': 'tips-below', 'levers.tips.drops_below': 'drops-below', 'levers.tips.cross_over': 'cross-over',
  'levers.heat.distance': 'heat', 'levers.heat.seconds': 'heat', 'levers.heat.charge': 'heat-charge', 'levers.heat.small_holes.thickness': 'small-holes', 'levers.heat.small_holes.ratio': 'small-holes',
  'skeleton.spacing_x': 'skeleton', 'skeleton.spacing_y': 'skeleton', 'skeleton.clearance': 'skeleton-clearance', 'skeleton.joint_spacing': 'skeleton-joints', 'skeleton.remainder': 'keep-strip',
};

/** Runs a check and turns its error into wrong usage. `renamed`: options that set other fields here than elsewhere. */
export function checkedAsWritten<T>(values: Words['values'], check: () => T, renamed: Readonly<Record<string, string>> = {}): T {
  try {
    return check();
  } catch (error) {
    throw new WrongUse(isKerfwayError(error) ? asWritten(values, error, renamed) : (error as Error).message);
  }
}

function asWritten(values: Words['values'], { message, params }: KerfwayError, renamed: Readonly<Record<string, string>>): string {
  const field = String(params['field'] ?? '');
  const plain = field.replace(/\[\d+\]/g, '');
  const fromShift = values['shift-parts'] === undefined ? 'offer-shifts' : 'shift-parts';
  const option = renamed[plain] ?? (plain === 'levers.common_cuts.shift' ? fromShift : OPTIONS[plain]);
  const given = option === undefined ? undefined : values[option];
  const rule = /\. (Give|Choose) (.*)$/s.exec(message);
  // A field that no option sets is one of a machine's file.
  if (given === undefined || rule === null) return message;
  const word = Array.isArray(given) ? given[Number(/\[(\d+)\]/.exec(field)?.[1] ?? 0)] : given;
  // An option that is absent takes the place of null.
  const range = inDegrees(rule[2] ?? '', params).replace(', or null', '');
  // One word has all settings of a layer.
  if (option === 'layer') return `--layer ${word}: ${kebab(field.split('.').at(-1) ?? '')} is ${params['value']}. ${rule[1]} ${range}`;
  return `--${option} ${word}: ${rule[1]?.toLowerCase()} ${range}`;
}

/** The range of an angle in degrees. Three digits are enough, because its ends are half a degree and half a turn. */
function inDegrees(rule: string, { least, most, unit }: KerfwayError['params']): string {
  if (unit !== 'rad') return rule;
  const degrees = (radians: unknown) => Number(((Number(radians) * 180) / Math.PI).toPrecision(3));
  return rule.replace(`${least} to ${most} rad`, `${degrees(least)} to ${degrees(most)} degrees`);
}

const kebab = (name: string) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

/** A sentence of the planner about levers of a machine, which names those that were asked for by their options. */
export function leversAsWritten(values: Words['values'], sentence: string): string {
  const named = sentence.replace(/\blevers\.(\w+)\b(?!\.\w)/g, (field, lever: string) => {
    const option = lever === 'common_cuts' ? 'shared-cuts' : lever.replaceAll('_', '-');
    return values[option] === undefined ? field : `--${option}`;
  });
  return named === sentence ? sentence : named.replace(/^The machine has (\S+) and (\S+)\. /, '$1 and $2 contradict each other. ');
}
