/** Lists whose items are moved by hand: a handle is dragged by mouse or finger, or moved with the arrow keys while it has the focus. */

import { button } from './dom.js';

interface Moves {
  /** An item is moved to another place; both are counted from 0, the new one without the item. */
  move(from: number, to: number): void;
}

/** A handle for item `index` of a list. The items are the children of the list. */
export function handle(label: string, list: HTMLElement, index: number, { move }: Moves): HTMLButtonElement {
  const grip = button(label, { icon: 'grip', iconOnly: true, class: 'quiet small grip' });
  const last = () => list.children.length - 1;
  grip.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowUp' ? -1 : event.key === 'ArrowDown' ? 1 : 0;
    const to = index + by;
    if (by === 0 || to < 0 || to > last()) return;
    event.preventDefault();
    event.stopPropagation();
    move(index, to);
  });
  grip.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    grip.focus();
    const item = list.children[index] as HTMLElement;
    const tops = [...list.children].map((child) => child.getBoundingClientRect());
    const begin = event.clientY;
    let to = index;
    const follow = (e: PointerEvent) => {
      item.style.transform = `translateY(${e.clientY - begin}px)`;
      const middle = tops[index]!.top + tops[index]!.height / 2 + e.clientY - begin;
      to = tops.filter((box, i) => i !== index && box.top + box.height / 2 < middle).length;
      for (const [i, child] of [...list.children].entries()) {
        if (i === index) continue;
        const shift = i > index && i <= to ? -1 : i < index && i >= to ? 1 : 0;
        (child as HTMLElement).style.transform = shift === 0 ? '' : `translateY(${shift * item.offsetHeight}px)`;
      }
    };
    const end = (keep: boolean) => {
      removeEventListener('pointermove', follow);
      removeEventListener('pointerup', drop);
      removeEventListener('pointercancel', cancel);
      removeEventListener('keydown', escape, true);
      item.classList.remove('dragged');
      for (const child of list.children) (child as HTMLElement).style.transform = '';
      if (keep && to !== index) move(index, to);
    };
    const drop = () => end(true);
    const cancel = () => end(false);
    const escape = (e: KeyboardEvent) => {
      if (e.key !== 'Escape') return;
      e.stopPropagation();
      end(false);
    };
    item.classList.add('dragged');
    addEventListener('pointermove', follow);
    addEventListener('pointerup', drop);
    addEventListener('pointercancel', cancel);
    addEventListener('keydown', escape, true);
  });
  return grip;
}

/** A list with one item moved. */
export function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const rest = list.filter((_, i) => i !== from);
  return [...rest.slice(0, to), list[from]!, ...rest.slice(to)];
}
