/** The report of a command for people: the details of a single file, or a table with a row for each of several files, with what an option has asked for under it. */

import type { Place } from './batch.js';
import { print } from './io.js';
import { visible } from './safe-text.js';

/** A column of the table, after that of the file name. */
export interface Column {
  title: string;
  width: number;
  /** Whether the cells are aligned to the right, as numbers are. */
  right?: true;
}

export class Report {
  private columns: readonly Column[] = [];
  private headed = false;

  /** `piped`: standard output has data for a program, so the report goes to standard error. `quiet`: there is no report. */
  constructor(
    private readonly piped: boolean,
    private readonly others: readonly Column[],
    private readonly quiet: boolean,
  ) {}

  begin(files: readonly string[]): void {
    this.columns = [{ title: 'File', width: files.reduce((most, f) => Math.max(most, visible(f).length), 4) }, ...this.others];
  }

  /** `under`: lines that have no column. */
  async add({ of }: Place, lines: () => readonly string[], cells: () => readonly string[], under: () => readonly string[] = () => []): Promise<void> {
    if (this.quiet) return;
    if (of === 1) return say(lines(), this.piped);
    if (!this.headed) await say([this.row(this.columns.map((c) => c.title))], this.piped);
    this.headed = true;
    await say([this.row(cells()), ...under().map((line) => `  ${line}`)], this.piped);
  }

  private row(cells: readonly string[]): string {
    const shown = cells.map(visible);
    const padded = this.columns.map(({ width, right }, k) => (right ? (shown[k] ?? '').padStart(width) : (shown[k] ?? '').padEnd(width)));
    return padded.join('  ').trimEnd();
  }
}

/** Prints lines for people, on standard error if standard output has data for a program. */
export async function say(lines: readonly string[], piped: boolean): Promise<void> {
  const text = lines.map((line) => `${visible(line)}\n`).join('');
  if (piped) process.stderr.write(text);
  else await print(text);
}
