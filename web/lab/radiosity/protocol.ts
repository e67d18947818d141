// What the exhibit of radiosity asks the engine, and what it answers.
import type { Channels } from '../machine/protocol';

export interface LightChange {
  /** So many shots were done. */
  readonly after: number;
  readonly object: string;
  /** A reflectance, an emitter, or a place, as `gw radiosity --change` has them. */
  readonly what: 'Kd' | 'dim' | 'move';
  readonly value: readonly number[];
}

/** A state of the light of a scene. */
export interface LightOptions {
  readonly width: number;
  readonly height: number;
  /** Pixels across. */
  readonly hemicube: number;
  readonly shots: number;
  readonly changes: readonly LightChange[];
  /** The changes are there before the first shot. */
  readonly resolved?: boolean;
}

export interface LitTone {
  /** Stops. */
  readonly exposure: number;
  readonly gamma: number;
  /** The estimate of the light yet to come is shown. */
  readonly ambient: boolean;
  readonly resolved?: boolean;
}

export interface LightFacts {
  readonly shots: number;
  readonly hemicubes: number;
  /** The state that was asked for is not reached. */
  readonly more: boolean;
  /** Nothing is unshot. */
  readonly dark: boolean;
  /** Shares: before the first shot, and after every step. */
  readonly unshot: readonly number[];
  /** The steps that were changes. */
  readonly changed: readonly number[];
  readonly emitted: Channels;
  readonly absorbed: Channels;
  readonly escaped: Channels;
  readonly left: Channels;
  readonly figures: readonly {
    readonly name: string;
    readonly Kd: Channels;
    readonly emission: Channels;
  }[];
  readonly pixmaps: readonly {
    readonly name: string;
    readonly width: number;
    readonly height: number;
  }[];
  readonly texels: number;
  readonly patches: number;
  /** The last shot; before the first one, the next. */
  readonly shot: {
    readonly patch: number;
    readonly pixmap: number;
    readonly x: number;
    readonly y: number;
    readonly width: number;
    readonly height: number;
    readonly flux: Channels;
    /** Hemicubes that the patch shoots from. */
    readonly points: number;
  };
}

interface Seen {
  readonly picture: Uint8Array;
}
declare module '../machine/protocol' {
  interface Methods {
    /** One step towards the state, or its beginning. */
    light(options: LightOptions): LightFacts;
    /** Pictures of the light of the last light(). */
    lit(options: View & LitTone): Seen;
    pixmap(options: LitTone & { readonly pixmap: number }): Seen;
    hemicube(options: { readonly patch: number; readonly point: number }): Seen;
  }
}
