/** The unit square as the project's own JSON. */
export const square = {
  circumball: 1,
  dimension: 2,
  vertices: [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  segments: [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
  ],
};
