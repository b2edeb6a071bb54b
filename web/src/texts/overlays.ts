/** Texts of what the picture shows: colors, overlays of the theory, the legend. */
export const overlaysTexts = {
  colors: {
    plain: 'None',
    quality: 'Smallest angle',
    size: 'Area',
    radius: 'Circumradius',
    step: 'Step of birth',
    age: 'Age',
    region: 'Region',
    error: 'Error on each triangle',
    dihedral: 'Smallest dihedral angle',
    radiusEdge: 'Radius / edge',
    volume: 'Volume',
  },
  overlays: {
    mesh: 'Mesh',
    outside: 'Outside the domain',
    vertices: 'Steiner vertices',
    circumcircles: 'Circumcircles',
    labels: 'Vertex numbers',
    grid: 'Grid',
  },
  /** Overlays of the theory: name, and what they show, in one sentence. */
  theory: {
    title: 'Overlays',
    open: 'Overlays',
    featureSize: {
      name: 'Local feature size',
      hint: 'lfs as a field; point at the picture for the ball, pick a point to keep it.',
    },
    neighbors: {
      name: 'N against lfs',
      hint: 'At each input vertex its nearest neighbor (solid) and lfs (dashed), with their ratio; flagged outside of [½, √2].',
    },
    diametral: {
      name: 'Diametral disks',
      hint: 'Of the subsegments; encroached ones with the vertex inside.',
    },
    spindles: {
      name: 'Spindles',
      hint: 'Spind(s) of the subsegment that is picked or acting: with an end segment go all end segments at its input vertex.',
    },
    collars: {
      name: 'Collars',
      hint: 'End segments that are never split, with their diametral disks.',
    },
    intestines: {
      name: 'Intestines',
      hint: 'Disks about acute input vertices, and the arcs that bound them.',
    },
    ancestry: {
      name: 'Ancestry',
      hint: 'From the picked vertex back to the input, parent by parent.',
    },
  },
  /** The ball of the local feature size (thesis, Definition 2.1.6). */
  featureSize: {
    title: 'Local feature size',
    invite:
      'Point at the picture, or give a point: the ball that shows its local feature size is drawn.',
    point: 'At the point',
    release: 'Let the point go',
    measuring: 'measuring …',
    ball: (at: string, radius: string, first: string, second: string) =>
      `lfs${at} = ${radius}: the smallest closed ball there that meets two disjoint input features; it meets ${first} and touches ${second}.`,
    none: (at: string) => `lfs${at} = ∞: no two input features are disjoint.`,
    feature: (kind: 'vertex' | 'segment', index: number) => `${kind} ${index}`,
  },
  legend: {
    title: 'Legend',
    onPicture: 'Legend of the picture',
    fold: 'Fold the legend',
    input: 'Input feature',
    onSegment: 'Vertex on a segment',
    inFace: 'Vertex in a face',
    free: 'Free vertex',
    acting: 'Simplex in hand',
    witness: 'Its witness',
    ball: 'Its ball',
    ghost: 'Point that was not inserted',
    yielding: 'Yields to',
  },
} as const;
