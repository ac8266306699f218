'use client';
import { useEffect } from 'react';
import { createLpquad } from 'lpquad';
import { createLpquad as createInline } from 'lpquad/inline';
import { createLpquadWorker } from 'lpquad/worker';

import { report } from '../report.js';

export default function Meshes({ rendered }) {
  useEffect(() => {
    report({ direct: createLpquad, inline: createInline, worker: createLpquadWorker });
  }, []);
  return <p id="rendered">{rendered}</p>;
}
