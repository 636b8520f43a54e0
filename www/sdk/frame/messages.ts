/**
 * The messages between the frame page and its host. Every message has a mark, and requests have a number. Messages to the
 * frame are checked strictly: anything that is not exactly one of these is ignored.
 */

import { isRecord } from '../check.js';
import type { Planned } from '../functions.js';
import type { PlanningOptions } from '../options.js';
import type { ErrorReport, MachineProfile, MethodInfo, OutputKind, Progress } from '../protocol.js';
import type { Material, Quote } from '../quote.js';

/** The version of these messages. */
export const MARK = 1;

/** The formats that a host may request. */
export const KINDS = ['gcode', 'svg', 'dxf', 'png'] as const satisfies readonly OutputKind[];
/** A format in which a frame can render a plan. */
export type Kind = (typeof KINDS)[number];

/** The figures of a running plan. */
export type Pace = Pick<Progress, 'moves' | 'seconds' | 'rate' | 'summary'>;

export type ToFrame =
  /** Asks the frame to send `ready` again if its planner has started. */
  | { type: 'hello' }
  /** Sets how drawings are read and planned, including those that a person drops. */
  | { type: 'options'; options: PlanningOptions }
  | { type: 'open'; id: number; bytes: ArrayBuffer; name: string }
  | { type: 'stop' }
  /** The material of the sheet, in a frame that quotes. */
  | { type: 'material'; material: Material }
  /** The price of the report that the frame asked about, in words; empty: none. */
  | { type: 'priced'; id: number; text: string }
  | { type: 'render'; id: number; kind: Kind; width: number | null };

export type FromFrame =
  /** `page`: when the page in the frame was loaded; another number is another page, which knows nothing that the host sent before. */
  | { type: 'ready'; page: number; machines: readonly MachineProfile[]; methods: readonly MethodInfo[] }
  | { type: 'progress'; progress: Pace }
  | { type: 'result'; result: Planned<'gcode'> }
  | { type: 'quoted'; quote: Quote }
  /** Asks for the price of a report. */
  | { type: 'price'; id: number; quote: Quote }
  | { type: 'error'; error: ErrorReport }
  | { type: 'answer'; id: number; value: unknown }
  | { type: 'refused'; id: number; error: ErrorReport };

/** A message with its mark, as it is posted. */
export type Marked<M> = M & { kerfway: typeof MARK };

/** The largest width of a picture, in pixels. */
const WIDEST = 8192;
/** The largest number of characters of a price in words. */
const LONGEST_PRICE = 1000;
/** The largest number of characters of a file's name. */
export const LONGEST_NAME = 255;

/** Reads `data` as a message to the frame; `null` if it is not exactly one of them. */
export function messageToFrame(data: unknown): ToFrame | null {
  if (!isRecord(data) || data['kerfway'] !== MARK) return null;
  const { type, id, bytes, name, options, kind, width, material, text } = data;
  switch (type) {
    case 'hello':
    case 'stop':
      return { type };
    case 'options':
      return isRecord(options) ? { type, options } : null;
    case 'material':
      return isRecord(material) ? { type, material } : null;
    case 'priced':
      return isId(id) && typeof text === 'string' && text.length <= LONGEST_PRICE ? { type, id, text } : null;
    case 'open':
      return isId(id) && bytes instanceof ArrayBuffer && isName(name) ? { type, id, bytes, name } : null;
    case 'render':
      return isId(id) && isKind(kind) && (width === null || isWidth(width)) ? { type, id, kind, width } : null;
    default:
      return null;
  }
}

const isId = (value: unknown): value is number => Number.isSafeInteger(value);
const isName = (value: unknown): value is string => typeof value === 'string' && value.length > 0 && value.length <= LONGEST_NAME;
const isKind = (value: unknown): value is Kind => KINDS.some((kind) => kind === value);
const isWidth = (value: unknown): value is number => typeof value === 'number' && Number.isInteger(value) && value > 0 && value <= WIDEST;

/** Reads the origin of a host: a single http or https origin, otherwise `null`. */
export function originOf(text: string | null): string | null {
  if (text === null || !URL.canParse(text)) return null;
  const { origin, protocol } = new URL(text);
  return ['http:', 'https:'].includes(protocol) && origin === text ? origin : null;
}
