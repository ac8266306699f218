// The paper that the page is about, for those who want to read it.
import { h } from '../panels/dom.js';

const address = 'https://doi.org/10.1007/s00366-012-0290-x';

/** Who, when, what, and where to find it. */
export const paperReference = () => h('p', { className: 'reference' },
  'The paper: T. Carrier Baudouin, J.-F. Remacle, E. Marchandise, J. Lambrechts and F. Henrotte (2012): Lloyd’s energy minimization in the L',
  h('sub', null, 'p'), ' norm for quadrilateral surface mesh generation. Engineering with Computers, ',
  h('a', { href: address, target: '_blank', rel: 'noopener' }, 'doi 10.1007/s00366-012-0290-x'), '.');
