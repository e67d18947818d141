// Stories: a scene, an algorithm (stories.json, which scripts/slides reads too), and a few stages,
// which words/stories.ts tells.
import type { Step } from './log';
import list from './stories.json';
import { stories as told, type Stories } from '../../words/stories';

export interface Story {
  readonly id: keyof Stories;
  readonly scene: string;
  readonly algorithm: string;
  readonly level: string;
  readonly size: string;
}

export const stories = list as readonly Story[];

/** 'begin', 'end', "test" or "test.answer". */
export const stagesOf = (story: Story): readonly string[] =>
  Object.keys(told[story.id]).filter((name) => name !== 'title');

export interface StageAt {
  /** Steps done. */
  readonly at: number;
  readonly stage: string;
}

/** By stage the steps done; stages whose step the log does not have are left out. */
export function stagesIn(story: Story, steps: readonly Step[]): StageAt[] {
  const found: StageAt[] = [];
  let from = 0;
  for (const stage of stagesOf(story)) {
    const [test, answer] = stage.split('.');
    const index = steps.findIndex(
      (step, i) => i >= from && step.test === test && (!answer || step.result === answer),
    );
    if (stage === 'begin') found.push({ at: 0, stage });
    else if (stage === 'end') found.push({ at: steps.length, stage });
    else if (index >= 0) found.push({ at: (from = index + 1), stage });
  }
  return found;
}

/** The place of the stage that has been reached. */
export const stageAt = (stages: readonly StageAt[], position: number): number =>
  Math.max(
    0,
    stages.findLastIndex(({ at }) => at <= position),
  );
