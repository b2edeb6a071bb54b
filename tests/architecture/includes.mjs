// The arrows of the architecture: reads every #include of the sources and says which go against them.
//   node includes.mjs ROOT
// Prints each include that is not allowed, as file:line, and fails if there is one.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

/**
 * Which layers of lib/src, or which single headers of one, a layer may include, besides itself and the public headers
 * in `headers`.
 */
export const layers = {
  predicates: [],
  delaunay: ['predicates'],
  complex: ['predicates', 'delaunay'],
  expression: ['predicates'],
  sizing: ['predicates', 'expression'],
  feature_size: ['predicates', 'delaunay', 'complex'],
  refinement: ['predicates', 'delaunay', 'complex', 'sizing'],
  protection: ['predicates', 'delaunay', 'complex', 'refinement'],
  algorithms: ['predicates', 'delaunay', 'complex', 'sizing', 'refinement', 'protection'], // not the oracle that they are checked with
  // Verification may reason about complexes as `check` does; what it shares with the mesher is looked at below.
  quality: ['predicates', 'complex', 'sizing', 'feature_size'],
  fem: ['predicates', 'expression', 'complex/box_tree'],
  io: ['predicates/elementary'], // rotations of drawings are the same everywhere
  report: [],
};

/** Which public headers a layer may include; the others it has no business with. */
export const headers = {
  predicates: ['types', 'predicates'],
  delaunay: ['types', 'predicates'],
  complex: ['types', 'predicates', 'complex', 'mesh'],
  expression: [],
  sizing: ['types'],
  feature_size: ['types', 'predicates', 'complex', 'mesh', 'feature_size'],
  refinement: ['types', 'predicates', 'complex', 'mesh', 'trace', 'refine'],
  protection: ['types', 'predicates', 'complex', 'mesh', 'trace', 'refine'],
  algorithms: ['types', 'predicates', 'complex', 'mesh', 'trace', 'refine', 'registry'],
  quality: ['types', 'predicates', 'complex', 'mesh', 'verify', 'feature_size'],
  fem: ['types', 'mesh', 'fem', 'fem_laboratory'],
  io: ['types', 'predicates', 'complex', 'mesh', 'io'], // whether triangles are coplanar is exact
  report: null, // every one
};

/** Libraries outside the standard one, and where they are allowed. */
const libraries = [
  { pattern: /^nlohmann\//, allowed: ['io', 'report', 'algorithms', 'refinement', 'sizing'] },
  { pattern: /^Eigen\//, allowed: ['fem'] },
  { pattern: /^fmt\//, allowed: ['io'] }, // for what Emscripten's standard library lacks
  { pattern: /^(CLI|boost|CGAL|gtest|benchmark|emscripten)\//, allowed: [] },
];

function includesOf(path) {
  const found = [];
  readFileSync(path, 'utf8')
    .split('\n')
    .forEach((line, index) => {
      const match = /^\s*#\s*include\s*([<"])([^>"]+)[>"]/.exec(line);
      if (match) found.push({ line: index + 1, quoted: match[1] === '"', name: match[2] });
    });
  return found;
}

function sourcesUnder(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true })
    .filter((name) => /\.(h|cpp)$/.test(name))
    .sort()
    .map((name) => join(folder, name));
}

/** Why a file of a layer may not include this; empty if it may. */
export function objection(layer, { quoted, name }) {
  const publicHeader = /^circumball\/(\w+)\.h$/.exec(name);
  if (publicHeader) {
    const known = headers[layer];
    if (known && !known.includes(publicHeader[1])) {
      return `${layer} has no business with the public header ${name}`;
    }
    return '';
  }
  if (!quoted) {
    const library = libraries.find(({ pattern }) => pattern.test(name));
    if (library && !library.allowed.includes(layer)) return `${layer} may not use <${name}>`;
    return '';
  }
  if (!name.includes('/')) return ''; // a neighbour in the same folder
  const target = name.split('/')[0];
  const allowed = layers[layer];
  if (target === layer || allowed.includes(target) || allowed.includes(name.replace(/\.h$/, '')))
    return '';
  return layers[target]
    ? `${layer} may not know ${target}`
    : `"${name}" is neither a public header nor of a layer`;
}

/** The headers of lib/src that the sources of some files lead to, directly or not. */
function reachable(root, files) {
  const found = new Set();
  const visit = (path) => {
    for (const { quoted, name } of includesOf(path)) {
      const next = join(root, 'lib/src', name);
      if (!quoted || found.has(name) || !existsSync(next)) continue;
      found.add(name);
      visit(next);
      const source = next.replace(/\.h$/, '.cpp'); // what a header declares, its source does
      if (existsSync(source)) visit(source);
    }
  };
  for (const file of files) visit(file);
  return found;
}

/**
 * Verification shares no code with what made the mesh, the predicates and the evaluation of sizing functions aside; and
 * the tree of boxes, a container that decides nothing.
 */
function sharedWithMesher(root) {
  const under = (layer) => sourcesUnder(join(root, 'lib/src', layer));
  const mesher = reachable(root, [...under('refinement'), ...under('algorithms')]);
  const verifier = reachable(root, under('quality'));
  return [...verifier].filter(
    (name) =>
      mesher.has(name) && !/^((predicates|expression|sizing)\/|complex\/box_tree\.h$)/.test(name),
  );
}

/** Command and WebAssembly see the public headers, and the files beside them. */
function outsideObjection({ quoted, name }) {
  if (!quoted || /^circumball\/\w+\.h$/.test(name) || !name.includes('/')) return '';
  return `only public headers may be included here, not "${name}"`;
}

export function check(root) {
  const defects = [];
  const note = (path, include, why) => {
    if (why) defects.push(`${relative(root, path)}:${include.line}: ${why}`);
  };
  for (const path of sourcesUnder(join(root, 'lib/src'))) {
    const layer = relative(join(root, 'lib/src'), path).split('/')[0];
    if (!layers[layer]) {
      defects.push(`${relative(root, path)}: '${layer}' is not a layer of the architecture`);
      continue;
    }
    for (const include of includesOf(path)) note(path, include, objection(layer, include));
  }
  for (const path of sourcesUnder(join(root, 'lib/include'))) {
    for (const include of includesOf(path)) {
      const own = /^circumball\/\w+\.h$/.test(include.name);
      if (include.quoted ? !own : include.name.includes('/')) {
        note(
          path,
          include,
          `a public header includes public headers and the standard library only`,
        );
      }
    }
  }
  for (const name of sharedWithMesher(root)) {
    defects.push(`lib/src/${name}: verification shares it with the mesher that it checks`);
  }
  for (const folder of ['lib/cli', 'wasm']) {
    for (const path of sourcesUnder(join(root, folder))) {
      for (const include of includesOf(path)) note(path, include, outsideObjection(include));
    }
  }
  return defects;
}

/** The script must be able to fail: each of these goes against an arrow. */
function selfTest() {
  const wrong = [
    ['predicates', { quoted: true, name: 'delaunay/delaunay2.h' }],
    ['delaunay', { quoted: true, name: 'refinement/loop.h' }],
    ['quality', { quoted: true, name: 'delaunay/delaunay2.h' }],
    ['complex', { quoted: true, name: 'feature_size/feature_table.h' }],
    ['quality', { quoted: true, name: 'circumball/refine.h' }],
    ['io', { quoted: true, name: 'complex/live2.h' }],
    ['io', { quoted: true, name: 'predicates/expansion.h' }],
    ['refinement', { quoted: true, name: 'algorithms/ruppert.h' }],
    ['delaunay', { quoted: false, name: 'fmt/format.h' }],
  ];
  return wrong.filter(([layer, include]) => !objection(layer, include)).map(([layer]) => layer);
}

const missed = selfTest();
if (missed.length > 0) {
  console.error(`the script misses violations of: ${missed.join(', ')}`);
  process.exit(1);
}
const root = process.argv[2];
const defects = check(root);
for (const defect of defects) console.error(defect);
const files = sourcesUnder(join(root, 'lib')).length;
console.log(`${files} files, ${defects.length} includes against the architecture`);
process.exit(defects.length === 0 && files > 0 ? 0 : 1);
