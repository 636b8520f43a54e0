/** What each key does; `words.help.keys` lists them for people. */

import { bindKeys } from '../core/keys.js';
import type { Playback } from '../playback/playback.js';
import type { Session } from '../session/session.js';
import type { StageSwitches } from '../panels/toolbar.js';
import type { Viewport } from '../stage/viewport.js';
import type { Files } from './files.js';
import type { Help } from './help.js';
import type { Layout } from './layout.js';
import type { Pointer } from './pointer.js';
import type { Selection } from './selection.js';

/** Pixels by which an arrow key moves the view. */
const STEP = 60;
const ZOOM = 1.4;

interface Parts {
  session: Session;
  playback: Playback;
  viewport: Viewport;
  files: Files;
  layout: Layout;
  pointer: Pointer;
  selection: Selection;
  help: Help;
  flip(what: keyof StageSwitches): void;
  /** Downloads what the machine takes. */
  program(): void;
}

export function bindKeyboard({ session, playback, viewport, files, layout, pointer, selection, help, flip, program }: Parts): void {
  const { planning } = session;
  const zoomIn = () => viewport.zoom(ZOOM);
  const redo = () => session.redo();
  bindKeys({
    o: () => files.choose(), g: program,
    s: () => planning.stop(),
    p: () => (session.state.phase === 'paused' ? planning.resume() : planning.pause()),
    k: () => planning.keepImproving(),
    ' ': () => playback.toggle(),
    ArrowRight: () => selection.stepBy(1), ArrowLeft: () => selection.stepBy(-1),
    Home: () => selection.stepToFirst(), End: () => selection.stepToLast(),
    '+': zoomIn, '=': zoomIn, '-': () => viewport.zoom(1 / ZOOM), f: () => viewport.fit(),
    'Shift+ArrowLeft': () => viewport.pan(STEP, 0), 'Shift+ArrowRight': () => viewport.pan(-STEP, 0),
    'Shift+ArrowUp': () => viewport.pan(0, STEP), 'Shift+ArrowDown': () => viewport.pan(0, -STEP),
    c: () => flip('ramp'), v: () => flip('layers'), d: () => flip('measure'), a: () => flip('air'), t: () => layout.toggleTable(),
    1: () => selection.toggleSelected('first'), 0: () => selection.toggleSelected('last'), m: () => selection.toggleSelected('mark'), x: () => selection.toggleSelected('exclude'),
    b: () => flip('several'), u: () => selection.toggleGroup(), w: () => selection.selectWhole(), l: () => selection.selectLike(),
    'Ctrl+s': () => void files.saveProject(),
    'Ctrl+z': () => session.undo(), 'Ctrl+Shift+z': redo, 'Ctrl+y': redo,
    '?': () => void help.open(),
    Escape: () => {
      if (help.cancel()) return;
      if (session.state.refused && session.state.loaded) session.store.refusalSeen();
      else if (pointer.measure(false)) flip('measure');
      else if (pointer.placeJoints(false) || pointer.cancelHome() || pointer.dragJob(false)) return;
      // The key ends the selecting of several when nothing is selected any more.
      else if (selection.several && selection.contours.length === 0) flip('several');
      else selection.clear();
    },
  });
}
