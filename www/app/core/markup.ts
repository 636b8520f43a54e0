/** Puts the words of another language into what `index.html` holds in English. */

import { language, words } from './words/index.js';

export function translate(): void {
  if (language === 'en') return;
  const { markup } = words;
  const text = (selector: string, content: string) => {
    const element = document.querySelector(selector);
    if (element) element.textContent = content;
  };
  const label = (id: string, content: string) => document.getElementById(id)?.setAttribute('aria-label', content);
  document.title = markup.title;
  text('h1', markup.heading);
  text('#canvas-keys', markup.keys);
  text('#hint', markup.hint);
  text('#drop', markup.drop);
  label('canvas', markup.canvas);
  label('panel', markup.panel);
  label('playback', markup.playback);
}
