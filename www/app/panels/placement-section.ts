/** The section of the place on the bed: its heading says where the job lies. The controls are loaded when it is first opened. */

import { sentenceOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import { fitsBed, shiftOf } from '../session/placing.js';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';
import type { PlacementControls } from './placement.js';
import { laterSection } from './section.js';

export interface PlacementActions {
  /** Lets the person drag the job on the bed, or ends it. */
  drag(on: boolean): void;
  /** Shows the whole bed. */
  showBed(): void;
}

export interface PlacementSection {
  root: HTMLElement;
  /** Shows whether the job is being dragged. */
  setDragging(on: boolean): void;
  /** Opens the section, with the focus on what brings the job onto the bed. */
  reveal(): Promise<void>;
}

/** `notify` shows a sentence to the person. */
export function placementSection(session: Session, notify: (sentence: string) => void, actions: PlacementActions): PlacementSection {
  let controls: PlacementControls | null = null;
  const { root, setGist, open } = laterSection(words.placement.title, async () => {
    const { placementControls } = await import('./placement.js');
    controls = placementControls(session, actions);
    return controls.root;
  }, notify);
  const refresh = () => {
    const { loaded, machine, placing, load, phase } = session.state;
    // It has its place before there is a drawing, so that the sections below stay where they are.
    root.hidden = loaded === null && phase === 'failed';
    if (!loaded || !machine) return;
    const off = whyOff(session.state) !== '';
    const moved = shiftOf(placing, loaded).some((v) => v !== 0);
    const place = off ? words.placement.offBed : moved ? words.placement.placed : words.placement.drawn;
    setGist([place, load.turn ? words.placement.turned(load.turn) : ''].filter(Boolean).join(', '), off ? 'warning' : '');
  };
  session.store.on('change', refresh);
  session.store.on('loaded', refresh);
  refresh();
  const reveal = async () => {
    await open();
    if (controls === null) return;
    // The panel alone is scrolled: `scrollIntoView` moves the whole page as well. What can be done about it is at the end, which a phone has no room for beside the rest.
    const panel = root.parentElement!;
    const [shown, whole, end] = [panel, root, controls.end].map((e) => e.getBoundingClientRect()) as [DOMRect, DOMRect, DOMRect];
    panel.scrollTop += Math.max(whole.top - shown.top, end.bottom - shown.bottom);
    controls.focus();
  };
  return { root, setDragging: (on) => controls?.setDragging(on), reveal };
}

/** Why the job does not lie on the bed, in a sentence; empty if it does. */
export function whyOff({ loaded, machine, placing, planFindings }: State): string {
  const off = planFindings.find((f) => f.code === 'off-bed');
  if (off !== undefined) return sentenceOf(off).text;
  return loaded && machine && !fitsBed(placing, machine, loaded) ? words.placement.off : '';
}
