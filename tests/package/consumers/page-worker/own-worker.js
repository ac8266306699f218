import './node_modules/lpquad/dist/worker-entry.js';
