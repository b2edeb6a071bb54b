// The typed face and the built module say the same: every declared function is there, nothing else is, and what each
// returns has the declared type, on good input and on bad.
import { fileURLToPath } from 'node:url';
import createCircumball, { type CircumballModule, type Progress } from 'circumball';
import { beforeAll, describe, expect, it } from 'vitest';
import { square } from '../support/square.ts';
import { nonconformity, readInterface } from './conforms';

const declarations = fileURLToPath(new URL('../../wasm/circumball.d.mts', import.meta.url));
const { checker, members } = readInterface(declarations, 'CircumballModule');

/** Whether what a function of the face returned is of the declared type. */
function expectDeclared(name: keyof CircumballModule, value: unknown) {
  const member = members.find((candidate) => candidate.name === name)!;
  const signature = checker.getTypeOfSymbol(member).getCallSignatures()[0]!;
  expect(nonconformity(value, signature.getReturnType(), checker, name)).toBe('');
}

const squareText = JSON.stringify(square);
const crossing = JSON.stringify({
  ...square,
  segments: [
    [0, 2],
    [1, 3],
  ],
});
const bytes = (text: string) => new TextEncoder().encode(text);

let core: CircumballModule;
beforeAll(async () => {
  core = await createCircumball();
});

/** A finished run of Ruppert's algorithm with small triangles. */
function finishedRun(options = {}) {
  const answer = core.start(
    squareText,
    JSON.stringify({ algorithm: 'ruppert', size: '0.1', ...options }),
  );
  expect(answer.error).toBe('');
  let progress: Progress;
  do progress = core.advance(answer.run, 100, 0);
  while (progress.status === 'running');
  return answer.run;
}

describe('the module', () => {
  it('has exactly the declared functions', () => {
    expect(Object.keys(core).sort()).toEqual(members.map((member) => member.name).sort());
    for (const value of Object.values(core)) expect(typeof value).toBe('function');
  });

  it('takes as many arguments as declared', () => {
    for (const member of members) {
      const signature = checker.getTypeOfSymbol(member).getCallSignatures()[0]!;
      const implemented = core[member.name as keyof CircumballModule];
      expect([member.name, implemented.length]).toEqual([member.name, signature.parameters.length]);
    }
  });

  it('says its version and that its arithmetic is sound', () => {
    expect(core.version()).toMatch(/^\d+\.\d+\.\d+$/);
    expect(core.selfTest()).toBe('');
  });

  it('lists the algorithms and the names of the trace', () => {
    expectDeclared('algorithms', core.algorithms());
    expect(core.algorithms().map(({ id }) => id)).toContain('ruppert');
    const names = core.traceNames();
    expectDeclared('traceNames', names);
    expect(names.kinds[6]).toBe('inserted');
    expect(names.reasons[3]).toBe('radius-edge');
  });
});

describe('read', () => {
  it('reads a file with its sibling', () => {
    const answer = core.read([
      { name: 'box.poly', bytes: bytes('0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n') },
      { name: 'box.node', bytes: bytes('3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n') },
    ]);
    expectDeclared('read', answer);
    expect(answer.defects).toEqual([]);
    expect(answer.complex.vertices).toHaveLength(3);
    expect(answer.complex.segments).toHaveLength(3);
  });

  it('answers hostile bytes with defects', () => {
    for (const text of ['', '\0\0\0', '9999999999 2 0 0\n', '{"circumball": 1', '[[[[[[']) {
      const answer = core.read([{ name: 'bad.poly', bytes: bytes(text) }]);
      expectDeclared('read', answer);
      expect(answer.ok).toBe(false);
      expect(answer.defects.length).toBeGreaterThan(0);
    }
  });
});

describe('check', () => {
  it('finds nothing in a square and the crossing of its diagonals', () => {
    expect(core.check(squareText)).toEqual([]);
    const defects = core.check(crossing);
    expectDeclared('check', defects);
    expect(defects.map(({ name }) => name)).toContain('segments-cross');
  });
});

describe('faceTriangles', () => {
  it('fills faces, holes left out, with the number of the face', () => {
    const ring = (z: number) => [
      [0, 0, z],
      [4, 0, z],
      [4, 4, z],
      [0, 4, z],
      [1, 1, z],
      [3, 1, z],
      [3, 3, z],
      [1, 3, z],
    ];
    const loop = (from: number) => [from, from + 1, from + 2, from + 3];
    const complex = {
      circumball: 1,
      dimension: 3,
      vertices: [...ring(0), ...ring(1)],
      faces: [{ loops: [loop(0), loop(4)], holes: [[2, 2, 0]] }, { loops: [loop(8)] }],
    };
    const triangles = core.faceTriangles(JSON.stringify(complex));
    expectDeclared('faceTriangles', triangles);
    let area = [0, 0];
    for (let t = 0; t < triangles.length; t += 4) {
      const [a, b, c] = [0, 1, 2].map((k) => complex.vertices[triangles[t + k]!]!);
      const twice = (b![0]! - a![0]!) * (c![1]! - a![1]!) - (b![1]! - a![1]!) * (c![0]! - a![0]!);
      expect(twice).toBeGreaterThan(0); // counter-clockwise about the normal
      area = area.map((x, face) => (face === triangles[t + 3] ? x + twice / 2 : x));
    }
    expect(area).toEqual([12, 16]);
  });

  it('of what is no complex are none', () => {
    for (const text of [
      '',
      '{"circumball": 1',
      '{"circumball":1,"dimension":3,"vertices":[],"faces":[{"loops":[[0,1,2]]}]}',
    ])
      expect(core.faceTriangles(text)).toHaveLength(0);
  });
});

describe('featureSizes', () => {
  it('gives lfs, mfs and the witnesses at each point', () => {
    const answer = core.featureSizes(squareText, new Float64Array([0.5, 0.25, 0, 0, 2, 0.5]));
    expectDeclared('featureSizes', answer);
    expect(answer.ok).toBe(true);
    expect([...answer.lfs]).toEqual([0.5, 1, Math.sqrt(1.25)]);
    expect([...answer.mfs]).toEqual([0.5, 0, Math.sqrt(1.25)]);
    expect(answer.witnesses).toHaveLength(12);
    expect([answer.witnesses[1], answer.witnesses[3]].sort()).toEqual([1, 3]); // the vertical sides
    expect([...answer.at.slice(0, 4)].sort()).toEqual([0, 0.25, 0.25, 1]);
    expect([...core.featureSizes(squareText, new Float64Array([1, 1])).lfs]).toEqual([1]); // kept
  });

  it('is infinite where no two features are disjoint, and where there is no point', () => {
    const lonely = JSON.stringify({ circumball: 1, dimension: 2, vertices: [[0, 0]] });
    const answer = core.featureSizes(lonely, new Float64Array([1, 2]));
    expectDeclared('featureSizes', answer);
    expect([...answer.lfs, ...answer.mfs]).toEqual([Infinity, Infinity]);
    expect([...answer.witnesses]).toEqual([3, 0xffffffff, 3, 0xffffffff]);
    expect(core.featureSizes(squareText, new Float64Array([NaN, 0])).lfs[0]).toBe(Infinity);
    expect(core.featureSizes(squareText, new Float64Array([1e300, 0])).lfs[0]).toBe(Infinity);
    expect(core.featureSizes(squareText, new Float64Array()).lfs).toHaveLength(0);
  });

  it('answers what is no valid complex with a sentence', () => {
    for (const text of ['', 'nonsense', crossing, '{"circumball":1,"dimension":3,"vertices":[]}']) {
      const answer = core.featureSizes(text, new Float64Array([0, 0]));
      expectDeclared('featureSizes', answer);
      expect([text, answer.ok, answer.lfs.length]).toEqual([text, false, 0]);
      expect(answer.error).not.toBe('');
    }
  });
});

/** The unit square in space, and a vertex half above its middle. */
const plate = JSON.stringify({
  circumball: 1,
  dimension: 3,
  vertices: [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
    [0.5, 0.5, 0.5],
  ],
  segments: [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ],
  faces: [{ loops: [[0, 1, 2, 3]] }],
});

describe('featureSizes in space', () => {
  it('knows faces as witnesses', () => {
    const answer = core.featureSizes(plate, new Float64Array([0.5, 0.5, 0.25]));
    expectDeclared('featureSizes', answer);
    expect([answer.error, ...answer.lfs, ...answer.mfs]).toEqual(['', 0.25, 0.25]);
    const witnesses = [...answer.witnesses];
    const found = [witnesses.slice(0, 2), witnesses.slice(2)].sort();
    expect(found).toEqual([
      [0, 4],
      [2, 0],
    ]);
    expect(answer.at).toHaveLength(6);
  });
});

describe('subsegmentSizes', () => {
  it('gives fs_1, lfs_1 and lfs of pieces of segments with where they are attained', () => {
    const ends = new Float64Array([0, 0, 0, 0.25, 0, 0, 0.25, 0, 0, 0.75, 0, 0]);
    const answer = core.subsegmentSizes(plate, ends);
    expectDeclared('subsegmentSizes', answer);
    expect(answer.error).toBe('');
    const { fs1, lfs1, lfs } = answer;
    // The end segment: nearest to two disjoint features where it is nearest to the vertex above.
    expect(fs1.radius[0]).toBe(lfs1.radius[0]);
    expect(fs1.radius[0]).toBeCloseTo(Math.hypot(0.25, 0.5, 0.5), 12);
    expect([...fs1.center.slice(0, 3)]).toEqual([0.25, 0, 0]);
    // Inside of the segment mfs_1 counts its own ends and sides beside it: the segment itself and an end.
    expect(fs1.radius[1]).toBeCloseTo(0.25, 12);
    expect(lfs1.radius[1]).toBeCloseTo(0.5, 12); // the two ends of the segment
    expect(lfs.radius[1]).toBeCloseTo(0.5, 12);
    expect(lfs.center[3]).toBeCloseTo(0.5, 12);
    for (const balls of [fs1, lfs1, lfs]) {
      for (const k of [0, 1]) {
        const center = balls.center.slice(3 * k, 3 * k + 3);
        for (const w of [0, 1]) {
          const at = balls.at.slice(6 * k + 3 * w, 6 * k + 3 * w + 3);
          const far = Math.hypot(...[...at].map((x, i) => x - center[i]!));
          expect(far).toBeLessThanOrEqual(balls.radius[k]! * (1 + 1e-12));
        }
      }
    }
  });

  it('answers in the plane, and what is no valid complex with a sentence', () => {
    const plane = core.subsegmentSizes(squareText, new Float64Array([0.25, 0, 0.75, 0]));
    expectDeclared('subsegmentSizes', plane);
    expect([...plane.fs1.radius]).toEqual([0.25]);
    for (const text of ['', 'nonsense', crossing]) {
      const answer = core.subsegmentSizes(text, new Float64Array(6));
      expectDeclared('subsegmentSizes', answer);
      expect([answer.ok, answer.lfs.radius.length]).toEqual([false, 0]);
      expect(answer.error).not.toBe('');
    }
  });
});

describe('faceFrames', () => {
  it('gives an orthonormal frame a face, in which the face is flat', () => {
    const frames = core.faceFrames(plate);
    expectDeclared('faceFrames', frames);
    const [origin, first, second, normal] = [0, 3, 6, 9].map((k) => [...frames.slice(k, k + 3)]);
    expect(origin).toEqual([0, 0, 0]);
    expect([first, second, normal]).toEqual([
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ]);
  });

  it('says that a face has none, and answers what is no complex with nothing', () => {
    const flat = { ...JSON.parse(plate), faces: [{ loops: [[0, 1]] }] };
    expect(core.faceFrames(JSON.stringify(flat))).toHaveLength(12);
    expect(core.faceFrames(JSON.stringify(flat))[0]).toBeNaN();
    expect(core.faceFrames(squareText)).toHaveLength(0);
    expect(core.faceFrames('nonsense')).toHaveLength(0);
    expect(core.faceFrames(plate.replace('[0,1,2,3]', '[0,1,99]'))).toHaveLength(0);
  });
});

describe('runComplex', () => {
  it('has the box with its edges and faces', () => {
    const { run } = core.start(plate, '{"algorithm":"feature-size","domain":"box"}');
    const text = core.runComplex(run);
    expectDeclared('runComplex', text);
    const complex = JSON.parse(text);
    expect(complex.vertices).toHaveLength(5 + 8);
    expect(complex.segments).toHaveLength(4 + 12);
    expect(complex.faces).toHaveLength(1 + 6);
    expect(core.faceFrames(text)).toHaveLength(7 * 12);
    core.release(run);
    expect(core.runComplex(run)).toBe('');
  });
});

describe('a run', () => {
  it('answers a wrong complex with its defects and wrong options with a sentence', () => {
    const invalid = core.start(crossing, '{}');
    expectDeclared('start', invalid);
    expect(invalid.ok).toBe(false);
    expect(invalid.defects.length).toBeGreaterThan(0);
    for (const options of ['{"algorithm": "nobody"}', '{"tau": "two"}', '{"tua": 2}', '[', '3']) {
      const answer = core.start(squareText, options);
      expectDeclared('start', answer);
      expect(answer.ok).toBe(false);
      expect(answer.error).not.toBe('');
    }
  });

  it('advances, and gives mesh, report and files of the declared types', () => {
    const run = finishedRun();
    expectDeclared('advance', core.advance(run, 1, 0));
    const mesh = core.mesh(run)!;
    expectDeclared('mesh', mesh);
    expect(mesh.cells.length % 3).toBe(0);
    expect(Math.max(...mesh.cells)).toBeLessThan(mesh.vertices.length / 2);
    expect(mesh.vertexFeatures.length).toBe(mesh.vertices.length);
    const report = core.report(run, true)!;
    expectDeclared('report', report);
    expect(report.status).toBe('complete');
    expect(report.mesh.cells).toBe(mesh.cells.length / 3);
    expect(report.checks.length).toBeGreaterThan(0);
    for (const check of report.checks) expect(check).toMatchObject({ ok: true });
    for (const extension of core.meshExtensions(2)) {
      const files = core.write(run, extension);
      expectDeclared('write', files);
      expect([extension, files.error]).toEqual([extension, '']);
    }
    core.release(run);
    expect(core.mesh(run)).toBeNull();
    expect(core.report(run, false)).toBeNull();
  });

  it('hands out the trace once, in events of 64 bytes', () => {
    const run = finishedRun();
    const chunk = core.takeTrace(run);
    expectDeclared('takeTrace', chunk);
    expect(chunk.events.length).toBeGreaterThan(0);
    expect(chunk.events.length % 64).toBe(0);
    expect(chunk.simplices.length % 4).toBe(0);
    expect(core.takeTrace(run).events).toHaveLength(0);
    core.release(run);
  });

  it('is the same whether advanced at once or one iteration at a time', () => {
    const once = core.start(squareText, '{"algorithm":"ruppert","size":"0.1"}').run;
    core.advance(once, 0, 0);
    const stepped = core.start(squareText, '{"algorithm":"ruppert","size":"0.1"}').run;
    while (core.advance(stepped, 1, 0).status === 'running');
    expect(core.report(stepped, false)!.fingerprint).toBe(core.report(once, false)!.fingerprint);
    core.release(once);
    core.release(stepped);
  });

  it('can be cancelled, and keeps its mesh', () => {
    const { run } = core.start(squareText, '{"algorithm":"ruppert","size":"0.01"}');
    core.advance(run, 200, 0);
    const progress = core.cancel(run);
    expectDeclared('cancel', progress);
    expect(progress.status).toBe('cancelled');
    expect(core.mesh(run)!.cells.length).toBeGreaterThan(0);
    expect(core.report(run, false)!.status).toBe('cancelled');
    core.release(run);
  });

  it('that does not exist is answered, not thrown at', () => {
    expectDeclared('advance', core.advance(999, 1, 0));
    expectDeclared('cancel', core.cancel(999));
    expectDeclared('takeTrace', core.takeTrace(999));
    expect(core.write(999, '.ele').ok).toBe(false);
    core.release(999);
  });
});

describe('writeComplex', () => {
  it('writes what it read', () => {
    const files = core.writeComplex(squareText, '.poly');
    expectDeclared('writeComplex', files);
    expect(files.error).toBe('');
    const again = core.read(
      files.files.map(({ extension, bytes }) => ({ name: `square${extension}`, bytes })),
    );
    expect(again.complex.vertices).toEqual(square.vertices);
    expect(core.writeComplex(squareText, '.nothing').ok).toBe(false);
    expect(core.writeComplex('nonsense', '.poly').ok).toBe(false);
  });
});

describe('linear elements', () => {
  const smooth = 'sin(pi*x) * sin(pi*y)';

  it('lists functions and families, and makes a mesh of each family', () => {
    expectDeclared('femFunctions', core.femFunctions());
    expectDeclared('femFamilies', core.femFamilies());
    for (const { expression } of core.femFunctions()) {
      expect(
        core.femTriangle(0.1, 0.1, 0.5, 0.2, 0.2, 0.6, expression).interpolation,
      ).not.toBeNull();
    }
    for (const { id } of core.femFamilies()) {
      const answer = core.femFamily(id, 4, 3);
      expectDeclared('femFamily', answer);
      const field = core.femInterpolate(answer.mesh!, 'x^2');
      expectDeclared('femInterpolate', field);
      expect(field.cellH1).toHaveLength(answer.mesh!.cells.length / 3);
      expect(field.size.area).toBeCloseTo(1, 12);
    }
    for (const [id, n, degeneration] of [
      ['nobody', 4, 4],
      ['narrow', 0, 4],
      ['narrow', 1e9, 1e9],
      ['narrow', Number.NaN, 2],
    ] as const) {
      const answer = core.femFamily(id, n, degeneration);
      expectDeclared('femFamily', answer);
      expect(answer.ok).toBe(false);
      expect(answer.error).not.toBe('');
    }
  });

  it('measures interpolation and Poisson on the mesh of a run', () => {
    const run = finishedRun();
    const interpolation = core.femInterpolate(run, smooth);
    const poisson = core.femPoisson(run, smooth);
    const averaged = core.femAveraged(run, smooth, 0);
    expectDeclared('femInterpolate', interpolation);
    expectDeclared('femPoisson', poisson);
    expectDeclared('femAveraged', averaged);
    expect(interpolation.nodal).toHaveLength(core.mesh(run)!.vertices.length / 2);
    expect(poisson.h1).toBeLessThan(interpolation.h1);
    expect(core.femInterpolate(core.mesh(run)!, smooth).h1).toBe(interpolation.h1);
    core.release(run);
  });

  it('makes a study, one size at a time, whose errors fall as they should', () => {
    const [coarse, fine] = [0.1, 0.025].map((size) => {
      const answer = core.femStudy(squareText, '{"algorithm":"ruppert"}', smooth, size);
      expectDeclared('femStudy', answer);
      expect([answer.ok, answer.error, answer.status]).toEqual([true, '', 'complete']);
      return answer;
    });
    expect(Math.log2(coarse!.poisson!.h1 / fine!.poisson!.h1) / 2).toBeCloseTo(1, 1);
    expect(Math.log2(coarse!.poisson!.l2 / fine!.poisson!.l2) / 2).toBeCloseTo(2, 1);
  });

  it('studies a triangle', () => {
    const flat = core.femTriangle(0, 0, 1, 0, 0.5, 0.01, 'x^2');
    expectDeclared('femTriangle', flat);
    expect(flat.circumradius).toBeGreaterThan(flat.circumradiusBound);
    expect(flat.h1Constant).toBeLessThan(flat.kobayashiBound);
    expectDeclared('femTriangle', core.femTriangle(0, 0, 1, 1, 2, 2, ''));
    expect(core.femTriangle(0, 0, 1, 1, 2, 2, '').ok).toBe(false);
    expect(core.femTriangle(0, 0, 1, 0, 0, 1, 'x +').interpolationError).not.toBe('');
  });

  it('answers what cannot be done with a sentence', () => {
    const mesh = core.femFamily('narrow', 2, 2).mesh!;
    const broken = { ...mesh, cells: new Uint32Array([0, 1, 99999]) };
    for (const field of [
      core.femInterpolate(999, 'x'),
      core.femInterpolate(mesh, 'x +'),
      core.femInterpolate(mesh, '1/x'),
      core.femInterpolate(broken, 'x'),
      core.femInterpolate({ ...mesh, dimension: 3 }, 'x'),
      core.femPoisson(broken, 'x'),
      core.femAveraged(mesh, 'x', 1e-3),
    ]) {
      expect(field.ok).toBe(false);
      expect(field.error).not.toBe('');
    }
    for (const answer of [
      core.femStudy('nonsense', '{}', 'x', 1),
      core.femStudy(crossing, '{}', 'x', 1),
      core.femStudy(squareText, '{"tau":"two"}', 'x', 1),
      core.femStudy(squareText, '{}', 'x', -1),
      core.femStudy(squareText, '{}', 'q', 1),
    ]) {
      expectDeclared('femStudy', answer);
      expect(answer.ok).toBe(false);
      expect(answer.error + answer.defects.map(({ message }) => message)).not.toBe('');
    }
  });
});
