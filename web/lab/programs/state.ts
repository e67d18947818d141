// The choices of the exhibit of programs in the address. What was recorded is not in it.
import { known } from '../../model/settings';
import type { ExhibitState } from '../exhibit/exhibit';
import { programs } from './program_list';

export interface ProgramsState {
  program: string;
  /** Frames of a recording. */
  frames: number;
}

export const frameCounts = [1, 4, 16];

export const programsState: ExhibitState<ProgramsState> = {
  from: (parts) => ({
    program: known(
      parts.get('program'),
      programs.map(({ id }) => id),
    ),
    frames: frameCounts.find((count) => String(count) === parts.get('frames')) ?? frameCounts[0]!,
  }),
  put(parts, { program, frames }) {
    parts.set('program', program);
    if (frames !== frameCounts[0]) parts.set('frames', String(frames));
  },
};
