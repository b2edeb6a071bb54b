import { driver } from 'driver.js';
import 'driver.js/dist/driver.css';
import { app } from '../store/app.svelte.ts';

/** A walk along the page in seven stops, each about something to do. */
export function startTour(): void {
  app.clock.pause();
  app.settings.panelOpen = true;
  app.tab = 'why';
  const stop = (element: string, title: string, description: string) => ({
    element,
    popover: { title, description },
  });
  const tour = driver({
    showProgress: true,
    animate: !app.settings.reducedMotion,
    steps: [
      stop(
        'canvas[role=application]',
        'The picture',
        'The input in ink, the mesh as it grows. Wheel or pinch to zoom, drag to move, pick a vertex or a triangle to see its numbers.',
      ),
      stop(
        '[data-action=play]',
        'At your pace',
        'Play, or better: step with the arrow keys, and guess what comes next before you do.',
      ),
      stop(
        '.strip',
        'The whole run',
        'Insertions rise from the line; refusals and yields hang from it. Drag to any moment.',
      ),
      stop(
        '.now',
        'What happened, and why',
        'Every moment in one sentence, in the words of the four rules, with its witness drawn.',
      ),
      stop(
        '[role=tabpanel]',
        'The four rules',
        'The algorithm is these four statements. The one that is acting is lit. Below, who waits in the queue.',
      ),
      stop(
        '#tab-numerics',
        'What the mesh is good for',
        'Choose a function, interpolate it or solve Poisson’s equation, and see the error on every triangle; then refine, and read the order off the plot.',
      ),
      stop(
        '.tools',
        'Draw',
        'Draw your own input here; then press Refine. Nothing that you draw is lost.',
      ),
    ],
  });
  tour.drive();
}
