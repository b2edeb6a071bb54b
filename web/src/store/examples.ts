import type { RunOptions } from 'circumball';

/** The example set of the project (examples/index.json): gallery here, smoke tests of the command, cases of the tests. */
export interface Example {
  readonly id: string;
  readonly title: string;
  readonly text: string;
  readonly files: readonly string[]; // the first one is read, the others are its siblings
  readonly options: RunOptions;
}

const urls = import.meta.glob('../../../examples/*.{json,poly,node,ele,svg,obj}', {
  query: '?url',
  import: 'default',
  eager: true,
}) as Record<string, string>;

const lists = import.meta.glob('../../../examples/index.json', {
  import: 'default',
  eager: true,
}) as Record<string, unknown>;

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

interface Entry {
  id?: string;
  file?: string;
  files?: string[];
  title?: string;
  text?: string;
  description?: string;
  dimension?: number;
  algorithm?: string;
  options?: RunOptions;
}

function parse(index: unknown): Example[] {
  const list = (
    Array.isArray(index) ? index : ((index as { examples?: unknown })?.examples ?? [])
  ) as Entry[];
  return list
    .filter((e) => (e.dimension ?? 2) === 2)
    .map((e) => {
      const files = e.files ?? (e.file ? [e.file] : []);
      return {
        id: e.id ?? files[0] ?? '',
        title: e.title ?? e.id ?? '',
        text: e.text ?? e.description ?? '',
        files,
        options: { ...(e.algorithm ? { algorithm: e.algorithm } : {}), ...e.options },
      };
    });
}
