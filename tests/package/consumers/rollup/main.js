import { createLpquad } from 'lpquad/inline';

import { report } from './report.js';

report({ inline: createLpquad });
