// The rows of the benchmark kit as CSV (RFC 4180). Numbers are read as numbers.

export function write(rows) {
  const columns = [...new Set(rows.flatMap(Object.keys))];
  const cell = (value) => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
  return [columns, ...rows.map((row) => columns.map((c) => row[c] ?? ''))].map((line) => `${line.map(cell).join(',')}\n`).join('');
}

export function parse(text) {
  const [columns, ...lines] = text.trimEnd().split('\n').map(split);
  const value = (cell) => (cell !== '' && Number.isFinite(Number(cell)) ? Number(cell) : cell);
  return lines.map((cells) => Object.fromEntries(columns.map((c, i) => [c, value(cells[i])])));
}

const split = (line) => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted?.replaceAll('""', '"') ?? plain);
