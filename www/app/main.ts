/**
 * The start of the page. The session holds the job, the stage draws it, the playback shows it over time, the panels show and change it, and the
 * controllers connect them. Data flows one way: actions change the store of the session, and everything else shows its state.
 */

import './styles/tokens.css';
import './styles/base.css';
import './styles/layout.css';
import './styles/controls.css';
import './styles/menus.css';
import './styles/section.css';
import './styles/drawing.css';
import './styles/result.css';
import './styles/dock.css';
import './styles/table.css';
import './styles/stage.css';
import './styles/cards.css';
import './styles/before-after.css';
import './styles/narrow.css';
import './styles/print.css';
import { keepForOffline } from './offline/register.js';
import { startPage } from './page.js';
import { messageOf } from './core/strings.js';

startPage().then(keepForOffline).catch((error: unknown) => {
  const sentence = document.getElementById('hint');
  if (sentence) {
    sentence.hidden = false;
    sentence.setAttribute('role', 'alert');
    sentence.textContent = messageOf(error);
  }
});
