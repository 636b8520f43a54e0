/** The colours of `styles/tokens.css` in a form that a canvas accepts, for the current theme. */

let probe: HTMLElement | null = null;

/** The current colour of a custom property, for example `accent`. */
export function colorOf(name: string): string {
  if (!probe) {
    probe = document.createElement('span');
    probe.hidden = true;
    // Where the system forces its colours, the sheet keeps its own.
    probe.style.forcedColorAdjust = 'none';
    document.body.append(probe);
  }
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}
