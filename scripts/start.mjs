// npm start: the page, served by Vite, with everything it needs made first. Arguments go to Vite (npm start -- --host).
import { buildModule, checkNode, installModules, node, run, setup, vite } from './lib.mjs';

checkNode();
await setup('build');
await installModules();
await buildModule();
const { code } = await run(node, [
  vite,
  '--config',
  'web/vite.config.ts',
  ...process.argv.slice(2),
]);
process.exit(code);
