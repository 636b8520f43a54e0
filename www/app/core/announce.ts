/**
 * Polite live announcements: the newest sentence, at most one every two seconds, so that a planning run does not talk
 * over the person.
 */

/** Milliseconds between two announcements. */
const PAUSE = 2000;

export class Announcer {
  private waiting: string | null = null;
  private spoken = -Infinity;
  private timer = 0;

  constructor(private readonly region: HTMLElement) {}

  /** Says the sentence now, or when two seconds have passed since the last; a newer one takes its place. */
  say(sentence: string): void {
    this.waiting = sentence;
    if (this.timer) return;
    const wait = Math.max(0, this.spoken + PAUSE - performance.now());
    this.timer = window.setTimeout(() => this.speak(), wait);
  }

  private speak(): void {
    this.timer = 0;
    this.spoken = performance.now();
    if (this.waiting !== null) this.region.textContent = this.waiting;
    this.waiting = null;
  }
}
