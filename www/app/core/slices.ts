/** Work that is done little by little, so that the page goes on meanwhile. */

/** Milliseconds of a slice: half of a frame. */
const SLICE = 8;
/** Steps between two looks at the clock. */
const STEPS = 32;

/** Lets the page go on with what waits. */
export const pause = () => new Promise<void>((next) => setTimeout(next));

/** Calls `step` for every number below `count`, and lets the page go on after each slice. */
export async function inSlices(count: number, step: (k: number) => void): Promise<void> {
  let until = performance.now() + SLICE;
  for (let k = 0; k < count; k += 1) {
    if (k % STEPS === 0 && performance.now() > until) {
      await pause();
      until = performance.now() + SLICE;
    }
    step(k);
  }
}
