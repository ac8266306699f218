// Pictures for buttons, drawn in lines on a grid of 24 × 24. Not characters of a font: not every
// machine has them.
import { s } from './dom.js';

const square = 'M5 5h14v14H5z', down = 'M12 4v11m-5-4 5 5 5-5', frame = 'M4 5h16v14H4z';

/** Path data by name. An action names its icon; other parts call `icon(name)`. */
export const icons = {
  // Editing
  undo: 'M8 5 4 9l4 4M4 9h10a5 5 0 0 1 0 10h-4',
  redo: 'M16 5l4 4-4 4M20 9H10a5 5 0 0 0 0 10h4',
  edit: 'M6 3.5v15l4-4 2.6 5.5 2.6-1.2-2.6-5.3h5.4z',
  polygon: 'M5 8 13 4l7 6-3 9H7zM13 4v0M5 8v0M20 10v0M17 19v0M7 19v0',
  freehand: 'M4 17c3-9 6-11 8-9s-4 8-1 9 5-7 9-6',
  line: 'M4 18 10 8l5 5 5-8M4 18v0M10 8v0M15 13v0M20 5v0',
  whole: 'M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3',
  angle: 'M20 19H4L16 5M10 19a8 8 0 0 0-2-5',
  circle: 'M12 4a8 8 0 1 0 0 16 8 8 0 0 0 0-16z',
  rectangle: 'M4 6h16v12H4z',
  hole: `${square}M12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6z`,
  point: 'M12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6zM12 3v3M12 18v3M3 12h3M18 12h3',
  brush: 'M20 4 11 13M13.5 15.5 8.5 10.5M9 11.5c-4 0-3 5-6 7 4 2 9 1 9-4z',
  guide: 'M4 18C7 7 12 18 20 6m-5 0h5v5',
  erase: 'M9 19 4 14 14 4l6 6-9 9zM9 9l6 6M9 19h11',
  remove: 'M5 7h14M10 4h4M7 7l1 13h8l1-13M10 11v5M14 11v5',
  plus: 'M12 5v14M5 12h14',
  minus: 'M5 12h14',
  snap: 'M6 4v8a6 6 0 0 0 12 0V4h-4v8a2 2 0 0 1-4 0V4zM6 8h4M14 8h4',
  grid: 'M5 5h14v14H5zM5 9.7h14M5 14.3h14M9.7 5v14M14.3 5v14',
  fix: 'M14 6a4 4 0 0 0-5 5l-5 5 4 4 5-5a4 4 0 0 0 5-5l-3 2-2-2z',
  warning: 'M12 4 3 19h18zM12 10v4M12 17v0',
  // Running
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M8 5v14M16 5v14',
  step: 'M6 5v14l9-7zM18 5v14',
  back: 'M18 5v14l-9-7zM6 5v14',
  end: 'M5 5v14l7-7zM12 5v14l7-7M20 5v14',
  reset: 'M19 5v14l-7-7zM12 5v14l-7-7M4 5v14',
  again: 'M19 12a7 7 0 1 1-2-5l2 2M19 4v5h-5',
  cancel: 'M6 6h12v12H6z',
  speed: 'M4 17a8.5 8.5 0 1 1 16 0M12 15l4-5',
  // Looking
  fit: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  zoomIn: 'M11 4a7 7 0 1 0 0 14 7 7 0 0 0 0-14zM16 16l5 5M8 11h6M11 8v6',
  zoomOut: 'M11 4a7 7 0 1 0 0 14 7 7 0 0 0 0-14zM16 16l5 5M8 11h6',
  layers: 'M12 3 3 8l9 5 9-5zM3 12l9 5 9-5M3 16l9 5 9-5',
  mesh: 'M4 4h16v16H4zM4 12h16M12 4l-1 8 1 8',
  compare: 'M4 5h7v14H4zM13 5h7v14h-7z',
  eye: 'M3 12c5-8 13-8 18 0-5 8-13 8-18 0zM12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6z',
  chart: 'M4 4v16h16M7 8c2 7 6 8 12 8',
  sun: 'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 2v3M12 19v3M2 12h3M19 12h3M5 5l2 2M17 17l2 2M5 19l2-2M17 7l2-2',
  moon: 'M19 14A8 8 0 0 1 10 5a8 8 0 1 0 9 9z',
  auto: 'M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16',
  // Keeping
  open: 'M3 19V5h6l2 3h8v3M3 19l3-8h16l-3 8z',
  download: `${down}M4 17v3h16v-3`,
  share: 'M6 9.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5zM17 3.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5zM17 15.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5zM8.2 10.8l6.5-3.5M8.2 13.2l6.5 3.5',
  copy: 'M9 8h11v12H9zM15 8V4H4v12h5',
  code: 'M8 7l-5 5 5 5M16 7l5 5-5 5M13.5 5l-3 14',
  picture: `${frame}M4 16l5-5 4 4 2-2 5 5M15 8.5v0`,
  file: 'M6 3h8l4 4v14H6zM14 3v4h4',
  // The page
  help: 'M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM9.5 9.5a2.5 2.5 0 1 1 3.5 2.3c-.7.3-1 .8-1 1.7M12 16.5v0',
  info: 'M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 11v6M12 7.5v0',
  learn: 'M12 6C9 4 6 4 3 5v14c3-1 6-1 9 1 3-2 6-2 9-1V5c-3-1-6-1-9 1zM12 6v14',
  close: 'M6 6l12 12M18 6 6 18',
  previous: 'M15 5l-7 7 7 7',
  next: 'M9 5l7 7-7 7',
  check: 'M4 12l6 6L20 6',
};

/** @typedef {keyof typeof icons} IconName */

/** Hidden from screen readers: what is beside it, or the button's name, says it. @param {IconName} name */
export function icon(name) {
  return s('svg', { viewBox: '0 0 24 24', class: 'icon', 'aria-hidden': 'true', 'data-icon': name }, s('path', { d: icons[name] }));
}
