// The visitor's own files, kept by the browser, so that a reload finds them. A browser that keeps
// nothing gives nothing.
import type { Files } from './protocol';

const store = 'files';

function database(): Promise<IDBDatabase> {
  return new Promise((done, failed) => {
    const request = indexedDB.open('gw lab', 1);
    request.onupgradeneeded = () => request.result.createObjectStore(store);
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error ?? new Error('no database'));
  });
}

/** Adds files by path; files of the same path are replaced. */
export async function keepFiles(files: Files): Promise<void> {
  try {
    const base = await database();
    const writing = base.transaction(store, 'readwrite');
    for (const [path, bytes] of Object.entries(files)) writing.objectStore(store).put(bytes, path);
    await new Promise((done) => (writing.oncomplete = writing.onerror = writing.onabort = done));
    base.close();
  } catch {
    // They are there until the page is closed.
  }
}

export async function keptFiles(): Promise<Files> {
  try {
    const base = await database();
    const files: Record<string, Uint8Array> = {};
    await new Promise((done) => {
      const reading = base.transaction(store).objectStore(store).openCursor();
      reading.onerror = done;
      reading.onsuccess = () => {
        const at = reading.result;
        if (!at) return done(undefined);
        files[String(at.key)] = at.value as Uint8Array;
        at.continue();
      };
    });
    base.close();
    return files;
  } catch {
    return {};
  }
}
