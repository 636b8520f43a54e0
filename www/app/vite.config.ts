import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import policy from '../policy.json' with { type: 'json' };

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/**
 * What the built page may load, and where it may connect to: its own folder and nothing else. It is added by the build, because the development
 * server needs more, and it is in the page itself, because any web server can serve the folder.
 */
const POLICY = Object.entries(policy).map(([what, from]) => `${what} ${from}`).join('; ');

const contentSecurityPolicy: Plugin = {
  name: 'content-security-policy',
  apply: 'build',
  transformIndexHtml: () => [{ tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: POLICY }, injectTo: 'head-prepend' }],
};

/**
 * The kind of a file by its first module. Languages are stored for use without a network when they are first used; other parts of the page, and what
 * several of them share, with the writers of programs.
 */
function kindOf(module: string): string {
  if (/core\/words\/\w+\.ts$/.test(module)) return 'language-';
  return /www\/app\/(session|panels|core)\/[\w-]+\.ts$/.test(module) ? 'later-' : '';
}

/** The modules of the package that only reports, savings and project files take, although its index, which the page needs at once, exports them. */
const LATER = /sdk\/(job-report|report-text|thumbnail|savings|project-file)\.js$/;

/** Whether the page needs a module at once: from its own script, imports that are no calls lead to it. */
function isNeededAtOnce(module: string, modules: { getModuleInfo(id: string): { isEntry: boolean; importers: readonly string[] } | null }): boolean {
  const found = new Set([module]);
  for (const id of found) {
    const info = modules.getModuleInfo(id);
    if (info?.isEntry) return true;
    info?.importers.forEach((from) => found.add(from));
  }
  return false;
}

// The page uses the built package as any other site would; any web server can serve the result.
export default defineConfig({
  root: at('.'),
  base: './',
  resolve: { alias: { kerfway: at('../../dist/sdk/index.js') } },
  plugins: [contentSecurityPolicy],
  worker: { format: 'es' },
  build: {
    outDir: at('../../dist/app'), emptyOutDir: true, target: 'es2022',
    // Nothing is preloaded that an old browser would have to be taught.
    modulePreload: { polyfill: false },
    rolldownOptions: {
      // The page opens planners itself: reading a function of the package that it does not call keeps nothing.
      treeshake: { propertyReadSideEffects: false },
      output: {
        // What the page needs at once is one file: many small ones are larger when they are compressed.
        codeSplitting: { groups: [{ debugName: 'page', name: (id, context) => (isNeededAtOnce(id, context) && !LATER.test(id) ? 'page' : null) }] },
        // What it loads when it is needed. The build and the service worker know these files by their names.
        chunkFileNames: ({ facadeModuleId, moduleIds, name }) => `assets/${name === 'page' ? '' : kindOf(facadeModuleId ?? moduleIds[0] ?? '')}[name]-[hash].js`,
      },
    },
  },
});
