import type { FemField, MeshArrays, RunOptions } from 'circumball';
import { CoreClient, type CoreLoss } from '../core/client.ts';
import { complexToText } from '../core/complex-json.ts';
import { unitSquare } from '../numerics/meshes.ts';
import { type Method, type StudyPoint, studyPoint, type Varied } from '../numerics/study.ts';
import type { Complex2 } from '../shared/types.ts';

/** What a study goes through. */
export interface StudyPlan {
  readonly expression: string;
  readonly varied: Varied;
  readonly values: readonly number[];
  /** Also the averaged interpolant, which takes longer. */
  readonly averaged: boolean;
  /** Where `varied` is a size: what is meshed, and how. */
  readonly complex: Complex2;
  readonly options: RunOptions;
  /** Where it is not: the family, and what stays as it is. */
  readonly family: { readonly id: string; readonly columns: number; readonly degeneration: number };
}

/** One mesh of a study, kept so that it can be looked at. */
export interface StudyStep {
  readonly point: StudyPoint;
  readonly mesh: MeshArrays;
  readonly fields: Partial<Record<Method, FemField>>;
  readonly complex: Complex2;
}

/**
 * Errors on one mesh after the other, in a worker of its own: everything else goes on meanwhile, and a study is stopped by ending the
 * worker, at once.
 */
export class StudyStore {
  plan = $state.raw<StudyPlan | null>(null);
  steps = $state.raw<readonly StudyStep[]>([]);
  /** The value that is at work; null: none. */
  working = $state<number | null>(null);
  /** Why it ended early, or what its last mesh needs to be told of. */
  message = $state('');
  /** Index of the step whose mesh is in the picture. */
  shown = $state<number | null>(null);
  readonly points = $derived(this.steps.map((s) => s.point));
  readonly busy = $derived(this.working !== null);

  private core: CoreClient | null = null;
  private generation = 0;

  constructor(private readonly onLoss: (loss: CoreLoss) => void) {}

  /** `onStep` hears of every mesh. Resolves when the study has ended. */
  async start(plan: StudyPlan, onStep: (step: StudyStep, index: number) => void): Promise<void> {
    this.stop();
    this.clear();
    const generation = ++this.generation;
    this.plan = plan;
    this.core ??= new CoreClient(this.onLoss);
    const { core } = this;
    try {
      for (const value of plan.values) {
        this.working = value;
        const step = await takeStep(core, plan, value);
        if (generation !== this.generation) return;
        if (typeof step === 'string') {
          this.message = step;
          break;
        }
        this.steps = [...this.steps, step];
        onStep(step, this.steps.length - 1);
      }
    } catch {
      // The core was lost, which it tells by itself; what was measured stays.
    }
    if (generation === this.generation) this.working = null;
  }

  stop(): void {
    this.generation++;
    if (this.working === null) return;
    this.working = null;
    this.core?.dispose();
  }

  clear(): void {
    this.stop();
    this.plan = null;
    this.steps = [];
    this.message = '';
    this.shown = null;
  }
}

/** A sentence where there is no such mesh. */
async function takeStep(
  core: CoreClient,
  plan: StudyPlan,
  value: number,
): Promise<StudyStep | string> {
  const { expression, varied } = plan;
  const fields: Partial<Record<Method, FemField>> = {};
  let mesh: MeshArrays | null;
  let complex = unitSquare;
  if (varied === 'size') {
    complex = plan.complex;
    const options = JSON.stringify(plan.options);
    const answer = await core.femStudy(complexToText(complex), options, expression, value);
    if (!answer.ok || !answer.mesh) return answer.error || answer.defects[0]?.message || '';
    if (answer.status !== 'complete') return 'limit';
    mesh = answer.mesh;
    if (answer.interpolation) fields.interpolation = answer.interpolation;
    if (answer.poisson) fields.poisson = answer.poisson;
  } else {
    const { id } = plan.family;
    const columns = varied === 'columns' ? value : plan.family.columns;
    const degeneration = varied === 'degeneration' ? value : plan.family.degeneration;
    const answer = await core.femFamily(id, columns, degeneration);
    if (!answer.ok || !answer.mesh) return answer.error;
    mesh = answer.mesh;
    fields.interpolation = await core.femInterpolate(mesh, expression);
    fields.poisson = await core.femPoisson(mesh, expression);
  }
  if (plan.averaged) fields.averaged = await core.femAveraged(mesh, expression);
  const point = studyPoint(value, fields);
  if (!point) return Object.values(fields)[0]?.error ?? '';
  return { point, mesh, fields, complex };
}
