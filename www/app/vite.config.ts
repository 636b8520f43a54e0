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

// The page uses the built package as any other site would; any web server can serve the result.
export default defineConfig({
  root: at('.'),
  base: './',
  resolve: { alias: { kerfway: at('../../dist/sdk/index.js') } },
  plugins: [contentSecurityPolicy],
  worker: { format: 'es' },
  build: {
    outDir: at('../../dist/app'), emptyOutDir: true, target: 'es2022',
    // Languages are loaded on demand. The build and the service worker know them by their names.
    rolldownOptions: { output: { chunkFileNames: ({ facadeModuleId }) => (/core\/words\/\w+\.ts$/.test(facadeModuleId ?? '') ? 'assets/language-[name]-[hash].js' : 'assets/[name]-[hash].js') } },
  },
});
