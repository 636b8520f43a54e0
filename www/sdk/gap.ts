/** When a plan counts as proven optimal. */

/** A gap up to this is rounding: the path is optimal. */
export const PROVEN = 1e-9;
