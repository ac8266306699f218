// For the build: a picture of every surface to begin with, made of the surface itself. The page does not draw them: making
// all eight takes a quarter of a second on a desk, and there is little room left in its scripts.
/** @import { Shape } from './shapes.js' */
import { crc32, deflateSync } from 'node:zlib';
import { presets } from './presets.js';

const width = 192, height = 128, margin = 6, fine = 2;  // `fine` samples a pixel, across and down
const azimuth = -2.21, above = 0.54;  // where from it is seen, in radians: as on the page when it is opened
const blue = [96, 152, 214];  // in full light: stands out on white and on black

/** Turned so that x goes right, y down and z away. @param {number[]} points */
function seen(points) {
  const [c, s, up, flat] = [Math.cos(azimuth), Math.sin(azimuth), Math.sin(above), Math.cos(above)];
  const turned = [];
  for (let i = 0; i < points.length; i += 3) {
    const [x, y, z] = points.slice(i, i + 3), towards = c * x + s * y;
    turned.push([c * y - s * x, up * towards - flat * z, -flat * towards - up * z]);
  }
  return turned;
}

/** In samples of the picture. @param {number[][]} points */
function fitted(points) {
  const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k]))), high = [0, 1].map((k) => Math.max(...points.map((p) => p[k])));
  const scale = fine * Math.min((width - 2 * margin) / (high[0] - low[0]), (height - 2 * margin) / (high[1] - low[1]));
  return points.map(([x, y, z]) => [fine * width / 2 + scale * (x - (low[0] + high[0]) / 2), fine * height / 2 + scale * (y - (low[1] + high[1]) / 2), scale * z]);
}

/** Lit from the upper left, either side. @param {number[][]} corners */
function lightOn([a, b, c]) {
  const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...normal) || 1, side = normal[2] > 0 ? -1 : 1;
  return 0.5 + 0.5 * Math.max(0, side * (-0.4 * normal[0] - 0.6 * normal[1] - 0.7 * normal[2]) / length);
}

/** How light every sample is; 0: nothing is there. @param {Shape} shape */
function shaded({ points, triangles }) {
  const across = fine * width, light = new Float32Array(across * fine * height), depth = new Float32Array(light.length).fill(Infinity);
  const at = fitted(seen(points));
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [at[triangles[t]], at[triangles[t + 1]], at[triangles[t + 2]]], [a, b, c] = corners;
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area === 0) continue;
    const shade = lightOn(corners);
    for (let y = Math.ceil(Math.min(a[1], b[1], c[1])); y <= Math.max(a[1], b[1], c[1]); ++y)
      for (let x = Math.ceil(Math.min(a[0], b[0], c[0])); x <= Math.max(a[0], b[0], c[0]); ++x) {
        const v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area, w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
        const z = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]), i = y * across + x;
        if (v < 0 || w < 0 || v + w > 1 || z >= depth[i]) continue;
        depth[i] = z;
        light[i] = shade;
      }
  }
  return light;
}

/** Rows of red, green, blue and opacity, each behind the 0 that PNG wants there. @param {Float32Array} light */
function rows(light) {
  const out = new Uint8Array(height * (4 * width + 1));
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const samples = [0, 1, 2, 3].map((k) => light[(fine * y + (k >> 1)) * fine * width + fine * x + k % 2]).filter((one) => one > 0);
      const mean = Math.round(32 * samples.reduce((sum, one) => sum + one, 0) / samples.length) / 32;  // few shades: a small file
      if (samples.length > 0) out.set([...blue.map((c) => c * mean), 255 * samples.length / 4], y * (4 * width + 1) + 1 + 4 * x);
    }
  return out;
}

/** @param {string} type  @param {Uint8Array} data */
function chunk(type, data) {
  const out = Buffer.alloc(12 + data.length);
  out.writeUInt32BE(data.length);
  out.write(type, 4, 'latin1');
  out.set(data, 8);
  out.writeUInt32BE(crc32(out.subarray(4, 8 + data.length)), 8 + data.length);
  return out;
}

/** As a PNG file. @param {Shape} shape */
export function pictureOf(shape) {
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width);
  head.writeUInt32BE(height, 4);
  head.set([8, 6], 8);  // bits of a colour; red, green, blue and opacity
  return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', head), chunk('IDAT', deflateSync(rows(shaded(shape)), { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

const folder = 'surfaces';

/** Puts them where the page looks for them. @returns {import('vite').Plugin} */
export function surfacePictures() {
  return {
    name: 'lpquad-surface-pictures',
    configureServer({ middlewares }) {
      middlewares.use(`/${folder}`, (request, response, next) => {
        const preset = presets.find(({ id }) => request.url === `/${id}.png`);
        if (preset) response.setHeader('content-type', 'image/png').end(pictureOf(preset.make()));
        else next();
      });
    },
    generateBundle() {
      for (const { id, make } of presets) this.emitFile({ type: 'asset', fileName: `${folder}/${id}.png`, source: pictureOf(make()) });
    },
  };
}
