// A pen that writes SVG: the same drawing as on a canvas, as paths that any editor opens.
/** @import { Pen } from '../types' */

/** Two digits of a pixel are enough. @param {number} x */
const digits = (x) => String(Math.round(100 * x) / 100);
/** @type {Record<string, string>} */
const entities = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' };
const escaped = (/** @type {string} */ text) => text.replace(/[&<>"]/g, (c) => entities[c]);

const plain = {
  fillStyle: '#000000', strokeStyle: '#000000', lineWidth: 1, globalAlpha: 1, lineJoin: 'miter', lineCap: 'butt',
  font: '10px sans-serif', textAlign: 'start', textBaseline: 'alphabetic', dash: '',
};

export class SvgPen {
  /** @type {string[]} */
  #parts = [];
  /** @type {string[]} */
  #path = [];
  /** @type {(typeof plain)[]} */
  #saved = [];
  #state = { ...plain };
  /** Of the last path, which the next one joins if it looks the same. */
  #last = { look: '', kind: '' };

  beginPath() { this.#path = []; }
  moveTo(/** @type {number} */ x, /** @type {number} */ y) { this.#path.push(`M${digits(x)} ${digits(y)}`); }
  lineTo(/** @type {number} */ x, /** @type {number} */ y) { this.#path.push(`L${digits(x)} ${digits(y)}`); }
  closePath() { this.#path.push('Z'); }

  /** @param {number} x  @param {number} y  @param {number} radius  @param {number} from  @param {number} to */
  arc(x, y, radius, from, to) {
    const at = (/** @type {number} */ angle) =>
      `${digits(x + radius * Math.cos(angle))} ${digits(y + radius * Math.sin(angle))}`;
    const r = digits(radius), middle = (from + to) / 2;  // in two: a whole turn has no direction
    const half = `A${r} ${r} 0 0 1 `;
    this.#path.push(`${this.#path.length > 0 ? 'L' : 'M'}${at(from)}${half}${at(middle)}${half}${at(to)}`);
  }

  fill(/** @type {CanvasFillRule | Path2D} */ rule = 'nonzero') {
    const { fillStyle, globalAlpha } = this.#state;
    // A hair of the same colour closes the seams between neighbours.
    this.#add('fill', `fill="${fillStyle}" stroke="${fillStyle}" stroke-width=".4"`
      + (rule === 'evenodd' ? ' fill-rule="evenodd"' : '') + opacity(globalAlpha));
  }

  stroke() {
    const { strokeStyle, lineWidth, lineJoin, lineCap, dash, globalAlpha } = this.#state;
    this.#add('stroke', `fill="none" stroke="${strokeStyle}" stroke-width="${digits(lineWidth)}"`
      + (lineJoin === 'miter' ? '' : ` stroke-linejoin="${lineJoin}"`)
      + (lineCap === 'butt' ? '' : ` stroke-linecap="${lineCap}"`)
      + (dash === '' ? '' : ` stroke-dasharray="${dash}"`) + opacity(globalAlpha));
  }

  fillText(/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y) {
    const { fillStyle, font, textAlign, textBaseline } = this.#state;
    const [, weight = '400', size = '10', family = 'sans-serif'] = /^(\d+)? ?([\d.]+)px (.*)$/.exec(font) ?? [];
    const anchor = textAlign === 'center' ? 'middle' : textAlign === 'right' || textAlign === 'end' ? 'end' : 'start';
    const down = textBaseline === 'middle' ? 0.35 * Number(size) : 0;  // editors do not know dominant-baseline
    this.#parts.push(`<text x="${digits(x)}" y="${digits(y + down)}" fill="${fillStyle}" text-anchor="${anchor}"`
      + ` font-family="${escaped(family)}" font-size="${size}" font-weight="${weight}">${escaped(text)}</text>`);
    this.#last = { look: '', kind: '' };
  }

  save() { this.#saved.push({ ...this.#state }); }
  restore() { this.#state = this.#saved.pop() ?? this.#state; }
  setLineDash(/** @type {number[]} */ dash) { this.#state.dash = dash.map(digits).join(' '); }

  /**
   * Strokes of one look become one path; polygons stay apart, so that each can be picked.
   * @param {'fill' | 'stroke'} kind  @param {string} look
   */
  #add(kind, look) {
    if (this.#path.length === 0) return;
    const d = this.#path.join('');
    if (kind === 'stroke' && this.#last.kind === kind && this.#last.look === look) {
      const last = /** @type {string} */ (this.#parts.pop());
      if (last.length < 100000) return void this.#parts.push(last.replace(/"\/>$/, `${d}"/>`));
      this.#parts.push(last);
    }
    this.#parts.push(`<path ${look} d="${d}"/>`);
    this.#last = { kind, look };
  }

  /**
   * The whole file.
   * @param {number} width  @param {number} height  @param {string} background  @param {string} title
   */
  text(width, height, background, title) {
    const [w, h] = [digits(width), digits(height)];
    return [
      '<?xml version="1.0" encoding="UTF-8"?>',
      `<svg xmlns="http://www.w3.org/2000/svg" width="${w}" height="${h}" viewBox="0 0 ${w} ${h}">`,
      `<title>${escaped(title)}</title>`, `<rect width="100%" height="100%" fill="${background}"/>`,
      ...this.#parts, '</svg>', '',
    ].join('\n');
  }

  static {
    for (const name of /** @type {(keyof typeof plain)[]} */ (Object.keys(plain)))
      if (name !== 'dash') Object.defineProperty(this.prototype, name, {
        get() { return this.#state[name]; },
        set(/** @type {never} */ value) { this.#state[name] = value; },
      });
  }
}

const opacity = (/** @type {number} */ alpha) => (alpha === 1 ? '' : ` opacity="${digits(alpha)}"`);

/** @returns {SvgPen & Pen} */
export const svgPen = () => /** @type {SvgPen & Pen} */ (/** @type {unknown} */ (new SvgPen()));
