# The service: docker build -t kerfway . && docker run --rm -p 8080:8080 kerfway
# The package is built from the repository in the first stage; the second has Node, the package and the libraries of its queue.

FROM rust:1-slim-bookworm AS build
RUN apt-get update && apt-get install -y --no-install-recommends ca-certificates curl xz-utils build-essential pkg-config && rm -rf /var/lib/apt/lists/*
COPY --from=node:22-bookworm-slim /usr/local/ /usr/local/
WORKDIR /kerfway
COPY . .
RUN rustup target add wasm32-unknown-unknown && npm run build && npm pack --pack-destination /tmp

FROM node:22-bookworm-slim
WORKDIR /service
COPY --from=build /tmp/kerfway-*.tgz kerfway.tgz
RUN npm install --no-audit --no-fund --omit=dev ./kerfway.tgz bullmq@6 ioredis@6 && npm cache clean --force && rm kerfway.tgz
USER node
EXPOSE 8080
HEALTHCHECK --interval=10s --timeout=3s CMD ["node", "-e", "fetch('http://127.0.0.1:8080/healthz').then((r) => process.exit(r.ok ? 0 : 1), () => process.exit(1))"]
# Node as the first process gets SIGTERM itself and finishes what runs.
ENTRYPOINT ["node", "node_modules/kerfway/dist/sdk/cli.js"]
CMD ["serve", "--host", "0.0.0.0", "--port", "8080"]
