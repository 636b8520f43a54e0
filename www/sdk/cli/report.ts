/** What people read of a command: all about one file, or a table with a row for each of several as it is done. */

import type { Place } from './batch.js';
import { put } from './io.js';

/** Columns after that of the file. */
export interface Column {
  title: string;
  width: number;
  /** Numbers stand to the right. */
  right?: true;
}

export class Report {
  private columns: readonly Column[] = [];
  private headed = false;

  /** `piped`: standard output is for a program, so people read the other one. */
  constructor(
    private readonly piped: boolean,
    private readonly others: readonly Column[],
  ) {}

  begin(files: readonly string[]): void {
    this.columns = [{ title: 'File', width: Math.max(4, ...files.map((f) => f.length)) }, ...this.others];
  }

  async tell({ of }: Place, words: () => string, cells: () => readonly string[]): Promise<void> {
    if (of === 1) return this.say(words());
    if (!this.headed) await this.say(this.row(this.columns.map((c) => c.title)));
    this.headed = true;
    await this.say(this.row(cells()));
  }

  private row(cells: readonly string[]): string {
    const padded = this.columns.map(({ width, right }, k) => (right ? (cells[k] ?? '').padStart(width) : (cells[k] ?? '').padEnd(width)));
    return `${padded.join('  ').trimEnd()}\n`;
  }

  private async say(text: string): Promise<void> {
    if (this.piped) process.stderr.write(text);
    else await put('-', text);
  }
}
