// The figures of an article: where each stands, what is lit in it, and the numbers that a text
// takes from it.
import { polygonOf, type Log } from '../model/steps/log';
import { Replay } from '../model/steps/replay';
import { placeOf, runNumber } from './bind';
import type { RunFigure } from './figures';
import { filmNumber, frameOf, type Film } from './film';
import type { FilmFigure } from './films';
import { stepNameOf, type StepName } from './markup';
import { movedSpot, type Model, type Spot, type Spots } from './models/model';

export class RunState {
  readonly kind = 'run';
  readonly replay: Replay;
  position = $state(0);
  /** The polygon or piece that is lit. */
  lit = $state<string | undefined>();
  pixel = $state<[number, number] | undefined>();

  constructor(
    readonly figure: RunFigure,
    readonly log: Log,
  ) {
    this.replay = new Replay(log);
    this.position = figure.at ? placeOf(log.steps, stepNameOf(figure.at)) : log.steps.length;
  }

  go(name: StepName): void {
    this.position = placeOf(this.log.steps, name);
  }
  isNow(name: StepName): boolean {
    return this.position === placeOf(this.log.steps, name);
  }
  isLit(name: string): boolean {
    return this.lit === name || this.lit === String(polygonOf(name));
  }
  /** A number of the step that is named, or of the present one; undefined: there is none. */
  number(name: string, at?: StepName): string | undefined {
    return runNumber(this.replay, this.position, name, at);
  }
}

export class ModelState {
  readonly kind = 'model';
  spots = $state.raw<Spots>({});
  lit = $state<string | undefined>();
  readonly picture = $derived.by(() => this.model.look(this.spots));

  constructor(readonly model: Model) {
    this.spots = model.spots;
  }
  move(name: string, spot: Spot): void {
    this.spots = movedSpot(this.model, this.spots, name, spot);
  }
  reset(): void {
    this.spots = this.model.spots;
  }
  isLit(name: string): boolean {
    return this.lit === name;
  }
  number(name: string): string | undefined {
    const value = this.picture.values[name];
    return typeof value === 'number' ? String(Number(value.toFixed(3))) : value;
  }
}

export class FilmState {
  readonly kind = 'film';
  position = $state(0);
  /** A film has no shapes to light. */
  lit = $state<string | undefined>();

  constructor(
    readonly figure: FilmFigure,
    readonly film: Film,
  ) {}

  go(name: StepName): void {
    this.position = frameOf(this.figure, name);
  }
  isNow(name: StepName): boolean {
    return this.position === frameOf(this.figure, name);
  }
  isLit(): boolean {
    return false;
  }
  number(name: string, at?: StepName): string | undefined {
    return filmNumber(this.figure, this.film, this.position, name, at);
  }
}

export type FigureState = RunState | ModelState | FilmState;
export type Figures = ReadonlyMap<string, FigureState>;
