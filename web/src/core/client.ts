import type {
  Defect,
  FeatureSizesAnswer,
  FemAveraged,
  FemField,
  FemPoisson,
  FemStudy,
  FemTriangle,
  MeshArrays,
  Progress,
  ReadAnswer,
  Report,
  SubsegmentSizesAnswer,
  TraceChunk,
} from 'circumball';
import * as Comlink from 'comlink';
import type { CoreApi, Hello, OutputFile, StartAnswer } from './worker.ts';

/** Why a worker was given up. */
export type CoreLoss = 'crashed' | 'hung';

/** A call ended because its worker is gone. */
export class CoreLost extends Error {
  constructor(readonly loss: CoreLoss) {
    super(`the core ${loss}`);
  }
}

/** A call that gives no sign of life for so long (a slice of a run, a check of a complex, a verification) hangs. */
const PATIENCE_MS = 30_000;
const PATIENCE_VERIFY_MS = 300_000;

/**
 * The core as the page sees it: promises in, plain objects out. A worker that crashes or hangs is replaced at the next
 * call; whatever it was doing fails with CoreLost, and nothing that the page holds is touched.
 */
export class CoreClient {
  private worker: Worker | null = null;
  private remote: Comlink.Remote<CoreApi> | null = null;
  private lose: (loss: CoreLoss) => void = () => {};
  private lost: Promise<never> = new Promise(() => {});
  private ready: Promise<Hello> | null = null;

  constructor(private readonly onLoss: (loss: CoreLoss) => void = () => {}) {}

  hello(): Promise<Hello> {
    this.ready ??= this.spawn();
    return this.ready;
  }

  async read(files: { name: string; bytes: Uint8Array }[]): Promise<ReadAnswer> {
    return this.call((core) => core.read(files));
  }

  async check(complex: string): Promise<Defect[]> {
    return this.call((core) => core.check(complex));
  }

  async faceTriangles(complex: string): Promise<Uint32Array> {
    return this.call((core) => core.faceTriangles(complex));
  }

  async faceFrames(complex: string): Promise<Float64Array> {
    return this.call((core) => core.faceFrames(complex));
  }

  async featureSizes(complex: string, points: Float64Array): Promise<FeatureSizesAnswer> {
    return this.call((core) => core.featureSizes(complex, points));
  }

  async subsegmentSizes(complex: string, ends: Float64Array): Promise<SubsegmentSizesAnswer> {
    return this.call((core) => core.subsegmentSizes(complex, ends));
  }

  async start(complex: string, options: string): Promise<StartAnswer> {
    return this.call((core) => core.start(complex, options));
  }

  /** Advances the run that was started, to its end; `onSlice` hears of every slice. Null: another run took its place. */
  async work(onSlice: (chunk: TraceChunk, progress: Progress) => void): Promise<Progress | null> {
    let heard = Date.now();
    const watch = setInterval(() => {
      if (Date.now() - heard > PATIENCE_MS) this.replace('hung');
    }, 1000);
    const listen = Comlink.proxy(async (chunk: TraceChunk, progress: Progress) => {
      heard = Date.now();
      onSlice(chunk, progress);
    });
    try {
      const remote = await this.connect();
      return await Promise.race([remote.work(listen), this.lost]);
    } finally {
      clearInterval(watch);
    }
  }

  /** Asks the run to stop; a worker that does not obey within three seconds is replaced. */
  async stop(): Promise<void> {
    if (!this.remote) return;
    const deadline = setTimeout(() => this.replace('hung'), 3000);
    try {
      await Promise.race([this.remote.stop(), this.lost]);
    } catch {
      // Replaced: the run is over all the same.
    } finally {
      clearTimeout(deadline);
    }
  }

  /** What the run refines: the input, and the box about it if there is one. Empty if there is no run. */
  async runComplex(): Promise<string> {
    return this.call((core) => core.runComplex());
  }

  async report(verify: boolean): Promise<Report | null> {
    return this.call((core) => core.report(verify), PATIENCE_VERIFY_MS);
  }

  async write(extension: string): Promise<{ ok: boolean; error: string; files: OutputFile[] }> {
    return this.call((core) => core.write(extension), PATIENCE_VERIFY_MS);
  }

  async writeComplex(
    complex: string,
    extension: string,
  ): Promise<{ ok: boolean; error: string; files: OutputFile[] }> {
    return this.call((core) => core.writeComplex(complex, extension));
  }

  async femFamily(
    id: string,
    n: number,
    degeneration: number,
  ): Promise<{ ok: boolean; error: string; mesh: MeshArrays | null }> {
    return this.call((core) => core.femFamily(id, n, degeneration));
  }

  async femInterpolate(mesh: MeshArrays, expression: string): Promise<FemField> {
    return this.call((core) => core.femInterpolate(mesh, expression), PATIENCE_VERIFY_MS);
  }

  async femPoisson(mesh: MeshArrays, expression: string): Promise<FemPoisson> {
    return this.call((core) => core.femPoisson(mesh, expression), PATIENCE_VERIFY_MS);
  }

  async femAveraged(mesh: MeshArrays, expression: string): Promise<FemAveraged> {
    return this.call((core) => core.femAveraged(mesh, expression), PATIENCE_VERIFY_MS);
  }

  async femStudy(
    complex: string,
    options: string,
    expression: string,
    size: number,
  ): Promise<FemStudy> {
    return this.call(
      (core) => core.femStudy(complex, options, expression, size),
      PATIENCE_VERIFY_MS,
    );
  }

  async femTriangles(corners: Float64Array, expression: string): Promise<FemTriangle[]> {
    return this.call((core) => core.femTriangles(corners, expression));
  }

  /** Ends the worker and fails what waits for it. The next call starts a new one. */
  replace(loss: CoreLoss): void {
    if (!this.worker) return;
    this.worker.terminate();
    this.worker = null;
    this.remote = null;
    this.ready = null;
    this.lose(loss);
    this.onLoss(loss);
  }

  /** Ends the worker, and nobody is told: the page has no more use for what it does. */
  dispose(): void {
    this.worker?.terminate();
    this.worker = null;
    this.remote = null;
    this.ready = null;
    this.lose('crashed');
  }

  private async call<T>(
    act: (core: Comlink.Remote<CoreApi>) => Promise<T>,
    patience = PATIENCE_MS,
  ): Promise<T> {
    const remote = await this.connect();
    const timer = setTimeout(() => this.replace('hung'), patience);
    try {
      return await Promise.race([act(remote), this.lost]);
    } finally {
      clearTimeout(timer);
    }
  }

  private async connect(): Promise<Comlink.Remote<CoreApi>> {
    await this.hello();
    if (!this.remote) throw new CoreLost('crashed');
    return this.remote;
  }

  private spawn(): Promise<Hello> {
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('error', () => this.replace('crashed'));
    worker.addEventListener('messageerror', () => this.replace('crashed'));
    this.worker = worker;
    this.remote = Comlink.wrap<CoreApi>(worker);
    this.lost = new Promise((_, reject) => {
      this.lose = (loss) => reject(new CoreLost(loss));
    });
    this.lost.catch(() => {}); // nobody may be waiting
    return Promise.race([this.remote.hello(), this.lost]);
  }
}
