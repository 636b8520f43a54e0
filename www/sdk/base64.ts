/** Bytes as text in base64, where there may be no `Buffer`. */

/** The base64 text of bytes. */
export function base64(bytes: Uint8Array): string {
  // In pieces, because a call takes some ten thousand arguments at most.
  const PIECE = 0x2000;
  const pieces: string[] = [];
  for (let at = 0; at < bytes.length; at += PIECE) pieces.push(String.fromCharCode(...bytes.subarray(at, at + PIECE)));
  return btoa(pieces.join(''));
}
