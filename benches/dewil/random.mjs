// Random numbers of the sheets: mulberry32, the same everywhere.

export class Random {
  #state;

  constructor(seed) {
    this.#state = seed >>> 0;
  }

  /** An even number in [0, 1). */
  even() {
    this.#state = (this.#state + 0x6d2b79f5) >>> 0;
    let t = this.#state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  }

  /** A whole number below `n`. */
  below(n) {
    return Math.floor(this.even() * n);
  }

  /** A number from `a` to `b`, in whole millimetres: sides that are to coincide do so exactly. */
  between(a, b) {
    return a + this.below(b - a + 1);
  }
}
