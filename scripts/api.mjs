// npm run docs: the reference of the package, docs/api, written from the types it is built with. A page for each entry point.

import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { exportsOf, moduleOf } from './api/declarations.mjs';
import { DIST, main, ROOT } from './tools.mjs';

export const FOLDER = join(ROOT, 'docs', 'api');

/** Entry points with something to call, and what each is for. */
const ENTRIES = [
  ['kerfway', 'index.d.ts', 'functions, planners and pools, in a browser and in Node; every type'],
  ['kerfway/element', 'element/index.d.ts', '`<kerfway-planner>` and `<kerfway-quote>`'],
  ['kerfway/frame', 'frame/host.d.ts', "a host's side of the frame page"],
  ['kerfway/inline', 'inline.d.ts', 'the compiled planner inside JavaScript'],
];

const FUNCTIONS = 'Functions';
const TYPES = 'Types';

const pageOf = (entry) => `${entry.replace('/', '-')}.md`;
const NOTE = '<!-- Written by npm run docs from the types. Change those. -->';

/** The pages, by file name. */
export function pages() {
  const entries = ENTRIES.map(([name, file, about]) => ({ name, about, path: join(DIST, 'sdk', file), exports: exportsOf(join(DIST, 'sdk', file)) }));
  // A name that several entries export is told on the page of the first.
  const places = new Map();
  for (const entry of entries) {
    const own = [...entry.exports.values()].filter((d) => !places.has(d.name));
    entry.called = own.filter((d) => d.kind === 'const' || d.kind === 'function');
    entry.types = own.filter((d) => !entry.called.includes(d)).sort((a, b) => (a.name < b.name ? -1 : 1));
    // Headings of the same letters, as `quote` and `Quote`, are numbered by those who show Markdown.
    const seen = new Map();
    const anchor = (heading) => {
      const key = heading.toLowerCase();
      const n = seen.get(key) ?? 0;
      seen.set(key, n + 1);
      return n === 0 ? key : `${key}-${n}`;
    };
    for (const heading of [entry.name, FUNCTIONS]) anchor(heading);
    const page = pageOf(entry.name);
    for (const d of entry.called) places.set(d.name, { page, anchor: anchor(d.name) });
    anchor(TYPES);
    for (const d of entry.types) places.set(d.name, { page, anchor: anchor(d.name) });
  }
  const index = [NOTE, '', '# Reference', '', '| Import | |', '|---|---|', ...entries.map((e) => `| [\`${e.name}\`](${pageOf(e.name)}) | ${e.about} |`), '', 'How they are used: [embedding](../embedding.md).', ''];
  return new Map([['README.md', index.join('\n')], ...entries.map((e) => [pageOf(e.name), page(e, places)])]);
}

function page({ name, path, called, types }, places) {
  const to = { here: pageOf(name), places };
  const list = (declared) => declared.map((d) => `[${d.name}](${address(d.name, to)})`).join(' · ');
  const parts = [NOTE, '', `# \`${name}\``, '', linked(moduleOf(path).doc, to), ''];
  for (const [title, declared] of [[FUNCTIONS, called], [TYPES, types]]) {
    if (declared.length > 0) parts.push(`## ${title}`, '', list(declared), '', ...declared.flatMap((d) => told(d, to)));
  }
  return `${parts.join('\n').replace(/\n{3,}/g, '\n\n').trimEnd()}\n`;
}

function told(declared, to) {
  const { name, kind, doc, text, members } = declared;
  if (kind === 'const') return toldOf(declared, to);
  const parts = [`### ${name}`, '', linked(doc, to), ''];
  if (members.length === 0) return [...parts, code(text.replace(/^export (declare )?/gm, ''), to), ''];
  const head = text.split('\n')[0].replace(/^export (declare )?/, '').replace(/ \{$/, '');
  return [...parts, code(head, to), '', ...membersIn(members, to), ''];
}

/** `const plan: Entry['plan']`: as the member of that interface, which is where it is documented. */
function toldOf({ name, doc, path }, to) {
  const member = inheritedMember(join(path, '..', 'entry.d.ts'), name);
  return [`### ${name}`, '', linked(member.doc || doc.replace(/: see \{@link [^}]*\}/, ''), to), '', code(member.text, to), ''];
}

function inheritedMember(path, name) {
  for (const file of [path, join(path, '..', 'functions.d.ts')]) {
    for (const { members } of moduleOf(file).declared.values()) {
      const member = members.find((m) => m.name === name);
      if (member !== undefined) return member;
    }
  }
  throw new Error(`${name} is declared nowhere.`);
}

// Methods with long documentation are read better one below the other; plain data as a table.
function membersIn(members, to) {
  const long = members.some((m) => m.doc.includes('\n\n'));
  if (long) return members.flatMap((m) => [`**${m.name}**. ${linked(m.doc, to)}`, '', code(m.text, to), '']);
  const row = ({ name, text, doc }) => {
    const method = new RegExp(`^${name}[<(]`).test(text);
    const type = method ? text : text.replace(/^(?:(?:static|readonly|abstract|get) )*\w+(\?)?(\(\))?: /, (_, optional) => (optional ? 'optional ' : ''));
    return `| \`${name}\` | ${inline(type.replace(/;$/gm, ''), to)} | ${linked(doc, to).replaceAll('\n', ' ').replaceAll('|', '\\|')} |`;
  };
  return ['| | | |', '|---|---|---|', ...members.map(row)];
}

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

/** Code in which names of types lead to them. */
function withLinks(text, to) {
  return escaped(text).replace(/\b[A-Z]\w+\b/g, (name) => (to.places.has(name) ? `<a href="${address(name, to)}">${name}</a>` : name));
}

/** Where a name is told, seen from a page. */
function address(name, { here, places }) {
  const { page, anchor } = places.get(name);
  return `${page === here ? '' : page}#${anchor}`;
}

const code = (text, to) => `<pre>${withLinks(text.replace(/;$/, ''), to)}</pre>`;
const inline = (text, to) => `<code>${withLinks(text.replace(/\s*\n\s*/g, ' '), to).replaceAll('|', '&#124;')}</code>`;

function linked(doc, to) {
  return doc.replace(/\{@link (\w+)(\.\w+)?\}/g, (_, name, member = '') => (to.places.has(name) ? `[${name}${member}](${address(name, to)})` : `\`${name}${member}\``));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(() => {
    mkdirSync(FOLDER, { recursive: true });
    for (const file of readdirSync(FOLDER)) rmSync(join(FOLDER, file));
    for (const [file, text] of pages()) writeFileSync(join(FOLDER, file), text);
    console.log(`docs/api: ${readdirSync(FOLDER).map((f) => `${f} ${readFileSync(join(FOLDER, f), 'utf8').split('\n').length}`).join(', ')} lines`);
  });
}
