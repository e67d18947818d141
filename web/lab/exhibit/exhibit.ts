// What an exhibit is to the lab: a row of the registry (lab/exhibits.ts). The lab knows nothing
// else of it.
import type { Component } from 'svelte';
import type { Words } from '../../words/en';
import type { LabState } from './lab_state';
import type { Machine } from '../machine/machine';
import type { SceneFacts, Started } from '../machine/protocol';

export interface ExhibitProps<Choices> {
  machine: Machine;
  /** What all exhibits share. */
  lab: LabState;
  /** The exhibit's own part of the lab's state. */
  choices: Choices;
  scene: SceneFacts;
  started: Started;
  words: Words;
}

/** Choices in the address. */
export interface ExhibitState<Choices> {
  from(parts: URLSearchParams): Choices;
  /** Adds what an address of the exhibit leaves out, before anybody reads it. */
  complete?(parts: URLSearchParams): void;
  put(parts: URLSearchParams, choices: Choices): void;
  /** Drops what belongs to one scene: another one was chosen. */
  forget?(choices: Choices): void;
}

export interface Exhibit<Choices = unknown> {
  /** In the address. */
  readonly id: string;
  readonly component: Component<ExhibitProps<Choices>, object, 'lab' | 'choices'>;
  readonly title: (words: Words) => string;
  /** A sentence. */
  readonly keys: (words: Words) => string;
  /** The scene that it begins with. */
  readonly firstScene: string;
  /** Whether it shows polygons by name and colour. */
  readonly hasPolygons?: boolean;
  /** Whether it shows other scenes than the one that the page has opened. */
  readonly hasOwnScenes?: boolean;
  readonly state: ExhibitState<Choices>;
}
