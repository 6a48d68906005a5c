// SPDX-License-Identifier: Apache-2.0
// Reads the page's own layers: grey PNG of 8 or 16 bit. Not by way of a canvas, because browsers
// that guard privacy falsify what a canvas gives back.
"use strict";

/** The bytes of all IDAT chunks, and the picture's size and depth. */
function pngChunks(bytes) {
  const view = new DataView(bytes.buffer);
  const png = { parts: [] };
  for (let at = 8; at < bytes.length;) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (type === "IHDR") {
      png.cols = view.getUint32(at + 8);
      png.rows = view.getUint32(at + 12);
      png.bytesPerPixel = bytes[at + 16] / 8;
    } else if (type === "IDAT") {
      png.parts.push(bytes.subarray(at + 8, at + 8 + length));
    }
    at += 12 + length;
  }
  return png;
}

function paeth(a, b, c) {
  const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

/** Undoes the filter of every row (PNG specification, section 9.2), in place. */
function unfilter(raw, rowBytes, rows, step) {
  for (let y = 0; y < rows; ++y) {
    const filter = raw[y * (rowBytes + 1)];
    const row = y * (rowBytes + 1) + 1, above = row - rowBytes - 1;
    for (let i = 0; i < rowBytes && filter > 0; ++i) {
      const a = i < step ? 0 : raw[row + i - step];
      const b = y === 0 ? 0 : raw[above + i];
      const c = y === 0 || i < step ? 0 : raw[above + i - step];
      const guess = filter === 1 ? a : filter === 2 ? b
        : filter === 3 ? (a + b) >> 1 : paeth(a, b, c);
      raw[row + i] += guess;  // modulo 256, as the format wants
    }
  }
}

/** {cols, rows, codes}: one whole number per pixel, row by row. */
async function decodePng(base64) {
  const png = pngChunks(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)));
  const unpacked = new Blob(png.parts).stream().pipeThrough(new DecompressionStream("deflate"));
  const raw = new Uint8Array(await new Response(unpacked).arrayBuffer());
  const { cols, rows, bytesPerPixel: step } = png;
  unfilter(raw, cols * step, rows, step);
  const codes = new Uint16Array(cols * rows);
  for (let y = 0, i = 0; y < rows; ++y) {
    let at = y * (cols * step + 1) + 1;
    for (let x = 0; x < cols; ++x, ++i, at += step) {
      codes[i] = step === 2 ? raw[at] * 256 + raw[at + 1] : raw[at];
    }
  }
  return { cols, rows, codes };
}
