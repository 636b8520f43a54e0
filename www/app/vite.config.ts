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

/** Languages are stored for use without a network when they are first used; other parts of the page with the writers of programs. */
function kindOf(module: string): string {
  if (/core\/words\/\w+\.ts$/.test(module)) return 'language-';
  return /www\/app\/session\/\w+\.ts$/.test(module) ? 'later-' : '';
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
    // What the page loads when it is needed. The build and the service worker know these files by their names.
    rolldownOptions: { output: { chunkFileNames: ({ facadeModuleId }) => `assets/${kindOf(facadeModuleId ?? '')}[name]-[hash].js` } },
  },
});
