// |x|^p + |y|^p = 1: what the L_p norm takes for round. The larger p, the squarer, and so are the
// cells that it makes (the paper's Fig. 1).
import { s } from '../panels/dom.js';

const turn = Math.PI / 9;  // of the cross that the ball follows

/** The ball as points, turned. @param {number} p  @param {number} [angle] @returns {[number, number][]} */
export function unitBall(p, angle = 0, count = 96) {
  const [c, d] = [Math.cos(angle), Math.sin(angle)];
  return Array.from({ length: count }, (_, i) => {
    const t = 2 * Math.PI * i / count;
    const [x, y] = [Math.cos(t), Math.sin(t)];
    const r = (Math.abs(x) ** p + Math.abs(y) ** p) ** (-1 / p);
    return [r * (c * x - d * y), r * (d * x + c * y)];
  });
}

const path = (/** @type {[number, number][]} */ points, /** @type {number} */ scale) =>
  `M${points.map(([x, y]) => `${(scale * x).toFixed(2)} ${(-scale * y).toFixed(2)}`).join('L')}Z`;

/** A small one. @param {number} p */
export function ballIcon(p) {
  return s('svg', { viewBox: '-14 -14 28 28', class: 'ball', 'aria-hidden': 'true' },
    s('path', { d: path(unitBall(p, turn), 10) }));
}

/** The ball with the cross that turns it, beside the circle of p = 2. */
export function createBall() {
  const ball = s('path', { class: 'ball-shape' });
  const arms = [0, 1].map((k) => {
    const [x, y] = [30 * Math.cos(turn + k * Math.PI / 2), 30 * Math.sin(turn + k * Math.PI / 2)];
    return s('line', { x1: -x, y1: y, x2: x, y2: -y, class: 'ball-arm' });
  });
  const element = s('svg', { viewBox: '-36 -36 72 72', class: 'ball-figure', role: 'img' },
    s('circle', { r: 24, class: 'ball-circle' }), ball, ...arms);
  const show = (/** @type {number} */ p) => {
    ball.setAttribute('d', path(unitBall(p, turn), 24));
    const shape = p === 2 ? 'a circle' : 'a rounded square';
    element.setAttribute('aria-label', `Unit ball of the Lp norm for p = ${p}, turned to a cross: ${shape}`);
  };
  return { element, show };
}
