async function main() {
  const { createLpquad } = await import('lpquad');
  const { createLpquadWorker } = await import('lpquad/worker');
  const { fingerprints } = await import('./report.js');
  const ways = { direct: createLpquad, worker: createLpquadWorker };
  // As the README says.
  const [major, minor] = process.versions.node.split('.').map(Number);
  const requires = major === 20 ? minor >= 19 : major === 22 ? minor >= 12 : major > 22;
  if (requires) ways.required = require('lpquad').createLpquad;
  console.log(JSON.stringify(await fingerprints(ways)));
}
main();
