import { describe, expect, it } from 'vitest';
import { Kind, Reason } from '../../web/src/replay/event.ts';
import { angleBound } from '../../web/src/replay/measure.ts';
import { momentAt } from '../../web/src/replay/moment.ts';
import { Replay } from '../../web/src/replay/replay.ts';
import { Trace } from '../../web/src/replay/trace.ts';
import { texts } from '../../web/src/texts.ts';
import { asSentence } from '../../web/src/words.ts';
import { type Draft, encode, squareDrafts, unitSquare } from './small-trace.ts';

/** The moment of one more event, after the unit square has been triangulated. */
function momentOf(draft: Draft) {
  const drafts = [...squareDrafts.slice(0, 8), draft];
  const trace = new Trace(unitSquare);
  const { events, simplices } = encode(drafts);
  trace.append(events, simplices, ['0', '1']);
  return momentAt(new Replay(trace), drafts.length)!;
}

const bottom = { step: 1, dimension: 1, simplex: [0, 1], segment: 0 } as const;

describe('sentences and balls of moments', () => {
  it('draws a witness for every reason that names one', () => {
    for (const reason of [Reason.encroached, Reason.witness, Reason.tooLong]) {
      const moment = momentOf({ kind: Kind.queued, ...bottom, reason, subject: 2, value: 1 });
      expect(moment.witness).toBe(2);
      expect(moment.sentence).toContain('vertex 2');
      expect(moment.ball).toEqual({ center: [0.5, 0], radius: 0.5 });
    }
  });

  it('says that a segment is longer than twice the shortest of its spindle', () => {
    const moment = momentOf({
      kind: Kind.queued,
      ...bottom,
      reason: Reason.tooLong,
      subject: 2,
      value: 1,
    });
    expect(moment.sentence).toContain('more than twice the shortest segment of its spindle');
  });

  it('draws the circle around the input vertex on which a collar vertex lies', () => {
    const at = [0.75, 0] as [number, number];
    const moment = momentOf({
      kind: Kind.inserted,
      ...bottom,
      reason: Reason.collar,
      subject: 4,
      at,
      value: 0.25,
      dead: [[0, 1, 2, 1]],
      born: [
        [0, 4, 2, 1],
        [4, 1, 2, 1],
      ],
    });
    expect(moment.ball).toEqual({ center: [1, 0], radius: 0.25 });
    expect(moment.sentence).toContain('protects its acute angle');
  });

  it('says which collar is in the way of a refused simplex', () => {
    const triangle = {
      step: 1,
      dimension: 2,
      simplex: [0, 1, 2],
      at: [0.5, 0.5] as [number, number],
    };
    const refused = momentOf({ kind: Kind.refused, reason: Reason.protected, ...triangle });
    expect(refused.sentence).toContain('in the diametral disk of a collar simplex');
    expect(refused.rule).toBe('safety');
    const segment = momentOf({ kind: Kind.refused, reason: Reason.protected, ...bottom });
    expect(segment.sentence).toContain('it is a collar simplex');
  });

  it('knows the smallest angle that an algorithm promises', () => {
    expect(angleBound(['topology', 'radius-edge'], 1)).toBeCloseTo(30);
    expect(angleBound(['topology', 'radius-edge'], Math.SQRT2)).toBeCloseTo(20.7, 1);
    expect(angleBound(['size', 'min-angle'], 1.4145)).toBe(30);
    expect(angleBound(['topology', 'delaunay'], 1.4145)).toBeNull();
  });

  it('writes messages of the core as sentences, and numbers of things in words', () => {
    expect(asSentence('segments 4 and 11 cross')).toBe('Segments 4 and 11 cross.');
    expect(asSentence('Done.')).toBe('Done.');
    expect(asSentence('broken.poly could not be opened.')).toBe('broken.poly could not be opened.');
    expect(asSentence('')).toBe('');
    expect(texts.document.crossingsSplit(1)).toBe('1 crossing split.');
    expect(texts.document.crossingsSplit(3)).toBe('3 crossings split.');
    expect(texts.queue.length(5, 1)).toBe('5 waiting, one of them a subsegment');
    expect(texts.queue.length(5, 2)).toBe('5 waiting, 2 of them subsegments');
    expect(texts.queue.length(3, 3)).toBe('3 waiting, all subsegments');
    expect(texts.run.done(0)).toContain('nothing unacceptable is left');
    expect(texts.run.done(1)).toContain('1 simplex stays');
  });
});
