// What the benches share: running one case in a process of its own, medians, and tables.

import { spawnSync } from 'node:child_process';
import { ENV, Stop } from '../../scripts/tools.mjs';

/** Runs a program; the JSON it printed, one value a line. */
export function rows(command, args) {
  const r = spawnSync(command, args, { env: ENV, encoding: 'utf8', maxBuffer: 1 << 28 });
  if (r.status !== 0) throw new Stop(`${command} ${args.join(' ')} failed:\n${r.stderr ?? r.error}`);
  return r.stdout.trim().split('\n').map((line) => JSON.parse(line));
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)];
}

export const mean = (values) => values.reduce((sum, v) => sum + v, 0) / values.length;

export const ms = (value) => `${value.toFixed(0)} ms`;
export const mb = (bytes) => (bytes / 1e6).toFixed(0);

export function table(title, columns, lines) {
  const widths = columns.map((c, i) => Math.max(c.length, ...lines.map((r) => r[i].length)));
  const line = (cells) => cells.map((c, i) => (i === 0 ? c.padEnd(widths[i]) : c.padStart(widths[i]))).join('  ').trimEnd();
  console.log(`\n${title}\n${line(columns)}\n${widths.map((w) => '-'.repeat(w)).join('  ')}`);
  for (const row of lines) console.log(line(row));
}
