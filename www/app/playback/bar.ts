/** The bar at the bottom: play, the time in the job, the speed. */

import { button, h, icon, setText } from '../core/dom.js';
import { clock } from '../core/format.js';
import type { Playback } from './playback.js';
import { words } from '../core/words/index.js';

/** Steps of the slider: one step is less than a pixel on any screen. */
const STEPS = 10_000;

const SPEEDS: readonly [label: string, speed: number | null][] = [[words.playback.whole, null], ['1×', 1], ['5×', 5], ['20×', 20], ['100×', 100]];

export function playbackBar(playback: Playback, longest: () => number): Node[] {
  const play = button(words.playback.play, { icon: 'play', iconOnly: true, class: 'quiet', onclick: () => playback.toggle() });
  const slider = h('input', { type: 'range', min: 0, max: STEPS, value: STEPS, 'aria-label': words.playback.moment });
  // Not an output, which would be read aloud with every frame: the slider says the time when it is asked for.
  const now = h('span', { class: 'number now' });
  const whole = h('span', { class: 'number soft whole' });
  const speed = h('select', { 'aria-label': words.playback.speed }, ...SPEEDS.map(([label]) => h('option', {}, label)));
  slider.addEventListener('input', () => {
    playback.pause();
    playback.seek((slider.valueAsNumber / STEPS) * playback.total);
  });
  speed.addEventListener('change', () => (playback.speed = SPEEDS[speed.selectedIndex]?.[1] ?? null));

  let wasReady = false;
  const show = () => {
    const { time, total } = playback;
    const ready = total > 0;
    const written = (s: number) => clock(s, total, longest());
    play.disabled = slider.disabled = !ready;
    if (ready !== wasReady) showState();
    wasReady = ready;
    const at = ready ? Math.round((time / total) * STEPS) : STEPS;
    if (slider.valueAsNumber !== at) slider.value = String(at);
    slider.style.setProperty('--share', String(at / STEPS));
    slider.setAttribute('aria-valuetext', words.playback.at(written(time), written(total), playback.stop + 1, playback.stops));
    setText(now, written(time));
    setText(whole, `/ ${written(total)}`);
  };
  const showState = () => {
    const label = playback.playing ? words.playback.pauseKey : words.playback.playKey;
    play.title = play.disabled ? words.playback.none : label;
    play.setAttribute('aria-label', label);
    play.replaceChildren(icon(playback.playing ? 'pause' : 'play'));
  };
  playback.on('moment', show);
  playback.on('state', showState);
  show();
  showState();
  return [play, now, slider, whole, speed];
}
