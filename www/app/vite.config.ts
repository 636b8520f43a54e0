import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const at = (path: string) => fileURLToPath(new URL(path, import.meta.url));

// The page uses the built package as an embedder would; any folder can serve the result.
export default defineConfig({
  root: at('.'),
  base: './',
  resolve: { alias: { kerfway: at('../../dist/sdk/index.js') } },
  worker: { format: 'es' },
  build: { outDir: at('../../dist/app'), emptyOutDir: true, target: 'es2022' },
});
