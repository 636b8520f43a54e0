/** The name of a file in one line. Where it does not fit it is cut in the middle: its end tells one revision from the next. */

import { h, setText } from './dom.js';

/** Characters at the end that are always shown, and those of a name that fits anywhere. */
const [END, FITS] = [12, 24];

export function fileName(className: string): { root: HTMLElement; show(name: string): void } {
  const [begin, end] = [h('span'), h('span')];
  // A name in Arabic or Hebrew is read from the right, and would lose its beginning there.
  const root = h('span', { class: `shortened ${className}`, dir: 'auto' }, begin, end);
  const show = (name: string) => {
    const characters = [...name];
    const cut = characters.length > FITS ? characters.length - END : FITS;
    setText(begin, characters.slice(0, cut).join(''));
    setText(end, characters.slice(cut).join(''));
    root.title = name;
  };
  return { root, show };
}
