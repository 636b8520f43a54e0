// The words of the page and other modules of its sources, as JavaScript.

import { join } from 'node:path';
import { buildSync } from 'esbuild';
import { ROOT } from './support.mjs';

export const APP = join(ROOT, 'www', 'app');
export const WORDS = join(APP, 'core', 'words');

/** A module of the page's sources with all that it imports. */
export async function bundled(file) {
  const { outputFiles: [bundle] } = buildSync({ entryPoints: [file], bundle: true, format: 'esm', write: false });
  return import(`data:text/javascript;base64,${Buffer.from(bundle.text).toString('base64')}`);
}

/** The words of a language. */
export const wordsOf = async (language) => (await bundled(join(WORDS, `${language}.ts`)))[language];
