// Loaded before the command line (`node --import`), this module makes the disk fail at a chosen moment. `FAULT` is an error code or
// the name of a signal, `FAULT_AT` the number (from 1) of the write that it interrupts, `FAULT_CALL` the name of the call.

import fs from 'node:fs';
import { syncBuiltinESMExports } from 'node:module';

const { FAULT, FAULT_AT = '1', FAULT_CALL = 'write' } = process.env;
let calls = 0;

/** Whether this call is the one that fails. */
const due = () => ++calls === Number(FAULT_AT);

/** What happens in it. */
function fail() {
  if (FAULT.startsWith('SIG')) process.kill(process.pid, FAULT);
  else throw Object.assign(new Error(`${FAULT}: from the test`), { code: FAULT });
}

if (FAULT_CALL === 'write') {
  const { writeSync, promises: { writeFile } } = fs;
  fs.writeSync = (file, bytes, at = 0, ...others) => {
    if (file <= 2 || !due()) return writeSync(file, bytes, at, ...others);
    const half = Math.ceil((bytes.length - at) / 2);
    const written = writeSync(file, bytes, at, half);
    fail();
    return written;
  };
  fs.promises.writeFile = async (file, data, ...others) => {
    if (!due()) return writeFile(file, data, ...others);
    await writeFile(file, data.slice(0, data.length / 2), ...others);
    fail();
    await new Promise((resume) => setTimeout(resume, 100));
    return writeFile(file, data, ...others);
  };
} else {
  const call = fs[FAULT_CALL];
  fs[FAULT_CALL] = (...args) => {
    if (due()) fail();
    return call(...args);
  };
}
syncBuiltinESMExports();
