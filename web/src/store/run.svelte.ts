import type { Defect, Progress, Report, RunOptions } from 'circumball';
import { type CoreClient, CoreLost } from '../core/client.ts';
import { complexToText, inputFromJson } from '../core/complex-json.ts';
import { Trace } from '../replay/trace.ts';
import { type Complex3, type Input, isSpace } from '../shared/types.ts';

export type RunPhase =
  | 'none'
  | 'starting'
  | 'running'
  | 'complete'
  | 'limit'
  | 'cancelled'
  | 'failed';

/** One run of the core and what it has handed out so far. Replaced as a whole by the next one. */
export class RunStore {
  phase = $state<RunPhase>('none');
  trace = $state.raw<Trace | null>(null);
  /** Grows with every slice: what reads the trace depends on it. */
  traceVersion = $state(0);
  progress = $state.raw<Progress | null>(null);
  report = $state.raw<Report | null>(null);
  verifying = $state(false);
  verified = $state(false);
  error = $state('');
  defects = $state.raw<readonly Defect[]>([]);
  /** What the run was started with, and what the core made of it. */
  options = $state.raw<RunOptions>({});
  complex = $state.raw<Input | null>(null);
  /** What a run in space refines: the input, and the box about it if there is one. */
  refined = $state.raw<Complex3 | null>(null);
  algorithm = $state('');
  tau = $state(0);
  domain = $state('');
  readonly busy = $derived(this.phase === 'starting' || this.phase === 'running');
  readonly finished = $derived(
    this.phase === 'complete' || this.phase === 'limit' || this.phase === 'cancelled',
  );

  private generation = 0;

  constructor(private readonly core: CoreClient) {}

  /** Starts a run and stays with it to its end. `onTrace` is called once, when there is a trace to look at. */
  async start(complex: Input, options: RunOptions, onTrace: () => void): Promise<void> {
    const generation = ++this.generation;
    const isCurrent = () => generation === this.generation;
    if (this.busy) await this.core.stop();
    this.clear();
    this.phase = 'starting';
    this.options = options;
    this.complex = complex;
    try {
      const answer = await this.core.start(complexToText(complex), JSON.stringify(options));
      if (!isCurrent()) return;
      if (!answer.ok) {
        this.phase = 'failed';
        this.error = answer.error;
        this.defects = answer.defects;
        return;
      }
      this.algorithm = answer.algorithm;
      this.tau = answer.tau;
      this.domain = answer.domain;
      const trace = new Trace({
        dimension: isSpace(complex) ? 3 : 2,
        vertexCount: complex.vertices.length,
        segments: complex.segments,
      });
      this.trace = trace;
      this.phase = 'running';
      onTrace();
      if (isSpace(complex)) {
        const refined = answer.domain === 'box' ? await this.core.runComplex() : '';
        if (!isCurrent()) return;
        this.refined = refined ? (inputFromJson(JSON.parse(refined)) as Complex3) : complex;
      }
      const last = await this.core.work((chunk, progress) => {
        if (!isCurrent()) return;
        trace.append(chunk.events, chunk.simplices, chunk.steps);
        this.progress = progress;
        this.traceVersion++;
      });
      if (!isCurrent() || !last) return;
      const report = await this.core.report(false);
      if (!isCurrent()) return;
      this.report = report;
      this.phase = last.status === 'running' ? 'cancelled' : last.status;
    } catch (error) {
      if (!isCurrent()) return;
      this.phase = this.trace ? 'cancelled' : 'failed';
      this.error = error instanceof CoreLost ? error.loss : String(error);
    }
  }

  async stop(): Promise<void> {
    if (this.busy) await this.core.stop();
  }

  /** The input has changed: what was computed is no longer about it. */
  discard(): void {
    this.generation++;
    if (this.busy) void this.core.stop();
    this.clear();
  }

  async verify(): Promise<void> {
    if (!this.finished || this.verifying) return;
    const generation = this.generation;
    this.verifying = true;
    try {
      const report = await this.core.report(true);
      if (generation !== this.generation) return;
      this.report = report;
      this.verified = report !== null;
    } catch (error) {
      this.error = error instanceof CoreLost ? error.loss : String(error);
    } finally {
      this.verifying = false;
    }
  }

  private clear(): void {
    this.phase = 'none';
    this.trace = null;
    this.traceVersion = 0;
    this.progress = null;
    this.report = null;
    this.verified = false;
    this.error = '';
    this.defects = [];
    this.complex = null;
    this.refined = null;
  }
}
