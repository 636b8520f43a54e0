/**
 * Fills an element again under the hands of a person: the control that has the focus keeps it, the field that is typed into stays the same element,
 * and what is opened or scrolled stays so.
 */

const CONTROLS = 'button, select, input, summary';

/** By what a control, a disclosure or a list is known again. */
const nameOf = (e: Element) => `${e.tagName} ${e.getAttribute('aria-label') ?? (e.matches('button, summary') ? e.textContent : e.className)}`;

/** The like of an element among others: of those that have its name, the one with the same number. */
function twinOf(old: Element, before: readonly HTMLElement[], after: readonly HTMLElement[]): HTMLElement | undefined {
  const like = (e: Element) => nameOf(e) === nameOf(old);
  return after.filter(like)[before.filter(like).indexOf(old as HTMLElement)];
}

/** Replaces the children of an element. What listeners of text fields do must not depend on the data of one filling. */
export function refill(root: Element, ...children: (Node | string)[]): void {
  const old = [...root.childNodes];
  const before = [...root.querySelectorAll<HTMLElement>('*')];
  const open = before.filter((e) => e.matches('details[open]') && e.firstElementChild !== null);
  const scrolled = before.filter((e) => e.scrollTop + e.scrollLeft > 0).map((e) => [e, e.scrollTop, e.scrollLeft] as const);
  const focused = before.find((e) => e === document.activeElement && e.matches(CONTROLS));
  root.append(...children);
  const after = [...root.querySelectorAll<HTMLElement>('*')].slice(before.length);
  for (const e of open) twinOf(e.firstElementChild!, before, after)?.parentElement?.setAttribute('open', '');
  if (focused) keepFocus(focused, before, after);
  for (const node of old) (node as ChildNode).remove();
  for (const [e, top, left] of scrolled) twinOf(e, before, after)?.scrollTo(left, top);
}

/** The focus goes to the stage before what has it disappears: the next key acts there, and the next tab goes on from there. */
export function leave(root: Element): void {
  if (root.contains(document.activeElement)) document.getElementById('canvas')?.focus();
}

function keepFocus(focused: HTMLElement, before: readonly HTMLElement[], after: readonly HTMLElement[]): void {
  const controls = after.filter((e) => e.matches(CONTROLS));
  const twin = twinOf(focused, before, after);
  if (!twin || !focused.matches('input:not([type=checkbox])')) {
    // Where a control is gone, the one in its place: the next key acts where the person is.
    const place = before.filter((e) => e.matches(CONTROLS)).indexOf(focused);
    const next = twin ?? controls[Math.min(place, controls.length - 1)];
    if (next) next.focus({ preventScroll: true });
    else leave(focused);
    return;
  }
  // What is typed has no other place than the field itself, not even its value: "-" or "1e" are no numbers yet.
  const parent: ParentNode & { moveBefore?(node: Node, before: Node): void } = twin.parentElement!;
  if (parent.moveBefore) parent.moveBefore(focused, twin);
  else {
    twin.before(focused);
    focused.focus({ preventScroll: true });
    // A field that was moved has forgotten that it was typed into.
    focused.addEventListener('blur', () => focused.dispatchEvent(new Event('change')), { once: true });
  }
  twin.remove();
}
