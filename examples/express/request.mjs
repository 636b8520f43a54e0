// What a request asks for: the wishes in its address, checked, and whether its body is a drawing at all.

/** A wish that cannot be met, in one sentence for the person who sent it. */
export class WishError extends Error {}

/** The bytes in which the first header of a form's first part must stand. */
const FORM_HEAD = 1024;
/** The longest name of a drawing, as most file systems have it. */
const LONGEST_NAME = 255;
/** What may be wished for. */
const FIELDS = ['name', 'machine', 'thickness', 'density'];

/** The options of a quote from the query of an address. Throws a `WishError` that names the field. */
export function wishes(query, machines) {
  const strange = Object.keys(query).find((field) => !FIELDS.includes(field));
  if (strange !== undefined) throw new WishError(`There is no field ${JSON.stringify(strange)}: there are ${FIELDS.join(', ')}.`);
  const { name = 'drawing.dxf', machine = machines[0] } = query;
  if (typeof name !== 'string' || name.length > LONGEST_NAME) throw new WishError(`The field name must be one text of at most ${LONGEST_NAME} characters.`);
  if (!machines.includes(machine)) throw new WishError(`The field machine: there is no machine named ${machine}. Choose one of: ${machines.join(', ')}.`);
  const material = {};
  for (const [field, unit, example] of [['thickness', 'mm', 3], ['density', 'g/cm³', 1.19]]) {
    if (query[field] !== undefined) material[field] = positive(query[field], field, unit, example);
  }
  return { name, machine, material };
}

function positive(text, field, unit, example) {
  const value = typeof text === 'string' && text.trim() !== '' ? Number(text) : NaN;
  if (!(value > 0 && value < Infinity)) throw new WishError(`The field ${field} must be a number above 0 in ${unit}, without its unit: ${field}=${example}.`);
  return value;
}

/** Whether a body is a form (multipart/form-data), whatever type its sender named. A reader of DXF might find a drawing within one. */
export function isForm(body) {
  const head = Buffer.from(body.buffer, body.byteOffset, Math.min(body.length, FORM_HEAD)).toString('latin1');
  return /^(\r?\n)*--[^\r\n]+\r?\ncontent-disposition:\s*form-data/i.test(head);
}
