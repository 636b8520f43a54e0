/** Answers what is no request of HTTP with an error in JSON, as everything else: Node would answer without a body. */

import { STATUS_CODES, type Server, type ServerResponse } from 'node:http';
import type { Duplex } from 'node:stream';
import { KerfwayError } from '../errors.js';
import type { Log } from './log.js';
import { statusOf } from './status.js';

/** Milliseconds for which what a refused client still sends is dropped, so that it sees the answer and not a reset. */
export const DROPPED = 500;

/** What the server does with connections on which no request, or half of one, can be read. */
export function answerUnreadable(server: Server, log: Log): void {
  const answers = new WeakMap<Duplex, ServerResponse>();
  server.on('request', (request, response) => answers.set(request.socket, response));
  server.on('clientError', (error: NodeJS.ErrnoException, socket) => {
    const last = answers.get(socket);
    // Within an answer that has begun there is no room for another.
    if (!socket.writable || (last?.headersSent && !last.writableFinished)) {
      socket.destroy();
      return;
    }
    const reason = reasonOf(error);
    const status = statusOf(reason.code);
    log('info', 'unreadable', { status, code: reason.code, cause: error.code });
    const body = JSON.stringify({ error: reason });
    const head = [`HTTP/1.1 ${status} ${STATUS_CODES[status]}`, 'connection: close', 'content-type: application/json; charset=utf-8', `content-length: ${Buffer.byteLength(body)}`];
    socket.on('data', () => {});
    socket.end(`${head.join('\r\n')}\r\n\r\n${body}`);
    setTimeout(() => socket.destroy(), DROPPED).unref();
  });
}

function reasonOf({ code }: NodeJS.ErrnoException): KerfwayError {
  if (code === 'ERR_HTTP_REQUEST_TIMEOUT') return new KerfwayError('slow-upload', 'The request did not arrive in time.');
  if (code === 'HPE_HEADER_OVERFLOW') return new KerfwayError('too-large', 'The headers of the request are larger than 16 kB.');
  return new KerfwayError('malformed-form', 'This is no request of HTTP/1.1, or its length is not what its headers say.');
}
