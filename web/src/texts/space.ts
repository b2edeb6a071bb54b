import { formatCount } from '../words.ts';

const removal =
  'Tetrahedra with a small dihedral angle, which a good radius-edge ratio does not rule out: where some point of the ball of one makes them fewer, and encroaches upon nothing, it is inserted.';

/** Algorithms 6.3 and 6.4 differ in how tubes are refined. */
const intestineSteps = {
  '0': 'The input vertices alone are tetrahedralized.',
  '2b': 'Segments at acute angles are split until they are short against all that is near, and beside longer ones are graded: so spheres and tubes of different features do not meet.',
  '2c': 'A sphere is put about every protected input vertex and a tube, by rings, about every protected segment. In each face they leave collar arcs and collar segments.',
  '3a': 'Arcs and collar segments with a vertex in their diametral ball are split, until each is an edge.',
  '3b': 'In every face what lies in spheres and tubes is told from what is beyond.',
  '3c': 'Patches of spheres and tubes, and triangles of faces outside of them, with a vertex in their ball are split: patches of tubes by new rings or arcs. Then the surfaces are unions of facets.',
  '3d': 'Tetrahedra inside of the domain are told from those outside.',
  '3': 'Tetrahedra outside of the spheres and tubes whose circumradius is more than τ times their shortest edge are split: none is refused there, whatever the angles.',
};

/** Texts of space: how it is looked at, what is measured and protected in it, one face alone. */
export const spaceTexts = {
  /** The picture of space. */
  space: {
    label:
      'The complex in space. Shift and arrow keys turn it, plus and minus zoom, arrow keys step.',
    tools: 'View',
    views: {
      corner: 'View from a corner',
      front: 'View from the front',
      right: 'View from the right',
      top: 'View from above',
    },
    turn: { left: 'Turn left', right: 'Turn right', up: 'Turn up', down: 'Turn down' },
    closer: 'Look at what happens',
    nowhere: 'This moment is about no place.',
    colorBy: 'Color by',
    ofCells: 'Of the tetrahedra.',
    ofFacets: 'Of the triangles of the faces; show the tetrahedra to color them.',
    faces: 'Faces',
    faceLook: 'Faces: translucent, solid, hidden',
    faceLooks: { translucent: 'Translucent', solid: 'Solid', hidden: 'Hidden' },
    show: 'Show',
    switches: {
      facets: 'Triangles of faces',
      cells: 'Tetrahedra',
      outside: 'Outside the domain',
      vertices: 'Steiner vertices',
      collars: 'Collars',
      surfaces: 'Spheres and tubes',
      labels: 'Vertex numbers',
    },
    shrink: 'Take apart',
    peel: 'Peel off',
    layers: (n: number) => (n === 0 ? 'nothing' : n === 1 ? '1 layer' : `${n} layers`),
    explode: 'Take the tetrahedra apart',
    clip: {
      title: 'Clip plane',
      across: 'The plane stands across',
      axes: { x: 'x', y: 'y', z: 'z', view: 'the view' },
      place: 'Place of the clip plane',
      flip: 'Show the other half',
      exact: 'Cut cells',
      exactHint: 'Cells that meet the plane are cut through; else they stay whole.',
      remove: 'Remove the clip plane',
      forward: 'Clip plane forwards',
      back: 'Clip plane back',
    },
    close: 'Close, back to the drawing',
    noAlgorithm: 'This version has no algorithm for space.',
  },
  /** What protects acute features in space (thesis, chapter 6). */
  protection: {
    row: 'protection',
    inCollar: 'in the collar: never split',
    beyond: 'beyond the collars',
    piece: 'never split any more',
    ordinary: 'none: split where it is encroached',
    about: (n: number) => `${formatCount(n)} arcs or patches about it`,
    refused: 'not split, as',
    stopped: 'circumcenter',
    stoppers: (name: string, others: number) =>
      `in the ball of ${name}, a collar simplex${others === 0 ? '' : `, and of ${formatCount(others)} more`} (Theorem 6.11)`,
    free: 'in no ball of a collar simplex',
    legend: {
      collar: 'Collar',
      piece: 'Protected piece',
      surface: 'Sphere or tube',
    },
  },
  /** Feature sizes of a subsegment in space. */
  sizes: {
    length: '|s|',
    kind: 'kind',
    end: 'end segment',
    inner: 'non-end segment',
    fs1: 'fs₁(s)',
    lfs1: 'lfs₁(s)',
    lfs: 'lfs(s)',
    ratio: (name: string) => `|s| / ${name}`,
    between: (a: string, b: string) => `${a} and ${b}`,
    feature: (kind: 'vertex' | 'segment' | 'face', index: number) => `${kind} ${index}`,
    none: 'no two such features',
    witnesses: 'witnesses',
    draw: 'Spheres',
    drawn: { fs1: 'fs₁', lfs: 'lfs', both: 'both' },
    measuring: 'measuring …',
    bounds: 'What is proved at this moment',
    noBounds: 'Of this moment chapter 4 says nothing about |s|; go to the end of a step.',
    gone: 'This subsegment is not in the mesh at this moment.',
    ofBound: (times: string) => `|s| is ${times} times that`,
  },
  /** One face alone in its own plane. */
  face: {
    show: 'One face in its own plane',
    showThis: 'Show this face in its own plane',
    showOf: (f: number) => `Face ${f} in its plane`,
    title: (f: number) => `Face ${f}`,
    number: 'Number of the face',
    of: (n: number) => `of ${formatCount(n)}`,
    next: 'Next face',
    previous: 'Previous face',
    follow: 'Follow',
    followHint: 'Goes with the face in which something happens.',
    close: 'Close the face',
    fit: 'Fit the face to its picture',
    label: (f: number) => `Face ${f} in its own plane. Arrow keys step, plus and minus zoom.`,
    counts: (vertices: number, triangles: number) =>
      `${formatCount(vertices)} vertices, ${formatCount(triangles)} triangles`,
    elsewhere: (f: number) => `Now in face ${f}`,
    outsider: (v: number, height: string, above: boolean) =>
      `vertex ${v}, ${height} ${above ? 'before' : 'behind'} the face`,
    none: 'This face has no plane.',
    needsRun: 'Refine the input to see the triangulation of the face.',
  },
  /** Counts by step in space. */
  steps: {
    step: 'step',
    vertices: 'vertices',
    segments: 'segments',
    triangles: 'triangles of faces',
    now: 'now',
    reference: (source: string) => `${source} has`,
    /** What each step is for, by algorithm. */
    why: {
      'feature-size': {
        '0': 'The input vertices alone are tetrahedralized. In it the nearest neighbor of an input vertex is as far as lfs₀ there: the first size that is known.',
        '1a': 'Every segment is cut at a third of that distance from its input vertices. From now on end segments at one vertex are equally long, and those at different vertices are far apart.',
        '1b': 'Segments that are long against their distance from other segments and vertices are halved, the longest first: it ends with |s| ≤ √2 fs₁(s). Faces are not looked at.',
        '2a': 'Every segment is cut into four, so that no segment or vertex is left near another one. What is still too near can only be a face.',
        '2b': 'Triangles of faces are split where something outside of the face is near, and segments where a face is: it ends with |s| ≤ 5/3 lfs(s).',
      },
      ruppert: {
        '0': 'The input vertices alone are tetrahedralized.',
        '1': 'Pieces of segments with a vertex in their diametral ball are halved, and triangles of faces with one in their equatorial ball are split: then every face is a union of facets.',
        '1b': 'Tetrahedra inside of the domain are told from those outside.',
        '2': 'Tetrahedra whose circumradius is more than τ times their shortest edge are split, the first that was found first.',
        slivers: removal,
      },
      collar: {
        '0': 'The input vertices alone are tetrahedralized.',
        '2b': 'Segments at acute angles are split until they are short against all that is near, end segments at one vertex alike. So what protects one feature stays clear of all others.',
        '2c': 'Vertices are put beside protected segments, in every face: across from each vertex of the segment (rule 1), on the circle about its end (rule 2), and on the rest of that circle (rule 3). Collar segments and arcs join them.',
        '3a': 'Collar segments and arcs with a vertex in their diametral ball are split, until each is an edge.',
        '3b': 'In every face the collar, between its segments and arcs and what they protect, is told from what is beyond.',
        '3c': 'Triangles beyond the collars with a vertex in their equatorial ball are split: then every face is a union of facets.',
        '3d': 'Tetrahedra inside of the domain are told from those outside.',
        '3': 'Tetrahedra whose circumradius is more than τ times their shortest edge are split, unless their circumcenters lie in balls of collar simplices alone: these stay (Theorem 6.11), and so it ends.',
        slivers: removal,
      },
      'intestine-structured': intestineSteps,
      intestine: {
        ...intestineSteps,
        '3c': 'Patches of spheres and tubes, and triangles of faces outside of them, with a vertex in their ball are split: patches at their circumcenters, in the tube unrolled. Then the surfaces are unions of facets.',
      },
    } as Readonly<Record<string, Readonly<Record<string, string>>>>,
  },
  /** The rules of the step that removes slivers. */
  sliverRules: {
    source: 'Chew 1997, Li 2000, Li and Teng 2001',
    unacceptability:
      'A tetrahedron is unacceptable if its smallest dihedral angle is below the bound.',
    priority: 'The first that was found is processed first; those refused once more at the end.',
    safety: 'It is safe to split any tetrahedron.',
    action:
      'Of sixty points in the ball of the tetrahedron insert the one that lowers the number of slivers most, if it encroaches upon nothing and every new tetrahedron has a radius-edge ratio of at most $\\tau$; where triangles of a face are in the way, points of that face.',
  },
  /** Below the histogram, of its outline. */
  slivers: (before: string, now: string, bound: string) =>
    `before slivers were removed: ${before} tetrahedra with an angle below ${bound}, now ${now}`,
} as const;
