/**
 * Makes text safe for a terminal. Names of files and layers, and texts from a drawing, may contain characters that move the
 * cursor, change colours, or reverse the direction of writing. All text that the command line prints for people passes here.
 */

/**
 * Control characters (C0, DEL, C1), the marks that change the direction of writing, and the separators that some terminals
 * treat as the end of a line.
 */
const UNSAFE = /[\u0000-\u001f\u007f-\u009f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/g;

/** Makes the unsafe characters of a line visible, for example as `\u001b`. */
export function visible(line: string): string {
  return line.replace(UNSAFE, written);
}

/** The same for several lines. JSON remains the same document, because it has these escapes. */
export function visibleText(text: string): string {
  return text.replace(UNSAFE, (character) => (character === '\n' ? character : written(character)));
}

function written(character: string): string {
  return `\\u${character.charCodeAt(0).toString(16).padStart(4, '0')}`;
}

/** Prints a sentence about an error on standard error. */
export function complain(sentence: string): void {
  process.stderr.write(`kerfway: ${visible(sentence)}\n`);
}
