import createCircumball, {
  type AlgorithmInfo,
  type CircumballModule,
  type Defect,
  type FeatureSizesAnswer,
  type FemAveraged,
  type FemFamilyInfo,
  type FemField,
  type FemFunction,
  type FemPoisson,
  type FemStudy,
  type FemTriangle,
  type MeshArrays,
  type Progress,
  type ReadAnswer,
  type Report,
  type SubsegmentSizesAnswer,
  type TraceChunk,
} from 'circumball';
import * as Comlink from 'comlink';

/** The core in a worker. One run at a time; a run is advanced in slices so that it can be watched and stopped. */

const SLICE_SECONDS = 0.012;
/** So that a slice's part of the trace is decoded within a frame. */
const SLICE_ITERATIONS = 2000;

export interface Hello {
  version: string;
  selfTest: string;
  algorithms: AlgorithmInfo[];
  extensions: { readonly 2: string[]; readonly 3: string[] }; // of meshes, by dimension
  functions: FemFunction[];
  families: FemFamilyInfo[];
}

export interface StartAnswer {
  ok: boolean;
  error: string;
  defects: Defect[];
  steps: string[];
  tau: number;
  domain: string;
  algorithm: string;
}

export interface OutputFile {
  extension: string;
  bytes: Uint8Array;
}

let core: CircumballModule;
let run: number | null = null;
let stopping = false;

/** Lets messages in: a stop must be heard between two slices. */
function breathe(): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, 0));
}

function takeTrace(handle: number): TraceChunk {
  const chunk = core.takeTrace(handle);
  return Comlink.transfer(chunk, [chunk.events.buffer, chunk.simplices.buffer] as Transferable[]);
}

const api = {
  async hello(): Promise<Hello> {
    core = await createCircumball();
    return {
      version: core.version(),
      selfTest: core.selfTest(),
      algorithms: core.algorithms(),
      extensions: { 2: core.meshExtensions(2), 3: core.meshExtensions(3) },
      functions: core.femFunctions(),
      families: core.femFamilies(),
    };
  },

  read(files: { name: string; bytes: Uint8Array }[]): ReadAnswer {
    return core.read(files);
  },

  check(complex: string): Defect[] {
    return core.check(complex);
  },

  faceTriangles(complex: string): Uint32Array {
    return core.faceTriangles(complex);
  },

  featureSizes(complex: string, points: Float64Array): FeatureSizesAnswer {
    return core.featureSizes(complex, points);
  },

  faceFrames(complex: string): Float64Array {
    return core.faceFrames(complex);
  },

  subsegmentSizes(complex: string, ends: Float64Array): SubsegmentSizesAnswer {
    return core.subsegmentSizes(complex, ends);
  },

  start(complex: string, options: string): StartAnswer {
    if (run !== null) core.release(run);
    run = null;
    stopping = false;
    const answer = core.start(complex, options);
    if (answer.ok) run = answer.run;
    const { ok, error, defects, steps, tau, domain, algorithm } = answer;
    return { ok, error, defects, steps, tau, domain, algorithm };
  },

  /** Runs to the end, handing out the trace as it grows. The receiver's answer is waited for: it sets the pace. */
  async work(
    onSlice: (chunk: TraceChunk, progress: Progress) => Promise<void>,
  ): Promise<Progress | null> {
    const handle = run;
    if (handle === null) return null;
    for (;;) {
      const progress = stopping
        ? core.cancel(handle)
        : core.advance(handle, SLICE_ITERATIONS, SLICE_SECONDS);
      if (run !== handle) return null;
      await onSlice(takeTrace(handle), progress);
      if (progress.status !== 'running') return progress;
      await breathe();
    }
  },

  stop(): void {
    stopping = true;
  },

  runComplex(): string {
    return run === null ? '' : core.runComplex(run);
  },

  report(verify: boolean): Report | null {
    return run === null ? null : core.report(run, verify);
  },

  write(extension: string): { ok: boolean; error: string; files: OutputFile[] } {
    return run === null ? { ok: false, error: 'no run', files: [] } : core.write(run, extension);
  },

  writeComplex(
    complex: string,
    extension: string,
  ): { ok: boolean; error: string; files: OutputFile[] } {
    return core.writeComplex(complex, extension);
  },

  femFamily(
    id: string,
    n: number,
    degeneration: number,
  ): { ok: boolean; error: string; mesh: MeshArrays | null } {
    return core.femFamily(id, n, degeneration);
  },

  femInterpolate(mesh: MeshArrays, expression: string): FemField {
    return core.femInterpolate(mesh, expression);
  },

  femPoisson(mesh: MeshArrays, expression: string): FemPoisson {
    return core.femPoisson(mesh, expression);
  },

  femAveraged(mesh: MeshArrays, expression: string): FemAveraged {
    return core.femAveraged(mesh, expression, 0);
  },

  femStudy(complex: string, options: string, expression: string, size: number): FemStudy {
    return core.femStudy(complex, options, expression, size);
  },

  /** Six coordinates a triangle. */
  femTriangles(corners: Float64Array, expression: string): FemTriangle[] {
    const answers: FemTriangle[] = [];
    for (let i = 0; i + 5 < corners.length; i += 6) {
      const [ax, ay, bx, by, cx, cy] = corners.subarray(i, i + 6) as unknown as SixNumbers;
      answers.push(core.femTriangle(ax, ay, bx, by, cx, cy, expression));
    }
    return answers;
  },
};

type SixNumbers = [number, number, number, number, number, number];

export type CoreApi = typeof api;
Comlink.expose(api);
