/** The choices that findings offer: the border of the sheet is cut or ignored, and lettering is cut, marked or ignored. */

import type { Finding, Group, Operation } from 'kerfway';
import { words } from '../core/words/index.js';
import type { Session } from '../session/session.js';
import type { Action } from './findings.js';

const OPERATIONS: readonly Operation[] = ['cut', 'mark', 'ignore'];

export function findingActions(session: Session, { code }: Finding): Action[] {
  if (code === 'sheet-outline') return border(session);
  return code === 'lettering' || code === 'leaders' ? group(session, code) : [];
}

function border(session: Session): Action[] {
  const { load, loaded } = session.state;
  const { keepBorder: keep, ignoreBorder: ignore } = words.findings.actions;
  const cut: Action = { label: keep, name: keep, act: () => session.drawing.change({ keepBorder: true, ignoreOutline: false }) };
  const drop: Action = { label: ignore, name: ignore, act: () => session.drawing.change({ keepBorder: false, ignoreOutline: true }) };
  if (load.keepBorder) return [drop];
  // The border is among the contours as long as it is not ignored.
  return loaded?.outline === null ? [cut] : [drop, cut];
}

function group(session: Session, name: Group): Action[] {
  const groups = () => session.state.load.groups ?? [];
  const now = groups().findLast((g) => g.name === name)?.operation ?? 'cut';
  return OPERATIONS.filter((operation) => operation !== now).map((operation) => ({
    label: words.findings.actions[operation],
    name: words.findings.act(words.findings.actions[operation], words.findings.group[name]),
    act: () => session.drawing.change({ groups: [...groups().filter((g) => g.name !== name), { name, operation }] }),
  }));
}
