import { formatCount } from '../words.ts';

/** Texts of what is picked. */
export const inspectorTexts = {
  inspector: {
    vertex: (v: number) => `Vertex ${v}`,
    subsegment: 'Subsegment',
    triangle: 'Triangle',
    tetrahedron: 'Tetrahedron',
    face: (f: number) => `Face ${f}`,
    segment: (s: number) => `Segment ${s}`,
    number: 'Pick a vertex by number',
    pick: 'Pick',
    features: 'features',
    ends: (segments: readonly number[]) =>
      segments.length === 0
        ? 'input vertex, isolated'
        : `input vertex, end of segment${segments.length === 1 ? '' : 's'} ${segments.join(', ')}`,
    onSegment: (s: number) => `on input segment ${s}`,
    onBox: 'on a side of the box',
    onBoxEdge: 'on an edge of the box',
    onBoxFace: 'in a face of the box',
    inFace: (f: number) => `in face ${f}`,
    ofFaces: (faces: readonly number[]) =>
      `of face${faces.length === 1 ? '' : 's'} ${faces.join(', ')}`,
    ofBox: 'of the box',
    onCircle: (v: number) => `on the circle that protects vertex ${v}`,
    box: 'corner of the box',
    free: 'on no input feature',
    born: 'born',
    event: (event: number, step: string) => `event ${formatCount(event)}, step ${step}`,
    showBirth: 'Show that moment',
    insertionRadius: 'r_q',
    lfs: 'lfs(q)',
    ratio: 'lfs(q) / r_q',
    nearest: 'N(q)',
    nearestRatio: 'N(q) / lfs(q)',
    bound: (theorem: string, symbol: string, value: string, condition: string) =>
      `${condition === '' ? '' : `For ${condition}, `}${theorem} bounds it by ${symbol}${value === '' || value === symbol ? '' : ` = ${value}`}.`,
    unbounded: (theorem: string, symbol: string) =>
      `${theorem}: at most some ${symbol} that depends on the input angles and the parameters alone.`,
    ancestry: 'Ancestry',
    nearestIn: (v: number) => `N(q), to vertex ${v}`,
    step: 'step',
    parent: 'split',
    ancestryHint3: 'Each vertex and the witness that made it necessary, back to the input.',
    ancestryHint:
      'Each vertex and the one that made it necessary (the cases of the proof of Theorem 2.2).',
    isInput: 'A vertex of the input: the chain ends here.',
    back: (v: number) => `Back to vertex ${v}`,
    more: (n: number) => `and ${formatCount(n)} more`,
    causes: {
      input: 'of the input',
      box: 'a corner of the box',
      division: (segment: number) => `divides input segment ${segment}, by its length alone`,
      third: (segment: number) =>
        `divides input segment ${segment}, a third of the way to the nearest neighbor of its end`,
      protection: (v: number) => `protects the acute angle at vertex ${v}`,
      encroached: (split: string, v: number) =>
        `splits ${split}, upon which vertex ${v} encroached`,
      yielded: (triangle: string, edge: string, v: number) =>
        `the circumcenter of ${triangle} yielded to it; its shortest edge ${edge} has vertex ${v} as the younger end`,
      nearer: (split: string, v: number) =>
        `splits ${split}: its witness, vertex ${v}, is nearer to an end of it or of its spindle than its length`,
      outside: (split: string, v: number) =>
        `splits ${split}: vertex ${v}, outside of that face, is nearer to a corner of it than twice its circumradius`,
      missing: (split: string, v: number) =>
        `splits ${split}, which was no edge; vertex ${v} is its younger end`,
      triangle: (triangle: string, edge: string, v: number) =>
        `splits ${triangle}; its shortest edge ${edge} has vertex ${v} as the younger end`,
    },
  },
} as const;
