/** Lists whose items are moved by hand: a handle is dragged by mouse or finger, or moved with the arrow keys while it has the focus. */

import { followPointer, grip } from './grip.js';

interface Moves {
  /** An item is moved to another place; both are counted from 0, the new one without the item. */
  move(from: number, to: number): void;
}

/** A handle for item `index` of a list. The items are the children of the list. */
export function handle(label: string, list: HTMLElement, index: number, { move }: Moves): HTMLButtonElement {
  const step = (by: number) => {
    const to = index + by;
    if (to < 0 || to >= list.children.length) return false;
    move(index, to);
    return true;
  };
  const press = (event: PointerEvent, made: HTMLButtonElement) => {
    made.focus();
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
    item.classList.add('dragged');
    followPointer(follow, (keep) => {
      item.classList.remove('dragged');
      for (const child of list.children) (child as HTMLElement).style.transform = '';
      if (keep && to !== index) move(index, to);
    });
  };
  return grip(label, { step, press });
}

/** A list with one item moved. */
export function moved<T>(list: readonly T[], from: number, to: number): T[] {
  const rest = list.filter((_, i) => i !== from);
  return [...rest.slice(0, to), list[from]!, ...rest.slice(to)];
}
