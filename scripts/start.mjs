// npm start: sets up, builds, serves the page and says where. PORT chooses another port.

import { join } from 'node:path';
import { build } from './build.mjs';
import { serve } from './serve.mjs';
import { setup } from './setup.mjs';
import { DIST, main } from './tools.mjs';

/** The port tried first; a free one is taken when it is in use. */
const PORT = Number(process.env.PORT ?? 4173);

main(async () => {
  setup();
  build();
  const page = join(DIST, 'app');
  const { url } = await serve(page, PORT).catch((error) => {
    if (error.code !== 'EADDRINUSE') throw error;
    return serve(page, 0);
  });
  console.log(`\nKerfway is at ${url} with a sample sheet loaded. Ctrl-C ends it.`);
});
