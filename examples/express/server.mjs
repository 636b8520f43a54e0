// Accepts drawings over HTTP and answers with quote reports. The shop computes the price:
//
//     node server.mjs                                         PORT, 3000 by default
//     curl --data-binary @plate.dxf 'localhost:3000/quotes?name=plate.dxf&machine=co2-100w&thickness=3&density=1.19'
//
// Status: 200 the report; 400 an option in the query is wrong; 413 the drawing is too large; 415 the body is a form, not a drawing;
// 422 the drawing cannot be used; 500 an error of the server; 503 too many requests wait. All but 200 give the reason in `problem`.

import express from 'express';
import { createPlanner, createPool } from 'kerfway';
import { FORM, isForm, OptionError, quoteOptions, whyUnusable } from './request.mjs';

/** The number of drawings that may wait. More are refused, because a late answer is useless. */
const MOST_WAITING = 400;
/** The size limit of a drawing. */
const LARGEST = '20mb';
/** The budget is in moves and not in seconds, so that the same drawing gets the same report and hash, however busy the computer is. */
const BUDGET = { moves: 10_000, seed: 1 };

const pool = createPool();
const machines = await machineNames();
const app = express();

// A body of any content type is accepted, because browsers and programs use many for DXF. Only its content counts.
app.post('/quotes', refuseForms, express.raw({ type: () => true, limit: LARGEST }), async (request, response) => {
  const drawing = Buffer.isBuffer(request.body) ? request.body : new Uint8Array(0);
  if (isForm(drawing)) return problem(response, 415, FORM);
  if (pool.waiting >= MOST_WAITING) return problem(response.set('retry-after', '10'), 503, 'Too many drawings wait. Try again in ten seconds.');
  const gone = new AbortController();
  // A client that disconnects frees its place in the queue.
  response.on('close', () => gone.abort());
  try {
    response.json(await pool.quote(drawing, { ...BUDGET, ...quoteOptions(request.query, machines), signal: gone.signal }));
  } catch (error) {
    if (gone.signal.aborted) return;
    if (error instanceof OptionError) return problem(response, 400, error.message);
    const unusable = await whyUnusable(pool, drawing, gone.signal);
    if (gone.signal.aborted) return;
    if (unusable !== null) return problem(response, 422, unusable);
    // The sender of the drawing can do nothing about it, so the details go to the server's log only.
    console.error(error);
    problem(response, 500, 'The quote could not be made because of a fault of the server. Try again later.');
  }
});

app.get('/health', (_, response) => {
  response.json({ waiting: pool.waiting, megabytes: process.memoryUsage().rss / 1e6 });
});

// Errors of Express itself: a drawing over the limit, a broken connection.
app.use((error, _request, response, _next) => {
  const tooLarge = error.status === 413;
  if (!tooLarge) console.error(error);
  problem(response, error.status ?? 500, tooLarge ? `The drawing is larger than ${LARGEST}.` : 'The drawing could not be received.');
});

const server = app.listen(process.env.PORT ?? 3000, () => console.log(`Send drawings to http://localhost:${server.address().port}/quotes`));
// What runs and waits is finished first.
process.on('SIGTERM', () => server.close(() => pool.close()));

function problem(response, status, text) {
  response.status(status).json({ problem: text });
}

/** Refuses a form by its content type, before its body is read. */
function refuseForms(request, response, next) {
  if (request.is('multipart/*')) problem(response, 415, FORM);
  else next();
}

async function machineNames() {
  const planner = await createPlanner();
  const names = planner.machines.map((m) => m.name);
  planner.close();
  return names;
}
