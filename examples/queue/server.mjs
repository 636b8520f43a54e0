// Accepts drawings, puts them into the queue, and returns the results:
//
//     curl --data-binary @plate.dxf 'localhost:3000/quotes?name=plate.dxf&thickness=3&density=1.19'      202, with the address of the answer
//     curl localhost:3000/quotes/ID                                                                    202 waits, 200 the report
//
// Status of an upload that is refused: 400 an option in the query is wrong; 413 the drawing is too large; 415 the body is a form, not a
// drawing; 503 too many drawings wait. Status of a job that failed: 422 the drawing cannot be used; 500 an error of the server.

import { mkdir, rename, writeFile } from 'node:fs/promises';
import { Queue } from 'bullmq';
import express from 'express';
import { createPlanner } from 'kerfway';
import { FORM, isForm, OptionError, quoteOptions } from '../express/request.mjs';
import { connection, DRAWINGS, drawingOf, idOf, JOB, LARGEST, MOST_WAITING, QUEUE, UNUSABLE } from './queue.mjs';

const GIVEN_UP = 'Two workers died of this drawing. It may need more memory than there is.';
const FAULT = 'The quote could not be made because of a fault of the server. Try again later.';

await mkdir(DRAWINGS, { recursive: true });
const queue = new Queue(QUEUE, { connection, defaultJobOptions: JOB });
const machines = await machineNames();
const app = express();

app.post('/quotes', refuseForms, express.raw({ type: () => true, limit: LARGEST }), async (request, response) => {
  const drawing = Buffer.isBuffer(request.body) ? request.body : Buffer.alloc(0);
  if (isForm(drawing)) return problem(response, 415, FORM);
  if ((await queue.getWaitingCount()) >= MOST_WAITING) return problem(response.set('retry-after', '10'), 503, 'Too many drawings wait. Try again in ten seconds.');
  const options = quoteOptions(request.query, machines);
  const id = idOf(drawing, options);
  if ((await queue.getJob(id)) === undefined) {
    // The file is renamed when it is complete, so that no worker reads a part of it.
    const half = `${drawingOf(id)}.${process.pid}.${performance.now()}`;
    await writeFile(half, drawing);
    await rename(half, drawingOf(id));
    await queue.add('quote', options, { jobId: id });
  }
  response.status(202).location(`/quotes/${id}`).json({ id });
});

app.get('/quotes/:id', async (request, response) => {
  // The state first: what is read after it is at least as new.
  const state = await queue.getJobState(request.params.id);
  const job = await queue.getJob(request.params.id);
  if (job === undefined) problem(response, 404, 'There is no such quote, or it is older than a day.');
  else if (state === 'completed') response.json(job.returnvalue);
  else if (state === 'failed') problem(response, ...whyFailed(job.failedReason));
  else response.status(202).json({ id: job.id, state });
});

app.get('/health', async (_, response) => {
  response.json({ ...(await queue.getJobCounts()), megabytes: process.memoryUsage().rss / 1e6 });
});

// A wrong option, errors of Express itself (a drawing over the limit, a broken connection), and a queue that does not answer.
app.use((error, _request, response, _next) => {
  if (error instanceof OptionError) return problem(response, 400, error.message);
  if (error.status === 413) return problem(response, 413, `The drawing is larger than ${LARGEST}.`);
  console.error(error);
  problem(response, error.status ?? 500, 'The drawing could not be received.');
});

const server = app.listen(process.env.PORT ?? 3000, () => console.log(`Send drawings to http://localhost:${server.address().port}/quotes`));
process.on('SIGTERM', () => {
  server.close();
  void queue.close();
});

function problem(response, status, text) {
  response.status(status).json({ problem: text });
}

/** Refuses a form by its content type, before its body is read. */
function refuseForms(request, response, next) {
  if (request.is('multipart/*')) problem(response, 415, FORM);
  else next();
}

/** The status and the sentence for a job that failed. Only faults that the sender can correct are described in detail. */
function whyFailed(reason) {
  if (/stalled/.test(reason)) return [422, GIVEN_UP];
  if (reason.startsWith(UNUSABLE)) return [422, reason.slice(UNUSABLE.length)];
  return [500, FAULT];
}

async function machineNames() {
  const planner = await createPlanner();
  const names = planner.machines.map((m) => m.name);
  planner.close();
  return names;
}
