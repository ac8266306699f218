// Numbers about a run: of the finished mesh from the library's own report, before that from what is
// on the screen. The two agree to the last bit where both know them.
/** @import { Report, Snapshot, State } from 'lpquad' */
/** @import { Run } from '../types' */

/**
 * Undefined is what cannot be told yet.
 * @typedef {object} Figures
 * @property {boolean} final
 * @property {number} [quads]
 * @property {number} [triangles]
 * @property {number} [vertices]
 * @property {number} [boundaryNodes]
 * @property {number} [singularities]
 * @property {number} [irregular]  interior vertices without four quads
 * @property {number} [etaMean]
 * @property {number} [etaMin]
 * @property {number} [etaP5]
 * @property {number} [fourValentPercent]
 * @property {number[]} [etaHistogram]  in 20 equal bins
 * @property {number[]} [valenceHistogram]
 * @property {number} [tau]
 * @property {number} [energy]
 * @property {number} [gradientNorm]
 * @property {Report['size']} [size]
 * @property {Record<string, number>} [seconds]
 * @property {string} [hash]
 */

/** @param {NonNullable<Snapshot['quads']>} layer @returns {Partial<Figures>} */
export function qualityOf({ points, quads, triangles, eta, valence, boundaryNodes }) {
  const count = quads.length / 4;
  let [sum, least] = [0, 1];
  const etaHistogram = new Array(20).fill(0);
  for (let i = 0; i < count; ++i) {
    sum += eta[i];
    least = Math.min(least, eta[i]);
    ++etaHistogram[Math.max(0, Math.min(19, Math.floor(20 * eta[i])))];
  }
  const valenceHistogram = new Array(10).fill(0);
  for (let v = boundaryNodes; v < valence.length; ++v) ++valenceHistogram[Math.min(9, valence[v])];
  const interior = valence.length - boundaryNodes;
  return {
    quads: count, triangles: triangles.length / 3, vertices: points.length / 2, boundaryNodes,
    etaMean: count > 0 ? sum / count : undefined, etaMin: count > 0 ? least : undefined,
    etaHistogram, valenceHistogram, irregular: interior - valenceHistogram[4],
    fourValentPercent: interior > 0 ? 100 * valenceHistogram[4] / interior : undefined,
  };
}

/** @param {Report} report @returns {Figures} */
export function reported(report) {
  const { quality, vertices, quads, triangles, boundaryNodes, singularities, tau, size, hash } = report;
  const { etaMean, etaMin, etaP5, fourValentPercent, etaHistogram, valenceHistogram, interiorVertices } = quality;
  return {
    final: true, quads, triangles, vertices, boundaryNodes, singularities, tau, size, hash,
    etaMean, etaMin, etaP5, fourValentPercent, etaHistogram, valenceHistogram,
    irregular: interiorVertices - (valenceHistogram[4] ?? 0),
    energy: report.lp.energy?.at(-1), gradientNorm: report.lp.gradientNorm?.at(-1), seconds: report.cpuSeconds,
  };
}

/** @param {NonNullable<Snapshot['triangles']>} layer */
const countsOf = ({ points, triangles, boundaryNodes }) =>
  ({ vertices: points.length / 2, triangles: triangles.length / 3, boundaryNodes });

/** Of the picture that is shown. @param {Run} run @returns {Figures} */
export function figuresOf({ frame, result }) {
  if (frame?.stage === 'done' && result) return reported(result.report);
  if (frame === null) return { final: false };
  const settling = frame.stage === 'optimise';
  return {
    final: false,
    ...(frame.triangles && countsOf(frame.triangles)),
    ...(frame.crosses && { singularities: frame.crosses.indices.length }),
    ...(frame.quads && qualityOf(frame.quads)),
    ...(settling && { energy: frame.energy, gradientNorm: frame.gradientNorm || undefined }),
    tau: frame.tau || undefined,
  };
}

/** One iteration of the L_p stage. @typedef {{iteration: number, energy: number, gradientNorm: number}} Iterate */

/** What is known of the iterations, and the tick of the first.
 * @param {Run} run  @returns {{iterates: Iterate[], first: number, planned: number}} */
export function iteratesOf({ history, result }) {
  const seen = history.filter(({ stage }) => stage === 'optimise');
  const first = seen.length > 0 ? seen[0].tick - seen[0].iteration : 0;
  const planned = seen.at(-1)?.maxIterations ?? 0;
  const { energy, gradientNorm } = result?.report.lp ?? {};
  if (energy && seen.length > 0)
    return { first, planned: energy.length - 1, iterates: energy.map((value, iteration) =>
      ({ iteration, energy: value, gradientNorm: gradientNorm?.[iteration] ?? 0 })) };
  return { first, planned, iterates: seen };
}

/** The iteration a state stands for; the end of the L_p stage counts as its last.
 * @param {State | null} state  @param {Iterate[]} iterates */
export function iterationOf(state, iterates) {
  if (state === null || state.stage === 'seeds') return 0;
  return state.stage === 'optimise' ? state.iteration : iterates.at(-1)?.iteration ?? 0;
}
