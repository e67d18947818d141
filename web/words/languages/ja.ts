// Japanese. The sentences of steps come with the logs.
import type { Translation } from '../language';
import { articles } from './ja/articles';
import { code } from './ja/code';
import { error } from './ja/errors';
import { label, scene, title } from './ja/figures';
import { modelError } from './ja/model_errors';
import { names } from './ja/names';
import { programs } from './ja/programs';
import { quiz } from './ja/quiz';
import { report } from './ja/report';
import { sceneError } from './ja/scene_errors';
import { stories } from './ja/stories';
import { words } from './ja/words';

export default {
  name: '日本語',
  words: { ...words, ...report, ...programs, ...articles },
  quiz,
  stories,
  names: { ...names, title, scene, code, label, error: [error, modelError, sceneError].join('\n') },
  steps: {},
} satisfies Translation;
