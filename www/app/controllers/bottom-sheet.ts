/** The bottom sheet of a phone: its edge is dragged to any of three heights, or down to close it. */

/** The heights it stays at, as shares of the window. */
const HEIGHTS = [0.36, 0.62, 0.84];
/** Below this share it closes. */
const CLOSED = 0.2;
/** Pixels that a finger may move and still tap. */
const SLOP = 6;

interface Sheet {
  open(): boolean;
  toggle(): void;
}

/** `edge`: what is dragged; `sheet`: what gets higher and lower. */
export function dragSheet(edge: HTMLElement, sheet: HTMLElement, { open, toggle }: Sheet): void {
  // A flick is no scrolling to the browser then, which would take the next tap as the one that stops it.
  edge.addEventListener('touchmove', (event) => event.preventDefault(), { passive: false });
  edge.addEventListener('pointerdown', (event) => {
    if (!matchMedia('(max-width: 719px)').matches) return;
    const begin = event.clientY;
    const height = open() ? sheet.offsetHeight : 0;
    let moved = false;
    const share = (e: PointerEvent) => (height + begin - e.clientY) / innerHeight;
    const follow = (e: PointerEvent) => {
      if (!moved && Math.abs(e.clientY - begin) < SLOP) return;
      moved = true;
      if (!open()) toggle();
      sheet.style.setProperty('--sheet-height', `${Math.max(0, Math.min(HEIGHTS.at(-1)!, share(e))) * 100}dvh`);
      sheet.classList.add('dragged');
    };
    const end = (e: PointerEvent) => {
      removeEventListener('pointermove', follow);
      removeEventListener('pointerup', end);
      removeEventListener('pointercancel', end);
      sheet.classList.remove('dragged');
      if (!moved) return;
      // The drag is not a click on the button that it began on.
      const swallow = (click: Event) => click.stopPropagation();
      addEventListener('click', swallow, { capture: true, once: true });
      setTimeout(() => removeEventListener('click', swallow, { capture: true }), 0);
      const at = share(e);
      const nearest = HEIGHTS.reduce((a, b) => (Math.abs(b - at) < Math.abs(a - at) ? b : a));
      sheet.style.setProperty('--sheet-height', `${nearest * 100}dvh`);
      if (at < CLOSED && open()) toggle();
    };
    addEventListener('pointermove', follow);
    addEventListener('pointerup', end);
    addEventListener('pointercancel', end);
  });
}
