// On which side of a line a point lies, without rounding: the sign of a determinant of doubles
// [Shewchuk 1997, Adaptive precision floating-point arithmetic]. Nearly always the first line of it
// decides.

const epsilon = 2 ** -53;
const bound = (3 + 16 * epsilon) * epsilon;
const splitter = 2 ** 27 + 1;

/** > 0: c lies to the left of the line from a to b; 0: on it; < 0: to the right. */
export function orient(/** @type {number} */ ax, /** @type {number} */ ay, /** @type {number} */ bx, /** @type {number} */ by,
  /** @type {number} */ cx, /** @type {number} */ cy) {
  const left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
  const sign = left - right;
  return Math.abs(sign) > bound * (Math.abs(left) + Math.abs(right)) ? sign : exact(ax, ay, bx, by, cx, cy);
}

/** @param {...number} _  as above; ax by - ax cy - cx by - ay bx + ay cx + cy bx */
function exact(...[ax, ay, bx, by, cx, cy]) {
  /** @type {number[]} */
  let sum = [];
  for (const [p, q] of [[ax, by], [-ax, cy], [-cx, by], [-ay, bx], [ay, cx], [cy, bx]]) {
    const high = p * q;
    sum = grown(grown(sum, errorOf(p, q, high)), high);
  }
  return sum.findLast((part) => part !== 0) ?? 0;
}

/** p q - high, exactly. */
function errorOf(/** @type {number} */ p, /** @type {number} */ q, /** @type {number} */ high) {
  const ps = splitter * p, p1 = ps - (ps - p), p0 = p - p1;
  const qs = splitter * q, q1 = qs - (qs - q), q0 = q - q1;
  return p0 * q0 - (high - p1 * q1 - p0 * q1 - p1 * q0);
}

/** A sum of parts that do not overlap, smallest first, and one more. */
function grown(/** @type {number[]} */ parts, /** @type {number} */ added) {
  const sum = [];
  let carry = added;
  for (const part of parts) {
    const both = carry + part, rest = both - carry;
    sum.push((carry - (both - rest)) + (part - rest));
    carry = both;
  }
  sum.push(carry);
  return sum;
}
