// The registry of exhibits, in the order of their tabs. A new exhibit is a folder and a row here.
import type { Exhibit } from './exhibit/exhibit';
import Hidden from './hidden/Hidden.svelte';
import { hiddenState } from './hidden/state';
import Own from './own/Own.svelte';
import { ownState } from './own/state';
import Passes from './passes/Passes.svelte';
import { passesState } from './passes/state';
import Pixel from './pixel/Pixel.svelte';
import { pixelState } from './pixel/state';
import Programs from './programs/Programs.svelte';
import { programsState } from './programs/state';
import Exercises from './quiz/Exercises.svelte';
import { quizState } from './quiz/state';
import Radiosity from './radiosity/Radiosity.svelte';
import { radiosityState } from './radiosity/state';
import Rays from './rays/Rays.svelte';
import { raysState } from './rays/state';

/** A row of any choices. */
const row = <Choices>(exhibit: Exhibit<Choices>): Exhibit => exhibit as unknown as Exhibit;

export const exhibits: readonly Exhibit[] = [
  row({
    id: 'hidden',
    component: Hidden,
    title: (words) => words.lab_hidden,
    keys: (words) => words.lab_keys_hidden,
    firstScene: 'hidden/cycle.toml',
    hasPolygons: true,
    state: hiddenState,
  }),
  row({
    id: 'own',
    component: Own,
    title: (words) => words.lab_own_algorithm,
    keys: (words) => words.lab_keys_own,
    firstScene: 'hidden/cycle.toml',
    hasPolygons: true,
    state: ownState,
  }),
  row({
    id: 'quiz',
    component: Exercises,
    title: (words) => words.lab_quiz,
    keys: (words) => words.lab_keys_own,
    firstScene: 'hidden/cycle.toml',
    hasPolygons: true,
    hasOwnScenes: true,
    state: quizState,
  }),
  row({
    id: 'pixel',
    component: Pixel,
    title: (words) => words.lab_pixel,
    keys: (words) => words.lab_keys_pixel,
    firstScene: 'rings.toml',
    state: pixelState,
  }),
  row({
    id: 'passes',
    component: Passes,
    title: (words) => words.lab_passes,
    keys: (words) => words.lab_keys_passes,
    firstScene: 'rings.toml',
    state: passesState,
  }),
  row({
    id: 'programs',
    component: Programs,
    title: (words) => words.lab_programs,
    keys: (words) => words.lab_keys_programs,
    firstScene: 'hidden/cycle.toml',
    hasOwnScenes: true,
    state: programsState,
  }),
  row({
    id: 'rays',
    component: Rays,
    title: (words) => words.lab_rays,
    keys: (words) => words.lab_keys_rays,
    firstScene: 'fig9.toml',
    state: raysState,
  }),
  row({
    id: 'radiosity',
    component: Radiosity,
    title: (words) => words.lab_radiosity,
    keys: (words) => words.lab_keys_radiosity,
    firstScene: 'radiosity/cornell.toml',
    state: radiosityState,
  }),
];
