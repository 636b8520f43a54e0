/**
 * The types of `kerfway/portable` for CommonJS programs. TypeScript's module kind `node16` lets them import types of an ES module only with
 * its resolution mode stated, so the package's own declarations cannot be used as they are.
 */

export type * from './types.js' with { 'resolution-mode': 'import' };

type Entry = typeof import('./portable.js', { with: { 'resolution-mode': 'import' } });

export declare const check: Entry['check'];
export declare const configure: Entry['configure'];
export declare const createPlanner: Entry['createPlanner'];
export declare const createPool: Entry['createPool'];
export declare const inspect: Entry['inspect'];
export declare const plan: Entry['plan'];
export declare const quote: Entry['quote'];
export declare const render: Entry['render'];
export declare const verifyQuote: Entry['verifyQuote'];
export declare const activeContours: Entry['activeContours'];
export declare const ANCHORS: Entry['ANCHORS'];
export declare const pointOf: Entry['pointOf'];
export declare const basket: Entry['basket'];
export declare const priceBreaks: Entry['priceBreaks'];
export declare const partThumbnail: Entry['partThumbnail'];
export declare const CORNER_KINDS: Entry['CORNER_KINDS'];
export declare const DEFAULT_JOINTS: Entry['DEFAULT_JOINTS'];
export declare const DEFAULT_LEADS: Entry['DEFAULT_LEADS'];
export declare const ENGLISH_REPORT: Entry['ENGLISH_REPORT'];
export declare const JOINT_KINDS: Entry['JOINT_KINDS'];
export declare const JOINT_SIDES: Entry['JOINT_SIDES'];
export declare const LEAD_KINDS: Entry['LEAD_KINDS'];
export declare const LEAD_POSITIONS: Entry['LEAD_POSITIONS'];
export declare const LEVERS: Entry['LEVERS'];
export declare const PROVEN: Entry['PROVEN'];
export declare const SIZE_TESTS: Entry['SIZE_TESTS'];
export declare const given: Entry['given'];
export declare const isProject: Entry['isProject'];
export declare const jobReport: Entry['jobReport'];
export declare const jointRules: Entry['jointRules'];
export declare const jointSettings: Entry['jointSettings'];
export declare const leadRules: Entry['leadRules'];
export declare const leadSettings: Entry['leadSettings'];
export declare const leverSavings: Entry['leverSavings'];
export declare const readProject: Entry['readProject'];
export declare const withoutLever: Entry['withoutLever'];
export declare const writeProject: Entry['writeProject'];
export declare const isKerfwayError: Entry['isKerfwayError'];
export declare const tooLarge: Entry['tooLarge'];
export declare const KerfwayError: Entry['KerfwayError'];
export type KerfwayError = InstanceType<Entry['KerfwayError']>;
export declare const Planner: Entry['Planner'];
export type Planner = Entry['Planner']['prototype'];
