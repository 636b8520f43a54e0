/**
 * Text for a terminal. Names of files and layers, and texts from a drawing, may hold characters that move the cursor, change
 * colours, or reverse the direction of writing. Everything that the command line prints for people passes through here.
 */

/**
 * Control characters (C0, DEL, C1), the marks that change the direction of writing, and the separators that some terminals take for
 * the end of a line.
 */
const UNSAFE = /[\u0000-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/g;

/** One line in which every such character is written out, for example as `\u001b`. */
export function visible(line: string): string {
  return line.replace(UNSAFE, written);
}

/** Text of several lines, made visible like a single one. JSON stays the same document: it knows these escapes. */
export function visibleText(text: string): string {
  return text.replace(UNSAFE, (character) => (character === '\n' ? character : written(character)));
}

function written(character: string): string {
  return `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;
}

/** Prints one sentence about what went wrong on standard error. */
export function complain(sentence: string): void {
  process.stderr.write(`kerfway: ${visible(sentence)}\n`);
}
