// The shaders that draw a frame of bench_lab_frames: the machine's lights at the vertices.
export const mostLights = 4;
const varyings = `varying vec4 color;
#ifdef TWO_SIDE
varying vec4 backColor;
#endif
#ifdef TEXTURED
varying vec2 st;
#endif`;
/** A program does no more than its draws need: LIT, TWO_SIDE, GENERATED, TEXTURED. */
export const vertexShader = `
precision highp float;
invariant gl_Position;
attribute vec4 position;
attribute vec3 normal;
attribute vec2 texcoord;
uniform mat4 projection, modelview, textureMatrix;
uniform mat3 normalMatrix;
uniform vec3 Ka, Kd, Ks, Ke, modelAmbient;
uniform float Ns;
uniform vec4 flatColor;
uniform int lights;
uniform bool localViewer;
uniform vec4 at[${mostLights}];
uniform vec3 Ia[${mostLights}], Id[${mostLights}], Is[${mostLights}], falloff[${mostLights}];
${varyings}
vec3 litColor(vec3 p, vec3 n) {
  vec3 sum = Ke + modelAmbient * Ka;
  vec3 viewer = localViewer ? normalize(-p) : vec3(0, 0, 1);
  for (int i = 0; i < ${mostLights}; ++i) {
    if (i >= lights) break;
    vec3 toward = at[i].w == 0.0 ? at[i].xyz : at[i].xyz / at[i].w - p;
    float d = length(toward);
    vec3 l = toward / d;
    float dimmed = falloff[i].x + d * (falloff[i].y + d * falloff[i].z);
    float faded = at[i].w == 0.0 ? 1.0 : 1.0 / dimmed;
    float diffuse = max(dot(n, l), 0.0);
    vec3 part = Ka * Ia[i] + diffuse * Kd * Id[i];
    if (diffuse > 0.0) {
      float h = max(dot(n, normalize(l + viewer)), 0.0);
      part += (Ns == 0.0 ? 1.0 : pow(h, Ns)) * Ks * Is[i];
    }
    sum += faded * part;
  }
  return min(sum, 1.0);
}
void main() {
  vec4 eye = modelview * position;
  gl_Position = projection * eye;
  color = flatColor;
#if defined(LIT) || defined(GENERATED)
  vec3 n = normalize(normalMatrix * normal);
#endif
#ifdef LIT
  color.rgb = litColor(eye.xyz, n);
#endif
#ifdef TWO_SIDE
  backColor = vec4(litColor(eye.xyz, -n), flatColor.a);
#endif
#ifdef TEXTURED
  st = texcoord;
#ifdef GENERATED
  vec3 r = reflect(normalize(eye.xyz), n);
  st = r.xy / (2.0 * length(r + vec3(0, 0, 1))) + 0.5;
#endif
  st = (textureMatrix * vec4(st, 0, 1)).xy;
#endif
}`;
export const fragmentShader = `
precision mediump float;
${varyings}
#ifdef TEXTURED
uniform sampler2D image;
#endif
void main() {
  gl_FragColor = color;
#ifdef TWO_SIDE
  if (!gl_FrontFacing) gl_FragColor = backColor;
#endif
#ifdef TEXTURED
  gl_FragColor *= texture2D(image, st);
#endif
}`;
