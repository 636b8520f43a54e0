/** Answers what is no request of HTTP with an error in JSON, as everything else: Node would answer without a body. */

import { STATUS_CODES, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { Socket } from 'node:net';
import type { Duplex } from 'node:stream';
import { KerfwayError } from '../errors.js';
import type { ErrorCode } from '../generated/types.js';
import { statusOf } from './status.js';

/** Milliseconds without a byte after which a refused client is taken to have sent all that it sends. */
const DROPPED = 500;

/**
 * Drops what a refused client still sends of its body. Many clients read the answer only when they have sent all, and would see a reset instead of it.
 * Calls `end` when all has come, when nothing comes any more, or after `most` milliseconds.
 */
export function dropRest(request: IncomingMessage, most: number, end: () => void): void {
  const ended = () => {
    clearTimeout(idle);
    clearTimeout(late);
    end();
  };
  const idle = setTimeout(ended, Math.min(DROPPED, most)), late = setTimeout(ended, most);
  request.on('data', () => idle.refresh()).on('end', ended).on('close', ended);
}

/** Hears of every such answer: its status, the code of its error, and what Node calls the cause. */
type Answered = (status: number, code: ErrorCode, cause: string) => void;

/**
 * Answers on connections on which no request, or half of one, can be read. The function that it returns says whether a connection was answered so: a
 * request that had begun on it needs no other answer.
 */
export function answerUnreadable(server: Server, answered: Answered): (socket: Duplex) => boolean {
  const begun = new WeakMap<Duplex, ServerResponse>();
  const ended = new WeakSet<Duplex>();
  const end = (socket: Duplex, reason: KerfwayError, cause: string) => {
    const status = statusOf(reason.code);
    answered(status, reason.code, cause);
    const body = JSON.stringify({ error: reason });
    const head = [`HTTP/1.1 ${status} ${STATUS_CODES[status]}`, 'connection: close', 'content-type: application/json; charset=utf-8', `content-length: ${Buffer.byteLength(body)}`];
    ended.add(socket);
    socket.on('data', () => {});
    socket.on('error', () => {});
    socket.end(`${head.join('\r\n')}\r\n\r\n${body}`);
    setTimeout(() => socket.destroy(), DROPPED).unref();
  };
  server.on('request', (request, response) => begun.set(request.socket, response));
  server.on('clientError', (error: NodeJS.ErrnoException, socket) => {
    const last = begun.get(socket);
    // A connection that a browser opens in advance sends nothing, and expects nothing. Within an answer that has begun there is no room for another.
    if ((socket as Socket).bytesRead === 0 || !socket.writable || (last?.headersSent && !last.writableFinished)) socket.destroy();
    else end(socket, reasonOf(error), error.code ?? '');
  });
  // Node would close the connection of one that asks for a tunnel.
  server.on('connect', (_, socket) => end(socket, new KerfwayError('method-not-allowed', 'This is no proxy: send GET or POST.'), 'CONNECT'));
  return (socket) => ended.has(socket);
}

function reasonOf({ code }: NodeJS.ErrnoException): KerfwayError {
  if (code === 'ERR_HTTP_REQUEST_TIMEOUT') return new KerfwayError('slow-upload', 'The request did not arrive in time.');
  if (code === 'HPE_HEADER_OVERFLOW') return new KerfwayError('too-large', 'The headers of the request are larger than 16 kB.');
  return new KerfwayError('malformed-form', 'This is no request of HTTP/1.1, or its length is not what its headers say.');
}
