// The instances that benches read. `benches/data/manifest.json` names every one with its checksum: those that are stored in the
// repository (compressed, or as a fixture of the tests), and those that may not be copied into it. The latter are taken from the
// folder that `--data` names, if they are there. All are unpacked into `target/bench-data`, each beside the list of values known.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { ROOT, Stop } from '../../scripts/tools.mjs';

const DATA = join(ROOT, 'benches', 'data');
const UNPACKED = join(ROOT, 'target', 'bench-data');

/** The layers of the sheets that are not cut, as options. */
export const IGNORED = ['SHEET', 'MARK'].map((name) => ({ name, operation: 'ignore' }));

/** What a table says of an instance that is not here. */
export const NOT_RUN = 'not run';

export class Instances {
  #folder;
  #entries;
  #missing = new Set();

  /** `folder`: the value of `--data`, or nothing. */
  constructor(folder) {
    if (folder !== undefined && !existsSync(folder)) throw new Stop(`--data ${folder}: there is no such folder.`);
    this.#folder = folder;
    const { files, missing } = JSON.parse(readFileSync(join(DATA, 'manifest.json'), 'utf8'));
    this.#entries = new Map([...files, ...missing].map((entry) => [entry.path, entry]));
  }

  /** Paths of the manifest in a folder that end in `extension`; `only` is a part of the file's name. */
  list(set, extension, only = '') {
    const inside = (path) => path.startsWith(`${set}/`) && path.endsWith(extension);
    return [...this.#entries.keys()].filter((path) => inside(path) && path.slice(set.length + 1).includes(only));
  }

  /** Where an instance can be read, its checksum compared; `null` when it may not be stored here and `--data` does not have it. */
  find(path) {
    const entry = this.#entries.get(path);
    if (entry === undefined) throw new Stop(`benches/data/manifest.json does not name ${path}.`);
    const bytes = this.#read(entry);
    if (bytes === null) {
      this.#missing.add(path);
      return null;
    }
    const unpacked = join(UNPACKED, path);
    mkdirSync(dirname(unpacked), { recursive: true });
    writeFileSync(unpacked, bytes);
    return unpacked;
  }

  /** The same for what is always stored in the repository. */
  file(path) {
    return this.find(path) ?? this.#stop(path);
  }

  /** Says which instances were not run, why, and what to do. */
  report() {
    const reasonOf = (path) => this.#entries.get(path).reason;
    for (const reason of new Set([...this.#missing].map(reasonOf))) {
      const paths = [...this.#missing].filter((path) => reasonOf(path) === reason);
      console.log(
        `${NOT_RUN}: ${paths.length} instance${paths.length === 1 ? '' : 's'} (${paths.slice(0, 4).join(', ')}${paths.length > 4 ? ', ...' : ''}), ` +
          `which may not be copied into this repository: ${reason}. benches/data/manifest.json says where each comes from; give the folder by --data.`,
      );
    }
    this.#missing.clear();
  }

  #read({ path, sha256, stored }) {
    const file = stored === undefined ? this.#folder && join(resolve(this.#folder), path) : join(ROOT, stored);
    if (!file || !existsSync(file)) return stored === undefined ? null : this.#stop(path);
    const raw = readFileSync(file);
    const bytes = file.endsWith('.gz') ? gunzipSync(raw) : raw;
    if (createHash('sha256').update(bytes).digest('hex') !== sha256) {
      throw new Stop(`${file} is not the file that the figures were measured on: its checksum differs from that in benches/data/manifest.json.`);
    }
    return bytes;
  }

  #stop(path) {
    throw new Stop(`${path} is missing in benches/data: check the repository out again.`);
  }
}
