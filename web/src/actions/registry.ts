import type { JumpTarget } from '../replay/timeline.ts';
import type { TheoryOverlay } from '../shared/types.ts';
import { app } from '../store/app.svelte.ts';
import { texts } from '../texts.ts';
import type { Action } from './types.ts';

/** Every action of the page. Buttons and menus name them by id; shortcuts and the help sheet read the list. */

const { doc, settings } = app;
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
    enabled: () => !doc.isEmpty && !busy(),
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
    enabled: () => doc.canUndo,
    perform: () => doc.editor.undo(),
  },
  {
    id: 'redo',
    title: texts.redo(''),
    now: () => texts.redo(doc.redoTitle),
    group: 'Edit',
    keys: ['Mod+Shift+Z', 'Mod+Y'],
    enabled: () => doc.canRedo,
    perform: () => doc.editor.redo(),
  },
  {
    id: 'select-all',
    title: 'Select all',
    group: 'Edit',
    keys: ['Mod+A'],
    enabled: () => app.mode === 'draw',
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
    enabled: () => doc.complex.segments.length > 1,
    perform: () => app.say(texts.document.crossingsSplit(doc.editor.splitCrossings())),
  },
  {
    id: 'clear',
    title: texts.document.clear,
    group: 'Edit',
    keys: [],
    enabled: () => !doc.isEmpty,
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
    perform: () => app.picture?.fit(),
  },
  {
    id: 'zoom-in',
    title: 'Zoom in',
    group: 'View',
    keys: ['+', '='],
    perform: () => app.picture?.zoomBy(1.4),
  },
  {
    id: 'zoom-out',
    title: 'Zoom out',
    group: 'View',
    keys: ['-'],
    perform: () => app.picture?.zoomBy(1 / 1.4),
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
  ...overlays,
  ...file,
];

export function action(id: string): Action {
  const found = actions.find((a) => a.id === id);
  if (!found) throw new Error(`no action ${id}`);
  return found;
}
