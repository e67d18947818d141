// The machine in a worker: requests in, answers out, one after the other.
import make_engine, { type Engine, type EngineModule } from 'gw-engine';
import make_scalar from 'gw-scalar';
import { decode, type DecodedPng } from 'fast-png';
import { folder } from './data';
import type { Answer, Files, Methods, Request, SceneFacts } from './protocol';
import { bytesOf, unpacked } from './unpacked';

let lab: EngineModule;
let engine: Engine;
/** Files that are textures, decoded when a scene asks for them. */
const pictures = new Map<string, Uint8Array>();

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
    if (/\.png$/i.test(path)) pictures.set(path, bytes);
  }
}

/** By path, "/scenes/hidden/cycle.toml". */
async function sceneFiles(text: string): Promise<Files> {
  const files = (await unpacked(text, 'application/json').json()) as Record<string, string>;
  return Object.fromEntries(
    Object.entries(files).map(([name, base64]) => [folder + name, bytesOf(base64)]),
  );
}

function decoded(path: string, bytes: Uint8Array): DecodedPng {
  try {
    return decode(bytes);
  } catch (error) {
    throw new Error(`${path}: ${(error as Error).message}; expected a PNG picture`);
  }
}

/** Four channels, as the file has their values. */
function addPicture(path: string): void {
  const bytes = pictures.get(path);
  if (!bytes) return;
  const png = decoded(path, bytes);
  const { width, height, channels, depth } = png;
  const count = width * height;
  const most = depth === 16 ? 65535 : 255;
  const rgba = depth === 16 ? new Uint16Array(count * 4) : new Uint8Array(count * 4);
  const grey = channels < 3;
  for (let i = 0; i < count; ++i) {
    let from = i * channels;
    const color = png.palette ? png.palette[png.data[i]!]! : undefined;
    for (let c = 0; c < 3; ++c)
      rgba[i * 4 + c] = color ? color[c]! : png.data[grey ? from : from + c]!;
    from += channels - 1;
    const alpha = color ? (color[3] ?? 255) : channels % 2 === 0 ? png.data[from]! : most;
    rgba[i * 4 + 3] = alpha;
  }
  const texels = new Uint8Array(rgba.buffer);
  const { error } = engine.add_picture(path, width, height, depth === 16 ? 16 : 8, texels);
  if (error !== undefined) throw new Error(error);
  pictures.delete(path);
}

type Own = 'start' | 'write' | 'open';
/** What is more than a method of the engine. */
const own: { [M in Own]: (...values: Parameters<Methods[M]>) => unknown } = {
  async start(engineText, vectors, scenesText) {
    const compiling =
      engineText instanceof WebAssembly.Module
        ? engineText
        : WebAssembly.compileStreaming(unpacked(engineText, 'application/wasm'));
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
  open(path) {
    const facts = called('open', { path }) as SceneFacts & { pictures: string[] };
    facts.pictures.forEach(addPicture);
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
