/** Counts what the service does, in the text format of Prometheus. */

/** Upper bounds of the histogram of seconds: from a small drawing to the deadline. */
const BOUNDS = [0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60, 120];

/** Figures that are read when they are asked for. */
export interface Gauges {
  waiting: () => number;
  running: () => number;
}

interface Durations {
  counts: number[];
  sum: number;
  count: number;
}

export class Metrics {
  private readonly requests = new Map<string, number>();
  private readonly errors = new Map<string, number>();
  private readonly durations = new Map<string, Durations>();
  private received = 0;

  constructor(private readonly gauges: Gauges) {}

  /** Counts an answered request. `route` is one of a fixed list, so that senders cannot add series. `seconds`: null if its begin is not known. */
  answered(route: string, status: number, seconds: number | null, code: string | null): void {
    add(this.requests, `route="${route}",status="${status}"`, 1);
    if (code !== null) add(this.errors, `code="${code}"`, 1);
    if (seconds === null) return;
    const d = this.durations.get(route) ?? { counts: BOUNDS.map(() => 0), sum: 0, count: 0 };
    BOUNDS.forEach((bound, k) => {
      if (seconds <= bound) d.counts[k] = (d.counts[k] ?? 0) + 1;
    });
    d.sum += seconds;
    d.count += 1;
    this.durations.set(route, d);
  }

  /** Counts the bytes of a drawing that has arrived. */
  drawing(bytes: number): void {
    this.received += bytes;
  }

  /** All figures. */
  text(): string {
    const memory = process.memoryUsage();
    const series = (name: string, map: ReadonlyMap<string, number>) => [...map].map(([labels, n]) => `${name}{${labels}} ${n}`);
    const histogram = [...this.durations].flatMap(([route, { counts, sum, count }]) => [
      ...BOUNDS.map((bound, k) => `kerfway_request_seconds_bucket{route="${route}",le="${bound}"} ${counts[k] ?? 0}`),
      `kerfway_request_seconds_bucket{route="${route}",le="+Inf"} ${count}`,
      `kerfway_request_seconds_sum{route="${route}"} ${sum}`,
      `kerfway_request_seconds_count{route="${route}"} ${count}`,
    ]);
    return [
      ...about('kerfway_requests_total', 'counter', 'Answered requests.'), ...series('kerfway_requests_total', this.requests),
      ...about('kerfway_errors_total', 'counter', 'Answers with an error, by its code.'), ...series('kerfway_errors_total', this.errors),
      ...about('kerfway_request_seconds', 'histogram', 'Seconds from the first byte of a request to the end of its answer.'), ...histogram,
      ...about('kerfway_drawing_bytes_total', 'counter', 'Bytes of drawings received.'), `kerfway_drawing_bytes_total ${this.received}`,
      ...about('kerfway_waiting', 'gauge', 'Requests that wait for a planner.'), `kerfway_waiting ${this.gauges.waiting()}`,
      ...about('kerfway_running', 'gauge', 'Requests that are being answered.'), `kerfway_running ${this.gauges.running()}`,
      ...about('process_resident_memory_bytes', 'gauge', 'Resident memory.'), `process_resident_memory_bytes ${memory.rss}`,
      ...about('process_cpu_seconds_total', 'counter', 'Processor time.'), `process_cpu_seconds_total ${cpuSeconds()}`, '',
    ].join('\n');
  }
}

function about(name: string, type: string, help: string): string[] {
  return [`# HELP ${name} ${help}`, `# TYPE ${name} ${type}`];
}

function add(map: Map<string, number>, key: string, n: number): void {
  map.set(key, (map.get(key) ?? 0) + n);
}

function cpuSeconds(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
}
