/** Small choices that stay in this browser. Private windows have no storage: a choice then lasts as long as the page. */

/** The choice of a key, if it is one of these. */
export function kept<T extends string>(key: string, known: readonly T[]): T | null {
  try {
    const value = localStorage.getItem(key);
    return known.find((k) => k === value) ?? null;
  } catch {
    return null;
  }
}

/** Keeps a choice. Returns whether the browser does. */
export function keep(key: string, value: string): boolean {
  try {
    localStorage.setItem(key, value);
    return true;
  } catch {
    return false;
  }
}
