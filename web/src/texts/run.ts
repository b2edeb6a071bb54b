import { formatCount } from '../words.ts';

/** Texts of a run: what happens, what is left, what holds, what two runs differ by. */
export const runTexts = {
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
      // The report lists a thousand of them at most.
      const many = `${formatCount(left)}${left < 1000 ? '' : ' or more'} simplices stay`;
      const stay = left === 1 ? '1 simplex stays' : many;
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
    tetrahedra: 'Tetrahedra',
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
    paces: { vertices: 'inserted vertices', steps: 'steps', share: 'share of the run' },
    paceHints: {
      vertices:
        'Both have inserted the same number of vertices at every moment. Between two insertions the one with less to do waits; who has ended stays as it is.',
      steps:
        'Steps of the same name begin together: within them each has done the same share of what it does there.',
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
} as const;
