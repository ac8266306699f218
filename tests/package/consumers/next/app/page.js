import { createLpquad } from 'lpquad';

import { domain, options } from '../report.js';
import Meshes from './meshes.js';

// On the server: the mesh is made when the page is rendered.
export default async function Page() {
  const lpquad = await createLpquad();
  return <Meshes rendered={lpquad.meshDomain(domain, options).report.hash} />;
}
