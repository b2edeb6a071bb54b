// npm run build: the static site in dist/site and the package in dist/package.
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildModule, checkNode, installModules, must, node, root, setup, vite } from './lib.mjs';

const glue = '../build/wasm/web/circumball-core';

/** The wrapper, with module and types beside it: what `import createCircumball from 'circumball'` needs, and no more. */
function makePackage() {
  const folder = join(root, 'dist/package');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  const wrapper = readFileSync(join(root, 'wasm/circumball.mjs'), 'utf8');
  if (!wrapper.includes(glue)) throw new Error('the wrapper imports its glue from elsewhere');
  writeFileSync(join(folder, 'circumball.mjs'), wrapper.replaceAll(glue, './circumball-core'));
  for (const name of ['circumball-core.mjs', 'circumball-core.wasm']) {
    copyFileSync(join(root, 'build/wasm/web', name), join(folder, name));
  }
  copyFileSync(join(root, 'wasm/circumball.d.mts'), join(folder, 'circumball.d.mts'));
  copyFileSync(join(root, 'LICENSE'), join(folder, 'LICENSE'));
  const { version, description, license, author } = JSON.parse(
    readFileSync(join(root, 'package.json'), 'utf8'),
  );
  const manifest = {
    name: 'circumball',
    version,
    description,
    license,
    author,
    type: 'module',
    exports: { '.': { types: './circumball.d.mts', default: './circumball.mjs' } },
    types: './circumball.d.mts',
    files: ['*.mjs', '*.mts', '*.wasm', 'LICENSE'],
    sideEffects: false,
  };
  writeFileSync(join(folder, 'package.json'), `${JSON.stringify(manifest, null, 2)}\n`);
}

checkNode();
await setup('build');
await installModules();
await buildModule();
makePackage();
await must(node, [vite, 'build', '--config', 'web/vite.config.ts']);
console.log('dist/site: the page, for any file server; dist/package: the package');
