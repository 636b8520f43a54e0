// npm start: sets up, builds for trying out, serves the page and says where. PORT chooses another port.

import { join } from 'node:path';
import { build, compiling } from './build.mjs';
import { serve } from './serve.mjs';
import { missing } from './setup.mjs';
import { sinceStart, together } from './together.mjs';
import { DIST, main } from './tools.mjs';

/** The port tried first; a free one is taken when it is in use. */
const PORT = Number(process.env.PORT ?? 4173);

main(async () => {
  // Our own crate compiles beside the tools: together they take two cores, one after the other mostly one.
  await together([...missing(), ...compiling({ quick: true })]);
  await build({ quick: true });
  const page = join(DIST, 'app');
  const { url } = await serve(page, PORT).catch((error) => {
    if (error.code !== 'EADDRINUSE') throw error;
    return serve(page, 0);
  });
  console.log(`\nReady after ${sinceStart()}. Kerfway is at ${url} with a sample sheet loaded. Ctrl-C ends it.`);
});
