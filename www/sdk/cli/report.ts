/** What people read of a command: all about one file, or a table with a row for each of several as it is done. */

import type { Place } from './batch.js';
import { print } from './io.js';
import { visible } from './safe-text.js';

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
    this.columns = [{ title: 'File', width: Math.max(4, ...files.map((f) => visible(f).length)) }, ...this.others];
  }

  async tell({ of }: Place, lines: () => readonly string[], cells: () => readonly string[]): Promise<void> {
    if (of === 1) return say(lines(), this.piped);
    if (!this.headed) await say([this.row(this.columns.map((c) => c.title))], this.piped);
    this.headed = true;
    await say([this.row(cells())], this.piped);
  }

  private row(cells: readonly string[]): string {
    const shown = cells.map(visible);
    const padded = this.columns.map(({ width, right }, k) => (right ? (shown[k] ?? '').padStart(width) : (shown[k] ?? '').padEnd(width)));
    return padded.join('  ').trimEnd();
  }
}

/** Prints lines for people; on standard error where standard output is for a program. */
export async function say(lines: readonly string[], piped: boolean): Promise<void> {
  const text = lines.map((line) => `${visible(line)}\n`).join('');
  if (piped) process.stderr.write(text);
  else await print(text);
}
