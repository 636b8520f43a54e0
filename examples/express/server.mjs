// Takes drawings over HTTP and answers with what a quote needs of them; the price is the shop's affair:
//
//     node server.mjs                                         PORT, 3000 when not said
//     curl --data-binary @plate.dxf 'localhost:3000/quotes?name=plate.dxf&machine=co2-100w&thickness=3&density=1.19'

import express from 'express';
import { createPool } from 'kerfway';

/** Drawings that may wait. More are turned away: an answer that comes too late is of use to nobody. */
const MOST_WAITING = 400;
/** The largest drawing taken. */
const LARGEST = '20mb';
/** A budget in moves, not in seconds: the same drawing gets the same answer, hash and all, however busy the machine is. */
const BUDGET = { moves: 10_000, seed: 1 };

const pool = createPool();
const app = express();

app.post('/quotes', express.raw({ type: () => true, limit: LARGEST }), async (request, response) => {
  if (pool.waiting >= MOST_WAITING) {
    response.status(503).set('retry-after', '10').json({ problem: 'Too many drawings wait. Try again in ten seconds.' });
    return;
  }
  const { name = 'drawing.dxf', machine = 'co2-100w', thickness, density } = request.query;
  const material = Object.fromEntries(Object.entries({ thickness, density }).filter(([, v]) => v !== undefined).map(([key, v]) => [key, Number(v)]));
  const gone = new AbortController();
  // Whoever hangs up no longer waits: the place is for the next.
  response.on('close', () => gone.abort());
  try {
    const drawing = Buffer.isBuffer(request.body) ? request.body : new Uint8Array(0);
    response.json(await pool.quote(drawing, { ...BUDGET, name: String(name), machine: String(machine), material, signal: gone.signal }));
  } catch (error) {
    // One sentence for the person who sent it.
    if (!gone.signal.aborted) response.status(422).json({ problem: error.message });
  }
});

app.get('/health', (_, response) => {
  response.json({ waiting: pool.waiting, megabytes: process.memoryUsage().rss / 1e6 });
});

// Errors of express itself: a drawing over the limit, a broken connection.
app.use((error, _request, response, _next) => {
  response.status(error.status ?? 500).json({ problem: error.status === 413 ? `The drawing is larger than ${LARGEST}.` : 'The drawing could not be received.' });
});

const server = app.listen(process.env.PORT ?? 3000, () => console.log(`Send drawings to http://localhost:${server.address().port}/quotes`));
process.on('SIGTERM', () => {
  server.close();
  pool.close();
});
