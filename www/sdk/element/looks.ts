/** The content and style sheets of the elements. A host changes them by CSS parts and properties. */

import type { ElementLabels } from './labels.js';

const CSS = `
:host {
  display: grid;
  grid-template-rows: 1fr auto;
  height: 360px;
  color-scheme: light dark;
  color: var(--kerfway-text, light-dark(#1a1d22, #e9ebef));
  background: var(--kerfway-surface, light-dark(#ffffff, #1a1d23));
  border: 1px solid var(--kerfway-line, light-dark(#dadee4, #2e343e));
  border-radius: var(--kerfway-radius, 6px);
  font: var(--kerfway-font, 14px/1.4 system-ui, sans-serif);
  overflow: hidden;
}
:host([hidden]), [hidden], :host([state=empty]) [part=bar] { display: none !important; }
[part=stage] { position: relative; min-height: 0; background: var(--kerfway-sheet, transparent); }
canvas { position: absolute; inset: 0; width: 100%; height: 100%; transition: color 1ms; }
[part=contours] { color: var(--kerfway-contour, light-dark(#1f2329, #dfe3e9)); }
[part=path] { color: var(--kerfway-accent, light-dark(#2f4fdb, #93a8ff)); }
[part=drop] {
  position: absolute; inset: 12px; display: grid; place-content: center; justify-items: center; gap: 8px; text-align: center;
  border: 1px dashed var(--kerfway-edge, light-dark(#868e9a, #737c8a)); border-radius: inherit;
}
:host([dragging]) [part=stage] { outline: 2px solid var(--kerfway-accent, light-dark(#2f4fdb, #93a8ff)); outline-offset: -4px; }
[part=bar] {
  display: flex; flex-wrap: wrap; align-items: center; gap: 8px; padding: 8px 12px;
  border-top: 1px solid var(--kerfway-line, light-dark(#dadee4, #2e343e));
}
[part=numbers] { flex: 1 1 12em; margin: 0; font-variant-numeric: tabular-nums; }
[part=message] { flex: 1 1 100%; margin: 0; color: var(--kerfway-error, light-dark(#b3201a, #ff958c)); }
button {
  font: inherit; min-height: 36px; padding: 4px 14px; cursor: pointer; color: inherit; background: transparent;
  border: 1px solid var(--kerfway-edge, light-dark(#868e9a, #737c8a));
  border-radius: var(--kerfway-radius, 6px);
}
[part~=main] {
  color: var(--kerfway-on-accent, light-dark(#ffffff, #0c1230));
  background: var(--kerfway-accent, light-dark(#2f4fdb, #93a8ff)); border-color: transparent;
}
button:focus-visible { outline: 2px solid var(--kerfway-accent, light-dark(#2f4fdb, #93a8ff)); outline-offset: 2px; }
`;

/** Additional styles of `<kerfway-quote>`, whose height grows with the report. */
const REPORT = `
:host { height: auto; grid-template-rows: 240px auto auto; }
[part=price] { margin: 0; padding: 12px 12px 0; font-size: 1.5em; font-weight: 600; }
[part=price]:empty { display: none; }
[part=report] { display: grid; grid-template-columns: max-content 1fr; gap: 4px 16px; margin: 0; padding: 12px; }
[part=report]:empty { display: none; }
[part=term] { color: var(--kerfway-quiet, light-dark(#5a626e, #a3acb9)); }
[part=figure] { margin: 0; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
`;

const STAGE = `
<div part="stage">
  <canvas part="contours" role="img" data-label="picture"></canvas>
  <canvas part="path" aria-hidden="true"></canvas>
  <div part="drop"><span data-text="drop"></span><button part="button choose main" data-does="choose" data-text="choose"></button></div>
</div>`;

const BAR = `
<div part="bar">
  <p part="numbers" role="status"></p>
  <button part="button stop main" data-does="stop" data-text="stop" hidden></button>
  <button part="button download main" data-does="download" data-text="download" hidden></button>
  <button part="button again" data-does="choose" data-text="again" hidden></button>
  <p part="message" role="alert" hidden></p>
</div>
<input type="file" accept=".dxf,.svg" hidden>
`;

/** What an element looks like, and what is in it. */
export interface Looks {
  css: string;
  body: string;
}

export const PLANNER: Looks = { css: CSS, body: STAGE + BAR };
export const QUOTE: Looks = { css: CSS + REPORT, body: `${STAGE}<div><p part="price" role="status"></p><dl part="report"></dl></div>${BAR}` };

/** Writes the fixed texts. They are set as text, so that a label cannot contain markup. */
export function label(root: ShadowRoot, labels: ElementLabels): void {
  for (const piece of root.querySelectorAll<HTMLElement>('[data-text]')) piece.textContent = String(labels[piece.dataset['text'] as keyof ElementLabels]);
  for (const piece of root.querySelectorAll<HTMLElement>('[data-label]')) piece.setAttribute('aria-label', String(labels[piece.dataset['label'] as keyof ElementLabels]));
}

/**
 * Gives a shadow root its style sheet. It is a constructed one, because a Content-Security-Policy may forbid style elements, and belongs to one
 * document: an element that is moved to another one has none.
 */
export function dress(root: ShadowRoot, css: string): void {
  const sheet = new (root.ownerDocument.defaultView ?? globalThis).CSSStyleSheet();
  sheet.replaceSync(css);
  root.adoptedStyleSheets = [sheet];
}
