/** The settings of the service, with their defaults. */

/** The settings of the service. */
export interface ServerSettings {
  host: string;
  port: number;
  /** Number of drawings that are worked on at once. */
  workers: number;
  /** Number of requests that may wait. More are answered with 429. */
  waiting: number;
  /** The largest body, in bytes. */
  largest: number;
  /** Seconds in which a body must have arrived, and in which an answer must have been read, with one more for each MB of it. */
  upload: number;
  /** Seconds that a drawing may take once its turn has come, besides the `seconds` of its search. */
  deadline: number;
  /** The most `seconds` that a request may ask for. */
  mostSeconds: number;
  /** The most `moves` that a request may ask for. */
  mostMoves: number;
  /** Seconds that running requests get to finish when the service stops. */
  grace: number;
  /** Origins of pages that may call the service; `*` for all. */
  cors: readonly string[];
  /** The accepted keys by name; empty: no key is needed. */
  keys: ReadonlyMap<string, string>;
  /** Address of a Redis or Valkey, for a service of several machines. */
  queue: string | null;
  /** Seconds for which results of a queue are kept. */
  expires: number;
}

export const DEFAULTS: Omit<ServerSettings, 'workers'> = {
  host: '127.0.0.1',
  port: 8080,
  waiting: 64,
  largest: 20 * 2 ** 20,
  upload: 30,
  deadline: 120,
  mostSeconds: 60,
  // The budget of a quote of 20,000 contours (`quoteBudget`), so that a server confirms every price that it can work out before its deadline.
  mostMoves: 500_000_000,
  grace: 30,
  cors: [],
  keys: new Map(),
  queue: null,
  expires: 86_400,
};
