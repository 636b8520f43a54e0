/** The section of the machine: its heading names the machine. The controls are loaded when it is first opened, because many visits need none. */

import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import type { Session } from '../session/session.js';
import { laterSection } from './section.js';

/** What is done on the sheet. */
export interface MachineActions {
  /** Lets the person choose where the head starts. */
  chooseHome(): void;
  /** Lets the person place micro-joints by hand, or ends that; `show` hears whether they are being placed. */
  placeJoints(show: (on: boolean) => void): void;
}

/** `notify` shows a sentence to the person. */
export function machineSection(session: Session, notify: (sentence: string) => void, actions: MachineActions): HTMLElement {
  const { root, setGist } = laterSection(words.machine.title, async () => (await import('./machine.js')).machineControls(session, notify, actions), notify);
  const show = () => {
    const { machine } = session.state;
    if (machine) setGist(isChanged(session, machine) ? words.machine.changed(machine.title) : machine.title);
  };
  session.store.on('change', show);
  show();
  return root;
}

/** The machine as it was before somebody changed its values; undefined if it has no name that is known here. */
export function presetOf({ catalog }: Session, { name }: MachineProfile): MachineProfile | undefined {
  return catalog.machines.find((m) => m.name === name);
}

/** Whether a machine differs from its preset. */
export function isChanged(session: Session, machine: MachineProfile): boolean {
  const preset = presetOf(session, machine);
  return preset !== undefined && JSON.stringify(preset) !== JSON.stringify(machine);
}
