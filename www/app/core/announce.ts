/**
 * Polite announcements for screen readers. The answer to what somebody does is spoken at once. Updates on the search are spoken at most every two
 * seconds, and only the latest, so that it neither talks all the time nor takes the place of an answer.
 */

/** Milliseconds between an announcement and the next update. */
const PAUSE = 2000;

export class Announcer {
  private answer: string | null = null;
  private update: string | null = null;
  /** The last update that was spoken, which is not repeated. */
  private known = '';
  private spoken = -Infinity;
  private timer = 0;

  constructor(private readonly region: HTMLElement) {}

  /** Answers what somebody has just done. A newer answer replaces one of the same moment. */
  say(sentence: string): void {
    this.answer = sentence;
    this.wait(0);
  }

  /** Reports what goes on by itself. */
  report(sentence: string): void {
    this.update = sentence;
    if (this.answer === null) this.wait(Math.max(0, this.spoken + PAUSE - performance.now()));
  }

  private wait(time: number): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.speak(), time);
  }

  private speak(): void {
    const { answer, update } = this;
    if (answer !== null) {
      this.answer = null;
      this.put(answer);
      if (update !== null) this.wait(PAUSE);
    } else if (update !== null) {
      this.update = null;
      if (update !== this.known) this.put((this.known = update));
    }
  }

  private put(sentence: string): void {
    this.spoken = performance.now();
    this.region.textContent = sentence;
  }
}
