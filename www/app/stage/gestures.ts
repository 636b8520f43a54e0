/**
 * Pointer and wheel on the stage: dragging pans, the wheel and a pinch zoom about the pointer, a click without movement picks.
 */

import type { Viewport } from './viewport.js';

/** How many pixels a pointer may move between down and up and still be a click. */
const CLICK_SLOP = 5;
/** Zoom per unit of the wheel: a notch of 100 units zooms by a fifth, as maps do. */
const WHEEL_RATE = 0.0018;
/** Zoom per unit of a trackpad pinch, which sends small deltas with the control key held. */
const PINCH_RATE = 0.012;

export interface Click {
  touch: boolean;
  shift: boolean;
  alt: boolean;
  /** The control key, or the command key of a Mac. */
  command: boolean;
}

/** A pointer has moved by `dx`, `dy` pixels, on a drag that began at `from`. */
export interface Drag {
  dx: number;
  dy: number;
  from: { x: number; y: number };
  to: { x: number; y: number };
  shift: boolean;
}

export interface Picks {
  /** The pointer is over this place; null when it has left. */
  hover(at: { x: number; y: number } | null): void;
  /** A pointer drags; returns whether something other than the view follows it. */
  drag?(by: Drag): boolean;
  /** A drag has ended. */
  drop?(): void;
  click(x: number, y: number, by: Click): void;
}

export function attachGestures(target: HTMLElement, viewport: Viewport, picks: Picks): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let moved = 0;
  let from = { x: 0, y: 0 };
  let wasPinch = false;

  const local = (event: PointerEvent | WheelEvent) => {
    const box = target.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  target.addEventListener('pointerdown', (event) => {
    if (event.button > 1) return;
    target.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, local(event));
    if (pointers.size === 1) {
      moved = 0;
      from = local(event);
      wasPinch = false;
    } else wasPinch = true;
    picks.hover(null);
  });

  target.addEventListener('pointermove', (event) => {
    const now = local(event);
    const before = pointers.get(event.pointerId);
    if (!before) {
      if (event.pointerType !== 'touch') picks.hover(now);
      return;
    }
    if (pointers.size === 1) {
      moved += Math.hypot(now.x - before.x, now.y - before.y);
      if (moved > CLICK_SLOP) {
        target.classList.add('dragging');
        const by: Drag = { dx: now.x - before.x, dy: now.y - before.y, from, to: now, shift: event.shiftKey };
        if (picks.drag?.(by) !== true) viewport.pan(now.x - before.x, now.y - before.y);
      }
    } else if (pointers.size === 2) {
      const other = [...pointers.entries()].find(([id]) => id !== event.pointerId)![1];
      const spread = Math.hypot(before.x - other.x, before.y - other.y);
      const wider = Math.hypot(now.x - other.x, now.y - other.y);
      if (spread > 1 && wider > 1) viewport.zoomAt((before.x + other.x) / 2, (before.y + other.y) / 2, wider / spread);
      viewport.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    }
    pointers.set(event.pointerId, now);
  });

  const release = (event: PointerEvent) => {
    const at = pointers.get(event.pointerId);
    if (!pointers.delete(event.pointerId)) return;
    if (pointers.size > 0) return;
    target.classList.remove('dragging');
    picks.drop?.();
    if (at && event.type === 'pointerup' && !wasPinch && moved <= CLICK_SLOP && event.button === 0) {
      picks.click(at.x, at.y, { touch: event.pointerType === 'touch', shift: event.shiftKey, alt: event.altKey, command: event.ctrlKey || event.metaKey });
    }
  };
  target.addEventListener('pointerup', release);
  target.addEventListener('pointercancel', release);
  target.addEventListener('pointerleave', () => picks.hover(null));

  target.addEventListener('wheel', (event) => {
    event.preventDefault();
    const { x, y } = local(event);
    const unit = event.deltaMode === 1 ? 33 : event.deltaMode === 2 ? 400 : 1;
    const delta = Math.max(-400, Math.min(400, event.deltaY * unit));
    viewport.zoomAt(x, y, Math.exp(-delta * (event.ctrlKey ? PINCH_RATE : WHEEL_RATE)));
  }, { passive: false });
}
