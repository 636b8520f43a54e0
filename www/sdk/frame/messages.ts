/**
 * What the frame page and its host tell each other. Every message is marked, numbered where it wants an answer, and read
 * with suspicion: a message that is not exactly one of these is none.
 */

import type { Planned } from '../functions.js';
import type { PlanningOptions } from '../options.js';
import type { MachineProfile, MethodInfo, OutputKind, Progress } from '../protocol.js';

/** Version of these messages. */
export const MARK = 1;

/** What may be rendered for a host. */
export const KINDS = ['gcode', 'svg', 'dxf', 'png'] as const satisfies readonly OutputKind[];
/** What a frame can render. */
export type Kind = (typeof KINDS)[number];

/** Numbers of a plan under way. */
export type Pace = Pick<Progress, 'moves' | 'seconds' | 'rate' | 'summary'>;

export type ToFrame =
  /** Asks for `ready`, if the planner is ready already. */
  | { type: 'hello' }
  /** How drawings are read and planned from now on, those a person drops, too. */
  | { type: 'options'; options: PlanningOptions }
  | { type: 'open'; id: number; bytes: ArrayBuffer; name: string }
  | { type: 'stop' }
  | { type: 'render'; id: number; kind: Kind; width: number | null };

export type FromFrame =
  | { type: 'ready'; machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }
  | { type: 'progress'; progress: Pace }
  | { type: 'result'; result: Planned<'gcode'> }
  /** One sentence for people. */
  | { type: 'error'; message: string }
  | { type: 'answer'; id: number; value: unknown }
  | { type: 'refused'; id: number; message: string };

/** A message as it is posted. */
export type Marked<M> = M & { kerfway: typeof MARK };

/** Pixels across the widest picture. */
const WIDEST = 8192;
/** The characters a file's name may have. */
const LONGEST_NAME = 255;

/** The message to the frame that `data` is; `null`: it is none. */
export function messageToFrame(data: unknown): ToFrame | null {
  if (!isRecord(data) || data['kerfway'] !== MARK) return null;
  const { type, id, bytes, name, options, kind, width } = data;
  switch (type) {
    case 'hello':
    case 'stop':
      return { type };
    case 'options':
      return isRecord(options) ? { type, options } : null;
    case 'open':
      return isId(id) && bytes instanceof ArrayBuffer && isName(name) ? { type, id, bytes, name } : null;
    case 'render':
      return isId(id) && isKind(kind) && (width === null || isWidth(width)) ? { type, id, kind, width } : null;
    default:
      return null;
  }
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

const isId = (value: unknown): value is number => Number.isSafeInteger(value);
const isName = (value: unknown): value is string => typeof value === 'string' && value.length > 0 && value.length <= LONGEST_NAME;
const isKind = (value: unknown): value is Kind => KINDS.some((kind) => kind === value);
const isWidth = (value: unknown): value is number => typeof value === 'number' && Number.isInteger(value) && value > 0 && value <= WIDEST;

/** The origin a host states: exactly one, of the web. */
export function originOf(text: string | null): string | null {
  if (text === null || !URL.canParse(text)) return null;
  const { origin, protocol } = new URL(text);
  return ['http:', 'https:'].includes(protocol) && origin === text ? origin : null;
}
