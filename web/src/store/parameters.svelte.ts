import type { AlgorithmInfo, ParameterInfo, RunOptions } from 'circumball';

/** What the next run is asked for: the algorithm and what was set by hand. Everything else is the core's default. */
export class ParameterStore {
  /** Id of the registry. */
  algorithm = $state('ruppert');
  /** As typed, by parameter name; only what differs from the default. */
  values = $state.raw<Readonly<Record<string, string>>>({});
  domain = $state<'' | 'hull' | 'box' | 'closed'>('');
  maxVertices = $state(DEFAULT_MAX_VERTICES);
  minEdge = $state('');

  set(name: string, value: string, parameter: ParameterInfo): void {
    const next = { ...this.values };
    if (value.trim() === '' || Number(value) === Number(parameter.default)) delete next[name];
    else next[name] = value.trim();
    // Two names of one threshold: the last one set is meant.
    if (name === 'tau') delete next['min-angle'];
    if (name === 'min-angle') delete next.tau;
    this.values = next;
  }

  reset(): void {
    this.values = {};
    this.domain = '';
    this.maxVertices = DEFAULT_MAX_VERTICES;
    this.minEdge = '';
  }

  options(algorithms: readonly AlgorithmInfo[]): RunOptions {
    const info = algorithms.find((a) => a.id === this.algorithm);
    const options: RunOptions = { algorithm: this.algorithm, maxVertices: this.maxVertices };
    const rest: Record<string, string> = {};
    for (const { name } of info?.parameters ?? []) {
      const value = this.values[name];
      if (value === undefined) continue;
      if (name === 'tau') options.tau = Number(value);
      else if (name === 'min-angle') options.minAngle = Number(value);
      else if (name === 'size') options.size = value;
      else rest[name] = value;
    }
    if (Object.keys(rest).length > 0) options.parameters = rest;
    if (this.domain !== '') options.domain = this.domain;
    if (Number(this.minEdge) > 0) options.minEdge = Number(this.minEdge);
    return options;
  }

  /** Takes over options as a link, an example or the last visit carries them. */
  adopt(options: RunOptions): void {
    this.reset();
    this.algorithm = options.algorithm ?? 'ruppert';
    const values: Record<string, string> = { ...options.parameters };
    if (options.tau !== undefined) values.tau = String(options.tau);
    if (options.minAngle !== undefined) values['min-angle'] = String(options.minAngle);
    if (options.size !== undefined) values.size = String(options.size);
    this.values = values;
    this.domain = options.domain ?? '';
    this.maxVertices = options.maxVertices ?? DEFAULT_MAX_VERTICES;
    this.minEdge = options.minEdge === undefined ? '' : String(options.minEdge);
  }
}

/** A recorded run takes about a kilobyte a vertex in the page; more is asked for by hand. */
const DEFAULT_MAX_VERTICES = 200_000;
