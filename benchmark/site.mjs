// The benchmark as static pages: a table for each track, and the gap over time for instances whose plans were written at several times.

import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { HERE, listed } from './instances.mjs';

const TRACKS = {
  CCP: 'Continuous cutting: each contour in one go, from any point',
  TIME: 'The same in seconds of rapid moves that start and end at rest',
  GTSP: 'One node of each set (GTSPLIB)',
  ECP: 'Endpoint cutting: a contour may be left and continued at ends of its lines and arcs',
  ICP: 'Intermittent cutting: a contour may be left and continued anywhere',
};

/** Writes index.html with everything it refers to into a folder. */
export async function site(folder) {
  mkdirSync(folder, { recursive: true });
  const { instances } = listed();
  const body = Object.entries(TRACKS).map(([track, title]) => section(track, title, instances.filter((e) => e.track === track)));
  writeFileSync(join(folder, 'index.html'), page([...body, curves()].join('\n')));
  for (const part of ['instances', 'best', 'instances.json', 'check.py', 'gtsplib.py', 'README.md']) {
    cpSync(join(HERE, part), join(folder, part), { recursive: true });
  }
  console.log(`${join(folder, 'index.html')}: ${instances.length} instances`);
}

function section(track, title, entries) {
  const rows = entries.map(({ name, size, best, file, licence }) => {
    const gap = best?.bound ? `${(100 * (1 - best.bound / best.value)).toFixed(1)} %` : 'none';
    const plan = best ? `<a href="${best.plan}">${best.value.toFixed(3)}</a>` : 'none yet';
    const instance = file.startsWith('..') ? name : `<a href="${file}">${name}</a>`;
    return row([instance, size, plan, best?.bound?.toFixed(3) ?? 'none', best ? gap : '', escaped(best?.by ?? ''), escaped(licence)]);
  });
  const head = ['instance', 'size', 'best known', 'lower bound', 'gap', 'found by', 'licence'].map((h) => `<th>${h}</th>`).join('');
  return `<h2 id="${track}">${track}</h2>\n<p>${title}.</p>\n<table><thead><tr>${head}</tr></thead><tbody>${rows.join('\n')}</tbody></table>`;
}

const row = (cells) => `<tr>${cells.map((c) => `<td>${c}</td>`).join('')}</tr>`;

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** Gap to the best known over seconds, from traces/NAME.json: [[seconds, value], ...] of each program. */
function curves() {
  const from = join(HERE, 'traces');
  if (!existsSync(from)) return '';
  const best = new Map(listed().instances.map((e) => [e.name, e.best?.value]));
  const plots = readdirSync(from).sort().map((file) => {
    const name = file.replace('.json', '');
    return plot(name, JSON.parse(readFileSync(join(from, file), 'utf8')), best.get(name));
  });
  return `<h2>Gap over time</h2>\n<p>Per cent above the best known value over seconds, both on logarithmic scales.</p>\n${plots.join('\n')}`;
}

const [WIDTH, HEIGHT] = [460, 260];
/** Seconds, and per cent, at the ends of the axes. */
const [SECONDS, PER_CENT] = [[0.1, 100], [0.01, 100]];

function plot(name, programs, best) {
  const across = (s) => 50 + ((WIDTH - 130) * Math.log(s / SECONDS[0])) / Math.log(SECONDS[1] / SECONDS[0]);
  const up = (g) => HEIGHT - 30 - ((HEIGHT - 50) * Math.log(Math.max(g, PER_CENT[0]) / PER_CENT[0])) / Math.log(PER_CENT[1] / PER_CENT[0]);
  const marks = [
    ...[0.1, 1, 10, 100].map((s) => `<text x="${across(s)}" y="${HEIGHT - 12}" text-anchor="middle">${s} s</text>`),
    ...[0.01, 0.1, 1, 10, 100].map((g) => `<text x="44" y="${up(g) + 4}" text-anchor="end">${g} %</text><path class="grid" d="M50 ${up(g)}H${WIDTH - 80}"/>`),
  ];
  const lines = Object.entries(programs).map(([program, points], k) => {
    const steps = points.map(([s, value]) => [across(Math.min(Math.max(s, SECONDS[0]), SECONDS[1])), up(100 * (value / best - 1))]);
    const [x, y] = steps.at(-1);
    const d = steps.map(([a, b], i) => (i === 0 ? `M${a.toFixed(1)} ${b.toFixed(1)}` : `H${a.toFixed(1)}V${b.toFixed(1)}`)).join('');
    return `<path class="line c${k}" d="${d}H${WIDTH - 80}"/><text class="c${k}" x="${Math.max(x, WIDTH - 80) + 4}" y="${y + 4}">${escaped(program)}</text>`;
  });
  return `<figure><figcaption>${name}</figcaption><svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="Gap over time on ${name}">${marks.join('')}${lines.join('')}</svg></figure>`;
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
figure { display: inline-block; margin: 0 1rem 1rem 0; width: min(460px, 100%) }
svg text { font: 12px system-ui, sans-serif; fill: var(--muted) }
svg .grid { stroke: var(--line) } svg .line { fill: none; stroke-width: 2 }
.c0 { stroke: #2f7ed8 } .c1 { stroke: #d8662f } .c2 { stroke: #2fa36b } .c3 { stroke: #a347c9 } .c4 { stroke: #b58900 }
svg text[class] { stroke: none }
</style>
<h1>A benchmark of cutting paths</h1>
<p>Frozen instances, the best plans known for them, and one checker: <a href="README.md">README.md</a> has the rules, <a href="check.py">check.py</a>
decides, <a href="instances.json">instances.json</a> has checksums and licences.</p>
${body}
</html>
`;
}
