/**
 * Settings in the address, after `#`, so that they can be shared. They are never sent to a server, and the drawing is not among them.
 * Default values are omitted; values that cannot be understood are ignored.
 *
 * The page writes the settings of the open drawing there. A reload must not take these for the settings of all later drawings, so the history
 * of the tab holds the address that the page was opened with.
 */

import { ANCHORS, type CommonCuts, type LoadOptions, type Place, type Unit } from 'kerfway';
import { AS_DRAWN, type Placing } from './placing.js';
import type { State } from './state.js';

export interface Shared {
  machine: string | null;
  method: string | null;
  seed: number | null;
  seconds: number | null;
  load: LoadOptions;
  placing: Placing;
}

/** The settings of a state, as the part of an address after `#`. */
export function written({ machine, search, load, placing }: State, defaults: { machine: string; method: string; seconds: number }): string {
  const words = new URLSearchParams();
  const put = (name: string, value: string | number | boolean | null | undefined, usual?: unknown) => {
    if (value !== null && value !== undefined && value !== false && value !== usual) words.set(name, value === true ? '1' : String(value));
  };
  put('machine', machine?.name, defaults.machine);
  put('method', search.method, defaults.method);
  put('seed', search.seed);
  put('seconds', search.seconds, defaults.seconds);
  put('units', load.units);
  put('dpi', load.dpi);
  put('join', load.joinTolerance);
  put('copies', load.copyTolerance);
  put('curves', load.tolerance);
  put('by-layer', load.orderByLayer);
  put('part-by-part', load.partByPart);
  put('common-cuts', load.commonCuts, 'best');
  put('turn', load.turn, 0);
  if (placing.place) put('place', `${placing.place.point ?? 'lower-left'}@${placing.place.at.join(',')}`);
  put('start', placing.start, 'absolute');
  return words.toString();
}

/** The settings that the page begins with. What drawings are read with is that of the address that the page was opened with. */
export function readAddress(): Shared {
  return { ...read(location.hash), load: read(openedWith()).load };
}

/** Writes settings to the address if they differ: every write goes to another process of the browser and takes milliseconds. */
export function writeAddress(settings: string): void {
  if ((location.hash || '#') !== `#${settings}`) history.replaceState({ openedWith: openedWith() }, '', `#${settings}`);
}

function openedWith(): string {
  const state: unknown = history.state;
  const before = typeof state === 'object' && state !== null && 'openedWith' in state ? state.openedWith : null;
  return typeof before === 'string' ? before : location.hash;
}

/** The settings of an address. */
function read(hash: string): Shared {
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const number = (name: string, most: number) => {
    const value = Number(words.get(name) ?? NaN);
    return value >= 0 && value <= most ? value : null;
  };
  const load: LoadOptions = {};
  const units = UNITS.find((u) => u === words.get('units'));
  const dpi = number('dpi', 100_000);
  const join = number('join', 5);
  const copies = number('copies', 1);
  const curves = number('curves', 1);
  if (units !== undefined) load.units = units;
  if (dpi !== null && dpi >= 1 && (units === undefined || units === 'px')) load.dpi = dpi;
  if (join !== null && join > 0) load.joinTolerance = join;
  if (copies !== null && copies > 0) load.copyTolerance = copies;
  if (curves !== null && curves > 0) load.tolerance = curves;
  if (words.get('by-layer') === '1') load.orderByLayer = true;
  if (words.get('part-by-part') === '1') load.partByPart = true;
  const common = COMMON_CUTS.find((c) => c === words.get('common-cuts'));
  if (common !== undefined) load.commonCuts = common;
  const turn = number('turn', 270);
  if (turn !== null && turn > 0 && turn % 90 === 0) load.turn = turn;
  const placing: Placing = { ...AS_DRAWN, place: placeOf(words.get('place') ?? ''), start: words.get('start') === 'current' ? 'current' : 'absolute' };
  const seed = number('seed', 4294967295);
  return {
    machine: words.get('machine'), method: words.get('method'), load, placing,
    seed: seed !== null && Number.isInteger(seed) ? seed : null, seconds: number('seconds', 3600) || null,
  };
}

/** `POINT@X,Y`; null for anything else. */
function placeOf(word: string): Place | null {
  const [from, to = ''] = word.split('@');
  const point = ANCHORS.find((a) => a === from);
  const [x = NaN, y = NaN] = to.split(',').map(Number);
  return point !== undefined && Math.abs(x) <= 1e6 && Math.abs(y) <= 1e6 ? { point, at: [x, y] } : null;
}

const COMMON_CUTS: readonly CommonCuts[] = ['best', 'insertion', 'off'];
const UNITS: readonly Unit[] = ['mm', 'cm', 'dm', 'm', 'um', 'in', 'ft', 'yd', 'mil', 'microinch', 'px'];
