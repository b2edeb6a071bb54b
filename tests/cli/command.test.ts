// The contract of the command: verbs, files, report and exit codes.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { Bench, commands, crossing, square } from './command';

describe.each(commands)('%s', (_, command) => {
  let bench: Bench;
  beforeAll(() => {
    bench = new Bench(command);
    bench.write('square.poly', square);
    bench.write('crossing.poly', crossing);
  });
  afterAll(() => bench.remove());

  describe('used wrongly, it exits with 2 and a sentence', () => {
    it.each([
      [[]],
      [['dance']],
      [['mesh']],
      [['mesh', 'square.poly', '--no-such-option']],
      [['mesh', 'square.poly', '--algorithm', 'nobody']],
      [['mesh', 'square.poly', '--tau', '2', '--min-angle', '20']],
      [['mesh', 'square.poly', '--tau', 'nan']],
      [['mesh', 'square.poly', '--tau', '-1']],
      [['mesh', 'square.poly', '--domain', 'everything']],
      [['mesh', 'square.poly', '--size', '1 +']],
      [['mesh', 'square.poly', '--set', 'size=1 +']],
      [['mesh', 'square.poly', '--algorithm', 'chew', '--set', 'size=x + 1']],
      [['mesh', 'square.poly', '--size', '@no-such-file']],
      [['mesh', 'square.poly', '--size', '{"grid": {}}']],
      [['mesh', 'square.poly', '--algorithm', 'ruppert', '--set', 'colour=red']],
      [['mesh', 'square.poly', '--algorithm', 'ruppert', '--set', 'steiner=anywhere']],
      [['mesh', 'square.poly', '-o', 'square.nothing']],
      [['mesh', 'square.poly', '-o', 'square']],
      [['mesh', 'square.poly', '-o', 'no/such/folder/square.ele']],
      [['mesh', 'square.poly', '-o', '-']],
      [['mesh', 'square.poly', '-o', '-', '--format', 'json', '--report', '-']],
      [['verify', 'square.ele']],
      [['convert', 'square.poly', 'square.nothing']],
    ])('%j', (args) => {
      const { code, err } = bench.run(...args);
      expect(err).not.toBe('');
      expect(code).toBe(2);
    });
  });

  it('says its version and its help with exit code 0', () => {
    expect(bench.run('--version')).toMatchObject({ code: 0, err: '' });
    expect(bench.run('--help').out).toContain('mesh');
    expect(bench.run('mesh', '--help').out).toContain('--min-angle');
  });

  describe('input that is no valid complex ends with 3', () => {
    const lines = (err: string) => err.split('\n').filter((line) => line.startsWith('error: '));

    it('crossing segments, with both segments and the place', () => {
      for (const verb of ['check', 'mesh']) {
        const { code, err } = bench.run(verb, 'crossing.poly');
        expect(code).toBe(3);
        expect(lines(err)).toHaveLength(1);
        expect(err).toMatch(/segments-cross.*\[segment 0, segment 1\] at \(/);
      }
    });

    it('check lists every defect, one a line', () => {
      bench.write(
        'bad.json',
        JSON.stringify({
          circumball: 1,
          dimension: 2,
          vertices: [
            [0, 0],
            [2, 0],
            [1, 0],
            [0, 0],
            [1, 1],
            [1, -1],
          ],
          segments: [
            [0, 1],
            [4, 4],
            [4, 5],
          ],
        }),
      );
      const { code, err } = bench.run('check', 'bad.json');
      expect(code).toBe(3);
      for (const name of ['duplicate-vertices', 'vertex-on-segment', 'zero-length-segment']) {
        expect(err).toContain(name);
      }
    });

    it('check lists what refers to nothing together with all else, and convert refuses it', () => {
      bench.write(
        'five.poly',
        '6 2 0 0\n1 0 0\n2 4 4\n3 0 4\n4 4 0\n5 nan 1\n6 0 0\n4 0\n1 1 2\n2 3 4\n3 1 12\n4 0 4\n0\n',
      );
      for (const args of [
        ['check', 'five.poly'],
        ['convert', 'five.poly', 'five.json'],
        ['mesh', 'five.poly', '-o', 'five.ele'],
      ]) {
        const { code, err } = bench.run(...args);
        expect(code).toBe(3);
        expect(lines(err).map((line) => line.split(': ')[1])).toEqual([
          'not-finite',
          'index-out-of-range',
          'index-out-of-range',
          'duplicate-vertices',
          'segments-cross',
        ]);
        expect(err).toMatch(/warning: index-out-of-range: line 11: .*vertex 12/);
      }
      expect(existsSync(join(bench.folder, 'five.json'))).toBe(false);
    });

    it('missing, empty, foreign, truncated and lying files', () => {
      bench.write('empty.poly', '');
      bench.write('binary.poly', '\0\x01\x02\xff'.repeat(100));
      bench.write('truncated.poly', square.slice(0, 40));
      bench.write('lying.poly', '4000000000 2 0 0\n1 0 0\n');
      bench.write('nan.poly', square.replace('1 1 1\n', 'nan 1 1\n'));
      bench.write('range.poly', square.replace('4 4 1 5', '4 4 9 5'));
      const names = ['missing', 'empty', 'binary', 'truncated', 'lying', 'nan', 'range'];
      for (const name of names) {
        const { code, err } = bench.run('check', `${name}.poly`);
        expect([name, code, lines(err).length > 0]).toEqual([name, 3, true]);
      }
      expect(bench.run('check', '.').code).toBe(3);
    });
  });

  it('check says what is in a complex', () => {
    const { code, out } = bench.run('check', 'square.poly');
    expect(code).toBe(0);
    expect(out).toMatch(/4 vertices, 4 segments/);
    expect(out).toMatch(/smallest angle: 90 degrees/);
    expect(out).toMatch(/valid/);
  });

  it('list --json gives the registry with the keys of the manual', () => {
    const { code, out } = bench.run('list', '--json');
    expect(code).toBe(0);
    const algorithms = JSON.parse(out);
    expect(algorithms.map((a: { id: string }) => a.id)).toContain('ruppert');
    for (const algorithm of algorithms) {
      expect(Object.keys(algorithm).sort()).toEqual(
        ['id', 'title', 'dimension', 'thesis', 'rules', 'parameters', 'guarantee', 'checks'].sort(),
      );
      expect(Object.keys(algorithm.rules).sort()).toEqual(
        ['action', 'priority', 'unacceptability', 'safety'].sort(),
      );
      expect(bench.run('list').out).toContain(algorithm.title);
    }
  });

  it('the report has the keys of the manual, in its order', () => {
    const { code } = bench.run('mesh', 'square.poly', '--size', '0.2', '--report', 'report.json');
    expect(code).toBe(0);
    const report = bench.json('report.json');
    expect(Object.keys(report)).toEqual(
      (
        'schema version algorithm dimension parameters input status steps mesh unresolved ' +
        'unresolved_total checks fingerprint seconds peak_bytes'
      ).split(' '),
    );
    expect(Object.keys(report.input)).toEqual([
      'vertices',
      'segments',
      'faces',
      'smallest_angle_degrees',
    ]);
    expect(Object.keys(report.steps[0])).toEqual([
      'name',
      'title',
      'vertices',
      'inserted',
      'refused',
      'seconds',
    ]);
    expect(Object.keys(report.mesh)).toEqual([
      'vertices',
      'cells',
      'min_angle_degrees',
      'max_angle_degrees',
      'max_radius_edge',
      'min_dihedral_degrees',
      'max_dihedral_degrees',
      'shortest_edge',
    ]);
    expect(report).toMatchObject({ schema: 1, algorithm: 'ruppert', status: 'complete' });
    expect(report.mesh.min_angle_degrees).toBeGreaterThan(20.7);
  });

  it('the fingerprint is FNV-1a over coordinates and sorted cells, as the manual says', () => {
    bench.run('mesh', 'square.poly', '--size', '0.2', '--report', 'r.json', '-o', 'mesh.json');
    const { vertices, mesh } = bench.json('mesh.json');
    const cells: number[][] = mesh.cells
      .map((cell: number[]) => [...cell].sort((a, b) => a - b))
      .sort((a: number[], b: number[]) => a[0]! - b[0]! || a[1]! - b[1]! || a[2]! - b[2]!);
    const bytes: number[] = [];
    const integer = (value: number) => bytes.push(...new Uint8Array(Uint32Array.of(value).buffer));
    const double = (value: number) => bytes.push(...new Uint8Array(Float64Array.of(value).buffer));
    integer(vertices.length);
    for (const point of vertices) point.forEach(double);
    integer(cells.length);
    for (const cell of cells) cell.forEach(integer);
    let hash = 0xcbf29ce484222325n;
    for (const byte of bytes) hash = ((hash ^ BigInt(byte)) * 0x100000001b3n) & (2n ** 64n - 1n);
    expect(bench.json('r.json').fingerprint).toBe(hash.toString(16).padStart(16, '0'));
  });

  it('a verified mesh ends with 0 and its table; verify agrees; a moved vertex does not pass', () => {
    const { code, out } = bench.run(
      ...'mesh square.poly --size 0.2 --verify -o good.ele -o good.json'.split(' '),
    );
    expect(out).toMatch(/ok +delaunay/);
    expect(code).toBe(0);
    for (const name of ['good.ele', 'good.json']) {
      const verified = bench.run('verify', name, '--input', 'square.poly', '--tau', '1.415');
      expect([name, verified.code, verified.out]).toEqual([name, 0, verified.out]);
    }
    const moved = bench.json('good.json');
    const last = moved.vertices.length - 1;
    moved.vertices[last] = [moved.vertices[last][0] + 0.3, moved.vertices[last][1] + 0.3];
    bench.write('moved.json', JSON.stringify(moved));
    expect(bench.run('verify', 'moved.json', '--input', 'square.poly').code).toBe(1);
  });

  it('--size reads an expression or a grid from a file, and verify --size holds a mesh to it', () => {
    const grid = { origin: [0, 0], spacing: [1, 1], columns: 2, values: [0.05, 0.3, 0.1, 0.3] };
    bench.write('grid.json', JSON.stringify({ grid }));
    bench.write('size.txt', '0.05 + 0.2*x\n');
    for (const file of ['grid.json', 'size.txt']) {
      for (const algorithm of ['fem-size', 'ruppert']) {
        const args = ['mesh', 'square.poly', '--algorithm', algorithm, '--size', `@${file}`];
        const { code, out } = bench.run(...args, '--verify', '-o', 'sized.json');
        expect(out).toMatch(/ok +sizing/);
        expect(code).toBe(0);
        const verify = ['verify', 'sized.json', '--input', 'square.poly', '--size'];
        expect(bench.run(...verify, `@${file}`).code).toBe(0);
        expect(bench.run(...verify, '0.03').code).toBe(1);
      }
    }
  });

  it('-o writes the family of the extension, and again for more formats', () => {
    const { code } = bench.run('mesh', 'square.poly', '-o', 'family.1.ele', '-o', 'family.1.svg');
    expect(code).toBe(0);
    for (const extension of ['.node', '.ele', '.svg']) {
      expect(existsSync(join(bench.folder, `family.1${extension}`))).toBe(true);
    }
  });

  it('-o - writes to standard output what a file would hold, and nothing else', () => {
    bench.run('mesh', 'square.poly', '-o', 'file.json');
    const { out, err } = bench.run('mesh', 'square.poly', '-o', '-', '--format', 'json');
    expect(out).toBe(bench.text('file.json'));
    expect(err).toContain('fingerprint');
  });

  it('--quiet says nothing', () => {
    expect(bench.run('mesh', 'square.poly', '--quiet')).toEqual({ code: 0, out: '', err: '' });
  });

  it('a limit ends with 4, and the valid mesh so far is written', () => {
    const args = 'mesh square.poly --size 0.01 --max-vertices 100 -o limit.ele --report limit.json';
    expect(bench.run(...args.split(' ')).code).toBe(4);
    const report = bench.json('limit.json');
    expect(report).toMatchObject({ status: 'limit', limit: 'vertices' });
    expect(report.mesh.vertices).toBeLessThanOrEqual(100);
    expect(report.unresolved.length).toBeGreaterThan(0);
    expect(Object.keys(report.unresolved[0])).toEqual(['simplex', 'rule', 'reason', 'near']);
    expect(bench.run('verify', 'limit.ele', '--input', 'square.poly').code).toBe(0);
  });

  it('Ctrl-C ends with 5, and the mesh so far is written', async () => {
    const args =
      'mesh square.poly --size 1e-5 --max-vertices 0 --max-seconds 30 -o late.ele --report late.json';
    const { code } = await bench.interrupt(1500, ...args.split(' '));
    expect(code).toBe(5);
    expect(bench.json('late.json').status).toBe('cancelled');
    expect(existsSync(join(bench.folder, 'late.ele'))).toBe(true);
  }, 60_000);

  it('--trace writes a readable trace as lines of JSON, and a binary one', () => {
    bench.run(...'mesh square.poly --size 0.2 --trace t.jsonl'.split(' '));
    const events = bench
      .text('t.jsonl')
      .trim()
      .split('\n')
      .map((line) => JSON.parse(line));
    expect(events.length).toBeGreaterThan(10);
    bench.run(...'mesh square.poly --size 0.2 --trace t.trace'.split(' '));
    expect(bench.text('t.trace').startsWith('circumball-trace 1')).toBe(true);
  });

  it('convert there and back keeps every bit, markers too', () => {
    bench.write('third.poly', square.replace('3 1 1 1', '3 0.1 0.30000000000000004 1'));
    expect(bench.run('convert', 'third.poly', 'third.json').code).toBe(0);
    expect(bench.json('third.json').vertices[2]).toEqual([0.1, 0.30000000000000004]);
    expect(bench.run('convert', 'third.json', 'again.poly').code).toBe(0);
    expect(bench.run('convert', 'again.poly', 'again.json').code).toBe(0);
    expect(bench.json('again.json')).toEqual(bench.json('third.json'));
  });

  it('a surface of space is welded and merged as asked, and check and convert agree', () => {
    const corners = ['0 0 0', '1 0 0', '1 1 0', '0 1 0', '0 0 1'];
    const facets = [
      [0, 2, 1],
      [0, 3, 2],
      [0, 1, 4],
      [1, 2, 4],
      [2, 3, 4],
      [3, 0, 4],
    ];
    const text = (tip: string) =>
      [
        'solid',
        ...facets.flatMap((f) => [
          'outer loop',
          ...f.map((v) => `vertex ${corners[v]}`),
          'endloop',
        ]),
        'endsolid',
      ]
        .join('\n')
        .replace('0 0 1', tip);
    bench.write('pyramid.stl', text('0 0 1'));
    bench.write('loose.stl', text('0 0 1.0000001'));
    const counts = (...args: string[]) =>
      /: (\d+) vertices, (\d+) segments, (\d+) faces/
        .exec(bench.run('check', ...args).out)
        ?.slice(1);
    expect(counts('pyramid.stl')).toEqual(['5', '8', '5']);
    expect(counts('pyramid.stl', '--no-merge')).toEqual(['5', '9', '6']);
    expect(counts('loose.stl')).toEqual(['6', '10', '5']);
    expect(counts('loose.stl', '--weld', '1e-6')).toEqual(['5', '8', '5']);
    for (const output of ['p.poly', 'p.smesh', 'p.off', 'p.obj', 'p.ply', 'p.json']) {
      expect(bench.run('convert', 'pyramid.stl', output).code).toBe(0);
      expect(counts(output, '--no-merge')).toEqual(['5', '8', '5']);
    }
    expect(bench.run('check', 'p.off', '--weld', '-1').code).toBe(2);
  });

  it('--compact drops the vertices that no cell uses', () => {
    bench.write(
      'dot.poly',
      square.replace('4 2 0 1', '5 2 0 1').replace('4 1\n', '5 9 9 1\n4 1\n'),
    );
    bench.run(...'mesh dot.poly --domain closed -o all.json'.split(' '));
    bench.run(...'mesh dot.poly --domain closed --compact -o some.json'.split(' '));
    expect(bench.json('some.json').vertices.length).toBe(
      bench.json('all.json').vertices.length - 1,
    );
  });

  it('sizes in space writes the estimate at every segment, and they verify', () => {
    const example = join(import.meta.dirname, '../../examples/three-squares.json');
    const { code, out } = bench.run(
      ...['sizes', example, '--verify', '-o', 'sizes.csv', '-o', 'sizes.json'],
      ...['--report', 'sizes-report.json'],
    );
    expect(code).toBe(0);
    expect(out).toContain('segment-upper');
    const [head, ...rows] = bench.text('sizes.csv').trim().split('\n');
    expect(head).toBe('segment,a,b,length,fs1_at_least,lfs_at_least');
    const { mesh, vertices } = bench.json('sizes.json');
    expect(rows.length).toBe(mesh.edges.length);
    rows.forEach((row, i) => {
      const [segment, a, b, length] = row.split(',').map(Number) as [
        number,
        number,
        number,
        number,
      ];
      expect([a, b, segment]).toEqual(mesh.edges[i]);
      expect(Math.hypot(...[0, 1, 2].map((k) => vertices[a][k] - vertices[b][k]))).toBeCloseTo(
        length,
        12,
      );
    });
    const report = bench.json('sizes-report.json');
    expect(report.dimension).toBe(3);
    expect(report.steps.map((step: { name: string }) => step.name)).toEqual([
      '0',
      '1a',
      '1b',
      '2a',
      '2b',
    ]);
    expect(report.mesh.min_dihedral_degrees).toBeGreaterThan(0);
  });

  it('only feature sizes are written as a table', () => {
    expect(bench.run('sizes', 'square.poly', '-o', 'square.csv').code).toBe(0);
    expect(bench.text('square.csv').split('\n').length).toBe(6);
    expect(bench.run('mesh', 'square.poly', '-o', 'square.csv').code).toBe(2);
  });

  it('sizes is mesh --algorithm feature-size', () => {
    const sizes = bench.run('sizes', 'square.poly');
    const mesh = bench.run('mesh', 'square.poly', '--algorithm', 'feature-size');
    expect([sizes.code, sizes.err]).toEqual([mesh.code, mesh.err]);
  });
});
