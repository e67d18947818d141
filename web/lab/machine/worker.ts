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

/** The engine's answer, or its refusal as an error. */
function answered(text: string): string {
  if (text.startsWith('{"error":')) throw new Error((JSON.parse(text) as { error: string }).error);
  return text;
}

const json = (text: string): object => JSON.parse(answered(text)) as object;

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
  answered(
    engine.add_picture(path, width, height, depth === 16 ? 16 : 8, new Uint8Array(rgba.buffer)),
  );
  pictures.delete(path);
}

const methods: { [M in keyof Methods]: (...values: Parameters<Methods[M]>) => unknown } = {
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
    return {
      algorithms: JSON.parse(lab.algorithms()) as unknown,
      simd: lab.simd_target(),
      scenes: Object.keys(await files),
      module,
    };
  },
  write,
  open(path) {
    const facts = JSON.parse(answered(engine.open(path))) as SceneFacts & { pictures: string[] };
    facts.pictures.forEach(addPicture);
    return facts;
  },
  draw(options) {
    const before = performance.now();
    const answer = JSON.parse(answered(engine.draw(JSON.stringify(options)))) as unknown;
    const milliseconds = performance.now() - before;
    return { answer, picture: engine.picture().slice(), milliseconds };
  },
  manifest: (options) => answered(engine.manifest(JSON.stringify(options))),
  passes(options) {
    const run = json(engine.passes(JSON.stringify(options)));
    return { ...run, picture: engine.picture().slice() };
  },
  plane(pass, plane) {
    const facts = json(engine.plane(JSON.stringify({ pass, plane })));
    return { ...facts, picture: engine.picture().slice(), change: engine.change().slice() };
  },
  history: (x, y) => json(engine.history(JSON.stringify({ x, y }))),
  pixel(options) {
    const facts = json(engine.pixel(JSON.stringify(options)));
    return { order: [], sides: [], steps: [], ...facts, picture: engine.picture().slice() };
  },
  volumes(options) {
    const facts = json(engine.volumes(JSON.stringify(options)));
    return { ...facts, picture: engine.picture().slice() };
  },
  light: (options) => json(engine.light(JSON.stringify(options))),
  lit(options) {
    answered(engine.lit(JSON.stringify(options)));
    return engine.picture().slice();
  },
  pixmap(options) {
    answered(engine.pixmap(JSON.stringify(options)));
    return engine.picture().slice();
  },
  hemicube(options) {
    answered(engine.hemicube(JSON.stringify(options)));
    return engine.picture().slice();
  },
  rays(options) {
    const run = json(engine.rays(JSON.stringify(options)));
    return { ...run, picture: engine.picture().slice() };
  },
  raytraced(options) {
    const run = json(engine.raytraced(JSON.stringify(options)));
    return { ...run, picture: engine.picture().slice() };
  },
  identifiers(options) {
    const facts = json(engine.identifiers(JSON.stringify(options)));
    return { ...facts, ids: engine.picture().slice(), mask: engine.difference().slice() };
  },
  reasons(options) {
    const facts = json(engine.reasons(JSON.stringify(options)));
    return { ...facts, reason: engine.difference().slice() };
  },
  path: (options) => json(engine.path(JSON.stringify(options))),
  outside(options) {
    const facts = json(engine.outside(JSON.stringify(options)));
    return { ...facts, picture: engine.picture().slice() };
  },
  cast(options) {
    const run = json(engine.cast(JSON.stringify(options)));
    return { ...run, picture: engine.picture().slice(), tests: engine.change().slice() };
  },
  visits: (options) => json(engine.visits(JSON.stringify(options))),
  inside: (options) => json(engine.inside(JSON.stringify(options))),
  polygons: (options) => answered(engine.polygons(JSON.stringify(options))),
  play(options, steps) {
    const log = answered(engine.play(JSON.stringify(options), steps));
    return { log, difference: engine.difference().slice() };
  },
  hidden(options) {
    const log = answered(engine.hidden(JSON.stringify(options)));
    return { log, difference: engine.difference().slice() };
  },
};

/** The engine answers its refusals itself; a number is an exception for which text found no room. */
function reasonOf(error: unknown): string {
  if (typeof error === 'number') return 'not enough memory; expected a smaller scene or picture';
  return error instanceof Error ? error.message : String(error);
}

async function take({ number, method, values }: Request): Promise<void> {
  const answer = (rest: Omit<Answer, 'number'>) => self.postMessage({ number, ...rest });
  try {
    const call = methods[method] as (...values: readonly unknown[]) => unknown;
    answer({ value: await call(...values) });
  } catch (error) {
    answer({ error: reasonOf(error) });
  }
}

let last = Promise.resolve();
self.onmessage = (event: MessageEvent<Request>) => {
  last = last.then(() => take(event.data));
};
