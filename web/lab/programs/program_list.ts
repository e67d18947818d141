// The programs of the exhibit: their pages beside the lab, and what to try.
import type { Words } from '../../words/en';
import type { ToProgram } from './protocol';

export interface Try {
  readonly id: string;
  readonly title: (words: Words) => string;
  /** What will be seen. */
  readonly expect: (words: Words) => string;
  readonly message: ToProgram;
}

export interface ProgramRow {
  /** Of its page programs/ID.html, and in the address. */
  readonly id: string;
  readonly width: number;
  readonly title: (words: Words) => string;
  readonly about: (words: Words) => string;
  readonly press: (words: Words) => string;
  readonly tries: readonly Try[];
}

const digit = (number: number): ToProgram => ({
  what: 'key',
  code: `Digit${number}`,
  key: String(number),
});
const entry = (number: number): ToProgram => ({ what: 'menu', entry: number });

export const programs: readonly ProgramRow[] = [
  {
    id: 'hidden',
    width: 480,
    title: (words) => words.program_hidden,
    about: (words) => words.program_hidden_about,
    press: (words) => words.program_hidden_press,
    tries: [
      {
        id: 'zbuffer',
        title: (words) => words.program_zbuffer,
        expect: (words) => words.program_zbuffer_see,
        message: digit(1),
      },
      {
        id: 'painter',
        title: (words) => words.program_painter,
        expect: (words) => words.program_painter_see,
        message: digit(2),
      },
      {
        id: 'backface',
        title: (words) => words.program_backface,
        expect: (words) => words.program_backface_see,
        message: digit(3),
      },
      {
        id: 'nobody',
        title: (words) => words.program_nobody,
        expect: (words) => words.program_nobody_see,
        message: digit(4),
      },
      {
        id: 'spin',
        title: (words) => words.program_spin,
        expect: (words) => words.program_spin_see,
        message: { what: 'key', code: 'Space', key: ' ' },
      },
    ],
  },
  {
    id: 'flight',
    width: 640,
    title: (words) => words.program_flight,
    about: (words) => words.program_flight_about,
    press: (words) => words.program_flight_press,
    tries: [
      {
        id: 'cueing',
        title: (words) => words.program_cueing,
        expect: (words) => words.program_cueing_see,
        message: entry(3),
      },
      {
        id: 'hiding',
        title: (words) => words.program_hiding,
        expect: (words) => words.program_hiding_see,
        message: entry(4),
      },
      {
        id: 'slow',
        title: (words) => words.program_slow,
        expect: (words) => words.program_slow_see,
        message: entry(1),
      },
      {
        id: 'fast',
        title: (words) => words.program_fast,
        expect: (words) => words.program_fast_see,
        message: entry(2),
      },
    ],
  },
];
