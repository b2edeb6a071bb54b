// npm run format: formats C++ and TypeScript in place. With --check it only says what is not formatted.
import { checkNode, installModules, must, root, run, setup } from './lib.mjs';

/** The C++ files that git knows, or would (not those of the build folders). */
async function cppFiles() {
  const listed = await must(
    'git',
    ['ls-files', '--cached', '--others', '--exclude-standard', '*.h', '*.cpp'],
    { capture: true, cwd: root },
  );
  return listed.split('\n').filter(Boolean);
}

export async function clangFormat(check) {
  return run(
    'clang-format',
    [...(check ? ['--dry-run', '-Werror'] : ['-i']), ...(await cppFiles())],
    {
      capture: true,
    },
  );
}

export async function biome(check) {
  return run('node_modules/.bin/biome', ['check', ...(check ? [] : ['--write'])], {
    capture: true,
  });
}

if (import.meta.filename === process.argv[1]) {
  checkNode();
  await setup('test');
  await installModules();
  const check = process.argv.includes('--check');
  for (const { code, output } of [await clangFormat(check), await biome(check)]) {
    process.stdout.write(output);
    if (code !== 0) process.exitCode = 1;
  }
}
