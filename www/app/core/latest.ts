/**
 * Requests that may overlap, of which only the newest counts: `begin` returns a function that says whether its request is still the newest.
 */
export class Latest {
  private newest = 0;

  begin(): () => boolean {
    this.newest += 1;
    return this.watch();
  }

  /** The same of the request that is the newest now. */
  watch(): () => boolean {
    const request = this.newest;
    return () => request === this.newest;
  }
}
