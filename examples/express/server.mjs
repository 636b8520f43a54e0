// Takes drawings over HTTP and answers with what a quote needs of them; the price is the shop's affair:
//
//     node server.mjs                                         PORT, 3000 when not said
//     curl --data-binary @plate.dxf 'localhost:3000/quotes?name=plate.dxf&machine=co2-100w&thickness=3&density=1.19'
//
// Status: 200 the report; 400 a wish in the address is wrong; 413 the drawing is too large; 415 the body is a form, not a drawing;
// 422 the drawing cannot be used; 500 a fault of the server; 503 too many wait. All but 200 say why in `problem`.

import express from 'express';
import { createPlanner, createPool } from 'kerfway';
import { isForm, wishes, WishError } from './request.mjs';

/** Drawings that may wait. More are turned away: an answer that comes too late is of use to nobody. */
const MOST_WAITING = 400;
/** The largest drawing taken. */
const LARGEST = '20mb';
/** A budget in moves, not in seconds: the same drawing gets the same answer, hash and all, however busy the machine is. */
const BUDGET = { moves: 10_000, seed: 1 };
/** A drawing that every planner in good order reads: one line. */
const PROBE = new TextEncoder().encode('0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n10\n21\n0\n0\nENDSEC\n0\nEOF\n');
const FORM = 'The body is a form (multipart/form-data). Send the bytes of the DXF file alone as the body, and its name in the address: /quotes?name=plate.dxf.';

const pool = createPool();
const machines = await machineNames();
const app = express();

// The body is taken whatever type is named: browsers and programs name many for DXF. What it is decides its content.
app.post('/quotes', refuseForms, express.raw({ type: () => true, limit: LARGEST }), async (request, response) => {
  const drawing = Buffer.isBuffer(request.body) ? request.body : new Uint8Array(0);
  if (isForm(drawing)) return problem(response, 415, FORM);
  if (pool.waiting >= MOST_WAITING) return problem(response.set('retry-after', '10'), 503, 'Too many drawings wait. Try again in ten seconds.');
  const gone = new AbortController();
  // Whoever hangs up no longer waits: the place is for the next.
  response.on('close', () => gone.abort());
  try {
    response.json(await pool.quote(drawing, { ...BUDGET, ...wishes(request.query, machines), signal: gone.signal }));
  } catch (error) {
    if (gone.signal.aborted) return;
    if (error instanceof WishError) return problem(response, 400, error.message);
    const unusable = await whyUnusable(drawing, gone.signal);
    if (gone.signal.aborted) return;
    if (unusable !== null) return problem(response, 422, unusable);
    // The person who sent the drawing can do nothing about it; whoever runs the server reads the log.
    console.error(error);
    problem(response, 500, 'The quote could not be made because of a fault of the server. Try again later.');
  }
});

app.get('/health', (_, response) => {
  response.json({ waiting: pool.waiting, megabytes: process.memoryUsage().rss / 1e6 });
});

// Errors of express itself: a drawing over the limit, a broken connection.
app.use((error, _request, response, _next) => {
  const tooLarge = error.status === 413;
  if (!tooLarge) console.error(error);
  problem(response, error.status ?? 500, tooLarge ? `The drawing is larger than ${LARGEST}.` : 'The drawing could not be received.');
});

const server = app.listen(process.env.PORT ?? 3000, () => console.log(`Send drawings to http://localhost:${server.address().port}/quotes`));
process.on('SIGTERM', () => {
  server.close();
  pool.close();
});

function problem(response, status, text) {
  response.status(status).json({ problem: text });
}

/** A form that says so is refused before its body is read. */
function refuseForms(request, response, next) {
  if (request.is('multipart/*')) problem(response, 415, FORM);
  else next();
}

/** One sentence on why a drawing cannot be used; `null` where the fault is not the drawing's. */
async function whyUnusable(drawing, signal) {
  try {
    const { contours } = await pool.inspect(drawing, { signal });
    return contours.some((c) => c.operation !== 'ignore') ? null : 'There is nothing to cut in this drawing.';
  } catch (error) {
    // The drawing is at fault when the planner still reads another one.
    return pool.inspect(PROBE, { signal }).then(() => error.message, () => null);
  }
}

async function machineNames() {
  const planner = await createPlanner();
  const names = planner.machines.map((m) => m.name);
  planner.close();
  return names;
}
