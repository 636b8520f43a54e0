// Reads the emitted declarations (.d.ts) of the package: what each module declares, with its documentation, and what it
// exports. The compiler writes them in one shape, which is all that is understood here; anything else stops with a word.

import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { Stop } from '../tools.mjs';

const modules = new Map();

/** A module: `doc`, `declared` (by name), `exports` (names it exports itself), `from` (what it passes on of others). */
export function moduleOf(path) {
  if (!modules.has(path)) modules.set(path, read(path));
  return modules.get(path);
}

/** Everything an entry point exports, by name. */
export function exportsOf(path) {
  const module = moduleOf(path);
  const all = new Map(module.exports.map((name) => [name, module.declared.get(name)]));
  for (const { names, file } of module.from) {
    const other = resolve(dirname(path), file.replace(/\.js$/, '.d.ts'));
    for (const [name, declared] of exportsOf(other)) if (names === null || names.includes(name)) all.set(name, declared);
  }
  return all;
}

function read(path) {
  const lines = readFileSync(path, 'utf8').split('\n');
  const module = { path, doc: '', declared: new Map(), exports: [], from: [] };
  let doc = null;
  for (let k = 0; k < lines.length; ) {
    const line = lines[k];
    if (line.startsWith('/**')) {
      // Two in a row, or one before imports: the first is that of the module.
      if (doc !== null && module.doc === '') module.doc = doc;
      [doc, k] = docAt(lines, k);
      continue;
    }
    const [text, next] = statementAt(lines, k);
    k = next;
    if (text === '') continue;
    const from = /^export (?:type )?(\*|\{(.*)\}) from '(.*)';$/s.exec(text);
    const declared = /^(export )?(?:declare )?(?:abstract )?(interface|class|type|const|function) (\w+)/.exec(text);
    if (from !== null) {
      const names = from[1] === '*' ? null : from[2].split(',').map((n) => n.trim().replace(/^type /, '')).filter(Boolean);
      module.from.push({ names, file: from[3] });
    } else if (declared !== null) {
      const [, exported, kind, name] = declared;
      const before = module.declared.get(name);
      // A function declared more than once has more than one way to be called.
      if (before !== undefined) before.text += `\n${text}`;
      else module.declared.set(name, { name, kind, text, doc: doc ?? '', members: membersOf(kind, text), path });
      if (exported && before === undefined) module.exports.push(name);
    } else if (!/^(import |export \{\}|declare global|#!)/.test(text)) throw new Stop(`${path}: what is "${text.slice(0, 60)}"?`);
    if (declared === null && doc !== null && module.doc === '') module.doc = doc;
    doc = null;
  }
  return module;
}

/** Public members of an interface or class, with their documentation; ways to call a method stand together. */
function membersOf(kind, text) {
  if (kind !== 'interface' && kind !== 'class') return [];
  const lines = text.split('\n').slice(1, -1).map((l) => l.slice(4));
  const members = [];
  let doc = null;
  for (let k = 0; k < lines.length; ) {
    if (lines[k].startsWith('/**')) {
      [doc, k] = docAt(lines, k);
      continue;
    }
    const [member, next] = statementAt(lines, k);
    k = next;
    const name = /^(?:(?:static|readonly|abstract|get|set) )*(\w+)/.exec(member)?.[1];
    const hidden = /^(private|protected|constructor)\b/.test(member) || /Callback$|^observedAttributes$/.test(name ?? '');
    if (!hidden && name !== undefined) {
      const before = members.find((m) => m.name === name);
      if (before === undefined) members.push({ name, text: member, doc: doc ?? '' });
      else if (!member.startsWith('set ')) before.text += `\n${member}`;
    }
    doc = null;
  }
  return members;
}

/** From one line to where its brackets are closed and it ends. */
function statementAt(lines, k) {
  let text = '';
  for (let depth = 0; k < lines.length; ) {
    const line = lines[k];
    k += 1;
    text += `${text === '' ? '' : '\n'}${line}`;
    const code = line.replace(/\/\*\*.*?\*\/|^\s*\*.*|'[^']*'|=>/g, '');
    for (const c of code) depth += '{(['.includes(c) ? 1 : '})]'.includes(c) ? -1 : 0;
    const block = /^(export )?(declare )?(abstract )?(interface|class|global) /.test(text);
    if (text === '' || (depth === 0 && (block ? /\}$/ : /;$|^#!/).test(line))) break;
  }
  return [text, k];
}

function docAt(lines, k) {
  const end = lines.findIndex((line, i) => i >= k && line.trimEnd().endsWith('*/'));
  const inner = lines.slice(k, end + 1).join('\n').replace(/^\/\*\*/, '').replace(/\*\/\s*$/, '');
  return [inner.split('\n').map((line) => line.replace(/^\s*\* ?/, '')).join('\n').trim(), end + 1];
}
