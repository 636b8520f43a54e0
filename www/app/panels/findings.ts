/**
 * The findings by kind, the most severe first. A finding that has a place can be shown on the sheet. Warnings are amber triangles, errors
 * (things that cannot be cut as drawn) are red octagons.
 */

import { button, h, icon, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import { refill } from '../core/refill.js';
import { sentenceOf } from '../core/strings.js';
import type { Finding, Severity } from 'kerfway';
import { words } from '../core/words/index.js';

/** How many findings of one kind are listed before "and more": people do not read longer lists. */
const LISTED = 60;

const GRAVITY: Record<Severity, number> = { error: 0, warning: 1, info: 2 };
const ICONS = { error: 'error', warning: 'warning', info: 'info' } as const;

/** A choice that a finding offers. */
export interface Action {
  label: string;
  /** What it does, for those who do not see the finding beside it. */
  name: string;
  act: () => void;
}

export class FindingList {
  readonly root: HTMLDetailsElement;
  private readonly list = h('div', { class: 'findings' });
  private readonly head = h('span');
  private readonly buttons = new Map<Finding, HTMLButtonElement>();

  /** `actions` gives the choices that a finding offers. */
  constructor(private readonly onShow: (finding: Finding) => void, private readonly actions: (finding: Finding) => readonly Action[]) {
    this.root = h('details', { class: 'more' }, h('summary', {}, this.head), this.list);
  }

  show(findings: readonly Finding[]): void {
    this.buttons.clear();
    const problems = problemCounts(findings);
    setText(this.head, headline(problems.map((p) => p.text), kindsOf(findings, 'info')));
    this.root.classList.toggle('grave', problems.length > 0);
    this.root.classList.toggle('errors', problems[0]?.severity === 'error');
    this.root.hidden = findings.length === 0;
    const kinds = new Map<string, Finding[]>();
    for (const f of findings) {
      const key = `${GRAVITY[f.severity]}${f.code}`;
      const group = kinds.get(key);
      if (group) group.push(f);
      else kinds.set(key, [f]);
    }
    const ordered = [...kinds.keys()].sort((a, b) => Number(a[0]) - Number(b[0]));
    refill(this.list, ...ordered.map((key) => this.group(kinds.get(key)!)));
  }

  /** Opens the list and moves the focus to one finding. */
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
      h('summary', {}, mark(first.severity), h('span', {}, words.findingTitles[first.code](sum, count(sum)))),
      ...findings.slice(0, LISTED).map((f) => this.item(f)),
      findings.length > LISTED && h('p', { class: 'soft' }, words.findings.more(count(findings.length - LISTED))));
  }

  private item(finding: Finding): HTMLElement {
    const { text, detail } = sentenceOf(finding);
    const where = [finding.layer && words.findings.layer(finding.layer), finding.handle && words.findings.entity(finding.handle)].filter(Boolean).join(', ');
    const inner = [mark(finding.severity), h('span', { class: 'finding-text' }, h('span', {}, text), where ? h('span', { class: 'soft' }, ` ${where}`) : null, detail && h('span', { class: 'soft detail', lang: 'en' }, detail))];
    const actions = this.actions(finding).map(({ label, name, act }) => button(label, { class: 'small', 'aria-label': name, onclick: act }));
    const withActions = (item: HTMLElement) => (actions.length > 0 ? h('div', { class: 'finding-choice' }, item, h('div', { class: 'finding-actions' }, ...actions)) : item);
    if (!finding.at) return withActions(h('div', { class: 'finding' }, ...inner));
    const item = h('button', { type: 'button', class: 'finding', onclick: () => this.onShow(finding) }, ...inner, h('span', { class: 'show' }, words.findings.show));
    this.buttons.set(finding, item);
    return withActions(item);
  }
}

/** How many kinds of findings there are of a severity: 45 skipped texts are one issue. */
function kindsOf(findings: readonly Finding[], severity: Severity): number {
  return new Set(findings.filter((f) => f.severity === severity).map((f) => f.code)).size;
}

/** The errors and the warnings, each as a number in words; empty when there are neither. */
export function problemCounts(findings: readonly Finding[]): { severity: 'error' | 'warning'; text: string }[] {
  const [errors, warnings] = [kindsOf(findings, 'error'), kindsOf(findings, 'warning')];
  return [
    ...(errors > 0 ? [{ severity: 'error' as const, text: words.findings.errors(errors, count(errors)) }] : []),
    ...(warnings > 0 ? [{ severity: 'warning' as const, text: words.findings.warnings(warnings, count(warnings)) }] : []),
  ];
}

function headline(problems: readonly string[], notes: number): string {
  const noted = notes > 0 ? [words.findings.notes(notes, count(notes))] : [];
  return problems.length > 0 ? [...problems, ...noted].join(', ') : words.findings.nothingToDo(noted.join());
}

function mark(severity: Severity): HTMLElement {
  return h('span', { class: `mark ${severity}` }, icon(ICONS[severity]), h('span', { class: 'hidden' }, `${words.findings[severity]}: `));
}
