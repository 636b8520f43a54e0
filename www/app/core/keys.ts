/** Keyboard shortcuts. They act while no form control but a switch has the focus, so typing a number never plays the cut. */

export type Bindings = Record<string, (event: KeyboardEvent) => void>;

/** Calls the binding of a key. Its name begins with `Ctrl+` where the control key (or the command key of a Mac) is held, and for arrows and
 * commands with `Shift+` after that. */
export function bindKeys(bindings: Bindings): void {
  addEventListener('keydown', (event) => {
    if (event.altKey || event.defaultPrevented) return;
    const command = event.ctrlKey || event.metaKey;
    const target = event.target as HTMLElement;
    if (target.closest('input:not([type=checkbox]), select, textarea, [contenteditable], dialog, [popover]')) {
      // Out of a field, so that the next key is a shortcut again; Tab goes on from there.
      if (event.key === 'Escape' && !target.closest('dialog, [popover]')) target.blur();
      return;
    }
    // Space and Enter act on the button, the switch or the disclosure that has the focus.
    if ((event.key === ' ' || event.key === 'Enter') && target.closest('button, summary, a, input')) return;
    if (event.key.startsWith('Arrow') && target.closest('.order-scroll') && /Up|Down/.test(event.key)) return;
    const arrow = event.key.startsWith('Arrow');
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const name = `${command ? 'Ctrl+' : ''}${event.shiftKey && (arrow || command) ? 'Shift+' : ''}${key}`;
    const action = bindings[name];
    if (!action) return;
    event.preventDefault();
    action(event);
  });
}
