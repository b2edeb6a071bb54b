#!/usr/bin/env node
// The command under Node: the same arguments, files and exit codes as the native one.
import { createRequire } from 'node:module';

createRequire(import.meta.url)('./circumball-cli.cjs');
