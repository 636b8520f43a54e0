// Reads a request: checks the options in its query, and whether its body is a drawing at all. The queue example uses it too.

import { activeContours } from 'kerfway';

/** An unusable option, with one sentence for the person who sent it. */
export class OptionError extends Error {}

/** The answer to a form. */
export const FORM = 'The body is a form (multipart/form-data). Send the bytes of the DXF file alone as the body, and its name in the address: /quotes?name=plate.dxf.';
/** A drawing of one line, which every working planner can read. */
const PROBE = new TextEncoder().encode('0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n10\n21\n0\n0\nENDSEC\n0\nEOF\n');
/** The number of bytes that must contain the first header of a form's first part. */
const FORM_HEAD = 1024;
/** The longest name of a drawing: the limit of most file systems. */
const LONGEST_NAME = 255;
/** The allowed options. */
const FIELDS = ['name', 'machine', 'thickness', 'density'];

/** Reads the options of a quote from the query of a URL. Throws an `OptionError` that names the field. */
export function quoteOptions(query, machines) {
  const strange = Object.keys(query).find((field) => !FIELDS.includes(field));
  if (strange !== undefined) throw new OptionError(`There is no field ${JSON.stringify(strange)}: there are ${FIELDS.join(', ')}.`);
  const { name = 'drawing.dxf', machine = machines[0] } = query;
  if (typeof name !== 'string' || name.length > LONGEST_NAME) throw new OptionError(`The field name must be one text of at most ${LONGEST_NAME} characters.`);
  if (!machines.includes(machine)) throw new OptionError(`The field machine: there is no machine named ${machine}. Choose one of: ${machines.join(', ')}.`);
  const material = {};
  for (const [field, unit, example] of [['thickness', 'mm', 3], ['density', 'g/cm³', 1.19]]) {
    if (query[field] !== undefined) material[field] = positive(query[field], field, unit, example);
  }
  return { name, machine, material };
}

function positive(text, field, unit, example) {
  const value = typeof text === 'string' && text.trim() !== '' ? Number(text) : NaN;
  if (!(value > 0 && value < Infinity)) throw new OptionError(`The field ${field} must be a number above 0 in ${unit}, without its unit: ${field}=${example}.`);
  return value;
}

/** Whether a body is a form (multipart/form-data), regardless of its content type. A DXF reader might find a drawing inside one. */
export function isForm(body) {
  const head = Buffer.from(body.buffer, body.byteOffset, Math.min(body.length, FORM_HEAD)).toString('latin1');
  return /^(\r?\n)*--[^\r\n]+\r?\ncontent-disposition:\s*form-data/i.test(head);
}

/** Why a drawing cannot be used, in one sentence; `null` if the drawing is not the cause. */
export async function whyUnusable(pool, drawing, signal) {
  try {
    const { contours } = await pool.inspect(drawing, { signal });
    return activeContours({ contours }).length > 0 ? null : 'There is nothing to cut in this drawing.';
  } catch (error) {
    // The drawing is the cause if the planner can still read another one.
    return pool.inspect(PROBE, { signal }).then(() => error.message, () => null);
  }
}
