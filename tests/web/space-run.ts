import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { CircumballModule } from 'circumball';
import { complexToText, inputFromJson } from '../../web/src/core/complex-json.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import type { Complex3 } from '../../web/src/shared/types.ts';

/** A run of the core in space, as the page has it. */
export interface SpaceRun {
  readonly trace: Trace;
  readonly input: Complex3;
  readonly complex: Complex3; // what it refines: with the box, if there is one
  readonly text: string; // the same for the core
  readonly frames: Float64Array; // of its faces
  readonly unresolved: readonly (readonly number[])[];
}

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));

export function spaceRun(core: CircumballModule, file: string, options: object = {}): SpaceRun {
  const bytes = new Uint8Array(readFileSync(folder + file));
  const input = inputFromJson(core.read([{ name: file, bytes }]).complex) as Complex3;
  const asked = JSON.stringify({ algorithm: 'feature-size', ...options });
  const start = core.start(complexToText(input), asked);
  if (!start.ok) throw new Error(start.error);
  const trace = new Trace({
    dimension: 3,
    vertexCount: input.vertices.length,
    segments: input.segments,
  });
  let status = 'running';
  while (status === 'running') {
    status = core.advance(start.run, 0, 0).status;
    const chunk = core.takeTrace(start.run);
    trace.append(chunk.events, chunk.simplices, chunk.steps);
  }
  const text = core.runComplex(start.run);
  const unresolved = core.report(start.run, false)?.unresolved.map((u) => u.simplex) ?? [];
  core.release(start.run);
  const complex = inputFromJson(JSON.parse(text)) as Complex3;
  return { trace, input, complex, text, frames: core.faceFrames(text), unresolved };
}
