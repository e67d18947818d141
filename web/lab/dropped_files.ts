// The files that a visitor drops on the page, folders with all that is in them.

/** By path from what was dropped: "room/textures/wood.png". */
export type Dropped = Record<string, File>;

/** A file or folder that cannot be read; the message is its name. */
export class Unreadable extends Error {}

export const byName = (files: Iterable<File>): Dropped =>
  Object.fromEntries([...files].map((file) => [file.name, file]));

/** Chromium opens a folder for a page that is a file only by a handle; others have no handles. */
interface WithHandle {
  getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
}

async function addHandle(
  folder: FileSystemDirectoryHandle,
  path: string,
  to: Dropped,
): Promise<void> {
  for await (const [name, inside] of folder as unknown as AsyncIterable<[string, FileSystemHandle]>)
    if (inside.kind === 'file')
      to[`${path}/${name}`] = await (inside as FileSystemFileHandle).getFile();
    else await addHandle(inside as FileSystemDirectoryHandle, `${path}/${name}`, to);
}

const fileOf = (entry: FileSystemFileEntry): Promise<File> =>
  new Promise((done, failed) => entry.file(done, failed));

/** A reader gives some hundred entries a call, and none at the end. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, failed) =>
      reader.readEntries(done, failed),
    );
    if (some.length === 0) return all;
    all.push(...some);
  }
}

async function addEntry(
  folder: FileSystemDirectoryEntry,
  path: string,
  to: Dropped,
): Promise<void> {
  for (const inside of await entriesOf(folder))
    if (inside.isFile) to[`${path}/${inside.name}`] = await fileOf(inside as FileSystemFileEntry);
    else await addEntry(inside as FileSystemDirectoryEntry, `${path}/${inside.name}`, to);
}

interface Folder {
  readonly entry: FileSystemDirectoryEntry;
  readonly handle: Promise<FileSystemHandle | null> | undefined;
}

async function addFolder({ entry, handle }: Folder, to: Dropped): Promise<void> {
  const found = await handle?.catch(() => null);
  if (found?.kind === 'directory')
    await addHandle(found as FileSystemDirectoryHandle, entry.name, to);
  else await addEntry(entry, entry.name, to);
}

/** Rejects with Unreadable. */
export async function droppedFiles(data: DataTransfer): Promise<Dropped> {
  // All of the data is gone after the first await.
  const folders: Folder[] = [];
  for (const item of data.items) {
    const entry = item.webkitGetAsEntry();
    const handle = (item as WithHandle).getAsFileSystemHandle;
    if (entry?.isDirectory)
      folders.push({ entry: entry as FileSystemDirectoryEntry, handle: handle?.call(item) });
  }
  const names = new Set(folders.map(({ entry }) => entry.name));
  const files = byName([...data.files].filter(({ name }) => !names.has(name)));
  for (const folder of folders)
    await addFolder(folder, files).catch(() => Promise.reject(new Unreadable(folder.entry.name)));
  return files;
}

const kinds = [/\.toml$/i, /\.(gltf|glb)$/i, /\.obj$/i];
export const isScene = (path: string): boolean => kinds.some((kind) => kind.test(path));

/** The scene to open: TOML first, and what lies in fewer folders. */
export function mainScene(paths: readonly string[]): string | undefined {
  const depth = (path: string): number => path.split('/').length;
  for (const kind of kinds) {
    const found = paths.filter((path) => kind.test(path));
    if (found.length > 0) return found.reduce((a, b) => (depth(b) < depth(a) ? b : a));
  }
  return undefined;
}
