/**
 * The types of `kerfway` for CommonJS programs. TypeScript's module kind `node16` lets them import types of an ES module only with
 * its resolution mode stated, so the package's own declarations cannot be used as they are.
 */

export type * from './types.js' with { 'resolution-mode': 'import' };

type Entry = typeof import('./index.js', { with: { 'resolution-mode': 'import' } });

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
export declare const isKerfwayError: Entry['isKerfwayError'];
export declare const tooLarge: Entry['tooLarge'];
export declare const KerfwayError: Entry['KerfwayError'];
export type KerfwayError = InstanceType<Entry['KerfwayError']>;
export declare const Planner: Entry['Planner'];
export type Planner = Entry['Planner']['prototype'];
