// The wrapper of the Embind module: JSON text of the core becomes plain objects. Types are in circumball.d.mts.
import createCore from '../build/wasm/web/circumball-core.mjs';

/** In Node there is nothing to fetch from: the bytes are read from beside the glue. */
async function bytesInNode() {
  if (typeof process === 'undefined' || !process.versions?.node) return undefined;
  const fileSystem = 'node:fs/promises'; // not a literal in the import: bundlers must leave it alone
  const { readFile } = await import(/* @vite-ignore */ fileSystem);
  return readFile(new URL('../build/wasm/web/circumball-core.wasm', import.meta.url));
}

/** Embind takes byte arrays of its own realm only; tests and frames may bring others. */
const ownBytes = (bytes) => (bytes instanceof Uint8Array ? bytes : new Uint8Array(bytes));

/** A run's number, or arrays: of this realm, and of the types that the core reads them as. */
function ownMesh(mesh) {
  if (typeof mesh === 'number') return mesh;
  return {
    dimension: mesh.dimension,
    vertices: new Float64Array(mesh.vertices),
    cells: new Uint32Array(mesh.cells),
  };
}

const noFile = {
  ok: false,
  format: '',
  complex: '',
  mesh: null,
  defects:
    '[{"name":"unreadable","features":[],"at":[],"message":"There is not enough memory to read it.","warning":false}]',
};

/** A complex with coordinates that JSON cannot say (NaN) has no text; its defects tell why. */
function parseComplex(text) {
  try {
    return JSON.parse(text);
  } catch {
    return { circumball: 1, dimension: 2, vertices: [] };
  }
}

export default async function createCircumball(options = {}) {
  const wasmBinary = options.wasmBinary ?? (options.locateFile ? undefined : await bytesInNode());
  const settings = {};
  if (wasmBinary) settings.wasmBinary = ownBytes(wasmBinary);
  if (options.locateFile) settings.locateFile = options.locateFile;
  const core = await createCore(settings);
  return {
    version: () => core.version(),
    selfTest: () => core.selfTest(),
    algorithms: () => JSON.parse(core.algorithms()),
    traceNames: () => JSON.parse(core.traceNames()),
    read(files) {
      const own = files.map(({ name, bytes }) => ({ name, bytes: ownBytes(bytes) }));
      const answer = core.read(own) ?? noFile;
      return {
        ...answer,
        complex: parseComplex(answer.complex),
        defects: JSON.parse(answer.defects),
      };
    },
    check: (complex) => JSON.parse(core.check(complex)),
    faceTriangles: (complex) => core.faceTriangles(complex),
    faceFrames: (complex) => core.faceFrames(complex),
    featureSizes: (complex, points) => core.featureSizes(complex, points),
    subsegmentSizes: (complex, ends) => core.subsegmentSizes(complex, ends),
    start(complex, runOptions) {
      const answer = core.start(complex, runOptions);
      return { ...answer, defects: JSON.parse(answer.defects) };
    },
    advance: (run, iterations, seconds) => core.advance(run, iterations, seconds),
    cancel: (run) => core.cancel(run),
    takeTrace: (run) => core.takeTrace(run),
    runComplex: (run) => core.runComplex(run),
    mesh: (run) => core.mesh(run),
    report: (run, verify) => JSON.parse(core.report(run, verify)),
    write: (run, extension) => core.write(run, extension),
    writeComplex: (complex, extension) => core.writeComplex(complex, extension),
    meshExtensions: (dimension) => core.meshExtensions(dimension),
    release: (run) => core.release(run),
    femFunctions: () => core.femFunctions(),
    femFamilies: () => core.femFamilies(),
    femFamily: (id, n, degeneration) => core.femFamily(id, n, degeneration),
    femInterpolate: (mesh, expression) => core.femInterpolate(ownMesh(mesh), expression),
    femPoisson: (mesh, expression) => core.femPoisson(ownMesh(mesh), expression),
    femAveraged: (mesh, expression, h) => core.femAveraged(ownMesh(mesh), expression, h),
    femTriangle: (ax, ay, bx, by, cx, cy, expression) =>
      core.femTriangle(ax, ay, bx, by, cx, cy, expression),
    femStudy(complex, runOptions, expression, size) {
      const answer = core.femStudy(complex, runOptions, expression, size);
      return { ...answer, defects: JSON.parse(answer.defects) };
    },
  };
}
