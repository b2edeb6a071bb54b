/** Every English text of the page that is not a fact of the core, in one place; and how numbers and names are written. */

export const texts = {
  name: 'Circumball',
  tagline: 'Delaunay refinement that you can watch, and trust',
  loading: 'Loading the core …',
  coreFailed: 'The core could not be started.',
  coreUnsound: 'The arithmetic of this browser is not what the exact predicates need: ',
  reload: 'Reload the page',
  noWebGL:
    'This browser offers no WebGL 2, which the picture is drawn with. Turn on hardware acceleration, or try another browser.',
  empty: {
    title: 'Draw a polygon, or start from an example',
    hint: 'Choose a tool at the left edge, drop a file anywhere, or paste one.',
  },
  top: {
    examples: 'Examples',
    open: 'Open',
    share: 'Share',
    export: 'Export',
    theme: 'Theme',
    help: 'Help',
    algorithm: 'Algorithm',
    more: 'More',
    fold: 'Panel',
  },
  tools: {
    title: 'Tools',
    watch: 'Watch',
    picture: 'picture',
    meshLabel: 'The mesh. Arrow keys step, plus and minus zoom.',
    inputLabel: 'The input. Arrow keys move the cursor, Enter sets a point.',
  },
  panel: {
    title: 'Details',
    now: 'Now',
    rules: 'The four rules',
    parameters: 'Parameters',
    queue: 'Queue',
    inspector: 'Picked',
    quality: 'Quality',
    counts: 'Steps',
    prove: 'Prove',
    document: 'Input',
    guarantee: 'Guarantee',
    source: 'Source',
  },
  rules: {
    action: 'Action',
    priority: 'Priority',
    unacceptability: 'Unacceptability',
    safety: 'Safety',
    acting: 'acting now',
  },
  moment: {
    start: 'Nothing has happened yet. Press play, or step.',
    none: 'No run yet.',
    computing: 'Refining …',
  },
  queue: {
    empty: 'The queue is empty.',
    more: (n: number) => `and ${formatCount(n)} more`,
    length: (n: number, segments: number) => {
      if (segments === n) return `${formatCount(n)} waiting, all subsegments`;
      return (
        `${formatCount(n)} waiting` +
        (segments === 1 ? ', one of them a subsegment' : '') +
        (segments > 1 ? `, ${formatCount(segments)} of them subsegments` : '')
      );
    },
  },
  transport: {
    play: 'Play',
    pause: 'Pause',
    step: 'Step',
    stepBack: 'Step back',
    start: 'To the start',
    end: 'To the end',
    speed: 'Speed',
    timeline: 'Timeline',
    stop: 'Stop computing',
    next: 'Next',
    previous: 'Previous',
    targets: { insertion: 'insertion', refusal: 'refusal', yield: 'yield', step: 'end of step' },
  },
  run: {
    start: 'Refine',
    stale: 'Draw, then refine to see what becomes of it.',
    kept: 'The input as it was refined. Change it, or go back to watching.',
    none: 'Refine the input to fill the timeline.',
    failed: 'The run could not start.',
    done: (left: number) => {
      if (left === 0) return 'The queue is empty and nothing unacceptable is left: the end.';
      const stay = left === 1 ? '1 simplex stays' : `${formatCount(left)} simplices stay`;
      return `The queue is empty: the end. ${stay} unacceptable, as it is not safe to split ${left === 1 ? 'it' : 'them'}.`;
    },
    crashed: 'The core stopped unexpectedly and was started again. Your drawing is safe.',
    hung: 'The core did not answer and was started again. Your drawing is safe.',
    limits: {
      vertices:
        'The bound on vertices was reached. Raise it under Parameters, or change the input.',
      other: 'A limit was reached: the mesh is valid, but not everything could be made acceptable.',
    },
  },
  colors: {
    plain: 'None',
    quality: 'Smallest angle',
    size: 'Area',
    radius: 'Circumradius',
    step: 'Step of birth',
    age: 'Age',
    region: 'Region',
    error: 'Error on each triangle',
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
  inspector: {
    vertex: (v: number) => `Vertex ${v}`,
    subsegment: 'Subsegment',
    triangle: 'Triangle',
    number: 'Pick a vertex by number',
    pick: 'Pick',
    features: 'features',
    ends: (segments: readonly number[]) =>
      segments.length === 0
        ? 'input vertex, isolated'
        : `input vertex, end of segment${segments.length === 1 ? '' : 's'} ${segments.join(', ')}`,
    onSegment: (s: number) => `on input segment ${s}`,
    onBox: 'on a side of the box',
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
    ancestryHint:
      'Each vertex and the one that made it necessary (the cases of the proof of Theorem 2.2).',
    isInput: 'A vertex of the input: the chain ends here.',
    back: (v: number) => `Back to vertex ${v}`,
    more: (n: number) => `and ${formatCount(n)} more`,
    causes: {
      input: 'of the input',
      box: 'a corner of the box',
      division: (segment: number) => `divides input segment ${segment}, by its length alone`,
      protection: (v: number) => `protects the acute angle at vertex ${v}`,
      encroached: (split: string, v: number) =>
        `splits ${split}, upon which vertex ${v} encroached`,
      yielded: (triangle: string, edge: string, v: number) =>
        `the circumcenter of ${triangle} yielded to it; its shortest edge ${edge} has vertex ${v} as the younger end`,
      missing: (split: string, v: number) =>
        `splits ${split}, which was no edge; vertex ${v} is its younger end`,
      triangle: (triangle: string, edge: string, v: number) =>
        `splits ${triangle}; its shortest edge ${edge} has vertex ${v} as the younger end`,
    },
  },
  legend: {
    title: 'Legend',
    onPicture: 'Legend of the picture',
    fold: 'Fold the legend',
    input: 'Input feature',
    onSegment: 'Vertex on a segment',
    free: 'Free vertex',
    acting: 'Simplex in hand',
    witness: 'Its witness',
    ball: 'Its ball',
    ghost: 'Point that was not inserted',
    yielding: 'Yields to',
  },
  unresolved: {
    title: 'Left as it is',
    hint: 'Still unacceptable when the run ended, and why it was not split:',
    near: 'near',
  },
  prove: {
    title: 'Prove',
    invite: 'The core checks what the algorithm promises, on the finished mesh.',
    run: 'Verify the mesh',
    running: 'Verifying …',
    needsRun: 'Refine the input first.',
    check: 'Check',
    bound: 'Bound',
    observed: 'Observed',
    holds: 'holds',
    fails: 'fails',
    allHold: 'Every promised check holds.',
    holdsSoFar: (left: number) =>
      `Every check holds of the mesh so far; ${left} ${left === 1 ? 'simplex is' : 'simplices are'} left unacceptable.`,
    someFail: (n: number) => `${n} of the promised checks ${n === 1 ? 'fails' : 'fail'}.`,
    fingerprint: 'Fingerprint',
    fingerprintHint: 'The command prints the same for the same input and parameters.',
  },
  gallery: { title: 'Examples', hint: 'Each opens in the picture and can be changed.' },
  exports: {
    title: 'Export',
    mesh: 'The finished mesh',
    complex: 'The input',
    picture: 'The picture at this moment',
    svg: 'Vector figure (SVG)',
    png: 'Image for print (PNG, 300 dpi)',
    width: 'Width in centimeters',
    background: 'Background',
    caption: 'Caption',
    copyCaption: 'Copy the caption',
    trace: 'The trace',
  },
  share: {
    title: 'Share this moment',
    hint: 'The link carries input, algorithm, parameters, moment and view exactly. Nothing is uploaded.',
    copy: 'Copy link',
    copied: 'Copied.',
    long: 'This input makes a long link; some programs cut it off. Sending the exported input is safer.',
  },
  help: { title: 'Help', keys: 'Keys', tour: 'Take the tour', about: 'About' },
  document: {
    vertices: 'vertices',
    segments: 'segments',
    holes: 'holes',
    coordinates: 'Coordinates',
    selected: (n: number) => `${n} selected`,
    split: 'Split crossings',
    crossingsSplit: (n: number) => (n === 1 ? '1 crossing split.' : `${n} crossings split.`),
    clear: 'Clear all',
    defects: 'What is wrong with the input',
    snap: 'Snap to',
    snaps: { vertex: 'vertices', segment: 'segments', grid: 'grid', angle: '45°' },
    add: 'Add a point',
    join: 'Join',
    close: 'Close',
  },
  repetition: {
    title: 'It does not end',
    zoom: 'Zoom into the repetition',
    stop: 'Stop the zoom',
    next: 'Next cycle',
    previous: 'Previous cycle',
    story: (vertex: number, factor: string, segments: string) =>
      `At input vertex ${vertex} the ends of segments ${segments} are split again and again in the same order, each time ${factor} times as large.`,
    vertex: 'Limit vertex',
    factor: 'Shrink factor',
    period: 'Period',
    periodOf: (midpoints: number, circumcenters: number) => {
      const parts = [];
      if (midpoints > 0) parts.push(midpoints === 1 ? '1 midpoint' : `${midpoints} midpoints`);
      if (circumcenters > 0)
        parts.push(circumcenters === 1 ? '1 circumcenter' : `${circumcenters} circumcenters`);
      const all = midpoints + circumcenters;
      return `${formatCount(all)} ${all === 1 ? 'insertion' : 'insertions'}: ${parts.join(', ')}`;
    },
    each: 'Each single split',
    eachOf: (factor: string) => `${factor} already, turned or mirrored`,
    cycles: 'Cycles seen',
    radius: 'Insertion radius',
    radiusFrom: (first: string, last: string) => `${first} to ${last}`,
    here: (cycle: number, cycles: number, times: string) =>
      `Cycle ${cycle} of ${cycles}, magnified ${times} ×`,
    why: (free: string) =>
      `Nearer than ${free} to that vertex the input is nothing but segments that meet in a point: alike at every size. And the rules compare lengths with lengths: none of them knows a size. So what came again will come again, and there is no end.`,
    stopped: (limit: string, left: number) =>
      `Stopped by ${limit}; ${left === 1 ? '1 simplex is' : `${formatCount(left)} simplices are`} left unacceptable.`,
    limits: {
      vertices: 'the bound on the number of vertices',
      'min-edge': 'the bound on the shortest edge',
      seconds: 'the bound on time',
      precision: 'the end of double precision',
      memory: 'the bound on memory',
      cancelled: 'hand',
    },
    left: 'What is left, and why',
    beside: 'Compare with collars',
  },
  compare: {
    title: 'Compare',
    tab: 'Compare',
    brief: 'Differences, in step by …',
    firstAlgorithm: 'First algorithm',
    secondAlgorithm: 'Second algorithm',
    details: (name: string) => `The panel is about: ${name}`,
    vertices: 'Vertices',
    triangles: 'Triangles',
    minAngle: 'Smallest angle',
    maxAngle: 'Largest angle',
    refused: 'Refused',
    waits: 'Waits.',
    ended: {
      complete: 'Done.',
      limit: 'Stopped by a limit.',
      cancelled: 'Stopped.',
    },
    inStep: 'In step by',
    paces: { vertices: 'inserted vertices', share: 'share of the run' },
    paceHints: {
      vertices:
        'Both have inserted the same number of vertices at every moment. Between two insertions the one with less to do waits; who has ended stays as it is.',
      share: 'Both begin and end together: each has done the same share of all that it does.',
    },
    table: 'Differences',
    now: 'at this moment',
    final: 'at the end',
    difference: 'Difference',
    bad: (tau: string) => `Radius / edge > ${tau}`,
    badHint: 'Triangles worse than τ of the first algorithm, counted alike in both meshes.',
    unresolved: 'Left unacceptable',
    checks: 'Checks that hold',
    checksOf: (ok: number, all: number) => `${ok} of ${all}`,

    verify: 'Verify both meshes',
    ends: 'Ends',
    endings: { complete: 'by itself', limit: 'by a limit', cancelled: 'by hand', failed: 'failed' },
    parameters:
      'Each algorithm has its parameters under Setup; the button beside its name chooses whose the panel shows.',
  },
  /** Linear elements on the mesh at hand (thesis, chapter 7). */
  numerics: {
    tab: 'Numerics',
    title: 'Numerical methods',
    function: 'Function',
    choose: 'Choose a function',
    own: 'an expression of your own',
    expression: 'u(x, y)',
    domain: (title: string) => `Open the domain of “${title}”`,
    domainHint: 'It is meant for another domain; here it is moved and scaled to your input.',
    method: 'Approximation',
    methods: {
      interpolation: 'Interpolant',
      poisson: 'Poisson’s equation',
      averaged: 'Averaged interpolant',
    },
    methodHints: {
      interpolation: '$I_1 u$ takes the values of $u$ at the vertices.',
      poisson: 'Linear elements for $-\\Delta v = -\\Delta u$, with $v = u$ on the boundary.',
      averaged:
        'Theorem 7.12: $u$ is cut off near the boundary, smoothed over $h$, and interpolated. It needs no values at the vertices and no angle condition; $u$ should be zero on the boundary.',
    },
    notZero:
      'Here u is not zero on the boundary, and what is cut off there is lost: in L² the error falls like √h only. Open the domain of “Steep shores” to see the order 1 of the theorem.',
    norm: 'Colored by',
    norms: { h1: '$|u - u_h|_{H^1}$', l2: '$\\|u - u_h\\|_{L^2}$' },
    normNames: { h1: 'error in H1', l2: 'error in L2' },
    mesh: 'Mesh',
    run: 'the mesh of the run',
    figure: (letter: string, title: string) => `Figure 7.1(${letter}): ${title.toLowerCase()}`,
    columns: 'columns',
    degeneration: 'degeneration',
    familyTitle: (title: string, columns: number, degeneration: number) =>
      `${title}: ${columns} columns, degeneration ${degeneration}`,
    sizeTitle: (h: string) => `The mesh of the study with h = ${h}`,
    back: 'Back to the run',
    errors: 'Errors',
    relative: (percent: string) => `${percent} of u`,
    rows: {
      h1: '$|u - u_h|_{H^1}$',
      l2: '$\\|u - u_h\\|_{L^2}$',
      h: 'longest edge $h$',
      circumradius: 'largest $R$',
      angle: 'largest angle',
      triangles: 'triangles',
      unknowns: 'unknowns',
    },
    weakLoad: 'u is made of pieces: the load is taken as the integral of ∇u · ∇v.',
    unsettled: (n: number) =>
      `On ${formatCount(n)} triangles the integral did not settle: the error is known roughly there.`,
    measuring: 'Measuring …',
    now: (method: string, triangles: string, h1: string, l2: string) =>
      `${method} on ${triangles} triangles: the error is ${h1} in H¹ and ${l2} in L².`,
    needsRun: 'Refine the input first, or choose a family of meshes.',
    study: 'Refine and watch',
    varied: 'What changes',
    varieds: {
      size: 'size',
      columns: 'columns (h)',
      degeneration: 'degeneration',
    },
    first: 'from',
    count: 'meshes',
    start: 'Refine and watch',
    stop: 'Stop',
    working: (name: string, value: string) => `${name} = ${value} …`,
    byAlgorithm: (title: string) =>
      `Meshes by: ${title}. Each has half the size of the one before.`,
    byFamily: 'Each mesh has twice the value of the one before.',
    limit: 'The bound on vertices was reached (Setup): the study ends here.',
    order: (norm: string, order: string) => `${norm}: order ${order}`,
    orders: 'Observed order',
    growth: 'Observed growth',
    power: 'power',
    grows: (norm: string, power: string) => `${norm}: like k^${power}`,
    noOrder: 'Two meshes with an error are needed for an order.',
    exact: 'The error is rounding only: u is linear on every triangle.',
    plotLabel: (method: string, x: string) =>
      `Errors of the ${method} against ${x}, both by logarithms. The table below has the numbers.`,
    slope: (n: number) => `h${n === 1 ? '' : '²'}`,
    axisH: 'h',
    axisDegeneration: 'degeneration',
    asR: 'R',
    table: 'Numbers of the study',
    rate: 'order',
    show: 'Show this mesh',
    csv: 'Numbers (CSV)',
    png: 'Plot (PNG)',
    stale: 'This study is about another function; start it again.',
    needsAveraged: 'The averaged interpolant was not part of this study; start it again.',
    laboratory: 'A single triangle',
    laboratoryHint:
      'Why R and not h: drag the apex of one triangle and watch the constants of Theorem 7.10.',
  },
  /** The triangle laboratory (thesis, section 7.2.3). */
  triangle: {
    title: 'Triangle laboratory',
    figure: 'The triangle with its circumscribed and inscribed circles',
    hint: 'Drag a corner, or focus it and use the arrow keys (Shift: finer).',
    corner: (name: string) => `Corner ${name}`,
    at: (x: string, y: string) => `${x}, ${y}`,
    presets: 'Shapes',
    presetNames: {
      equilateral: 'Equilateral',
      needle: 'Needle, right-angled',
      flat: 'Flat, isosceles',
      skew: 'Flat, skew',
    },
    halve: 'Halve the height',
    double: 'Double the height',
    cornersTitle: 'Corners',
    shape: 'Shape',
    angles: 'angles',
    h: 'longest edge $h$',
    R: 'circumradius $R$',
    bound75: 'Proposition 7.5: $R \\ge$',
    inradius: 'inradius',
    radiusEdge: 'radius / shortest edge',
    parameters: 'Figure 7.2: $(\\alpha, \\beta)$',
    constants: 'The constant',
    constant: '$C = \\max |u - I_1 u|_{H^1} / |u|_{H^2}$',
    constantHint: 'over all quadratic $u$',
    perR: '$C / R$',
    perH: '$C / h$',
    kobayashi: '$C$ over all $u$ (Kobayashi): at most',
    l2: '$C$ for $L^2$',
    error: 'This function',
    h1Error: '$|u - I_1 u|_{H^1}$',
    h1Bound: '$R \\, |u|_{H^2}$',
    ratio: 'error / bound',
    worst: 'Take the worst quadratic',
    plot: 'The apex comes down',
    plotHint: (beta: string) =>
      `The apex sinks onto the longest edge above the same foot, $\\beta$ = ${beta}: the constant against h and against R.`,
    axis: 'height / longest edge',
    perRName: 'C / R',
    perHName: 'C / h',
    plotTable: 'Numbers of the plot',
    apexAngle: 'largest angle',
    link: 'Copy a link to this triangle',
    linkCopied: 'Link copied.',
    flatError: 'The corners are in line.',
    seen: {
      flat: (angle: string, rh: string, perH: string, perR: string) =>
        `The largest angle is ${angle}. R is ${rh} h, and the constant has grown with it: ${perH} h, but only ${perR} R. Large angles are the danger, and R is what measures it.`,
      needle: (angle: string, rh: string, perH: string, perR: string) =>
        `Narrow, but no angle is above ${angle}: R is still ${rh} h, and the constant stays small, ${perH} h or ${perR} R. Small angles alone do no harm.`,
      fat: (angle: string, rh: string, perH: string, perR: string) =>
        `A well-shaped triangle, its largest angle is ${angle}: R is ${rh} h, the constant is ${perH} h or ${perR} R. Now bring the apex down.`,
    },
  },
  open: {
    drop: 'Drop the file to open it',
    failed: (name: string) => `${name} could not be opened.`,
    three: 'This file holds a complex in space; the page draws the plane.',
    noExample: (id: string) =>
      `There is no example “${id}”. The gallery of examples lists what there is.`,
    noFunction: (id: string) =>
      `There is no function “${id}”. The tab Numerics lists what there is.`,
    opened: (name: string) => `Opened ${name}`,
  },
  close: 'Close',
  undo: (title: string) => (title ? `Undo: ${title}` : 'Undo'),
  redo: (title: string) => (title ? `Redo: ${title}` : 'Redo'),
} as const;

const counts = new Intl.NumberFormat('en-US');

export function formatCount(n: number): string {
  return counts.format(n);
}

/** Four significant digits: for reading. Exact values are shown where they are edited. */
export function formatNumber(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? '–' : x > 0 ? '∞' : '−∞';
  if (x === 0) return '0';
  const size = Math.abs(x);
  const text =
    size >= 1e6 || size < 1e-3
      ? x.toExponential(2).replace('e', ' · 10^').replace('^+', '^')
      : String(Number(x.toPrecision(4)));
  return text.replace('-', '−').replace(/\^(.*)$/, (_, power: string) => superscript(power));
}

function superscript(power: string): string {
  const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
  return [...power].map((c) => (c >= '0' && c <= '9' ? digits[Number(c)] : '⁻')).join('');
}

/** 0.002, 50, 10⁻⁴, 2 · 10⁻⁵: numbers of few digits, as axes carry them. */
export function formatTick(x: number): string {
  if (x >= 1e-3 && x < 1e5) return String(Number(x.toPrecision(3)));
  const [digits, power] = x.toExponential().split('e');
  const ten = `10${superscript(power!.replace('+', ''))}`;
  return digits === '1' ? ten : `${digits} · ${ten}`;
}

export function formatDegrees(x: number): string {
  return Number.isFinite(x) ? `${x.toFixed(1)}°` : '–';
}

/** The core's messages begin in lower case, as the command prints them after a file name. */
export function asSentence(message: string): string {
  // The name of a function, or of a file, stays as it is.
  const text = message.replace(/^(?!u\b|\S+\.\w)./, (first) => first.toUpperCase());
  return /[.!?]$/.test(text) || text === '' ? text : `${text}.`;
}

/** "H1", "H^s", "L2", "h^2", as the core writes them in plain text, with raised letters and digits. */
export function raised(text: string): string {
  return text
    .replace(/\b([HL])\^?([12])\b/g, (_, space: string, of: string) => space + superscript(of))
    .replace(/\^(\d+)\b/g, (_, power: string) => superscript(power))
    .replace(/\^s\b/g, 'ˢ');
}

/** "0", "0 and 4", "0, 1 and 4". */
export function formatList(items: readonly (number | string)[]): string {
  const last = items.length - 1;
  return last < 1 ? items.join('') : `${items.slice(0, last).join(', ')} and ${items[last]}`;
}

/** "triangle 3–7–12", "subsegment 3–7 of segment 2". */
export function simplexName(simplex: readonly number[], segment?: number): string {
  if (simplex.length === 2) {
    // An arc of a protecting circle lies on no input segment.
    if (segment === 0xffffffff) return `arc ${simplex.join('–')}`;
    const of = segment === undefined ? '' : ` of segment ${segment}`;
    return `subsegment ${simplex.join('–')}${of}`;
  }
  return simplex.length === 3 ? `triangle ${simplex.join('–')}` : `vertex ${simplex.join('')}`;
}
