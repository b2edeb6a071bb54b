import {
  type ColorMode,
  defaultOverlays,
  type Overlays,
  type TheoryOverlay,
  theoryOverlays,
} from '../shared/types.ts';

/** What the viewer prefers; kept across visits. */

export type ThemeChoice = 'auto' | 'light' | 'dark';

const KEY = 'circumball.settings';

export class Settings {
  theme = $state<ThemeChoice>('auto');
  color = $state<ColorMode>('plain');
  overlays = $state.raw<Overlays>(defaultOverlays);
  /** Moments a second. */
  speed = $state(6);
  panelOpen = $state(true);
  legendOpen = $state(true);
  /** Shortcuts of a single character; speech input can trip over them (WCAG 2.1.4). */
  singleKeys = $state(true);

  private readonly systemDark = window.matchMedia('(prefers-color-scheme: dark)');
  private readonly systemStill = window.matchMedia('(prefers-reduced-motion: reduce)');
  private systemIsDark = $state(this.systemDark.matches);
  reducedMotion = $state(this.systemStill.matches);
  readonly dark = $derived(this.theme === 'auto' ? this.systemIsDark : this.theme === 'dark');

  constructor() {
    this.systemDark.addEventListener('change', (e) => (this.systemIsDark = e.matches));
    this.systemStill.addEventListener('change', (e) => (this.reducedMotion = e.matches));
    this.load();
  }

  private load(): void {
    try {
      const saved = JSON.parse(localStorage.getItem(KEY) ?? '{}');
      if (['auto', 'light', 'dark'].includes(saved.theme)) this.theme = saved.theme;
      if (typeof saved.color === 'string') this.color = saved.color;
      if (saved.speed >= 1 && saved.speed <= 1e5) this.speed = saved.speed;
      if (typeof saved.legendOpen === 'boolean') this.legendOpen = saved.legendOpen;
      if (typeof saved.singleKeys === 'boolean') this.singleKeys = saved.singleKeys;
      if (typeof saved.overlays === 'object')
        this.overlays = { ...defaultOverlays, ...saved.overlays, highlight: null };
    } catch {
      // Storage is closed or holds something else: the defaults do.
    }
  }

  save(): void {
    const { theme, color, speed, legendOpen, singleKeys } = this;
    const overlays = { ...this.overlays, highlight: null };
    try {
      localStorage.setItem(
        KEY,
        JSON.stringify({ theme, color, speed, legendOpen, singleKeys, overlays }),
      );
    } catch {
      // Full or closed: preferences last for this visit.
    }
  }

  setOverlay<K extends keyof Overlays>(name: K, value: Overlays[K]): void {
    this.overlays = { ...this.overlays, [name]: value };
  }

  get shownOverlays(): TheoryOverlay[] {
    return theoryOverlays.filter((name) => this.overlays[name]);
  }

  /** These and no others, as a link asks. */
  showOverlays(names: readonly string[]): void {
    const shown = Object.fromEntries(theoryOverlays.map((name) => [name, names.includes(name)]));
    this.overlays = { ...this.overlays, ...shown };
  }

  cycleTheme(): void {
    this.theme = this.dark ? 'light' : 'dark';
  }
}
