// The machine in a worker: requests in, answers out, one after the other.
import make_engine, { type Engine, type EngineModule } from 'gw-engine';
import make_scalar from 'gw-scalar';
import { decode } from 'fast-png';
import { folder } from './data';
import type { Answer, Files, Methods, Request, SceneFacts } from './protocol';
import { bytesOf, unpackedAs } from '../../model/packed';

let lab: EngineModule;
let engine: Engine;
/** Textures that the engine has. */
const added = new Set<string>();

/** Paths of the scene's textures. */
interface Textures {
  readonly pictures: readonly string[];
  /** Within the scene's file. */
  readonly embedded: readonly string[];
}

/** The engine's answer: JSON or a text, and planes. */
function called(method: string, options: unknown): unknown {
  const { error, json, ...rest } = engine.call(method, JSON.stringify(options));
  if (error !== undefined) throw new Error(error);
  return json === undefined ? rest : Object.assign(JSON.parse(json) as object, rest);
}

function write(files: Files): void {
  for (const [path, bytes] of Object.entries(files)) {
    lab.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    lab.FS.writeFile(path, bytes);
  }
  added.clear();
}

/** By path, "/scenes/hidden/cycle.toml". */
async function sceneFiles(text: string): Promise<Files> {
  const files = (await unpackedAs(text, 'application/json').json()) as Record<string, string>;
  return Object.fromEntries(
    Object.entries(files).map(([name, base64]) => [folder + name, bytesOf(base64)]),
  );
}

interface Picture {
  readonly width: number;
  readonly height: number;
  /** Four channels, as the file has their values. */
  readonly rgba: Uint8Array | Uint8ClampedArray | Uint16Array;
}

function decodedPng(bytes: Uint8Array): Picture {
  const { width, height, channels, depth, palette, data } = decode(bytes);
  const count = width * height;
  const most = depth === 16 ? 65535 : 255;
  const rgba = depth === 16 ? new Uint16Array(count * 4) : new Uint8Array(count * 4);
  const grey = channels < 3;
  for (let i = 0; i < count; ++i) {
    let from = i * channels;
    const color = palette?.[data[i]!];
    for (let c = 0; c < 3; ++c) rgba[i * 4 + c] = color ? color[c]! : data[grey ? from : from + c]!;
    from += channels - 1;
    const alpha = color ? (color[3] ?? 255) : channels % 2 === 0 ? data[from]! : most;
    rgba[i * 4 + 3] = alpha;
  }
  return { width, height, rgba };
}

/** JPEG and what else the browser reads. */
async function decodedByBrowser(bytes: Uint8Array): Promise<Picture> {
  const bitmap = await createImageBitmap(new Blob([bytes]), {
    colorSpaceConversion: 'none',
    imageOrientation: 'none',
    premultiplyAlpha: 'none',
  }).catch(() => Promise.reject(new Error('the browser cannot read it')));
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return { width, height, rgba: context.getImageData(0, 0, width, height).data };
}

const isPng = (bytes: Uint8Array): boolean => bytes[0] === 0x89 && bytes[1] === 0x50;

async function addPicture(path: string, bytes: Uint8Array): Promise<void> {
  let picture: Picture;
  try {
    picture = isPng(bytes) ? decodedPng(bytes) : await decodedByBrowser(bytes);
  } catch (error) {
    throw new Error(`${path}: ${(error as Error).message}; expected a PNG or JPEG picture`);
  }
  const { width, height, rgba } = picture;
  const bits = rgba.BYTES_PER_ELEMENT * 8;
  const texels = new Uint8Array(rgba.buffer);
  const { error } = engine.add_picture(path, width, height, bits, texels);
  if (error !== undefined) throw new Error(error);
  added.add(path);
}

/** A picture that is not here is missed when it is drawn. */
async function addPictures({ pictures, embedded }: Textures): Promise<void> {
  for (const path of pictures)
    if (!added.has(path) && lab.FS.analyzePath(path).exists)
      await addPicture(path, lab.FS.readFile(path));
  for (const path of embedded)
    if (!added.has(path))
      await addPicture(path, (called('embedded', { path }) as { picture: Uint8Array }).picture);
}

type Own = 'start' | 'write' | 'open';
/** What is more than a method of the engine. */
const own: { [M in Own]: (...values: Parameters<Methods[M]>) => unknown } = {
  async start(engineText, vectors, scenesText) {
    const compiling =
      engineText instanceof WebAssembly.Module
        ? engineText
        : WebAssembly.compileStreaming(unpackedAs(engineText, 'application/wasm'));
    const files = sceneFiles(scenesText);
    const module = await compiling;
    const make = vectors ? make_engine : make_scalar;
    lab = await new Promise<EngineModule>((resolve, reject) => {
      const instantiateWasm = (
        imports: WebAssembly.Imports,
        done: (instance: WebAssembly.Instance) => void,
      ): object => {
        WebAssembly.instantiate(module, imports).then(done, reject);
        return {};
      };
      make({ instantiateWasm, locateFile: (name) => name }).then(resolve, reject);
    });
    engine = new lab.Engine();
    write(await files);
    return { ...(called('about', {}) as object), scenes: Object.keys(await files), module };
  },
  write,
  async open(path) {
    const facts = called('open', { path }) as SceneFacts & Textures;
    await addPictures(facts);
    const { warnings } = called('finish', {}) as Pick<SceneFacts, 'warnings'>;
    return { ...facts, warnings: [...facts.warnings, ...warnings] };
  },
};

/**
 * The engine answers its refusals itself; a number is an exception for which text found no room.
 */
function reasonOf(error: unknown): string {
  if (typeof error === 'number') return 'not enough memory; expected a smaller scene or picture';
  return error instanceof Error ? error.message : String(error);
}

async function take({ number, method, values }: Request): Promise<void> {
  const answer = (rest: Omit<Answer, 'number'>) => self.postMessage({ number, ...rest });
  try {
    const call = own[method as Own] as ((...all: readonly unknown[]) => unknown) | undefined;
    answer({ value: await (call ? call(...values) : called(method, values[0])) });
  } catch (error) {
    answer({ error: reasonOf(error) });
  }
}

let last = Promise.resolve();
self.onmessage = (event: MessageEvent<Request>) => {
  last = last.then(() => take(event.data));
};
