import type { FemTriangle } from 'circumball';
import { CoreClient, type CoreLoss } from '../core/client.ts';
import type { TriangleOptions } from '../link/link.ts';
import { type Corners, defaultCorners, flattened, sweepHeights } from '../numerics/triangle.ts';

/** The constants of a triangle whose apex comes down on its longest edge, at one height after the other. */
export interface Sweep {
  readonly beta: number;
  readonly triangles: readonly FemTriangle[]; // from high to flat
}

/** The triangle laboratory (thesis, 7.2.3). Asked of a worker of its own; the newest triangle wins. */
export class TriangleStore {
  corners = $state.raw<Corners>(defaultCorners);
  expression = $state('x^2');
  answer = $state.raw<FemTriangle | null>(null);
  sweep = $state.raw<Sweep | null>(null);

  private core: CoreClient | null = null;
  private asking = false;
  private asked = '';

  constructor(private readonly onLoss: (loss: CoreLoss) => void) {}

  move(corner: number, to: readonly [number, number]): void {
    if (!to.every(Number.isFinite)) return;
    this.corners = this.corners.map((p, i) => (i === corner ? to : p)) as unknown as Corners;
  }

  /** Measures the triangle as it is now; called when corners or expression changed. */
  async measure(): Promise<void> {
    if (this.asking) return;
    this.asking = true;
    try {
      for (;;) {
        const { corners, expression } = this;
        const question = JSON.stringify([corners, expression]);
        if (question === this.asked) break;
        this.asked = question;
        this.core ??= new CoreClient(this.onLoss);
        const [answer] = await this.core.femTriangles(
          Float64Array.from(corners.flat()),
          expression,
        );
        if (!answer) break;
        this.answer = answer;
        if (answer.ok && answer.beta !== this.sweep?.beta) await this.flatten(answer.beta);
      }
    } catch {
      this.asked = ''; // the core was lost, which it tells by itself
    } finally {
      this.asking = false;
    }
  }

  options(): TriangleOptions {
    return { corners: this.corners, expression: this.expression };
  }

  adopt({ corners, expression }: TriangleOptions): void {
    this.corners = corners;
    this.expression = expression;
  }

  private async flatten(beta: number): Promise<void> {
    const corners = sweepHeights().flatMap((alpha) => flattened(alpha, beta));
    const triangles = await this.core!.femTriangles(Float64Array.from(corners), '');
    this.sweep = { beta, triangles };
  }
}
