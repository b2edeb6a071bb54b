import type { JumpTarget } from '../replay/timeline.ts';
import type { TheoryOverlay } from '../shared/types.ts';
import type { FaceLook, StandardView } from '../space/types.ts';
import { app } from '../store/app.svelte.ts';
import { texts } from '../texts.ts';
import type { Action } from './types.ts';

/** Every action of the page. Buttons and menus name them by id; shortcuts and the help sheet read the list. */

const { doc, settings } = app;
const inPlane = () => !app.inSpace;
const inSpace = () => app.inSpace;
const busy = () => app.panes.some((pane) => pane.run.busy);
const hasTrace = () => app.clock.length > 0;

function jumps(target: JumpTarget, digit: number): Action[] {
  const name = texts.transport.targets[target];
  const jump = (forward: boolean) => () => {
    if (!app.clock.jump(target, forward)) app.say(`No ${forward ? 'further' : 'earlier'} ${name}.`);
  };
  return [
    {
      id: `next-${target}`,
      title: `${texts.transport.next} ${name}`,
      group: 'Jump',
      keys: [String(digit)],
      enabled: hasTrace,
      perform: jump(true),
    },
    {
      id: `previous-${target}`,
      title: `${texts.transport.previous} ${name}`,
      group: 'Jump',
      keys: [`Shift+${digit}`],
      enabled: hasTrace,
      perform: jump(false),
    },
  ];
}

const speeds = [1, 2, 4, 6, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];

function changeSpeed(by: 1 | -1): void {
  const next =
    by > 0 ? speeds.find((s) => s > settings.speed) : speeds.findLast((s) => s < settings.speed);
  if (next !== undefined) settings.speed = next;
  app.announcement = `${texts.transport.speed} ${settings.speed}`;
}

const play: Action[] = [
  {
    id: 'play',
    title: texts.transport.play,
    now: () => (app.clock.playing ? texts.transport.pause : texts.transport.play),
    group: 'Play',
    keys: ['Space', 'k'],
    enabled: () => !doc.isEmpty,
    pressed: () => app.clock.playing,
    perform: () => (app.fresh ? app.clock.toggle() : void app.refine({ play: true })),
  },
  {
    id: 'step',
    title: texts.transport.step,
    group: 'Play',
    keys: ['ArrowRight'],
    enabled: hasTrace,
    perform: () => app.clock.step(1),
  },
  {
    id: 'step-back',
    title: texts.transport.stepBack,
    group: 'Play',
    keys: ['ArrowLeft'],
    enabled: hasTrace,
    perform: () => app.clock.step(-1),
  },
  {
    id: 'start',
    title: texts.transport.start,
    group: 'Play',
    keys: ['Home'],
    enabled: hasTrace,
    perform: () => app.clock.step(Number.NEGATIVE_INFINITY),
  },
  {
    id: 'end',
    title: texts.transport.end,
    group: 'Play',
    keys: ['End'],
    enabled: hasTrace,
    perform: () => app.clock.step(Number.POSITIVE_INFINITY),
  },
  { id: 'faster', title: 'Faster', group: 'Play', keys: ['>'], perform: () => changeSpeed(1) },
  { id: 'slower', title: 'Slower', group: 'Play', keys: ['<'], perform: () => changeSpeed(-1) },
  {
    id: 'refine',
    title: texts.run.start,
    group: 'Play',
    keys: ['Mod+Enter'],
    enabled: () => !doc.isEmpty && !busy() && app.algorithm !== undefined,
    perform: () => void app.refine({}),
  },
  {
    id: 'stop',
    title: texts.transport.stop,
    group: 'Play',
    keys: ['Mod+.'],
    enabled: busy,
    perform: () => {
      for (const { run } of app.panes) void run.stop();
    },
  },
];

const edit: Action[] = [
  {
    id: 'undo',
    title: texts.undo(''),
    now: () => texts.undo(doc.undoTitle),
    group: 'Edit',
    keys: ['Mod+Z'],
    enabled: () => inPlane() && doc.canUndo,
    perform: () => doc.editor.undo(),
  },
  {
    id: 'redo',
    title: texts.redo(''),
    now: () => texts.redo(doc.redoTitle),
    group: 'Edit',
    keys: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: () => inPlane() && doc.canRedo,
    perform: () => doc.editor.redo(),
  },
  {
    id: 'select-all',
    title: 'Select all',
    group: 'Edit',
    keys: ['Mod+A'],
    enabled: () => inPlane() && app.mode === 'draw',
    perform: () => doc.editor.selectAll(),
  },
  {
    id: 'duplicate',
    title: 'Duplicate',
    group: 'Edit',
    keys: ['Mod+D'],
    enabled: hasSelection,
    perform: () => doc.editor.duplicateSelection(),
  },
  {
    id: 'delete',
    title: 'Delete',
    group: 'Edit',
    keys: ['Delete', 'Backspace'],
    enabled: hasSelection,
    perform: () => doc.editor.deleteSelection(),
  },
  {
    id: 'split',
    title: texts.document.split,
    group: 'Edit',
    keys: [],
    enabled: () => inPlane() && doc.complex.segments.length > 1,
    perform: () => app.say(texts.document.crossingsSplit(doc.editor.splitCrossings())),
  },
  {
    id: 'clear',
    title: texts.document.clear,
    group: 'Edit',
    keys: [],
    enabled: () => inPlane() && !doc.isEmpty,
    perform: () => {
      doc.editor.replace(
        { vertices: [], segments: [], holes: [], regions: [] },
        texts.document.clear,
      );
      doc.title = '';
    },
  },
];

function hasSelection(): boolean {
  const { vertices, segments, holes, regions } = doc.selection;
  return app.mode === 'draw' && vertices.size + segments.size + holes.size + regions.size > 0;
}

function repeats(): boolean {
  return app.mode === 'watch' && app.repeating !== null;
}

const tools: Action[] = [
  {
    id: 'watch',
    title: texts.tools.watch,
    group: 'Tools',
    keys: ['w'],
    enabled: inPlane,
    pressed: () => app.mode === 'watch',
    perform: () => {
      doc.editor.cancel();
      app.mode = 'watch';
      if (app.tab === 'setup') app.tab = 'why';
    },
  },
  ...doc.editor.tools.map(
    (tool): Action => ({
      id: `tool-${tool.id}`,
      title: tool.title,
      group: 'Tools',
      keys: [tool.key],
      enabled: inPlane,
      pressed: () => app.mode === 'draw' && doc.tool === tool.id,
      perform: () => {
        app.clock.pause();
        app.mode = 'draw';
        app.tab = 'setup';
        doc.editor.setTool(tool.id);
        app.announcement = `${tool.title}. ${tool.hint}`;
      },
    }),
  ),
];

const view: Action[] = [
  {
    id: 'zoom-repetition',
    title: texts.repetition.zoom,
    now: () => (app.zoom.running ? texts.repetition.stop : texts.repetition.zoom),
    group: 'View',
    keys: ['z'],
    enabled: repeats,
    perform: () => app.zoom.toggle(),
  },
  {
    id: 'next-cycle',
    title: texts.repetition.next,
    group: 'View',
    keys: ['.'],
    enabled: repeats,
    perform: () => app.zoom.step(1),
  },
  {
    id: 'previous-cycle',
    title: texts.repetition.previous,
    group: 'View',
    keys: [','],
    enabled: repeats,
    perform: () => app.zoom.step(-1),
  },
  {
    id: 'fit',
    title: 'Fit to the picture',
    group: 'View',
    keys: ['0'],
    perform: () => (app.inSpace ? app.pane.spacePicture?.fit(true) : app.picture?.fit()),
  },
  {
    id: 'zoom-in',
    title: 'Zoom in',
    group: 'View',
    keys: ['+', '='],
    perform: () => app.shown?.zoomBy(1.4),
  },
  {
    id: 'zoom-out',
    title: 'Zoom out',
    group: 'View',
    keys: ['-'],
    perform: () => app.shown?.zoomBy(1 / 1.4),
  },
  {
    id: 'compare',
    title: texts.compare.title,
    group: 'View',
    keys: ['c'],
    enabled: () => app.comparing || !doc.isEmpty,
    pressed: () => app.comparing,
    perform: () => (app.comparing ? app.closeComparison() : void app.compare()),
  },
  {
    id: 'numerics',
    title: texts.numerics.title,
    group: 'View',
    keys: ['Shift+N'],
    enabled: inPlane,
    perform: () => {
      settings.panelOpen = true;
      app.sheetOpen = true;
      app.tab = 'numerics';
      requestAnimationFrame(() => document.getElementById('tab-numerics')?.focus());
    },
  },
  {
    id: 'triangle',
    title: texts.triangle.title,
    group: 'View',
    keys: ['Shift+T'],
    perform: () => (app.dialog = 'triangle'),
  },
  {
    id: 'theme',
    title: 'Dark or light',
    group: 'View',
    keys: ['Shift+D'],
    perform: () => settings.cycleTheme(),
  },
  {
    id: 'panel',
    title: 'Fold the panel',
    group: 'View',
    keys: ['Mod+B'],
    pressed: () => settings.panelOpen,
    perform: () => (settings.panelOpen = !settings.panelOpen),
  },
  {
    id: 'legend',
    title: texts.legend.title,
    group: 'View',
    keys: ['Shift+L'],
    pressed: () => settings.legendOpen,
    perform: () => (settings.legendOpen = !settings.legendOpen),
  },
];

const spaceView: StandardView[] = ['corner', 'front', 'right', 'top'];
const turns = { left: [-40, 0], right: [40, 0], up: [0, -40], down: [0, 40] } as const;
const faceLooks: readonly FaceLook[] = ['translucent', 'solid', 'hidden'];

function toggleClip(): void {
  const { look } = app.look;
  app.look.clip(look.clip ? null : 'x');
}

/** Cells apart and back. */
function explode(): void {
  const { shrink } = app.look.look;
  app.look.set({ shrink: shrink > 0 ? 0 : 0.45 });
  if (shrink === 0) app.look.showCells(true);
}

const hasFaces = () => app.inSpace && !app.comparing && app.face.count > 0;

/** The face that is picked or in which something happens, else the one that was shown last. */
function toggleFace(): void {
  const { face, first } = app;
  if (face.open) {
    face.close();
    return;
  }
  const { moment } = first.playback;
  const acting = moment?.dimension === 3 ? moment.face : null;
  const asked = first.spacePicked?.face ?? acting ?? face.index;
  face.show(asked < face.count ? asked : 0);
}

const space: Action[] = [
  ...spaceView.map(
    (name, i): Action => ({
      id: `view-${name}`,
      title: texts.space.views[name],
      group: 'Space',
      keys: [String(5 + i)],
      enabled: inSpace,
      perform: () => app.pane.spacePicture?.look(name),
    }),
  ),
  ...(Object.keys(turns) as (keyof typeof turns)[]).map(
    (name): Action => ({
      id: `turn-${name}`,
      title: texts.space.turn[name],
      group: 'Space',
      keys: [`Shift+Arrow${name.charAt(0).toUpperCase()}${name.slice(1)}`],
      enabled: inSpace,
      perform: () => {
        const [dx, dy] = turns[name];
        app.pane.spacePicture?.orbitBy(dx, dy);
      },
    }),
  ),
  {
    id: 'look-closer',
    title: texts.space.closer,
    group: 'Space',
    keys: ['a'],
    enabled: () => inSpace() && app.playback.moment !== null,
    perform: () => {
      if (!app.pane.spacePicture?.lookAtMoment()) app.say(texts.space.nowhere);
    },
  },
  {
    id: 'faces',
    title: texts.space.faceLook,
    now: () => `${texts.space.faces}: ${texts.space.faceLooks[app.look.look.faces]}`,
    group: 'Space',
    keys: ['f'],
    enabled: inSpace,
    perform: () => {
      const next = faceLooks[(faceLooks.indexOf(app.look.look.faces) + 1) % faceLooks.length]!;
      app.look.set({ faces: next });
      app.announcement = `${texts.space.faces}: ${texts.space.faceLooks[next]}`;
    },
  },
  {
    id: 'cells',
    title: texts.space.switches.cells,
    group: 'Space',
    keys: ['t'],
    enabled: inSpace,
    pressed: () => app.look.look.cells,
    perform: () => app.look.showCells(!app.look.look.cells),
  },
  {
    id: 'explode',
    title: texts.space.explode,
    group: 'Space',
    keys: ['e'],
    enabled: inSpace,
    pressed: () => app.look.look.shrink > 0 && app.look.look.cells,
    perform: explode,
  },
  {
    id: 'clip',
    title: texts.space.clip.title,
    group: 'Space',
    keys: ['p'],
    enabled: inSpace,
    pressed: () => app.look.look.clip !== null,
    perform: toggleClip,
  },
  {
    id: 'face',
    title: texts.face.show,
    group: 'Space',
    keys: ['o'],
    enabled: hasFaces,
    pressed: () => app.face.open,
    perform: toggleFace,
  },
  {
    id: 'face-next',
    title: texts.face.next,
    group: 'Space',
    keys: ['n'],
    enabled: () => hasFaces() && app.face.open,
    perform: () => app.face.go(1),
  },
  {
    id: 'face-previous',
    title: texts.face.previous,
    group: 'Space',
    keys: ['Shift+N'],
    enabled: () => hasFaces() && app.face.open,
    perform: () => app.face.go(-1),
  },
  {
    id: 'clip-forward',
    title: texts.space.clip.forward,
    group: 'Space',
    keys: [']'],
    enabled: () => inSpace() && app.look.look.clip !== null,
    perform: () => app.look.slide(0.02),
  },
  {
    id: 'clip-back',
    title: texts.space.clip.back,
    group: 'Space',
    keys: ['['],
    enabled: () => inSpace() && app.look.look.clip !== null,
    perform: () => app.look.slide(-0.02),
  },
];

/** One letter each; all of them are switched in the panel, too. */
const overlayKeys: readonly (readonly [TheoryOverlay, string])[] = [
  ['featureSize', 'f'],
  ['neighbors', 'n'],
  ['diametral', 'd'],
  ['spindles', 'x'],
  ['collars', 'o'],
  ['intestines', 'i'],
  ['ancestry', 'a'],
];

const overlays: Action[] = [
  {
    id: 'overlays',
    title: texts.theory.open,
    group: 'Overlays',
    keys: ['Shift+O'],
    perform: () => {
      app.settings.panelOpen = true;
      app.sheetOpen = true;
      app.tab = 'mesh';
      requestAnimationFrame(() => {
        const section = document.getElementById('overlays');
        section?.scrollIntoView({ block: 'start' });
        section?.querySelector('input')?.focus({ preventScroll: true });
      });
    },
  },
  ...overlayKeys.map(
    ([name, key]): Action => ({
      id: `overlay-${name}`,
      title: texts.theory[name].name,
      group: 'Overlays',
      keys: [key],
      enabled: inPlane,
      pressed: () => settings.overlays[name],
      perform: () => {
        settings.setOverlay(name, !settings.overlays[name]);
        app.announcement = `${texts.theory[name].name}: ${settings.overlays[name] ? 'on' : 'off'}`;
      },
    }),
  ),
];

const file: Action[] = [
  {
    id: 'gallery',
    title: texts.top.examples,
    group: 'File',
    keys: ['Shift+E'],
    perform: () => (app.dialog = 'gallery'),
  },
  {
    id: 'open',
    title: 'Open a file',
    group: 'File',
    keys: ['Mod+O'],
    perform: () => document.getElementById('open-file')?.click(),
  },
  {
    id: 'export',
    title: texts.top.export,
    group: 'File',
    keys: ['Mod+S'],
    enabled: () => !doc.isEmpty,
    perform: () => (app.dialog = 'export'),
  },
  {
    id: 'share',
    title: texts.top.share,
    group: 'File',
    keys: ['Shift+S'],
    enabled: () => !doc.isEmpty,
    perform: () => (app.dialog = 'share'),
  },
  {
    id: 'help',
    title: texts.top.help,
    group: 'Help',
    keys: ['?', 'F1'],
    perform: () => (app.dialog = 'help'),
  },
  {
    id: 'tour',
    title: texts.help.tour,
    group: 'Help',
    keys: [],
    perform: () => void import('../ui/tour.ts').then((m) => m.startTour()),
  },
];

export const actions: readonly Action[] = [
  ...play,
  ...jumps('insertion', 1),
  ...jumps('refusal', 2),
  ...jumps('yield', 3),
  ...jumps('step', 4),
  ...edit,
  ...tools,
  ...view,
  ...space,
  ...overlays,
  ...file,
];

export function action(id: string): Action {
  const found = actions.find((a) => a.id === id);
  if (!found) throw new Error(`no action ${id}`);
  return found;
}
