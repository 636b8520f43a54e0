// The reference checker of the benchmark, run on a plan, and what its tests make plans and instances of.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { HERE } from '../../benchmark/instances.mjs';

const python = spawnSync('python3', ['--version']).status === 0;
export const NEEDS_PYTHON = { skip: !python && 'there is no Python' };

/** What the checker says to a plan for an instance of the benchmark, or for one in a file. */
export function checked(t, instance, plan) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, 'plan.json'), typeof plan === 'string' ? plan : JSON.stringify(plan));
  const named = typeof instance === 'string' ? ['--instance', instance] : [join(folder, 'instance.json')];
  if (typeof instance !== 'string') writeFileSync(join(folder, 'instance.json'), JSON.stringify(instance));
  const { stdout, stderr, status } = spawnSync('python3', [join(HERE, 'check.py'), ...named, join(folder, 'plan.json')], { encoding: 'utf8' });
  return { text: stdout.trim(), stderr, status };
}

/** An instance in which the head starts at the origin and does not return; piercing costs 5. */
export const instanceOf = (track, ...contours) => ({ track, home: [0, 0], closed: false, cost: { unit: 'mm', pierce: 5 }, contours });

/** A contour of straight lines, open unless it ends where it begins. */
export function outline(start, ...points) {
  return { start, closed: String(points.at(-1)) === String(start), inside: null, path: points.map((line) => ({ line })) };
}

export const pierce = { kind: 'pierce' };
export const air = (...to) => ({ kind: 'air', to });
export const along = (...points) => ({ kind: 'cut', path: points.map((line) => ({ line })) });
