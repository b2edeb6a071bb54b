import type { PictureTheme } from './types.ts';

/**
 * Colors of the picture: Okabe and Ito's palette (2008), told apart by people of every color vision; each thing also has
 * its own shape or dash. Mesh edges and fills stay quiet so that what happens stands out.
 */
export const okabeIto = {
  orange: '#e69f00',
  sky: '#56b4e9',
  green: '#009e73',
  yellow: '#f0e442',
  blue: '#0072b2',
  vermillion: '#d55e00',
  purple: '#cc79a7',
} as const;

const light: Omit<PictureTheme, 'reducedMotion'> = {
  dark: false,
  background: '#fdfdfb',
  ink: '#1c1f22',
  inkFaint: '#d9dad5',
  edge: '#8fa0ab',
  fill: '#eaf1f5',
  fillOutside: '#f7f7f4',
  steinerSegment: okabeIto.blue,
  steinerFree: okabeIto.green,
  box: '#666c71',
  acting: okabeIto.orange,
  witness: okabeIto.vermillion,
  ball: okabeIto.blue,
  ghost: okabeIto.vermillion,
  born: okabeIto.sky,
  died: okabeIto.purple,
  yielding: '#8f5fae',
  hole: '#666c71',
  selection: okabeIto.blue,
  snap: okabeIto.green,
  defect: okabeIto.vermillion,
  warning: okabeIto.orange,
  featureSize: '#8a7400', // yellow, darkened until it can be read
  neighbor: okabeIto.blue,
  spindle: '#b36b00',
  collar: '#b0477f',
  intestine: '#00808a',
  ancestry: '#6a3d9a',
};

const dark: Omit<PictureTheme, 'reducedMotion'> = {
  dark: true,
  background: '#111316',
  ink: '#f0f0ee',
  inkFaint: '#2b3035',
  edge: '#566670',
  fill: '#1c262d',
  fillOutside: '#15181b',
  steinerSegment: okabeIto.sky,
  steinerFree: '#2ec99b',
  box: '#989ea3',
  acting: okabeIto.orange,
  witness: '#ff8a4c',
  ball: okabeIto.sky,
  ghost: '#ff8a4c',
  born: '#2f7fae',
  died: okabeIto.purple,
  yielding: '#c79be0',
  hole: '#989ea3',
  selection: okabeIto.sky,
  snap: '#2ec99b',
  defect: '#ff8a4c',
  warning: okabeIto.yellow,
  featureSize: okabeIto.yellow,
  neighbor: okabeIto.sky,
  spindle: '#f0b04a',
  collar: '#e88fbe',
  intestine: '#3fc9d3',
  ancestry: '#c9a6f0',
};

export function pictureTheme(isDark: boolean, reducedMotion: boolean): PictureTheme {
  return { ...(isDark ? dark : light), reducedMotion };
}
