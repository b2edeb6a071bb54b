import type { FemField, FemFunction, FemPoisson, MeshArrays } from 'circumball';
import { CoreClient, type CoreLoss } from '../core/client.ts';
import type { NumericsOptions } from '../link/link.ts';
import { isOutline, sameBounds, scaledTo } from '../numerics/functions.ts';
import { meshOf, stillMesh, unitSquare } from '../numerics/meshes.ts';
import { type Method, methods, type Norm, norms } from '../numerics/study.ts';
import { boundsOf } from '../picture/view.ts';
import type { Complex2, MeshState } from '../shared/types.ts';
import { StudyStore } from './study.svelte.ts';

/** A mesh in the picture that is not the run's: of a family of Figure 7.1, or of a study. */
export interface Still {
  readonly state: MeshState;
  readonly complex: Complex2;
  /** The error on each triangle, by number; null until it is measured. */
  readonly values: Float64Array | null;
  readonly title: string;
  /** Whether it lies elsewhere than the input, so that the view has to go there. */
  readonly elsewhere: boolean;
}

export interface FamilyChoice {
  readonly id: string;
  readonly columns: number;
  readonly degeneration: number;
}

/** What a method makes of u on one mesh. */
type Field = FemField & Partial<Pick<FemPoisson, 'unknowns' | 'weakLoad'>>;

export const defaultFamily: FamilyChoice = { id: 'narrow', columns: 8, degeneration: 4 };

/**
 * Numerical methods on the mesh at hand: a function, how it is approximated, and the error on each triangle. Measured in a worker of
 * its own, one question at a time; an answer that came too late is dropped.
 */
export class NumericsStore {
  /** Id of the core's list; '' for one's own expression. */
  function = $state('smooth');
  expression = $state('');
  method = $state<Method>('interpolation');
  norm = $state<Norm>('h1');
  /** Null: the mesh of the run. */
  family = $state.raw<FamilyChoice | null>(null);

  field = $state.raw<Field | null>(null);
  /** Why there is no field: of the expression, or of the mesh. */
  error = $state('');
  measuring = $state(false);
  still = $state.raw<Still | null>(null);
  /** The error on each triangle of the run's mesh, by number. */
  private runValues = $state.raw<Float64Array | null>(null);
  readonly values = $derived(this.still ? this.still.values : this.runValues);
  readonly study: StudyStore;

  private core: CoreClient | null = null;
  private wanted: (() => Promise<void>) | null = null;
  private generation = 0;

  constructor(private readonly onLoss: (loss: CoreLoss) => void) {
    this.study = new StudyStore(onLoss);
  }

  /** A function of the core's list, moved to where the input is. */
  choose(f: FemFunction, complex: Complex2): void {
    this.function = f.id;
    const home = boundsOf(f.outline);
    const here = this.family ? boundsOf(unitSquare.vertices) : boundsOf(complex.vertices);
    this.expression =
      home && here && !sameBounds(home, here) ? scaledTo(f.expression, home, here) : f.expression;
  }

  /** Measures on what a run has at its playhead. */
  measureRun(state: MeshState): void {
    const { expression, method, norm } = this;
    this.ask(async (isWanted) => {
      const { mesh, numbers } = meshOf(state);
      const count = state.cellCount; // the state goes on while the core is at work
      if (numbers.length === 0) return;
      const field = await this.apply(method, mesh, expression);
      if (!isWanted()) return;
      this.take(field);
      const values = new Float64Array(count);
      const errors = norm === 'h1' ? field.cellH1 : field.cellL2;
      numbers.forEach((t, i) => {
        values[t] = errors[i] ?? 0;
      });
      this.runValues = field.ok ? values : null;
    });
  }

  /** Shows the mesh of the family that is chosen, and measures on it. */
  measureFamily(choice: FamilyChoice, title: string): void {
    const { expression, method, norm } = this;
    this.ask(async (isWanted) => {
      const { ok, error, mesh } = await this.connected().femFamily(
        choice.id,
        choice.columns,
        choice.degeneration,
      );
      if (!isWanted()) return;
      if (!ok || !mesh) {
        this.error = error;
        return;
      }
      const field = await this.apply(method, mesh, expression);
      if (!isWanted()) return;
      this.take(field);
      this.show(mesh, field, norm, unitSquare, title, true);
    });
  }

  show(
    mesh: MeshArrays,
    field: FemField | null,
    norm: Norm,
    complex: Complex2,
    title: string,
    elsewhere: boolean,
  ): void {
    const values = field?.ok ? (norm === 'h1' ? field.cellH1 : field.cellL2) : null;
    this.still = { state: stillMesh(mesh), complex, values, title, elsewhere };
  }

  /** Back to the run. */
  leave(): void {
    this.family = null;
    this.still = null;
    this.study.shown = null;
  }

  /** Nothing that was measured is about the mesh at hand any more. */
  forget(): void {
    this.generation++;
    this.wanted = null;
    this.field = null;
    this.runValues = null;
    this.error = '';
  }

  take(field: Field): void {
    this.field = field.ok ? field : null;
    this.error = field.ok ? '' : field.error;
  }

  options(): NumericsOptions {
    const { expression, method, norm, family } = this;
    return { function: this.function, expression, method, norm, family };
  }

  adopt(options: NumericsOptions): void {
    this.leave();
    this.function = options.function;
    this.expression = options.expression;
    this.method = methods.find((m) => m === options.method) ?? 'interpolation';
    this.norm = norms.find((n) => n === options.norm) ?? 'h1';
    this.family = options.family;
  }

  /** Is the input the domain that the function is meant for? */
  isAtHome(f: FemFunction, complex: Complex2): boolean {
    return isOutline(f.outline, complex.vertices);
  }

  private connected(): CoreClient {
    this.core ??= new CoreClient(this.onLoss);
    return this.core;
  }

  private apply(method: Method, mesh: MeshArrays, expression: string): Promise<Field> {
    const core = this.connected();
    if (method === 'poisson') return core.femPoisson(mesh, expression);
    if (method === 'averaged') return core.femAveraged(mesh, expression);
    return core.femInterpolate(mesh, expression);
  }

  /** The newest question is asked when the one before is answered; those between are forgotten. */
  private ask(question: (isWanted: () => boolean) => Promise<void>): void {
    const generation = ++this.generation;
    this.wanted = () => question(() => generation === this.generation);
    if (!this.measuring) void this.answerAll();
  }

  private async answerAll(): Promise<void> {
    this.measuring = true;
    while (this.wanted) {
      const question = this.wanted;
      this.wanted = null;
      try {
        await question();
      } catch {
        this.field = null; // the core was lost, which it tells by itself
      }
    }
    this.measuring = false;
  }
}
