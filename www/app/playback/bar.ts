/** The bar at the bottom: play, the job's clock, how fast it runs. */

import { button, h, icon, setText } from '../core/dom.js';
import { clock } from '../core/format.js';
import type { Playback } from './playback.js';

/** Steps of the slider: a step is less than a pixel on any screen. */
const STEPS = 10_000;

const SPEEDS: readonly [label: string, speed: number | null][] = [['Whole job in 20 s', null], ['1×', 1], ['5×', 5], ['20×', 20], ['100×', 100]];

export function playbackBar(playback: Playback): Node[] {
  const play = button('Play', { icon: 'play', iconOnly: true, class: 'quiet', onclick: () => playback.toggle() });
  const slider = h('input', { type: 'range', min: 0, max: STEPS, value: STEPS, 'aria-label': 'Moment of the job' });
  const now = h('output', { class: 'number now' }, '0:00.0');
  const whole = h('span', { class: 'number soft whole' });
  const speed = h('select', { 'aria-label': 'Speed' }, ...SPEEDS.map(([label]) => h('option', {}, label)));
  slider.addEventListener('input', () => {
    playback.pause();
    playback.seek((slider.valueAsNumber / STEPS) * playback.total);
  });
  speed.addEventListener('change', () => (playback.speed = SPEEDS[speed.selectedIndex]?.[1] ?? null));

  const show = () => {
    const { time, total } = playback;
    const ready = total > 0;
    play.disabled = slider.disabled = !ready;
    const at = ready ? Math.round((time / total) * STEPS) : STEPS;
    if (slider.valueAsNumber !== at) slider.value = String(at);
    slider.style.setProperty('--share', String(at / STEPS));
    slider.setAttribute('aria-valuetext', `${clock(time)} of ${clock(total)}, contour ${playback.stop + 1} of ${playback.stops}`);
    setText(now, clock(time));
    setText(whole, `/ ${clock(total)}`);
  };
  const showState = () => {
    const label = playback.playing ? 'Pause the cut (space)' : 'Play the cut (space)';
    play.title = label;
    play.setAttribute('aria-label', label);
    play.replaceChildren(icon(playback.playing ? 'pause' : 'play'));
  };
  playback.on('moment', show);
  playback.on('state', showState);
  show();
  showState();
  return [play, now, slider, whole, speed];
}
