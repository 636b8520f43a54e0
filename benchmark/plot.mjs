// Plots of the site: how far the value of a plan is above the best known one, and how far the lower bound is below it, over the seconds.

const [WIDTH, HEIGHT] = [460, 260];
/** Edges of the area of the plot; labels of the lines are right of it. */
const [LEFT, RIGHT, TOP, BOTTOM] = [50, WIDTH - 60, 20, HEIGHT - 30];
/** Seconds, and per cent, at the ends of the axes, which are logarithmic. */
const [SECONDS, PER_CENT] = [[0.01, 100], [0.01, 100]];
/** Least distance between the labels of the two lines. */
const LABELS = 14;

/** The place of a value between two ends on a logarithmic axis, 0 to 1. */
const share = (value, [least, most]) => Math.log(Math.min(Math.max(value, least), most) / least) / Math.log(most / least);
const rounded = (place) => Number(place.toFixed(1));
const across = (seconds) => rounded(LEFT + (RIGHT - LEFT) * share(seconds, SECONDS));
const up = (perCent) => rounded(BOTTOM - (BOTTOM - TOP) * share(perCent, PER_CENT));

/** A figure of a trace, as in `traces`, of a run of so many seconds; `best`: the best value known. */
export function plot(name, { seconds, values, bounds }, best) {
  const marks = [
    ...[0.01, 0.1, 1, 10, 100].map((s) => `<text x="${across(s)}" y="${HEIGHT - 12}" text-anchor="middle">${s} s</text>`),
    ...[0.01, 0.1, 1, 10, 100].map((g) => `<text x="${LEFT - 6}" y="${up(g) + 4}" text-anchor="end">${g} %</text><path class="grid" d="M${LEFT} ${up(g)}H${RIGHT}"/>`),
  ];
  const above = values.map(([s, value]) => [across(s), up(100 * (value / best - 1))]);
  const below = bounds.map(([s, bound]) => [across(s), up(100 * (1 - bound / best))]);
  const [low, high] = [above, below].map((steps) => steps.at(-1)?.[1] ?? BOTTOM);
  // Where both lines end near each other, the label of the bound moves up.
  // What a proof finds last may come a moment after the end.
  const end = across(Math.max(seconds, ...[...values, ...bounds].map(([s]) => s)));
  const lines = [line('value', above, end, low), line('bound', below, end, Math.abs(low - high) < LABELS ? low - LABELS : high)];
  return `<figure><figcaption>${name}</figcaption><svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="Value and lower bound over time on ${name}">${marks.join('')}${lines.join('')}</svg></figure>`;
}

/** A line in steps, which goes on to `end` at its last height, with its name there at the height `label`. */
function line(what, steps, end, label) {
  const d = steps.map(([x, y], k) => (k === 0 ? `M${x} ${y}` : `H${x}V${y}`)).join('');
  return `<path class="line ${what}" d="${d}H${end}"/><text class="${what}" x="${end + 4}" y="${label + 4}">${what}</text>`;
}
