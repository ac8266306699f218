async function main() {
  const { createLpquad } = await import('lpquad');
  const { createLpquadWorker } = await import('lpquad/worker');
  const { fingerprints } = await import('./report.js');
  console.log(JSON.stringify(await fingerprints({ direct: createLpquad, worker: createLpquadWorker })));
}
main();
