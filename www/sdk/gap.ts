/** When a plan counts as proven optimal. */

/**
 * A `gap` of a summary up to this counts as none: the path is proven optimal. It is a millionth, because proofs of entries anywhere on a contour
 * end within a ten-millionth of the travel.
 */
export const PROVEN = 1e-6;
