// npm run wasm: builds the WebAssembly module if its sources are newer.
import { buildModule, checkNode, setup } from './lib.mjs';

checkNode();
await setup('build');
await buildModule();
