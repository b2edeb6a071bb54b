import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import createCircumball from 'circumball';
import { expect, it } from 'vitest';
import { complexToText, inputFromJson } from '../../web/src/core/complex-json.ts';
import { examples } from '../../web/src/store/examples.ts';

const folder = fileURLToPath(new URL('../../examples/', import.meta.url));

it('every example starts with its options, and so does what it is compared with', async () => {
  const core = await createCircumball();
  for (const { id, files, options, compare } of examples) {
    const bytes = new Uint8Array(readFileSync(folder + files[0]));
    const complex = inputFromJson(core.read([{ name: files[0]!, bytes }]).complex);
    for (const asked of [options, ...(compare ? [compare] : [])]) {
      const answer = core.start(complexToText(complex), JSON.stringify(asked));
      expect(answer.error, id).toBe('');
      expect(answer.algorithm, id).toBe(asked.algorithm);
      core.release(answer.run);
    }
  }
  expect(examples.some((e) => e.compare !== null)).toBe(true);
});
