/** Opens the list of keys, which is loaded when somebody asks for it for the first time. */

import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';

export class Help {
  private readonly latest = new Latest();
  private isLoading = false;

  /** `failed` gets the reason if the list cannot be loaded. */
  constructor(private readonly failed: (sentence: string) => void) {}

  /** Opens the list once, however often somebody asks while it is being loaded. */
  async open(): Promise<void> {
    const isLatest = this.latest.begin();
    this.isLoading = true;
    try {
      const { showHelp } = await import('../panels/help.js');
      if (isLatest()) showHelp();
    } catch (error) {
      if (isLatest()) this.failed(messageOf(error));
    }
    if (isLatest()) this.isLoading = false;
  }

  /** Gives up a list that is still being loaded, and says whether there was one. */
  cancel(): boolean {
    const wasLoading = this.isLoading;
    this.latest.begin();
    this.isLoading = false;
    return wasLoading;
  }
}
