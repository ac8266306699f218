// The paper that both pages are about, for those who want to read it.
import { h, withSubscripts } from '../panels/dom.js';

const address = 'https://doi.org/10.1007/s00366-012-0290-x';

/** Who, when, what, and where to find it. */
export const citation = () => [
  'T. Carrier Baudouin, J.-F. Remacle, E. Marchandise, J. Lambrechts and F. Henrotte (2012): ',
  h('cite', null, ...withSubscripts('Lloyd’s energy minimization in the L_p norm for quadrilateral surface mesh generation')),
  '. Engineering with Computers, ', h('a', { href: address, target: '_blank', rel: 'noopener' }, 'doi 10.1007/s00366-012-0290-x'), '.',
];

/** Below what it is the source of. */
export const paperReference = () => h('p', { className: 'reference' }, 'The paper: ', ...citation());
