/**
 * What a worker says of a large drawing, in several messages: an object for each of 100,000 contours in one message would keep the thread that
 * reads it for a third of a second.
 */

import type { FromWorker, Loaded } from './protocol.js';

/** Contours, or parts, in one message: it is read within ten milliseconds on a slow machine. */
const PIECE = 4_000;

type Piece = Extract<FromWorker, { type: 'piece' }>;

/** The messages that come before the answer, and the drawing without what is in them. */
export function inPieces(id: number, loaded: Loaded): { pieces: Piece[]; rest: Loaded } {
  const { contours, parts } = loaded;
  const count = Math.ceil(Math.max(contours.length, parts.length) / PIECE) - 1;
  const slice = <T>(list: readonly T[], k: number) => list.slice(k * PIECE, (k + 1) * PIECE);
  const pieces = Array.from({ length: Math.max(0, count) }, (_, k): Piece => ({ type: 'piece', id, contours: slice(contours, k), parts: slice(parts, k) }));
  const last = pieces.length;
  return { pieces, rest: last === 0 ? loaded : { ...loaded, contours: slice(contours, last), parts: slice(parts, last) } };
}

/** Puts the messages together again. */
export class Pieces {
  private list: Piece[] = [];

  /** The message that is complete now; null for a piece. */
  receive(message: FromWorker): FromWorker | null {
    if (message.type === 'piece') {
      this.list.push(message);
      return null;
    }
    if (message.type !== 'loaded' || this.list.length === 0) return message;
    const { loaded } = message;
    const own = this.list.filter((p) => p.id === message.id);
    this.list = [];
    return { ...message, loaded: { ...loaded, contours: [...own.flatMap((p) => p.contours), ...loaded.contours], parts: [...own.flatMap((p) => p.parts), ...loaded.parts] } };
  }
}
