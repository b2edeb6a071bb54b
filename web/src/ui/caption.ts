import { histogram } from '../replay/measure.ts';
import { app } from '../store/app.svelte.ts';
import type { Pane } from '../store/pane.svelte.ts';
import { formatCount, formatDegrees, formatNumber } from '../words.ts';

/** A figure caption with everything that is needed to make the figure again: of both meshes while comparing. */
export function caption(): string {
  return app.panes.map(captionOf).join(' ');
}

function captionOf({ run, playback }: Pane): string {
  const { doc } = app;
  const { solid, input: complex } = doc;
  const title = doc.title || (solid ? 'A complex in space' : 'A planar straight-line complex');
  const faces = solid ? `, ${formatCount(solid.faces.length)} faces` : '';
  const input = `${formatCount(complex.vertices.length)} vertices, ${formatCount(complex.segments.length)} segments${faces}`;
  const [cellsName, anglesName] = solid
    ? ['tetrahedra', 'dihedral angles']
    : ['triangles', 'angles'];
  if (!run.trace || !playback.replay || !playback.angles)
    return `${title} (${input}). Circumball ${app.hello?.version ?? ''}.`;
  const info = app.algorithms.find((a) => a.id === run.algorithm);
  const algorithm = info?.title ?? run.algorithm;
  const {
    algorithm: _,
    maxVertices: __,
    minAngle: asked,
    minEdge,
    parameters,
    ...rest
  } = run.options;
  const set = Object.entries({ ...rest, ...parameters }).map(([k, v]) => `${k} = ${v}`);
  if (minEdge !== undefined) set.push(`no edge below ${minEdge}`);
  if (asked !== undefined) set.unshift(`smallest angle asked for ${asked}°`);
  // Not every algorithm has that threshold.
  if (run.tau > 0 && info?.parameters.some((p) => p.name === 'tau'))
    set.unshift(`τ = ${formatNumber(run.tau)}`);
  const { cells, minAngle, maxAngle } = histogram(playback.replay.state(), playback.angles);
  const at =
    playback.position === playback.length
      ? ''
      : ` Event ${formatCount(playback.position)} of ${formatCount(playback.length)}: ${playback.moment?.sentence ?? ''}`;
  return (
    `${title} (${input}), ${algorithm}${set.length > 0 ? `, ${set.join(', ')}` : ''}: ` +
    `${formatCount(cells)} ${cellsName}, ${anglesName} ${formatDegrees(minAngle)} to ${formatDegrees(maxAngle)}.${at}` +
    ` Circumball ${app.hello?.version ?? ''}${run.report ? `, fingerprint ${run.report.fingerprint}` : ''}.`
  );
}
