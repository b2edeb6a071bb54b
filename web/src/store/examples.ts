import type { RunOptions } from 'circumball';
import type { NumericsOptions } from '../link/link.ts';

/** The example set of the project (examples/index.json): gallery here, smoke tests of the command, cases of the tests. */
export interface Example {
  readonly id: string;
  readonly title: string;
  readonly dimension: number;
  readonly text: string;
  readonly files: readonly string[]; // the first one is read, the others are its siblings
  readonly options: RunOptions;
  readonly compare: RunOptions | null; // a second algorithm beside the first one
  readonly numerics: NumericsOptions | null; // what is measured on the mesh
  readonly reference: Reference | null; // what the literature counts
}

/** Counts of vertices after each step, as a source has them for these options. */
export interface Reference {
  readonly source: string;
  readonly vertices: Readonly<Record<string, number>>; // by name of the step
}

const urls = import.meta.glob(
  '../../../examples/*.{json,poly,smesh,node,ele,svg,obj,off,ply,stl}',
  {
    query: '?url',
    import: 'default',
    eager: true,
  },
) as Record<string, string>;

const lists = import.meta.glob('../../../examples/index.json', {
  import: 'default',
  eager: true,
}) as Record<string, unknown>;

/** What an entry that measures leaves out. */
const measured: NumericsOptions = {
  function: 'smooth',
  expression: '',
  method: 'interpolation',
  norm: 'h1',
  family: null,
};

export const examples: readonly Example[] = parse(Object.values(lists)[0]);

/** Downloads the files of an example. */
export async function load(example: Example): Promise<{ name: string; bytes: Uint8Array }[]> {
  return Promise.all(
    example.files.map(async (name) => {
      const url = urls[`../../../examples/${name}`];
      if (!url) throw new Error(`no example file ${name}`);
      const response = await fetch(url);
      return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
    }),
  );
}

/** An entry of examples/index.json. */
interface Entry {
  readonly id: string;
  readonly title: string;
  readonly file: string;
  readonly sentence: string;
  readonly dimension?: number;
  readonly algorithm?: string;
  readonly options?: RunOptions;
  readonly compare?: RunOptions;
  readonly numerics?: Partial<NumericsOptions>;
  readonly reference?: Reference;
}

function parse(index: unknown): Example[] {
  return ((index ?? []) as Entry[]).map((e) => ({
    id: e.id,
    title: e.title,
    dimension: e.dimension ?? 2,
    text: e.sentence,
    files: [e.file],
    options: { ...(e.algorithm ? { algorithm: e.algorithm } : {}), ...e.options },
    compare: e.compare ?? null,
    numerics: e.numerics ? { ...measured, ...e.numerics } : null,
    reference: e.reference ?? null,
  }));
}
