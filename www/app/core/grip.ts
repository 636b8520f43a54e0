/** Handles by which things are moved: by mouse or finger, or with the arrow keys while the handle has the focus. */

import { button } from './dom.js';

interface Grip {
  /** An arrow key asks for a place up (-1) or down (1); returns whether there is one. */
  step(by: number): boolean;
  /** The mouse or a finger is pressed on the handle. */
  press(event: PointerEvent, grip: HTMLButtonElement): void;
}

/** A handle. */
export function grip(label: string, { step, press }: Grip): HTMLButtonElement {
  const made = button(label, { icon: 'grip', iconOnly: true, class: 'quiet small grip' });
  made.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowUp' ? -1 : event.key === 'ArrowDown' ? 1 : 0;
    if (by === 0 || !step(by)) return;
    event.preventDefault();
    event.stopPropagation();
  });
  made.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    event.preventDefault();
    press(event, made);
  });
  return made;
}

/** Follows a pressed pointer until it is lifted. `end` is told whether that counts: Escape and a lost pointer undo the drag. */
export function followPointer(follow: (event: PointerEvent) => void, end: (keep: boolean) => void): void {
  const finish = (keep: boolean) => {
    removeEventListener('pointermove', follow);
    removeEventListener('pointerup', drop);
    removeEventListener('pointercancel', cancel);
    removeEventListener('keydown', escape, true);
    end(keep);
  };
  const drop = () => finish(true);
  const cancel = () => finish(false);
  const escape = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    finish(false);
  };
  addEventListener('pointermove', follow);
  addEventListener('pointerup', drop);
  addEventListener('pointercancel', cancel);
  addEventListener('keydown', escape, true);
}
