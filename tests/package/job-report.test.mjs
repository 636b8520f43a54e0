// The report of a job: one page with everything on it, in which nothing of the drawing is taken for markup.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { it } from 'node:test';
import { promisify } from 'node:util';
import { createPlanner, ENGLISH_REPORT, jobReport } from 'kerfway';
import { circle, dxf, folder, ROOT, square } from './support.mjs';

const CLI = join(ROOT, 'dist', 'sdk', 'cli.js');
const run = promisify(execFile);
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10), circle(20, 20, 5));

it('has the figures of the plan, each part, the order, and nothing that runs or loads', async (t) => {
  const planner = await createPlanner();
  t.after(() => planner.close());
  const loaded = await planner.load(PLATE, '<img src=x onerror=alert(1)>.dxf', { units: 'mm' });
  const { progress: { summary, path }, baselines, findings } = await planner.plan({ moves: 1000, seed: 3 }).done;
  const quote = await planner.quote({ material: { name: 'Steel & "co"', thickness: 3, density: 7.85 } });
  const page = jobReport({ loaded, summary, baselines, path, findings, quote, svg: await planner.output('svg'), date: new Date('2026-11-25T10:30:00Z') });
  assert.match(page, /^<!doctype html>/);
  assert.doesNotMatch(page, /<img src=x|<script|https?:(?!\/\/www\.w3\.org)/);
  assert.match(page, /&lt;img src=x onerror=alert\(1\)&gt;\.dxf/);
  assert.match(page, /Steel &amp; &quot;co&quot;, 3 mm/);
  assert.match(page, /<dt>Printed<\/dt><dd>2026-11-25 10:30<\/dd>/);
  assert.match(page, new RegExp(`<p class="time">${summary.total_time.toFixed(1)} s</p>`));
  assert.match(page, /<td>1<\/td><td>100 × 100 mm<\/td><td>96\.07 cm²<\/td><td>0\.49 m<\/td><td>2<\/td>/);
  const rows = [...page.matchAll(/<tr><td>(\d)<\/td><td>(\d)<\/td><td>0<\/td><td>([\d.]+) s<\/td>/g)].map((m) => Number(m[2]));
  assert.deepEqual(rows, [...path.contours]);
  assert.match(page, /<h2>Cutting order<\/h2><div class="order"><table>/);
  assert.match(page, /@media print \{.*\.order \{ columns: 2;/, 'hundreds of rows fill half as many sheets of paper');
  assert.deepEqual([40_790, 0.2].map(ENGLISH_REPORT.area), ['407.90 cm²', 'under 0.01 cm²'], 'areas below each other have the same decimals');
  assert.equal(ENGLISH_REPORT.duration(11_040), '3 h 04 min', 'as on the command line');
  const picture = Buffer.from(/base64,([^"]+)"/.exec(page)[1], 'base64').toString();
  assert.equal(picture, await planner.output('svg'));
});

it('names entries in the coordinates of the program: the command line had those of the drawing for a job that is placed elsewhere', async (t) => {
  const at = folder(t);
  const [file, page, program] = ['plate.dxf', 'plate.html', 'plate.nc'].map((name) => join(at, name));
  writeFileSync(file, PLATE);
  await run(process.execPath, [CLI, 'plan', file, '--units', 'mm', '--moves', '500', '--seed', '1', '--place', 'lower-left@100,200', '--report', page, '--gcode', program]);
  const [, x, y] = /G0 X([\d.]+) Y([\d.]+)\n.*cut contour/.exec(readFileSync(program, 'utf8'));
  const [, entry] = /<td>([\d.]+, [\d.]+)<\/td>/.exec(readFileSync(page, 'utf8').split('Entry, mm')[1]);
  assert.equal(entry, `${+(+x).toFixed(2)}, ${+(+y).toFixed(2)}`);
  assert.ok(x >= 100 && y >= 200, `${x}, ${y}`);
});

/** Contour and layer of each row of the order. */
const rowsOf = (page) => [...page.matchAll(/<tr><td>\d+<\/td><td>([^<]*)<\/td><td>([^<]*)<\/td><td>[\d.]+ s<\/td>/g)].map(([, contour, layer]) => `${contour} ${layer}`);

it('numbered contours from 1, and the program and the options from 0', async (t) => {
  const at = folder(t);
  const [file, page, program] = ['plate.dxf', 'plate.html', 'plate.nc'].map((name) => join(at, name));
  writeFileSync(file, dxf(square(0, 0, 100), circle(50, 50, 10), square(200, 0, 30, 'B')));
  const planned = async (...more) => {
    await run(process.execPath, [CLI, 'plan', file, '--units', 'mm', '--moves', '500', '--seed', '1', '--report', page, '--gcode', program, ...more]);
    return rowsOf(readFileSync(page, 'utf8'));
  };
  const rows = await planned();
  assert.deepEqual(rows, [...readFileSync(program, 'utf8').matchAll(/cut contour (\d+), layer (\w+)/g)].map(([, contour, layer]) => `${contour} ${layer}`));
  const [, other] = /(\d+) B/.exec(rows.join());
  assert.deepEqual((await planned('--exclude', other)).sort(), rows.filter((row) => row !== `${other} B`).sort());
  // All passes of a contour are one stop, or each is one: then they have the number of their contour.
  assert.deepEqual(await planned('--layer', '0=cut,passes=2'), rows.map((row) => row.replace(' 0', ' (2 times) 0')));
  const bySheet = await planned('--layer', '0=cut,passes=3', '--pass-order', 'sheet', '--kerf-width', '0.2', '--allow-off-bed');
  assert.deepEqual([...bySheet].sort(), ['0 (1/3) 0', '0 (2/3) 0', '0 (3/3) 0', '1 (1/3) 0', '1 (2/3) 0', '1 (3/3) 0', '2 B']);
  for (const contour of ['0', '1']) assert.deepEqual(bySheet.filter((row) => row.startsWith(contour)).map((row) => row[3]), ['1', '2', '3'], 'in the order in which they are cut');
});

it('lacked the values of the machine, and the checksum of the program that belongs to it', async (t) => {
  const at = folder(t);
  const [file, page, program] = ['plate.dxf', 'plate.html', 'plate.nc'].map((name) => join(at, name));
  writeFileSync(file, PLATE);
  const report = async (...more) => {
    await run(process.execPath, [CLI, 'plan', file, '--units', 'mm', '--moves', '500', '--kerf-width', '0.2', '--allow-off-bed', '--report', page, ...more]);
    return readFileSync(page, 'utf8');
  };
  const printed = await report('--gcode', program);
  assert.match(printed, /<dt>Machine<\/dt><dd>CO2 laser, 100 W, GRBL, 3 mm acrylic, 35 mm\/s<\/dd>.*<dt>Kerf width<\/dt><dd>0\.2 mm<\/dd>/s);
  const [, checksum] = /^; (checksum [0-9a-f]{16})$/m.exec(readFileSync(program, 'utf8'));
  assert.ok(printed.includes(` ${checksum}</footer>`), checksum);
  assert.doesNotMatch(await report(), /checksum/, 'there is no program');
});

it('is an output of the command line', async (t) => {
  const at = folder(t);
  writeFileSync(join(at, 'plate.dxf'), PLATE);
  await run(process.execPath, [CLI, 'plan', join(at, 'plate.dxf'), '--units', 'mm', '--moves', '500', '--report', `${at}/`, '--quiet']);
  assert.match(readFileSync(join(at, 'plate.html'), 'utf8'), /<h1>plate\.dxf<\/h1>/);
});
