/** Describes the service as OpenAPI 3.1. The options come from the tables that check them, so that both say the same. */

import { optional, type Field, type Kind, type Range } from '../check.js';
import { SHAPES } from '../fields.js';
import { MOST_THUMBNAILS } from './jobs.js';
import { fieldsOf, JOB_KINDS, type JobKind } from './request-options.js';
import type { ServerSettings } from './settings.js';

type Schema = Record<string, unknown>;

const SUMMARY: Record<JobKind, string> = {
  inspect: 'Describes a drawing without planning it: contours, parts, layers, units, findings (kerfway.inspect/1).',
  plan: 'Plans a drawing and writes it in the formats asked for (kerfway.planned/1).',
  quote: 'Plans a drawing and reports what a price needs (kerfway.quote/2).',
};

/** The document. With a queue, work is answered later. */
export function openapi(version: string, settings: ServerSettings): Schema {
  const [queued, keys] = [settings.queue !== null, settings.keys.size > 0];
  const security = keys ? [{ bearer: [] }, { key: [] }] : [];
  const fieldsIn = (kind: JobKind) => fieldsOf(kind).map((field) => limited(field, settings));
  return {
    openapi: '3.1.0',
    info: { title: 'Kerfway', version, description: 'Plans the path of a laser cutter, and quotes jobs. Lengths in mm, areas in mm2, times in s, weights in g.', license: { name: 'MIT', identifier: 'MIT' } },
    servers: [{ url: '/' }],
    paths: {
      ...Object.fromEntries(JOB_KINDS.map((kind) => [`/${kind}`, { post: operation(kind, fieldsIn(kind), queued, security) }])),
      ...(queued ? { '/jobs/{id}': { get: jobOperation(security) } } : {}),
      '/healthz': { get: { operationId: 'healthz', summary: 'Whether the service accepts work.', security: [], responses: { 200: json('It does.', ref('Health')), 503: json('It is about to stop.', ref('Health')) } } },
      '/metrics': { get: { operationId: 'metrics', summary: 'Figures for Prometheus.', security, responses: { 200: { description: 'Text format of Prometheus.', content: { 'text/plain': { schema: { type: 'string' } } } }, ...failures([401]) } } },
      '/openapi.json': { get: { operationId: 'openapi', summary: 'This document.', security: [], responses: { 200: json('OpenAPI 3.1.', { type: 'object' }) } } },
    },
    components: {
      ...(keys ? { securitySchemes: { bearer: { type: 'http', scheme: 'bearer' }, key: { type: 'apiKey', in: 'header', name: 'X-API-Key' } } } : {}),
      schemas: {
        Error: {
          type: 'object', required: ['error'],
          properties: { error: { type: 'object', required: ['code', 'message', 'params', 'retryable'], properties: { code: { type: 'string' }, message: { type: 'string' }, params: { type: 'object', additionalProperties: true }, retryable: { type: 'boolean' } } } },
        },
        Health: { type: 'object', required: ['status', 'version', 'waiting', 'running'], properties: { status: { enum: ['ok', 'stopping'] }, version: { type: 'string' }, waiting: { type: 'integer' }, running: { type: 'integer' } } },
        Job: { type: 'object', required: ['id', 'state'], properties: { id: { type: 'string' }, state: { type: 'string' } } },
        Report: { type: 'object', required: ['schema'], properties: { schema: { type: 'string' } }, additionalProperties: true },
        ...Object.fromEntries(JOB_KINDS.map((kind) => [optionsName(kind), objectOf([NAME, ...fieldsIn(kind)])])),
        Machine: machineSchema(),
      },
    },
  };
}

/** A field with the limit of this service, where that is below the one of the package. */
function limited(field: Field, { mostSeconds, mostMoves }: ServerSettings): Field {
  const { name, kind } = field;
  const within = (range: Range, most: number) => ({ ...range, most: Math.min(range.most, most) });
  if (name === 'seconds' && typeof kind === 'object' && 'number' in kind) return { ...field, kind: { number: within(kind.number, mostSeconds) } };
  if (name === 'moves' && typeof kind === 'object' && 'whole' in kind) return { ...field, kind: { whole: within(kind.whole, mostMoves) } };
  return field;
}

function operation(kind: JobKind, fields: readonly Field[], queued: boolean, security: unknown[]): Schema {
  const simple = fields.filter((f) => isSimple(f.kind));
  const parameter = (name: string, schema: Schema, description: string) => ({ name, in: 'query', required: false, schema, description });
  return {
    operationId: kind,
    summary: SUMMARY[kind],
    security,
    parameters: [
      parameter('name', { type: 'string', maxLength: 255 }, 'Name of the file, for reports.'),
      ...(kind === 'inspect' ? [parameter('thumbnails', { type: 'integer', minimum: 8, maximum: 1024 }, `Adds an SVG of each part, of this size in pixels; of more than ${MOST_THUMBNAILS} parts, of the first ${MOST_THUMBNAILS}.`)] : []),
      ...(kind === 'plan' ? [parameter('acceptGuess', { type: 'boolean' }, 'Writes programs although the unit of the drawing is in doubt.')] : []),
      ...simple.map((f) => parameter(f.name, schemaOf(f), `The option ${f.name}.`)),
      { name: 'options', in: 'query', required: false, description: 'All options as JSON.', content: { 'application/json': { schema: ref(optionsName(kind)) } } },
    ],
    requestBody: {
      required: true,
      content: {
        'application/octet-stream': { schema: { type: 'string', format: 'binary' } },
        'image/vnd.dxf': { schema: { type: 'string', format: 'binary' } },
        'multipart/form-data': { schema: { type: 'object', required: ['drawing'], properties: { drawing: { type: 'string', format: 'binary' }, options: { type: 'string', description: `JSON of ${optionsName(kind)}.` } } } },
      },
    },
    responses: {
      ...(queued ? { 202: json('The job is in the queue; its result will be at the address in Location.', ref('Job')) } : { 200: json('The result.', ref('Report')) }),
      ...failures([400, 401, 408, 413, 415, ...(queued ? [] : [422, 504]), 429, 500, 503]),
    },
  };
}

function jobOperation(security: unknown[]): Schema {
  return {
    operationId: 'job',
    summary: 'The result of a job.',
    security,
    parameters: [{ name: 'id', in: 'path', required: true, schema: { type: 'string', pattern: '^[0-9a-f]{64}$' } }],
    responses: { 200: json('The result.', ref('Report')), 202: json('It is not finished.', ref('Job')), ...failures([401, 404, 422, 429, 500, 503]) },
  };
}

const WHY: Record<number, string> = {
  400: 'An option or the form is wrong.', 401: 'The key is missing or unknown.', 404: 'There is no such job, or its result has expired.', 408: 'The body arrived too slowly.',
  413: 'The body is too large.', 415: 'The body is no drawing and no form with one.', 422: 'The drawing cannot be used.', 429: 'Too many requests wait; Retry-After says when to try again.',
  500: 'A fault of the service.', 503: 'The service is about to stop, or its queue does not answer.', 504: 'The drawing took too long.',
};

function failures(statuses: readonly number[]): Schema {
  return Object.fromEntries(statuses.map((status) => [status, {
    ...json(WHY[status] ?? '', ref('Error')),
    ...(status === 429 ? { headers: { 'Retry-After': { description: 'Seconds.', schema: { type: 'integer' } } } } : {}),
  }]));
}

/** The name of the drawing's file, which the options may have as well. */
const NAME = optional('name', 'text');

const optionsName = (kind: JobKind) => `${kind[0]?.toUpperCase()}${kind.slice(1)}Options`;
const ref = (name: string): Schema => ({ $ref: `#/components/schemas/${name}` });
const json = (description: string, schema: Schema): Schema => ({ description, content: { 'application/json': { schema } } });

function isSimple(kind: Kind): boolean {
  return kind === 'flag' || kind === 'text' || (typeof kind === 'object' && ('choice' in kind || 'number' in kind || 'whole' in kind || 'nameOr' in kind));
}

function schemaOf({ kind }: Pick<Field, 'kind'>): Schema {
  if (kind === 'flag') return { type: 'boolean' };
  if (kind === 'text') return { type: 'string' };
  if (typeof kind === 'string') return { type: 'object', additionalProperties: true };
  if ('choice' in kind) return { type: 'string', enum: [...kind.choice] };
  if ('number' in kind || 'whole' in kind) {
    const range = 'number' in kind ? kind.number : kind.whole;
    const limits: Schema = { minimum: range.or_zero ? 0 : range.least, maximum: range.most };
    return { type: 'whole' in kind ? 'integer' : 'number', ...limits, ...(range.unit === '' ? {} : { description: `${range.unit}; ${range.why}.` }) };
  }
  if ('pair' in kind) return { type: 'array', items: schemaOf({ kind: kind.pair }), minItems: 2, maxItems: 2 };
  if ('four' in kind) return { type: 'array', items: schemaOf({ kind: kind.four }), minItems: 4, maxItems: 4 };
  if ('list' in kind) return { type: 'array', items: schemaOf({ kind: kind.list }) };
  if ('object' in kind) return objectOf(kind.object);
  return { oneOf: [{ type: 'string' }, ref('Machine')] };
}

function objectOf(fields: readonly Field[]): Schema {
  const required = fields.filter((f) => f.required).map((f) => f.name);
  const property = (f: Field): Schema => (f.nullable ? { oneOf: [schemaOf(f), { type: 'null' }] } : schemaOf(f));
  return { type: 'object', additionalProperties: false, ...(required.length > 0 ? { required } : {}), properties: Object.fromEntries(fields.map((f) => [f.name, property(f)])) };
}

function machineSchema(): Schema {
  const machine = SHAPES.planning.fields.find((f) => f.name === 'machine')?.kind;
  return typeof machine === 'object' && 'nameOr' in machine ? objectOf(machine.nameOr.fields) : { type: 'object' };
}
