/**
 * The HTTP service: receives drawings, answers with JSON. Every answer but 200 and 202 has `{ "error": { code, message, params,
 * retryable } }`. A service that is full says so with 429 before it reads a body, and one that stops finishes what runs.
 */

import { createServer, type IncomingMessage, type Server, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { KerfwayError, reportOf } from '../errors.js';
import type { ErrorReport } from '../generated/types.js';
import { safeName, uploadOf } from './body.js';
import type { Backend } from './backend.js';
import { keyOf } from './keys.js';
import type { Log } from './log.js';
import { Metrics } from './metrics.js';
import { openapi } from './openapi.js';
import { isUnbudgeted, JOB_KINDS, requestOptions, type JobKind } from './request-options.js';
import type { ServerSettings } from './settings.js';
import { CLIENT_LEFT, statusOf, told } from './status.js';
import { answerUnreadable, dropRest } from './unreadable.js';

/** A running service. */
export interface Service {
  /** Its address. */
  url: string;
  /** Refuses new work, finishes what runs, and ends. */
  stop(): Promise<void>;
}

/** Seconds after which a refused request may try again: about the time of a few drawings. */
const RETRY_AFTER = 5;
/** Milliseconds in which the headers of a request must have arrived. */
const HEADERS_TIMEOUT = 10_000;
/** Bytes of an answer that even a slow client reads in a second. */
const READ_PER_SECOND = 1e6;
/** Milliseconds: a longer timer would end at once. */
const LONGEST_TIMER = 2 ** 31 - 1;

/** Starts the service. */
export async function serve(settings: ServerSettings, backend: Backend, version: string, log: Log): Promise<Service> {
  const service = new HttpService(settings, backend, version, log);
  return service.start();
}

/** The answer to a request. */
interface Reply {
  status: number;
  body: string;
  type?: string;
  headers?: Record<string, string>;
  /** The code of the error. */
  code?: string;
}

class HttpService {
  private readonly server: Server;
  private readonly metrics: Metrics;
  /** Whether the rest of a request could not be read, so that it has an answer. */
  private readonly wasUnreadable: ReturnType<typeof answerUnreadable>;
  private readonly running = new Set<AbortController>();
  /** The names of the keys that requests were sent with. */
  private readonly keys = new WeakMap<IncomingMessage, string>();
  /** The requests whose drawing is arriving, or is being put into the queue. */
  private arriving = 0;
  private stopping = false;
  /** Settles when the service has ended, once it was told to. */
  private stopped: Promise<void> | null = null;

  constructor(
    private readonly settings: ServerSettings,
    private readonly backend: Backend,
    private readonly version: string,
    private readonly log: Log,
  ) {
    this.metrics = new Metrics({ waiting: () => backend.waiting(), running: () => this.running.size });
    this.server = createServer({ requireHostHeader: false, headersTimeout: HEADERS_TIMEOUT, requestTimeout: Math.round((settings.upload + 30) * 1000), keepAliveTimeout: 5_000 }, (request, response) => {
      void this.handle(request, response);
    });
    // Node would answer an expectation that it does not know with a bare 417. Such a request is answered like any other.
    this.server.on('checkExpectation', (request, response) => this.server.emit('request', request, response));
    this.wasUnreadable = answerUnreadable(this.server, (status, code, cause) => {
      this.metrics.answered('unreadable', status, null, code);
      this.log('info', 'unreadable', { status, code, cause });
    });
  }

  async start(): Promise<Service> {
    const { host, port } = this.settings;
    await new Promise<void>((resolve, reject) => {
      this.server.once('error', reject);
      this.server.listen(port, host, resolve);
    });
    const address = this.server.address() as AddressInfo;
    const url = `http://${address.family === 'IPv6' ? `[${address.address}]` : address.address}:${address.port}`;
    this.log('info', 'started', { url, version: this.version, workers: this.settings.workers, queue: this.settings.queue !== null, keys: this.settings.keys.size });
    return { url, stop: () => (this.stopped ??= this.stop()) };
  }

  private async stop(): Promise<void> {
    this.stopping = true;
    this.log('info', 'stopping', { running: this.running.size });
    const closed = new Promise<void>((resolve) => this.server.close(() => resolve()));
    this.server.closeIdleConnections();
    const late = setTimeout(() => {
      this.log('warn', 'aborted', { running: this.running.size });
      for (const control of this.running) control.abort(new KerfwayError('stopping', 'The service stopped before the drawing was finished. Send it again.'));
      setTimeout(() => this.server.closeAllConnections(), 1_000).unref();
    }, this.settings.grace * 1000);
    await closed;
    clearTimeout(late);
    await this.backend.close();
    this.log('info', 'stopped');
  }

  private async handle(request: IncomingMessage, response: ServerResponse): Promise<void> {
    const begun = performance.now();
    const gone = new AbortController();
    response.on('close', () => {
      // An answer takes memory until its client has read it, so its place is free only then.
      this.running.delete(gone);
      if (!response.writableFinished) gone.abort(new KerfwayError('closed', 'The client has disconnected.'));
    });
    let route = 'other';
    let reply: Reply;
    try {
      const url = addressOf(request.url ?? '/');
      route = routeOf(url.pathname);
      reply = await this.reply(request, url, route, gone);
    } catch (error) {
      reply = this.failed(error, gone.signal);
    }
    if (this.wasUnreadable(request.socket)) return;
    if (gone.signal.aborted && reportOf(gone.signal.reason).code === 'closed') reply = { ...reply, status: CLIENT_LEFT };
    this.send(request, response, reply);
    // A refusal is small, so its place is free although the rest of its body still arrives.
    if (!request.complete) this.running.delete(gone);
    const seconds = (performance.now() - begun) / 1000;
    this.metrics.answered(route, reply.status, seconds, reply.code ?? null);
    const level = reply.status >= 500 ? 'error' : 'info';
    const [code, key] = [reply.code, this.keys.get(request)];
    this.log(level, 'request', { method: request.method, route, status: reply.status, ms: Math.round(seconds * 1000), ...(code !== undefined && { code }), ...(key !== undefined && { key }) });
  }

  private async reply(request: IncomingMessage, url: URL, route: string, gone: AbortController): Promise<Reply> {
    if (request.method === 'OPTIONS') return { status: 204, body: '' };
    const method = JOB_KINDS.includes(route as JobKind) ? 'POST' : 'GET';
    if (route === 'other') throw new KerfwayError('not-found', `There is nothing at this address: there are ${[...JOB_KINDS.map((k) => `POST /${k}`), 'GET /healthz', 'GET /metrics', 'GET /openapi.json'].join(', ')}.`);
    if (request.method !== method && !(method === 'GET' && request.method === 'HEAD')) throw new KerfwayError('method-not-allowed', `This address answers ${method}.`, { allow: method });
    if (route === 'healthz') return this.health();
    if (route === 'openapi') return ok(openapi(this.version, this.settings));
    const key = keyOf(request, this.settings.keys);
    if (key !== null) this.keys.set(request, key);
    if (route === 'metrics') return { status: 200, body: this.metrics.text(), type: 'text/plain; version=0.0.4; charset=utf-8' };
    if (route === 'jobs') return this.job(url.pathname.slice('/jobs/'.length), gone);
    return this.work(route as JobKind, request, url, gone);
  }

  private health(): Reply {
    const body = { status: this.stopping ? 'stopping' : 'ok', version: this.version, waiting: this.backend.waiting(), running: this.running.size };
    return { ...ok(body), status: this.stopping ? 503 : 200 };
  }

  private async job(id: string, gone: AbortController): Promise<Reply> {
    this.takePlace(gone);
    const found = /^[0-9a-f]{64}$/.test(id) ? await this.backend.find(id) : null;
    if (found === null) throw new KerfwayError('not-found', 'There is no such job, or its result has expired.');
    return { ...ok(found.body), status: found.status };
  }

  private async work(kind: JobKind, request: IncomingMessage, url: URL, gone: AbortController): Promise<Reply> {
    if (this.stopping) throw new KerfwayError('stopping', 'The service is about to stop. Send the drawing again in a moment.');
    // Bodies that are still arriving take memory, too, so they count before they are read.
    this.takePlace(gone);
    const before = this.arriving;
    this.arriving += 1;
    try {
      if (await this.backend.full(before)) throw busy();
      gone.signal.throwIfAborted();
      return await this.receive(kind, request, url, gone);
    } finally {
      this.arriving -= 1;
    }
  }

  private async receive(kind: JobKind, request: IncomingMessage, url: URL, gone: AbortController): Promise<Reply> {
    const { bytes, name, fields } = await uploadOf(request, this.settings);
    this.metrics.drawing(bytes.byteLength);
    const options = requestOptions(kind, url.searchParams, fields, this.settings);
    const job = {
      kind, name: safeName(url.searchParams.get('name') ?? fields.get('name') ?? (options['name'] as string | undefined) ?? name), options,
      thumbnails: thumbnailsIn(kind, url.searchParams), acceptGuess: acceptGuessIn(url.searchParams, fields),
      ...(kind === 'quote' && isUnbudgeted(options) ? { mostMoves: this.settings.mostMoves } : {}),
    };
    const answer = await this.backend.take(job, bytes, gone.signal);
    const headers: Record<string, string> = answer.status === 202 ? { location: `/jobs/${answer.body.id}` } : {};
    return { ...ok(answer.body), status: answer.status, headers };
  }

  /** Counts a request among those that are being answered, until its client has read the answer. */
  private takePlace(gone: AbortController): void {
    if (this.running.size >= this.settings.workers + this.settings.waiting) throw busy();
    // A client that has gone by now closes its response no second time.
    gone.signal.throwIfAborted();
    this.running.add(gone);
  }

  private failed(error: unknown, signal: AbortSignal): Reply {
    const report = reportOf(signal.aborted && !(error instanceof KerfwayError) ? signal.reason : error);
    // The sender can do nothing about it, so the details go to the log only.
    if (report.code === 'internal') this.log('error', 'fault', { message: report.message, stack: error instanceof Error ? error.stack : undefined });
    return failure(report);
  }

  private send(request: IncomingMessage, response: ServerResponse, { status, body, type = 'application/json; charset=utf-8', headers = {} }: Reply): void {
    const unread = !request.complete;
    // As bytes, because a text would be kept beside its bytes until all are sent.
    const bytes = Buffer.from(body);
    response.writeHead(status, {
      ...(status === 204 ? {} : { 'content-type': type, 'content-length': bytes.length }),
      'cache-control': 'no-store',
      'x-content-type-options': 'nosniff',
      ...this.cors(request),
      ...headers,
      // The rest of a refused body is not read, and a service that stops waits for no further request.
      ...(unread || this.stopping ? { connection: 'close' } : {}),
    });
    this.endUnread(request, response, bytes.length);
    const hasBody = status !== 204 && request.method !== 'HEAD';
    if (unread && hasBody && !request.destroyed) {
      response.write(bytes);
      // Node closes the connection at the end of the answer.
      dropRest(request, this.settings.upload * 1000, () => response.end());
    } else response.end(hasBody ? bytes : undefined);
  }

  /** Ends the connection of a client that does not read its answer: it would be kept for as long as the client likes. */
  private endUnread(request: IncomingMessage, response: ServerResponse, size: number): void {
    // A client that has left reads nothing, and closes nothing any more.
    if (response.destroyed) return;
    const seconds = this.settings.upload + size / READ_PER_SECOND;
    const late = setTimeout(() => {
      this.log('warn', 'unread', { bytes: size });
      request.socket.destroy();
    }, Math.min(seconds * 1000, LONGEST_TIMER));
    response.on('close', () => clearTimeout(late));
  }

  private cors(request: IncomingMessage): Record<string, string> {
    const { origin } = request.headers;
    const { cors } = this.settings;
    if (origin === undefined || !(cors.includes('*') || cors.includes(origin))) return cors.length > 0 ? { vary: 'origin' } : {};
    return {
      'access-control-allow-origin': cors.includes('*') ? '*' : origin,
      vary: 'origin',
      'access-control-expose-headers': 'retry-after, location',
      ...(request.method === 'OPTIONS' ? { 'access-control-allow-methods': 'GET, POST', 'access-control-allow-headers': 'authorization, content-type, x-api-key', 'access-control-max-age': '600' } : {}),
    };
  }
}

function busy(): KerfwayError {
  return new KerfwayError('busy', `Too many drawings wait. Try again in ${RETRY_AFTER} seconds.`, { retryAfter: RETRY_AFTER });
}

/** The address of a request: a path, or a whole address as for a proxy. What is neither is nothing that there is here. */
function addressOf(given: string): URL {
  const whole = given.startsWith('/') ? `http://service${given}` : given;
  return new URL(URL.canParse(whole) ? whole : 'http://service/');
}

function routeOf(path: string): string {
  if (JOB_KINDS.some((kind) => path === `/${kind}`)) return path.slice(1);
  if (path === '/healthz' || path === '/metrics') return path.slice(1);
  if (path === '/openapi.json') return 'openapi';
  return path.startsWith('/jobs/') ? 'jobs' : 'other';
}

function thumbnailsIn(kind: JobKind, query: URLSearchParams): number | null {
  const text = query.get('thumbnails');
  if (text === null || kind !== 'inspect') return null;
  const size = Number(text);
  if (Number.isInteger(size) && size >= 8 && size <= 1024) return size;
  throw new KerfwayError('out-of-range', `The option "thumbnails" is ${JSON.stringify(text.slice(0, 40))}. Give a whole number from 8 to 1024 pixels.`, { field: 'thumbnails', value: text.slice(0, 40), least: 8, most: 1024 });
}

function acceptGuessIn(query: URLSearchParams, fields: ReadonlyMap<string, string>): boolean {
  const text = query.get('acceptGuess') ?? fields.get('acceptGuess') ?? 'false';
  if (text === 'true' || text === 'false') return text === 'true';
  throw new KerfwayError('wrong-type', `The option "acceptGuess" is ${JSON.stringify(text.slice(0, 40))}. Give true or false.`, { field: 'acceptGuess' });
}

const ok = (body: object): Reply => ({ status: 200, body: JSON.stringify(body) });

function failure(report: ErrorReport): Reply {
  const retry = report.params['retryAfter'];
  const headers: Record<string, string> = {};
  if (retry !== undefined) headers['retry-after'] = String(retry);
  if (report.code === 'unauthorized') headers['www-authenticate'] = 'Bearer';
  if (report.code === 'method-not-allowed') headers['allow'] = String(report.params['allow'] ?? '');
  return { status: statusOf(report.code), body: JSON.stringify({ error: told(report) }), headers, code: report.code };
}
