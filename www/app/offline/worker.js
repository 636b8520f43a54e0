// Stores the page for use without a network. The files of a first visit are stored at once; the writers of programs, and what few people need,
// when the page says that its first seconds are over. What is loaded on demand (the PNG renderer, the file for SVG and methods of papers, further
// samples, another language) is stored when it is first used. The build fills in the lists of files, and a version made of their contents. A
// newer version is stored while the old one is open and replaces it at the next visit, so that a page never mixes files of two builds. Only the
// page's own files pass through here.

const VERSION = 'kerfway-__VERSION__';
const FILES = __FILES__;
const LATER = __LATER__;

self.addEventListener('install', (event) => {
  event.waitUntil(caches.open(VERSION).then((cache) => cache.addAll(FILES)));
});

self.addEventListener('activate', (event) => {
  const drop = async () => {
    const names = await caches.keys();
    await Promise.all(names.filter((n) => n.startsWith('kerfway-') && n !== VERSION).map((n) => caches.delete(n)));
    await self.clients.claim();
  };
  event.waitUntil(drop());
});

self.addEventListener('message', (event) => {
  if (event.data !== 'later') return;
  const store = async () => {
    const cache = await caches.open(VERSION);
    for (const file of LATER) if ((await cache.match(file)) === undefined) await cache.add(file);
  };
  event.waitUntil(store());
});

self.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method !== 'GET' || !request.url.startsWith(self.registration.scope)) return;
  const answer = async () => {
    const cache = await caches.open(VERSION);
    const kept = await cache.match(request.mode === 'navigate' ? './' : request, { ignoreSearch: true });
    if (kept !== undefined) return kept;
    const fetched = await fetch(request);
    if (fetched.ok) await cache.put(request, fetched.clone());
    return fetched;
  };
  event.respondWith(answer());
});
