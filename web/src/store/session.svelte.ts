import type { RunOptions } from 'circumball';
import { inputFromJson } from '../core/complex-json.ts';
import { fromHash, toHash } from '../link/link.ts';
import { bands } from '../replay/timeline.ts';
import { texts } from '../texts.ts';
import type { App } from './app.svelte.ts';
import { type Example, examples, load } from './examples.ts';

/** How a visit begins, and what of it survives a reload. */

const WORK = 'circumball.work';
/** Browsers give a site about five megabytes; beyond this only the title is lost, not the visit. */
const MOST_SAVED = 3_000_000;

/** A link comes first, then the work of the last visit, then the first example, which plays once, slowly. */
export async function enter(app: App): Promise<void> {
  const starting = app.begin();
  window.addEventListener('hashchange', () => void follow(app));
  if (await follow(app)) return;
  const saved = read();
  if (saved) {
    await starting;
    await app.restore(saved.shared, saved.title);
    return;
  }
  await starting;
  const first = examples[0];
  if (!first || app.coreError) return;
  await openExample(app, first, { first: true });
}

async function follow(app: App): Promise<boolean> {
  try {
    if (location.hash === '#triangle') {
      history.replaceState(null, '', location.pathname + location.search);
      app.dialog = 'triangle';
      return false;
    }
    const short = fromWords(location.hash);
    if (short) {
      history.replaceState(null, '', location.pathname + location.search);
      await app.begin();
      if (short.function !== null) measure(app, short.function);
      await openExample(app, short.example, { compare: short.compare, step: short.step });
      if (short.face !== null) app.face.show(short.face);
      return true;
    }
    const shared = fromHash(location.hash);
    if (!shared) return false;
    history.replaceState(null, '', location.pathname + location.search);
    await app.begin();
    await app.restore(shared, '');
    return true;
  } catch (error) {
    history.replaceState(null, '', location.pathname + location.search);
    app.say((error as Error).message, 'bad');
    return false;
  }
}

interface Words {
  readonly example: Example;
  readonly compare: RunOptions | null;
  readonly function: string | null;
  readonly step: string | null;
  readonly face: number | null;
}

/**
 * A link that can be written by hand: "#example=fan", "#example=fan&compare=collar", "#example=unit-square&function=smooth",
 * "#example=pyramid&algorithm=collar&step=2c&face=0", "…&maxVertices=2000" for a run that would not end. Null: the address is none; throws a sentence if it names what there is not.
 */
function fromWords(hash: string): Words | null {
  const words = new URLSearchParams(hash.slice(1));
  const id = words.get('example');
  if (id === null) return null;
  const known = examples.find((e) => e.id === id);
  if (!known) throw new Error(texts.open.noExample(id));
  const algorithm = words.get('algorithm');
  const most = Number.parseInt(words.get('maxVertices') ?? '', 10);
  const bound = most > 0 ? { maxVertices: most } : {};
  const own = algorithm === null ? known.options : optionsFor(known, algorithm);
  const example = { ...known, options: { ...own, ...bound } };
  const beside = words.get('compare');
  const face = Number.parseInt(words.get('face') ?? '', 10);
  return {
    example,
    compare: beside === null ? null : { ...optionsFor(known, beside), ...bound },
    function: words.get('function'),
    step: words.get('step'),
    face: Number.isNaN(face) ? null : face,
  };
}

/** Where the gallery has the same input under an algorithm, it knows the parameters to use. */
function optionsFor(example: Example, algorithm: string): RunOptions {
  const known = examples.find(
    (e) => e.files[0] === example.files[0] && e.options.algorithm === algorithm,
  );
  return known?.options ?? { ...example.options, algorithm };
}

/** Shows the error of a function of the core's list, by its id. */
function measure(app: App, id: string): void {
  const known = app.hello?.functions.find((f) => f.id === id);
  if (!known) throw new Error(texts.open.noFunction(id));
  app.numerics.choose(known, app.doc.complex);
  app.tab = 'numerics';
}

export async function openExample(
  app: App,
  example: Example,
  {
    first = false,
    compare = null,
    step = null,
  }: { first?: boolean; compare?: RunOptions | null; step?: string | null } = {},
): Promise<void> {
  const answer = await app.core.read(await load(example));
  if (!answer.complex) {
    app.say(answer.defects[0]?.message ?? example.title, 'bad');
    return;
  }
  app.closeComparison();
  app.open(inputFromJson(answer.complex), example.title, example.options);
  const beside = compare ?? example.compare;
  if (beside) await app.compare({ options: beside });
  const { numerics } = example;
  const { reducedMotion } = app.settings;
  const unseen = document.visibilityState === 'hidden' || app.dialog !== null;
  app.numerics.leave();
  const plays = !reducedMotion && !unseen && !numerics && step === null;
  if (app.algorithms.length > 0) await app.refine({ play: plays });
  if (step !== null) toEndOf(app, step);
  if (numerics && app.doc.title === example.title) {
    app.numerics.adopt(numerics); // after the run, as in a link
    measure(app, numerics.function);
  }
  if (first && app.doc.title === example.title)
    app.announcement = `${example.title}. ${example.text}`;
}

/** The moment at which a step has ended; at the end if there is no such step. */
function toEndOf(app: App, step: string): void {
  const { trace } = app.first.run;
  const ended = trace && bands(trace).find((band) => band.name === step);
  if (ended) app.seekMoment(ended.end);
}

function read() {
  try {
    const { hash, title } = JSON.parse(localStorage.getItem(WORK) ?? '{}');
    const shared = typeof hash === 'string' ? fromHash(hash) : null;
    return shared && shared.complex.vertices.length > 0
      ? { shared, title: String(title ?? '') }
      : null;
  } catch {
    return null;
  }
}

function write(app: App): void {
  try {
    const hash = app.doc.isEmpty ? '' : toHash(app.shared());
    if (hash.length > MOST_SAVED) return;
    localStorage.setItem(WORK, JSON.stringify({ hash, title: app.doc.title }));
  } catch {
    // Storage is full or closed: the visit goes on, only a reload would lose it.
  }
}

/** Saves a moment after the last change, and when the page is hidden. To be called while a component initializes. */
export function keepSaved(app: App): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  $effect(() => {
    void [
      app.doc.input,
      app.doc.title,
      app.look.shared(),
      app.face.open && app.face.index,
      app.settings.color,
      app.settings.overlays,
    ];
    void [app.comparison.pace, app.clock.playing, app.tab, app.dialog];
    void [app.numerics.options(), app.triangle.corners, app.triangle.expression];
    for (const { parameters, run } of app.panes) {
      void [parameters.algorithm, parameters.values, parameters.domain];
      void [parameters.maxVertices, parameters.minEdge, run.phase];
    }
    clearTimeout(timer);
    timer = setTimeout(() => write(app), 600);
  });
  $effect(() => {
    void [app.settings.theme, app.settings.color, app.settings.overlays, app.settings.speed];
    void [app.settings.legendOpen, app.settings.singleKeys];
    app.settings.save();
  });
  $effect(() => {
    const hide = () => {
      if (document.visibilityState === 'hidden') write(app);
    };
    document.addEventListener('visibilitychange', hide);
    window.addEventListener('pagehide', hide);
    return () => {
      document.removeEventListener('visibilitychange', hide);
      window.removeEventListener('pagehide', hide);
    };
  });
}
