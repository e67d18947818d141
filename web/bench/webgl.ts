// Plays a frame of bench_lab_frames through WebGL: lights at the vertices, buffers and programs
// made once. Runs in the page; does not measure.
import { fragmentShader, mostLights, vertexShader } from './shaders';

type Matrix = readonly number[];
type Color = readonly [number, number, number, number];
type Part = readonly [number, number, number];
interface StencilFace {
  func: number;
  ref: number;
  mask: number;
  fail: number;
  zfail: number;
  zpass: number;
  write_mask: number;
}
interface State {
  projection: Matrix;
  cull: { enable: boolean; face: number; front: number };
  color_source: number;
  local_viewer: boolean;
  two_side: boolean;
  model_ambient: Color;
  depth: { test: boolean; func: number; mask: boolean };
  blend: { enable: boolean; src: number; dst: number; equation: number };
  stencil: { test: boolean; front: StencilFace; back: StencilFace };
  color_mask: readonly [boolean, boolean, boolean, boolean];
  texture: {
    min_filter: number;
    mag_filter: number;
    wrap_s: number;
    wrap_t: number;
    env: number;
    gen: number;
    matrix: Matrix;
  };
}
interface Light {
  position: Color;
  Ia: Part;
  Id: Part;
  Is: Part;
  attenuation: Part;
}
interface Draw {
  mesh: number;
  eye_from_object: Matrix;
  material: {
    Ka: Part;
    Kd: Part;
    Ks: Part;
    Ke: Part;
    Ns: number;
    alpha: number;
  };
  lights: Light[];
  color?: Color;
  texture?: number;
}
interface Clear {
  planes: number;
  color: Color;
  depth: number;
  stencil: number;
}
export interface Frame {
  width: number;
  height: number;
  eye_from_world: Matrix;
  at: Part;
  meshes: {
    positions: number[];
    normals: number[];
    texcoords: number[];
    indices: number[];
  }[];
  textures: { width: number; height: number; rgba: number[] }[];
  commands: { clear?: Clear; state?: State; draw?: Draw }[];
}

/** a b, by columns. */
function product(a: Matrix, b: Matrix): number[] {
  return Array.from({ length: 16 }, (_, i) => {
    const row = i % 4;
    const column = i - row;
    return [0, 1, 2, 3].reduce((sum, k) => sum + a[k * 4 + row]! * b[column + k]!, 0);
  });
}
/** The inverse transpose of the upper 3x3, times the determinant; the shader normalizes. */
function normalMatrix(m: Matrix): number[] {
  const column = (i: number): Part => [m[i * 4]!, m[i * 4 + 1]!, m[i * 4 + 2]!];
  const cross = (a: Part, b: Part): number[] => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  const [x, y, z] = [column(0), column(1), column(2)];
  const [yz, zx, xy] = [cross(y, z), cross(z, x), cross(x, y)];
  const sign = Math.sign(x[0] * yz[0]! + x[1] * yz[1]! + x[2] * yz[2]!);
  return [...yz, ...zx, ...xy].map((v) => v * sign);
}

interface Program {
  program: WebGLProgram;
  places: Map<string, WebGLUniformLocation | null>;
}

export class WebGlPlayer {
  private readonly gl: WebGLRenderingContext;
  private readonly meshes: {
    buffers: (WebGLBuffer | undefined)[];
    indices: WebGLBuffer;
    count: number;
  }[];
  private readonly textures: WebGLTexture[];
  private readonly programs = new Map<string, Program>();
  private program!: Program;

  readonly canvas = document.createElement('canvas');

  constructor(private readonly frame: Frame) {
    const { canvas } = this;
    canvas.width = frame.width;
    canvas.height = frame.height;
    const gl = canvas.getContext('webgl', {
      antialias: false,
      stencil: true,
      alpha: true,
      premultipliedAlpha: false,
      preserveDrawingBuffer: true,
    });
    if (!gl) throw new Error('the browser has no WebGL');
    if (!gl.getExtension('OES_element_index_uint')) throw new Error('no indices of 32 bits');
    this.gl = gl;
    this.meshes = frame.meshes.map((mesh) => {
      return {
        buffers: [mesh.positions, mesh.normals, mesh.texcoords].map((values) =>
          values.length === 0 ? undefined : this.buffer(gl.ARRAY_BUFFER, new Float32Array(values)),
        ),
        indices: this.buffer(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(mesh.indices)),
        count: mesh.indices.length,
      };
    });
    this.textures = frame.textures.map(({ width, height, rgba }) => {
      const texture = gl.createTexture()!;
      gl.bindTexture(gl.TEXTURE_2D, texture);
      const texels = new Uint8Array(rgba);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
      gl.generateMipmap(gl.TEXTURE_2D);
      return texture;
    });
  }

  get renderer(): string {
    const debug = this.gl.getExtension('WEBGL_debug_renderer_info');
    return String(this.gl.getParameter(debug ? debug.UNMASKED_RENDERER_WEBGL : this.gl.RENDERER));
  }

  /** One frame, seen after `turn`: eye from the eye of the frame as it was written. */
  draw(turn: Matrix): void {
    let state: State | undefined;
    for (const command of this.frame.commands) {
      if (command.clear) this.clear(command.clear);
      if (command.state) this.apply((state = command.state));
      if (command.draw && state) this.drawMesh(command.draw, state, turn);
    }
  }
  /** Waits for the frame. RGBA, bottom row first. */
  read(): Uint8Array {
    const { width, height } = this.frame;
    const rgba = new Uint8Array(width * height * 4);
    this.gl.readPixels(0, 0, width, height, this.gl.RGBA, this.gl.UNSIGNED_BYTE, rgba);
    return rgba;
  }

  private makeProgram(defines: string): Program {
    const { gl } = this;
    const program = gl.createProgram()!;
    for (const [kind, source] of [
      [gl.VERTEX_SHADER, vertexShader],
      [gl.FRAGMENT_SHADER, fragmentShader],
    ] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, defines + source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(gl.getShaderInfoLog(shader) ?? 'a shader does not compile');
      gl.attachShader(program, shader);
    }
    ['position', 'normal', 'texcoord'].forEach((name, i) =>
      gl.bindAttribLocation(program, i, name),
    );
    gl.linkProgram(program);
    return { program, places: new Map() };
  }
  private buffer(kind: number, data: Float32Array | Uint32Array): WebGLBuffer {
    const buffer = this.gl.createBuffer()!;
    this.gl.bindBuffer(kind, buffer);
    this.gl.bufferData(kind, data, this.gl.STATIC_DRAW);
    return buffer;
  }
  private place(name: string): WebGLUniformLocation | null {
    const { program, places } = this.program;
    if (!places.has(name)) places.set(name, this.gl.getUniformLocation(program, name));
    return places.get(name)!;
  }
  private enable(what: number, on: boolean): void {
    if (on) this.gl.enable(what);
    else this.gl.disable(what);
  }

  private clear({ planes, color, depth, stencil }: Clear): void {
    const { gl } = this;
    gl.clearColor(...color);
    gl.clearDepth(depth);
    gl.clearStencil(stencil);
    const masks = [gl.COLOR_BUFFER_BIT, gl.DEPTH_BUFFER_BIT, gl.STENCIL_BUFFER_BIT];
    gl.clear(masks.reduce((all, mask, i) => (planes & (1 << i) ? all | mask : all), 0));
  }

  private apply(s: State): void {
    const { gl } = this;
    const factors: number[] = [
      gl.ZERO,
      gl.ONE,
      gl.SRC_COLOR,
      gl.ONE_MINUS_SRC_COLOR,
      gl.DST_COLOR,
      gl.ONE_MINUS_DST_COLOR,
      gl.SRC_ALPHA,
      gl.ONE_MINUS_SRC_ALPHA,
      gl.DST_ALPHA,
      gl.ONE_MINUS_DST_ALPHA,
      gl.SRC_ALPHA_SATURATE,
    ];
    const equations = [gl.FUNC_ADD, gl.FUNC_SUBTRACT, gl.FUNC_REVERSE_SUBTRACT];
    this.enable(gl.CULL_FACE, s.cull.enable);
    gl.cullFace([gl.FRONT, gl.BACK, gl.FRONT_AND_BACK][s.cull.face]!);
    gl.frontFace(s.cull.front === 0 ? gl.CW : gl.CCW);
    this.enable(gl.DEPTH_TEST, s.depth.test);
    gl.depthFunc(gl.NEVER + s.depth.func);
    gl.depthMask(s.depth.mask);
    this.enable(gl.BLEND, s.blend.enable);
    gl.blendFunc(factors[s.blend.src]!, factors[s.blend.dst]!);
    gl.blendEquation(equations[s.blend.equation]!);
    gl.colorMask(...s.color_mask);
    this.enable(gl.STENCIL_TEST, s.stencil.test);
    const ops: number[] = [
      gl.KEEP,
      gl.ZERO,
      gl.REPLACE,
      gl.INCR,
      gl.DECR,
      gl.INVERT,
      gl.INCR_WRAP,
      gl.DECR_WRAP,
    ];
    for (const [side, face] of [
      [gl.FRONT, s.stencil.front],
      [gl.BACK, s.stencil.back],
    ] as const) {
      gl.stencilFuncSeparate(side, gl.NEVER + face.func, face.ref, face.mask & 255);
      gl.stencilOpSeparate(side, ops[face.fail]!, ops[face.zfail]!, ops[face.zpass]!);
      gl.stencilMaskSeparate(side, face.write_mask & 255);
    }
  }

  private useProgram(draw: Draw, s: State): void {
    const { gl } = this;
    const lit = s.color_source === 1;
    const defines = [
      lit && 'LIT',
      lit && s.two_side && 'TWO_SIDE',
      draw.texture !== undefined && 'TEXTURED',
      draw.texture !== undefined && s.texture.gen === 1 && 'GENERATED',
    ];
    const key = defines.map((name) => (name ? `#define ${name}\n` : '')).join('');
    let program = this.programs.get(key);
    if (!program) this.programs.set(key, (program = this.makeProgram(key)));
    this.program = program;
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(this.place('projection'), false, [...s.projection]);
    gl.uniformMatrix4fv(this.place('textureMatrix'), false, [...s.texture.matrix]);
    gl.uniform1i(this.place('localViewer'), s.local_viewer ? 1 : 0);
    gl.uniform3fv(this.place('modelAmbient'), s.model_ambient.slice(0, 3));
  }

  private bindTexture(number: number | undefined, s: State): void {
    const { gl } = this;
    if (number === undefined) return;
    const filters: number[] = [
      gl.NEAREST,
      gl.LINEAR,
      gl.NEAREST_MIPMAP_NEAREST,
      gl.LINEAR_MIPMAP_NEAREST,
      gl.NEAREST_MIPMAP_LINEAR,
      gl.LINEAR_MIPMAP_LINEAR,
    ];
    const { texture } = s;
    gl.bindTexture(gl.TEXTURE_2D, this.textures[number]!);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filters[texture.min_filter]!);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filters[texture.mag_filter]!);
    const wrap = (mode: number): number => (mode === 0 ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap(texture.wrap_s));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap(texture.wrap_t));
  }

  private drawMesh(draw: Draw, state: State, turn: Matrix): void {
    const { gl } = this;
    this.useProgram(draw, state);
    const modelview = product(turn, draw.eye_from_object);
    gl.uniformMatrix4fv(this.place('modelview'), false, modelview);
    gl.uniformMatrix3fv(this.place('normalMatrix'), false, normalMatrix(modelview));
    gl.uniform4fv(this.place('flatColor'), [
      ...(draw.color ?? [1, 1, 1]).slice(0, 3),
      state.color_source === 1 ? draw.material.alpha : (draw.color?.[3] ?? 1),
    ]);
    if (state.color_source === 1) this.setLight(draw, turn);
    this.bindTexture(draw.texture, state);
    const mesh = this.meshes[draw.mesh]!;
    mesh.buffers.forEach((buffer, i) => {
      if (!buffer) return gl.disableVertexAttribArray(i);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, [4, 3, 2][i]!, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, mesh.indices);
    gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
  }
  private setLight({ material, lights }: Draw, turn: Matrix): void {
    const { gl } = this;
    if (lights.length > mostLights) throw new Error('more lights than the shader has');
    for (const name of ['Ka', 'Kd', 'Ks', 'Ke'] as const)
      gl.uniform3fv(this.place(name), [...material[name]]);
    gl.uniform1f(this.place('Ns'), material.Ns);
    gl.uniform1i(this.place('lights'), lights.length);
    if (lights.length === 0) return;
    const turned = ({ position }: Light): number[] =>
      product(turn, [...position, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]).slice(0, 4);
    gl.uniform4fv(this.place('at'), lights.flatMap(turned));
    for (const name of ['Ia', 'Id', 'Is'] as const)
      gl.uniform3fv(
        this.place(name),
        lights.flatMap((light) => [...light[name]]),
      );
    gl.uniform3fv(
      this.place('falloff'),
      lights.flatMap((light) => [...light.attenuation]),
    );
  }
}
