// The drawings of a bench.

import { existsSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';

/** The DXF files in folders, each name once; folders that do not exist have none. `only`: what the path contains. */
export function drawings(folders, only = '') {
  const files = folders
    .filter((folder) => existsSync(folder))
    .flatMap((folder) => readdirSync(folder).filter((f) => /\.dxf$/i.test(f)).sort().map((f) => join(folder, f)));
  const seen = new Set();
  return files.filter((file) => file.includes(only) && !seen.has(basename(file)) && seen.add(basename(file)));
}
