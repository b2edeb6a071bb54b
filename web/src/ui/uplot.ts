/** uPlot with its style sheet. Loaded when first needed. */
import 'uplot/dist/uPlot.min.css';

export { default as Plot } from 'uplot';
