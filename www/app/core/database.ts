/** Tables of values by key that stay in this browser (IndexedDB), with promises. */

export class Database {
  private opened: Promise<IDBDatabase> | null = null;

  constructor(private readonly name: string, private readonly tables: readonly string[]) {}

  /** The value of a key; undefined if there is none. */
  async get<T>(table: string, key: string): Promise<T | undefined> {
    const store = (await this.open()).transaction(table).objectStore(table);
    return result(store.get(key) as IDBRequest<T | undefined>);
  }

  /** Whether there is a value of a key, or of any. */
  async has(table: string, key?: string): Promise<boolean> {
    return (await result((await this.open()).transaction(table).objectStore(table).count(key))) > 0;
  }

  /** All keys of a table with their values. */
  async all<T>(table: string): Promise<[key: string, value: T][]> {
    const store = (await this.open()).transaction(table).objectStore(table);
    const [keys, values] = await Promise.all([result(store.getAllKeys()), result(store.getAll() as IDBRequest<T[]>)]);
    return keys.map((key, k) => [String(key), values[k]!]);
  }

  /** Stores values and deletes keys, all of them or none. */
  async change(puts: readonly (readonly [table: string, key: string, value: unknown])[], deletions: readonly (readonly [table: string, key: string])[] = []): Promise<void> {
    const transaction = (await this.open()).transaction(this.tables, 'readwrite');
    for (const [table, key, value] of puts) transaction.objectStore(table).put(value, key);
    for (const [table, key] of deletions) transaction.objectStore(table).delete(key);
    await new Promise<void>((done, failed) => {
      transaction.oncomplete = () => done();
      transaction.onabort = () => failed(transaction.error);
    });
  }

  private open(): Promise<IDBDatabase> {
    if (this.opened === null) {
      const request = indexedDB.open(this.name, 1);
      request.onupgradeneeded = () => this.tables.forEach((table) => request.result.createObjectStore(table));
      this.opened = result(request);
    }
    return this.opened;
  }
}

function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error);
  });
}
