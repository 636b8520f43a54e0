// How the value of a plan falls and its lower bound rises over the seconds, for the plots of the site.

export class Trace {
  /** Seconds since the start and value, whenever it changed. */
  values = [];
  /** The same of the lower bound. */
  bounds = [];
  #start = performance.now();
  /** Seconds of the job that every plan takes, such as those of cutting. The first plan tells them. */
  #always = null;

  /** A summary of the search: its best plan, and what it has proven itself. */
  found({ air_time: air, pierce_time: pierce, total_time: total, lower_bound: bound }) {
    this.#always ??= total - air - pierce;
    this.#note(this.values, air + pierce);
    this.proven(bound ?? 0);
  }

  /** No plan takes fewer seconds in all. */
  proven(seconds) {
    if (this.#always !== null) this.#note(this.bounds, Math.max(this.bound, seconds - this.#always));
  }

  /** The highest bound so far. */
  get bound() {
    return this.bounds.at(-1)?.[1] ?? 0;
  }

  /** Values closer than a millionth are the same, as sums of the same moves may be rounded differently. */
  #note(points, sum) {
    const value = Number(sum.toFixed(6));
    if (points.at(-1)?.[1] !== value) points.push([Number(((performance.now() - this.#start) / 1000).toFixed(3)), value]);
  }
}
