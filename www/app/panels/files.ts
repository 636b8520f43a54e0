/** The files that were dropped together: how many are planned, and the state of each. */

import { button, disable, h, icon, setText } from '../core/dom.js';
import { save } from '../core/files.js';
import { count, seconds } from '../core/format.js';
import { menuItem, popover } from '../core/menu.js';
import { downloadName } from '../core/strings.js';
import type { Item, Queue } from '../session/queue.js';
import { words } from '../core/words/index.js';

/** A button with the list below it. It is hidden while there is only one file. */
export function fileList(queue: Queue): Node[] {
  const label = h('span', { class: 'number' });
  const opener = h('button', { type: 'button', class: 'quiet queue', hidden: true }, label, icon('down'));
  const list = h('div', { class: 'menu' });
  const all = button(words.files.title, { class: 'small', onclick: () => {
    for (const { file, gcode, machine } of queue.items) if (gcode !== null) save(gcode, downloadName({ name: file.name, machine }, '.nc'), 'text/plain');
  } });
  const fill = () => {
    list.replaceChildren(
      ...queue.items.map((item, i) => {
        const entry = menuItem(item.file.name, about(item), item === queue.current, () => queue.openAt(i));
        entry.classList.toggle('warning', isUnplanned(item));
        return entry;
      }),
      h('div', { class: 'menu-foot' }, all));
    // Those without a program are no surprise after the download.
    const ready = queue.items.filter((item) => item.gcode !== null).length;
    setText(all.querySelector('span')!, words.files.all(count(ready), count(queue.items.length)));
    disable(all, ready > 0 ? '' : words.files.none);
  };
  const panel = popover(opener, words.files.title, list, fill);
  queue.on('change', (items) => {
    const done = items.filter((item) => item.state === 'done').length;
    opener.hidden = items.length === 0;
    opener.classList.toggle('warning', items.some(isUnplanned));
    setText(label, words.files.done(count(done), count(items.length)));
    opener.setAttribute('aria-label', words.files.label(count(done), count(items.length)));
    if (panel.matches(':popover-open')) fill();
  });
  return [opener, panel];
}

/** Whether a file waits for a person. */
const isUnplanned = ({ state }: Item) => state === 'question' || state === 'failed';

function about({ state, seconds: job, sentence }: Item): string {
  switch (state) {
    case 'waiting': return words.files.waiting;
    case 'planning': return words.files.planning;
    case 'question': return words.files.question;
    case 'failed': return sentence ?? words.files.failed;
    case 'done': return job === null ? words.files.planned : words.files.plannedIn(seconds(job));
  }
}
