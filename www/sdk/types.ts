/** What both entry points, `index.ts` and `node.ts`, export besides their functions. */

export { Planner, type PlannerOptions } from './planner.js';
export type { PlanHandle, PlanResult, Started } from './plan-handle.js';
export type { ProofHandle } from './prover.js';
export type { Functions, Outputs, Planned, PlanRun } from './functions.js';
export type { ByteHolder, Bytes, Source } from './bytes.js';
export type { CheckOptions, InspectOptions, JobOptions, PlanJobOptions, PlanningOptions, QuoteOptions, RenderOptions } from './options.js';
export type { Configuration, Places } from './places.js';
export type { Pool, PoolOptions } from './pool.js';
export type * from './protocol.js';
export { ANCHORS, pointOf } from './anchors.js';
export type { Limits, Material, Quote, QuoteTerms } from './quote.js';
export type { Verification } from './verify-quote.js';
export { basket, priceBreaks, type BasketReport, type BasketItem, type BasketLine, type BasketOptions, type PriceBreak } from './basket.js';
export type { SheetEstimate, Stock } from './sheets.js';
export { partThumbnail, type ThumbnailOptions } from './thumbnail.js';
export { jobReport, type ReportInput } from './job-report.js';
export { ENGLISH as ENGLISH_REPORT, type ReportText, type ReportWords } from './report-text.js';
export { isProject, readProject, writeProject, type Project, type SavedPlan } from './project.js';
export { DEFAULT_JOINTS, JOINT_KINDS, JOINT_SIDES, SIZE_TESTS, jointRules, jointSettings, type JointPattern, type JointSide } from './joints.js';
export { CORNER_KINDS } from './corners.js';
export { DEFAULT_LEADS, LEAD_KINDS, LEAD_POSITIONS, leadRules, leadSettings, type LeadChoice } from './leads.js';
export { LEVERS, leverSavings, withoutLever, type Lever, type LeverSaving, type Replanner } from './savings.js';
export { activeContours } from './contours.js';
export { tooLarge } from './size.js';
export { PROVEN } from './gap.js';
export { given } from './options.js';
export { isKerfwayError, KerfwayError, type ErrorParams } from './errors.js';
