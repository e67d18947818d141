// Every message that the readers of scenes can make has its Japanese: the sources say which.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it, vi } from 'vitest';
import { messagesOf } from './messages_of';

const project = join(process.env['GW_SCENES'] ?? '../scenes', '..');
const commands: unknown = JSON.parse(
  readFileSync(join(project, 'hiddensurface/run/messages.ja.json'), 'utf8'),
);
vi.stubGlobal('__GW_MESSAGES__', { ja: commands });
const { messageIn } = await import('../../words/message');

/** Texts that nobody reads: by which warnings are counted, and parts of texts. */
const unread = new Set([
  ...['item buffer', 'light range', 'metal map', 'no texcoords', 'opacity without st', 'map again'],
  ...[
    'texels of {}',
    'vertex colours',
    'shadow map',
    'its camera is',
    'its lights are',
    'its animations are',
  ],
  ...['the background is', 'the fog is', "the faces' own normals stand in", 'it is dark there'],
  ...['beside a texture are drawn as means of triangles, in at most 64 colours'],
  ...['are drawn as their mean', '{}a renderer by rays', '{}the file has no {}'],
  ...[', and {} more like it', "object '{}' has no area, so radiosity leaves it out{}"],
  ...['{} left out; the scene has its own', '{}; none is known'],
  "{}; the nearest known is '{}'",
]);
const isPart = /^[ ;:]|[ :]$|\{\}\{\}/;

/** As a reader of the file meets it. */
const met = (file: string, text: string): string =>
  (file.startsWith('gltf/') && /^(has (?!nothing)|is |lies |and )/.test(text)
    ? `nodes[3] ${text}`
    : text
  )
    .replace(/\{(:\.\df)?\}/g, '7')
    .replace(/'7'/g, "'x'");

const messages = ['scene', 'radiosity/model', 'web/engine'].flatMap((folder) =>
  readdirSync(join(project, folder), { recursive: true, encoding: 'utf8' })
    .filter((file) => /\.(cpp|h)$/.test(file))
    .flatMap((file) =>
      messagesOf(readFileSync(join(project, folder, file), 'utf8'))
        .filter((text) => /[a-z]{2,} [a-z]+/.test(text) && !isPart.test(text) && !unread.has(text))
        .map((text) => met(file.replaceAll('\\', '/'), text)),
    ),
);

it('finds them', () => {
  expect(messages.length).toBeGreaterThan(250);
  expect(messages).toContain("'x' is not a corner; expected v, v/vt, v//vn or v/vt/vn");
  expect(messages).toContain('7 has 7 corner; expected at least 7');
});

/** Words of the files, which have no other names. */
const names = new Set(
  `accum ASCII at axis back base BLEND bufferView candela color crease CUBICSPLINE data degrees
depth direction directional disc divide emission end exp exp2 eye false far file film float
frame glare GLB glTF gw GW halo hardware height height_field heights ID identifiers IES ies
illum INCLUDE JIS JSON Kd Ke known Ks light lights lights_off line linear LINEAR lumen lux map_d
map_Kd MASK material matrix MB metallicRoughnessTexture mode MTL mtllib multipass near NEAREST
newmtl nit none NONE OBJ object off on OPAQUE ortho orthographic outerConeAngle parts pass
passes perspective pixel pixmap point polygon position radiosity range raytrace rectangle refl
renderer rotate samplers scale shape Shift span specularGlossinessTexture sphere spot st ST
start stencil STEP texCoord texcoords TEXT TILT Tr track translate true turn TYPE type uri URI
UTF vn vt white width znear`.split(/\s+/),
);

it('has Japanese for each', () => {
  const missing = [...new Set(messages)].flatMap((message) => {
    const said = messageIn(message, 'ja').replace(/'[^']*'/g, '');
    const english = (said.match(/[A-Za-z_]{2,}/g) ?? []).filter((word) => !names.has(word));
    return english.length > 0 || !/[\u3041-\u9fff]/.test(said)
      ? [`${message} -> ${messageIn(message, 'ja')}`]
      : [];
  });
  expect(missing).toEqual([]);
});
