// Accepts drawings, puts them into the queue, and returns the results:
//
//     curl --data-binary @plate.dxf 'localhost:3000/quotes?name=plate.dxf&thickness=3&density=1.19'      202, with the address of the answer
//     curl localhost:3000/quotes/ID                                                                    202 waits, 200 the report, 422 the problem

import { mkdir, rename, writeFile } from 'node:fs/promises';
import { Queue } from 'bullmq';
import express from 'express';
import { connection, DRAWINGS, drawingOf, idOf, JOB, LARGEST, MOST_WAITING, QUEUE } from './queue.mjs';

const GIVEN_UP = 'Two workers died of this drawing. It may need more memory than there is.';

await mkdir(DRAWINGS, { recursive: true });
const queue = new Queue(QUEUE, { connection, defaultJobOptions: JOB });
const app = express();

app.post('/quotes', express.raw({ type: () => true, limit: LARGEST }), async (request, response) => {
  if ((await queue.getWaitingCount()) >= MOST_WAITING) {
    response.status(503).set('retry-after', '10').json({ problem: 'Too many drawings wait. Try again in ten seconds.' });
    return;
  }
  const { name = 'drawing.dxf', machine = 'co2-100w', thickness, density } = request.query;
  const material = Object.fromEntries(Object.entries({ thickness, density }).filter(([, v]) => v !== undefined).map(([key, v]) => [key, Number(v)]));
  const options = { name: String(name), machine: String(machine), material };
  const drawing = Buffer.isBuffer(request.body) ? request.body : Buffer.alloc(0);
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
  if (job === undefined) response.status(404).json({ problem: 'There is no such quote, or it is older than a day.' });
  else if (state === 'completed') response.json(job.returnvalue);
  else if (state === 'failed') response.status(422).json({ problem: /stalled/.test(job.failedReason) ? GIVEN_UP : job.failedReason });
  else response.status(202).json({ id: job.id, state });
});

app.get('/health', async (_, response) => {
  response.json({ ...(await queue.getJobCounts()), megabytes: process.memoryUsage().rss / 1e6 });
});

// Errors of Express itself (a drawing over the limit, a broken connection), and a queue that does not answer.
app.use((error, _request, response, _next) => {
  response.status(error.status ?? 500).json({ problem: error.status === 413 ? `The drawing is larger than ${LARGEST}.` : 'The drawing could not be received.' });
});

const server = app.listen(process.env.PORT ?? 3000, () => console.log(`Send drawings to http://localhost:${server.address().port}/quotes`));
process.on('SIGTERM', () => {
  server.close();
  void queue.close();
});
