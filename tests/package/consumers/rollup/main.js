import { createLpquad } from 'lpquad/inline';
import { createLpquad as createWithSurfaces } from 'lpquad/inline-surface';

import { report } from './report.js';

report({ inline: createLpquad, surface: createWithSurfaces });
