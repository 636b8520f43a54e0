// Loaded first by every Node process that the tests start: sets an option of V8 that NODE_OPTIONS does not take (scripts/test.mjs).

import { setFlagsFromString } from 'node:v8';

setFlagsFromString(process.env.KERFWAY_V8);
