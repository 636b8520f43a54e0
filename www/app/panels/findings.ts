/**
 * Findings by kind, the gravest first; those with a place can be shown on the sheet. Amber triangles for what to look
 * at, red octagons for what cannot be cut as drawn.
 */

import { h, icon, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import type { Finding, Severity } from 'kerfway';
import { words } from '../core/words/index.js';

/** Findings of a kind listed before "and more": a list people still read. */
const LISTED = 60;

const GRAVITY: Record<Severity, number> = { error: 0, warning: 1, info: 2 };
const ICONS = { error: 'error', warning: 'warning', info: 'info' } as const;

export class FindingList {
  readonly root: HTMLDetailsElement;
  private readonly list = h('div', { class: 'findings' });
  private readonly head = h('span');
  private readonly buttons = new Map<Finding, HTMLButtonElement>();

  constructor(private readonly onShow: (finding: Finding) => void) {
    this.root = h('details', { class: 'more' }, h('summary', {}, this.head), this.list);
  }

  show(findings: readonly Finding[]): void {
    this.buttons.clear();
    const grave = findings.filter((f) => f.severity !== 'info');
    setText(this.head, headline(grave.length, findings.length - grave.length));
    this.root.classList.toggle('grave', grave.length > 0);
    this.root.classList.toggle('errors', findings.some((f) => f.severity === 'error'));
    this.root.hidden = findings.length === 0;
    const kinds = new Map<string, Finding[]>();
    for (const f of findings) {
      const key = `${GRAVITY[f.severity]}${f.code}`;
      const group = kinds.get(key);
      if (group) group.push(f);
      else kinds.set(key, [f]);
    }
    const ordered = [...kinds.keys()].sort((a, b) => Number(a[0]) - Number(b[0]));
    this.list.replaceChildren(...ordered.map((key) => this.group(kinds.get(key)!)));
  }

  /** Opens the list at one finding. */
  reveal(finding: Finding): void {
    this.root.open = true;
    const item = this.buttons.get(finding);
    const group = item?.closest('details');
    if (group) group.open = true;
    item?.scrollIntoView({ block: 'nearest' });
    item?.focus({ preventScroll: true });
  }

  private group(findings: Finding[]): HTMLElement {
    const first = findings[0]!;
    if (findings.length === 1) return this.item(first);
    const sum = findings.reduce((n, f) => n + f.count, 0);
    return h('details', { class: 'finding-group' },
      h('summary', {}, mark(first.severity), h('span', {}, words.findingTitles[first.code]), h('span', { class: 'soft number' }, count(sum))),
      ...findings.slice(0, LISTED).map((f) => this.item(f)),
      findings.length > LISTED && h('p', { class: 'soft' }, words.findings.more(count(findings.length - LISTED))));
  }

  private item(finding: Finding): HTMLElement {
    const text = h('span', {}, finding.message);
    const where = [finding.layer && words.findings.layer(finding.layer), finding.handle && words.findings.entity(finding.handle)].filter(Boolean).join(', ');
    const inner = [mark(finding.severity), h('span', { class: 'finding-text' }, text, where ? h('span', { class: 'soft' }, ` ${where}`) : null)];
    if (!finding.at) return h('div', { class: 'finding' }, ...inner);
    const item = h('button', { type: 'button', class: 'finding', onclick: () => this.onShow(finding) }, ...inner, h('span', { class: 'show' }, words.findings.show));
    this.buttons.set(finding, item);
    return item;
  }
}

function headline(grave: number, notes: number): string {
  const parts = [grave > 0 && words.drawing.toLookAt(count(grave)), notes > 0 && words.drawing.notes(notes, count(notes))].filter(Boolean);
  return grave > 0 ? parts.join(', ') : words.drawing.nothingToDo(parts.join(''));
}

function mark(severity: Severity): HTMLElement {
  return h('span', { class: `mark ${severity}` }, icon(ICONS[severity]), h('span', { class: 'hidden' }, `${words.findings[severity]}: `));
}
