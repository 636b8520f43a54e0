// A small static server for the built page. It sends the right types and nothing from outside its folder, and the Content-Security-Policy of
// www/policy.json with every file, workers included. Browsers ask for each file again, but get its bytes again only after it has changed. A
// file that lies there compressed as well (`x.js.br` beside `x.js`) is sent so to browsers that take Brotli.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { policyWith } from './policy.mjs';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ico': 'image/x-icon',
  '.dxf': 'image/vnd.dxf',
};

/**
 * Serves `folder` on this machine only. `port` 0 takes a free port, `more` changes directives of the policy, `onSent` is called with each
 * file whose bytes are sent, and the file they come from, which may be the compressed one. Resolves to `{ url, close }`.
 */
export function serve(folder, port = 0, more = {}, onSent = () => {}) {
  const policy = policyWith(more);
  const server = createServer((request, response) => {
    const file = fileFor(folder, request.url ?? '/');
    if (file === null) {
      response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found\n');
      return;
    }
    const takesBrotli = /\bbr\b/.test(request.headers['accept-encoding'] ?? '');
    const compressed = takesBrotli && statSync(`${file}.br`, { throwIfNoEntry: false })?.isFile();
    const source = compressed ? `${file}.br` : file;
    const { size, mtimeMs } = statSync(source);
    const etag = `"${size.toString(36)}-${mtimeMs.toString(36)}"`;
    const headers = { etag, vary: 'accept-encoding', 'cache-control': 'no-cache', 'content-security-policy': policy };
    if (request.headers['if-none-match'] === etag) {
      response.writeHead(304, headers).end();
      return;
    }
    const type = TYPES[extname(file).toLowerCase()] ?? 'application/octet-stream';
    response.writeHead(200, { ...headers, ...(compressed && { 'content-encoding': 'br' }), 'content-type': type, 'content-length': size });
    onSent(file, source);
    createReadStream(source).pipe(response);
  });
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, '127.0.0.1', () => {
      const close = () =>
        new Promise((done) => {
          server.close(done);
          server.closeAllConnections();
        });
      resolve({ url: `http://127.0.0.1:${server.address().port}/`, close });
    });
  });
}

function fileFor(folder, url) {
  let path;
  try {
    path = decodeURIComponent(url.split(/[?#]/, 1)[0]);
  } catch {
    return null;
  }
  const file = normalize(join(folder, path.endsWith('/') ? `${path}index.html` : path));
  const inside = file.startsWith(normalize(folder) + sep);
  return inside && statSync(file, { throwIfNoEntry: false })?.isFile() ? file : null;
}
