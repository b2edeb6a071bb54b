import { VertexKind } from '../shared/types.ts';

/** What the thesis says of lfs(q) / r_q for an algorithm. */
export interface RatioBound {
  readonly theorem: string;
  /** Bound on lfs(q) / r_q; null where the thesis proves that there is one, and names none that is of use. */
  readonly bound: number | null;
  readonly symbol: string;
  /** The condition on the input under which it was proved. */
  readonly condition: string;
}

/** Null for algorithms that promise no grading, or at vertices of the box. */
export function ratioBound(algorithm: string, tau: number, kind: number): RatioBound | null {
  const condition = 'input angles of at least 90° and τ > √2';
  switch (algorithm) {
    case 'ruppert': {
      // (2.1), (2.2): C2 >= (1 + tau) / (tau - sqrt 2), C1 = sqrt 2 C2 + 1; for input vertices lfs <= lfs_0 <= r_q.
      const theorem = 'Theorem 2.2';
      if (kind === VertexKind.input) return { theorem, bound: 1, symbol: '1', condition: '' };
      if (!(tau > Math.SQRT2)) return { theorem, bound: null, symbol: 'C', condition };
      const c2 = (1 + tau) / (tau - Math.SQRT2);
      return kind === VertexKind.onSegment
        ? { theorem, bound: Math.SQRT2 * c2 + 1, symbol: 'C₁', condition }
        : { theorem, bound: c2, symbol: 'C₂', condition };
    }
    case 'collar':
      return { theorem: 'Theorem 5.6', bound: null, symbol: 'C', condition: 'τ > √2' };
    case 'intestine':
      return { theorem: 'Theorem 5.10', bound: null, symbol: 'C', condition: 'τ > √2' };
    default:
      return null;
  }
}
