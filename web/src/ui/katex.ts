import katex from 'katex';
import 'katex/dist/katex.min.css';

/** Mathematics as HTML with MathML beside it for screen readers. Loaded when first needed. */
export function render(source: string): string {
  return katex.renderToString(source, { throwOnError: false });
}
