/** Receives the body of a request: a drawing alone, or a form with one. Size and time are limited while it arrives. */

import type { IncomingMessage } from 'node:http';
import { KerfwayError } from '../errors.js';

/** A drawing as it was sent. */
export interface Upload {
  bytes: Uint8Array;
  /** The name of the file, if the form has one. */
  name: string | null;
  /** The text fields of the form. */
  fields: ReadonlyMap<string, string>;
}

export interface BodyLimits {
  largest: number;
  upload: number;
}

/** The most parts of a form. A body of 20 MB could have hundreds of thousands, each of which costs an object. */
const MOST_PARTS = 32;
/** The longest text field of a form, in bytes. */
const LONGEST_FIELD = 2 ** 20;

/** Receives the body of a request. */
export async function uploadOf(request: IncomingMessage, limits: BodyLimits): Promise<Upload> {
  const type = request.headers['content-type'] ?? '';
  const encoding = request.headers['content-encoding'] ?? 'identity';
  if (encoding !== 'identity') throw new KerfwayError('unsupported-media-type', `The body is encoded as ${JSON.stringify(encoding.slice(0, 40))}. Send it as it is, without a content encoding.`);
  const bytes = await received(request, limits);
  if (/^multipart\/form-data\b/i.test(type)) return formOf(bytes, type);
  // Any other type is taken for a drawing, because browsers and programs send many: curl says x-www-form-urlencoded.
  if (/^multipart\//i.test(type)) {
    throw new KerfwayError('unsupported-media-type', 'Send the bytes of the drawing as the body, or a form (multipart/form-data) with the drawing as its file.');
  }
  if (looksLikeForm(bytes)) {
    throw new KerfwayError('unsupported-media-type', 'The body is a form, but its content type does not say so. Send it as multipart/form-data with its boundary, or send the bytes of the drawing alone.');
  }
  return { bytes, name: null, fields: new Map() };
}

/** Reads the body to its end. */
function received(request: IncomingMessage, { largest, upload }: BodyLimits): Promise<Buffer> {
  return new Promise((resolve, reject) => {
    const tooLarge = () => new KerfwayError('too-large', `The body has more than ${Number((largest / 2 ** 20).toPrecision(3))} MB, which is the limit of this service.`, { limit: largest });
    if (Number(request.headers['content-length'] ?? 0) > largest) return reject(tooLarge());
    const chunks: Buffer[] = [];
    let length = 0;
    const end = (error: KerfwayError | null) => {
      clearTimeout(timer);
      request.removeAllListeners('data');
      if (error === null) resolve(Buffer.concat(chunks));
      else reject(error);
      // The rest of a refused body may come for a while.
      chunks.length = 0;
    };
    const timer = setTimeout(() => end(new KerfwayError('slow-upload', `The body did not arrive within ${upload} seconds.`, { seconds: upload })), upload * 1000);
    request.on('data', (chunk: Buffer) => {
      length += chunk.length;
      if (length > largest) return end(tooLarge());
      chunks.push(chunk);
    });
    request.on('end', () => end(null));
    request.on('error', () => end(new KerfwayError('slow-upload', 'The connection ended before the body had arrived.')));
    request.on('close', () => end(request.complete ? null : new KerfwayError('slow-upload', 'The connection ended before the body had arrived.')));
  });
}

/** The boundary in the type of a form. The parser gets no other one, so that the parts that are counted are those that it reads. */
const BOUNDARY = /;\s*boundary=(?:"([\w'()+,./:=? -]{1,70})"|([\w'()+,./:=?-]{1,70}))\s*(?:;|$)/i;

/** Reads a form with Node's own parser. It must have exactly one file. */
async function formOf(bytes: Buffer, type: string): Promise<Upload> {
  const [, quoted, boundary = quoted] = BOUNDARY.exec(type) ?? [];
  const malformed = (sentence: string) => new KerfwayError('malformed-form', sentence);
  if (boundary === undefined) throw malformed('The content type of the form has no boundary.');
  if (partsOf(bytes, boundary) > MOST_PARTS) throw malformed(`The form has more than ${MOST_PARTS} parts. Send one file, and its options in one field.`);
  const form = await new Response(new Uint8Array(bytes), { headers: { 'content-type': `multipart/form-data; boundary="${boundary}"` } }).formData().catch(() => {
    throw malformed('The form cannot be read: its parts do not end as they should.');
  });
  const files: File[] = [];
  const fields = new Map<string, string>();
  for (const [name, value] of form) {
    if (typeof value !== 'string') files.push(value);
    else if (fields.has(name)) throw malformed(`The field ${JSON.stringify(name.slice(0, 40))} is given twice.`);
    else if (value.length > LONGEST_FIELD) throw malformed(`The field ${JSON.stringify(name.slice(0, 40))} is longer than ${LONGEST_FIELD} characters.`);
    else fields.set(name, value);
  }
  const [file, second] = files;
  if (file === undefined) throw malformed('The form has no file. Add the drawing as a file, in a field of any name.');
  if (second !== undefined) throw malformed('The form has more than one file. Send one drawing with each request.');
  return { bytes: new Uint8Array(await file.arrayBuffer()), name: file.name === '' ? null : file.name, fields };
}

function partsOf(bytes: Buffer, boundary: string): number {
  let parts = 0;
  for (let at = bytes.indexOf(`--${boundary}`); at >= 0 && parts <= MOST_PARTS + 1; at = bytes.indexOf(`--${boundary}`, at + boundary.length)) parts += 1;
  return parts - 1;
}

/** The number of bytes that must contain the first header of a form's first part. */
const FORM_HEAD = 1024;

/** Whether a body is a form although its type does not say so. A reader of drawings might find a drawing inside one. */
function looksLikeForm(body: Buffer): boolean {
  return /^(\r?\n)*--[^\r\n]+\r?\ncontent-disposition:\s*form-data/i.test(body.subarray(0, FORM_HEAD).toString('latin1'));
}

/** The longest name of a drawing: the limit of most file systems. */
const LONGEST_NAME = 255;

/** The name of a file as a sender gives it: without folders and control characters. */
export function safeName(given: string | null): string {
  const last = (given ?? '').split(/[\\/]/).at(-1) ?? '';
  const clean = last.replace(/[\u0000-\u001f\u007f-\u009f\u200e\u200f\u202a-\u202e\u2066-\u2069]/g, '').trim().slice(0, LONGEST_NAME);
  return clean === '' || clean === '.' || clean === '..' ? 'drawing.dxf' : clean;
}
