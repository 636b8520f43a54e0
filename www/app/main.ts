/**
 * The page: puts the session (what is worked on), the stage (what is seen), the playback (when) and the panels (what
 * can be said and done) together. Data flows one way: the session and the playback tell, the rest shows.
 */

import './styles/tokens.css';
import './styles/base.css';
import './styles/layout.css';
import './styles/controls.css';
import './styles/panels.css';
import './styles/stage.css';
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
