// What the mesher says about itself, options and formats, for the parts of the page that are made of it.
/** @import { Description } from 'lpquad' */

/** @typedef {{engine: () => Promise<import('lpquad/worker').LpquadWorker>, subscribe: (listener: (run: {state: unknown}) => void) => () => void}} Described */

/** Calls `use` once, when the mesher has told. Where it cannot be loaded the run says so; a later run that gets on is another chance.
 * @param {Described} runner  @param {(description: Description) => void} use */
export function whenDescribed(runner, use) {
  let told = false;
  const ask = async () => {
    const description = await runner.engine().then((engine) => engine.ready()).catch(() => null);
    if (told || description === null) return;
    told = true;
    stop();
    use(description);
  };
  const stop = runner.subscribe(({ state }) => { if (state !== null) void ask(); });
  void ask();
}
