/**
 * Findings by kind, the gravest first; those with a place can be shown on the sheet. Amber triangles for what to look
 * at, red octagons for what cannot be cut as drawn.
 */

import { h, icon, setText } from '../core/dom.js';
import { count, counted } from '../core/format.js';
import { FINDING_TITLES } from '../core/strings.js';
import type { Finding, Severity } from 'kerfway';

/** Findings of a kind listed before "and more": a list people still read. */
const LISTED = 60;

const GRAVITY: Record<Severity, number> = { error: 0, warning: 1, info: 2 };
const ICONS = { error: 'error', warning: 'warning', info: 'info' } as const;
const SPOKEN = { error: 'Error', warning: 'Warning', info: 'Note' };

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
      h('summary', {}, mark(first.severity), h('span', {}, `${FINDING_TITLES[first.code] ?? first.code}`), h('span', { class: 'soft number' }, count(sum))),
      ...findings.slice(0, LISTED).map((f) => this.item(f)),
      findings.length > LISTED && h('p', { class: 'soft' }, `And ${count(findings.length - LISTED)} more: they are marked on the sheet.`));
  }

  private item(finding: Finding): HTMLElement {
    const text = h('span', {}, finding.message);
    const where = [finding.layer && `layer ${finding.layer}`, finding.handle && `entity ${finding.handle}`].filter(Boolean).join(', ');
    const inner = [mark(finding.severity), h('span', { class: 'finding-text' }, text, where ? h('span', { class: 'soft' }, ` ${where}`) : null)];
    if (!finding.at) return h('div', { class: 'finding' }, ...inner);
    const item = h('button', { type: 'button', class: 'finding', onclick: () => this.onShow(finding) }, ...inner, h('span', { class: 'show' }, 'show'));
    this.buttons.set(finding, item);
    return item;
  }
}

function headline(grave: number, notes: number): string {
  const parts = [grave > 0 && `${count(grave)} to look at`, notes > 0 && counted(notes, 'note')].filter(Boolean);
  return grave > 0 ? parts.join(', ') : `${parts.join('')}, nothing to do`;
}

function mark(severity: Severity): HTMLElement {
  return h('span', { class: `mark ${severity}` }, icon(ICONS[severity]), h('span', { class: 'hidden' }, `${SPOKEN[severity]}: `));
}
