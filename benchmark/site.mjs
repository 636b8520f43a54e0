// The benchmark as static pages: a table for each track, and the gap over time of the instances that have a trace.

import { cpSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { HERE, listed, made } from './instances.mjs';
import { plot } from './plot.mjs';

const TRACKS = {
  CCP: 'Continuous cutting: each contour in one go, from any point',
  TIME: 'The same in seconds of rapid moves that start and end at rest',
  GTSP: 'One node of each set: instances of GTSPLIB, whose files are in the repository (benches/data/gtsplib) and not here',
  ECP: 'Endpoint cutting: a contour may be left and continued at ends of its lines and arcs',
  ICP: 'Intermittent cutting: a contour may be left and continued anywhere',
};

/** Writes index.html with everything it refers to into a folder. */
export async function site(folder) {
  made(folder);
  const { instances } = listed();
  const body = Object.entries(TRACKS).map(([track, title]) => section(track, title, instances.filter((e) => e.track === track)));
  writeFileSync(join(folder, 'index.html'), page([...body, curves()].join('\n')));
  for (const part of ['instances', 'best', 'instances.json', 'check.py', 'rules.py', 'README.md']) {
    cpSync(join(HERE, part), join(folder, part), { recursive: true });
  }
  console.log(`${join(folder, 'index.html')}: ${instances.length} instances`);
}

function section(track, title, entries) {
  const rows = entries.map(({ name, size, best, file, licence }) => {
    const gap = best?.bound ? `${(100 * (1 - best.bound / best.value)).toFixed(1)} %` : 'none';
    const value = (number) => number.toFixed(track === 'GTSP' ? 0 : 3);
    const plan = best ? `<a href="${best.plan}">${value(best.value)}</a>` : 'none yet';
    const instance = file.startsWith('..') ? name : `<a href="${file}">${name}</a>`;
    return row([instance, size, plan, best?.bound ? value(best.bound) : 'none', best ? gap : '', escaped(best?.by ?? ''), escaped(licence)]);
  });
  const head = ['instance', 'size', 'best known', 'lower bound', 'gap', 'found by', 'licence'].map((h) => `<th>${h}</th>`).join('');
  return `<h2 id="${track}">${track}</h2>\n<p>${title}.</p>\n<table><thead><tr>${head}</tr></thead><tbody>${rows.join('\n')}</tbody></table>`;
}

const row = (cells) => `<tr>${cells.map((c) => `<td>${c}</td>`).join('')}</tr>`;

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** Plots of all instances that have a trace. */
function curves() {
  const plots = listed().instances.flatMap(({ name, best }) => {
    const trace = join(HERE, 'traces', `${name}.json`);
    return best && existsSync(trace) ? [plot(name, JSON.parse(readFileSync(trace, 'utf8')), best.value)] : [];
  });
  return `<h2>Gap over time</h2>\n<p>How far Kerfway's plan is above the best known value, and how far the lower bound is below it, in per cent over seconds,
both on logarithmic scales: search and bound beside each other in wasm, in a thread each.</p>\n${plots.join('\n')}`;
}

function page(body) {
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>A benchmark of cutting paths</title>
<style>
:root { color-scheme: light dark; --muted: light-dark(#5b6470, #9aa4b2); --line: light-dark(#dde1e6, #333a44) }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; display: block; overflow-x: auto }
th, td { text-align: left; padding: .3rem .8rem .3rem 0; border-bottom: 1px solid var(--line); white-space: nowrap }
th { color: var(--muted); font-weight: 500 }
:is(th, td):is(:nth-child(2), :nth-child(3), :nth-child(4), :nth-child(5)) { text-align: right }
figure { display: inline-block; margin: 0 1rem 1rem 0; width: min(460px, 100%) }
svg text { font: 12px system-ui, sans-serif; fill: var(--muted) }
svg .grid { stroke: var(--line) } svg .line { fill: none; stroke-width: 2 }
svg .value { stroke: #2f7ed8 } svg .bound { stroke: #d8662f; stroke-dasharray: 5 3 }
svg text[class] { stroke: none }
</style>
<h1>A benchmark of cutting paths</h1>
<p>Frozen instances, the best plans known for them, and one checker: <a href="README.md">README.md</a> explains the rules, <a href="rules.py">rules.py</a>
decides by them, <a href="check.py">check.py</a> is its command, and <a href="instances.json">instances.json</a> has checksums and licences.</p>
${body}
</html>
`;
}
