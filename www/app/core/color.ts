/** Colours of `styles/tokens.css` as a canvas takes them: those of the theme in force. */

let probe: HTMLElement | null = null;

/** The colour a custom property stands for now, e.g. `accent`. */
export function colorOf(name: string): string {
  if (!probe) {
    probe = document.createElement('span');
    probe.hidden = true;
    document.body.append(probe);
  }
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}
