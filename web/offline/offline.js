// Makes the built page work without a network. Not while developing: there the files change.

/** After the first mesh: until then the network and the processor have better things to do.
 * @param {{runner: {subscribe: (listener: (run: {phase: string}) => void) => () => void}}} app */
export function installOffline({ runner }) {
  if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
  const stop = runner.subscribe(({ phase }) => {
    if (phase !== 'done' && phase !== 'failed' && phase !== 'paused') return;
    stop();
    // Refused on file: and by some settings: then there is just no page without a network.
    navigator.serviceWorker.register('./service_worker.js').catch(() => {});
  });
}
