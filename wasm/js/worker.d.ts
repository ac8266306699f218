/// <reference lib="esnext.disposable" />
/**
 * `lpquad/worker`: the library in a worker of its own. The same calls as promises; results are
 * transferred, not copied. An abort is answered at once; a worker that is lost, or that is too busy to hear
 * the abort and that no session or other call needs, is replaced by the next call.
 */
import type {
  Description, Domain, Given, Layers, Mesh, MeshCallOptions, MeshFormat, MeshResult, Progress, ReadDomain,
  ReadOptions, ReadSurfaceOptions, Snapshot, State, Surface, SurfaceInput, SurfaceLayers, SurfaceMesh, SurfaceMeshFormat,
  SurfaceMeshResult, SurfaceOptions, SurfaceProgress, SurfaceSnapshot, WasmSource, WriteOptions,
} from './index.js';

export { LpquadError } from './index.js';

/** The worker takes no functions: sizes are given as samples. */
export type WorkerMeshOptions = Omit<MeshCallOptions, 'sizeAt' | 'angleAt' | 'onProgress'>;

export interface Control<P = Progress & { tick: number }> {
  /** Ends the run with the error CANCELLED, whose `cause` is the signal's reason. */
  signal?: AbortSignal;
  /** Returning false ends the run with the error CANCELLED. What it throws ends it too, and is what the call rejects with. */
  onProgress?: (progress: P) => unknown;
}
export type SurfaceControl = Control<SurfaceProgress>;

export interface WorkerSession {
  /** As of the last call that came back. */
  readonly state: State;
  step(ticks?: number, control?: Control): Promise<State>;
  restore(tick: number, control?: Control): Promise<State>;
  snapshot(layers?: Layers): Promise<Snapshot>;
  finish(control?: Control): Promise<MeshResult>;
  clone(): Promise<WorkerSession>;
  /** Snapshots after every `every` (1) ticks until the end. */
  run(options?: { layers?: Layers; every?: number; signal?: AbortSignal }): AsyncGenerator<Snapshot>;
  dispose(): Promise<void>;
  [Symbol.asyncDispose](): Promise<void>;
}

export interface WorkerSurfaceSession {
  /** As of the last call that came back. */
  readonly state: SurfaceProgress;
  step(ticks?: number, control?: SurfaceControl): Promise<SurfaceProgress>;
  snapshot(layers?: SurfaceLayers): Promise<SurfaceSnapshot>;
  finish(control?: SurfaceControl): Promise<SurfaceMeshResult>;
  /** Snapshots after every `every` (1) ticks until the end. */
  run(options?: { layers?: SurfaceLayers; every?: number; signal?: AbortSignal }): AsyncGenerator<SurfaceSnapshot>;
  dispose(): Promise<void>;
  [Symbol.asyncDispose](): Promise<void>;
}

export interface LpquadWorker {
  /** Starts the worker, unless it runs. */
  ready(): Promise<Description>;
  meshDomain(domain: Domain, options?: WorkerMeshOptions, control?: Control): Promise<MeshResult>;
  start(domain: Domain, options?: WorkerMeshOptions & { memory?: boolean }, control?: Control): Promise<WorkerSession>;
  readDomain(source: string | Uint8Array | ArrayBuffer, options?: ReadOptions): Promise<ReadDomain>;
  readSurface(source: string | Uint8Array | ArrayBuffer, options?: ReadSurfaceOptions): Promise<Surface>;
  isSurfaceFile(source: string | Uint8Array | ArrayBuffer, options?: { name?: string }): Promise<boolean>;
  meshSurface(surface: SurfaceInput, options?: SurfaceOptions, control?: SurfaceControl): Promise<SurfaceMeshResult>;
  startSurface(surface: SurfaceInput, options?: SurfaceOptions, control?: SurfaceControl): Promise<WorkerSurfaceSession>;
  writeMesh(mesh: Given<SurfaceMesh>, format: SurfaceMeshFormat, options?: WriteOptions): Promise<string>;
  writeMesh(mesh: Given<Mesh> & { dimension?: 2 }, format: MeshFormat, options?: WriteOptions): Promise<string>;
  /** Open calls and sessions end with WORKER_LOST. */
  terminate(): void;
  [Symbol.dispose](): void;
}

/**
 * @param options  `worker` makes the thread where the bundler does not know
 *   `new Worker(new URL(…))`: `() => new Worker(urlOfWorkerEntry, { type: 'module' })`.
 */
export function createLpquadWorker(options?: WasmSource & { worker?: () => unknown }): LpquadWorker;
