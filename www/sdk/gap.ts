/** When a plan counts as proven optimal. */

/** A `gap` of a summary up to this is rounding: the path is proven optimal. */
export const PROVEN = 1e-9;
