// ---- blocks: packed columns ----

class Blocks {
  constructor(text) {
    this.lines = text.split('\n');
  }

  async bytes(index) {
    const packed = fromBase64(this.lines[index]);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }

  async column(index, spec, frames, slots) {
    const count = frames * slots;
    return unpack(count === 0 ? new Uint8Array(0) : await this.bytes(index), spec, count, slots);
  }
}

function fromBase64(text) {
  if (Uint8Array.fromBase64) {
    return Uint8Array.fromBase64(text);
  }

  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) {
    bytes[i] = letters.charCodeAt(i);
  }

  return bytes;
}

// Bytes of the same weight lie together; each number is taken against the same slot in the frame before.
function unpack(bytes, spec, count, slots) {
  switch (spec.kind) {
    case 'double':
      return unpackDoubles(bytes, count, slots);
    case 'single':
      return new Float32Array(unpackWords(bytes, count, slots).buffer);
    case 'integer':
      return new Int32Array(unpackWords(bytes, count, slots).buffer);
    case 'byte':
      for (let i = slots; i < count; i++) {
        bytes[i] ^= bytes[i - slots];
      }

      return bytes;
    default:
      return unpackDecimals(bytes, spec, count, slots);
  }
}

function word(bytes, i, count, plane) {
  return (bytes[plane * count + i] | (bytes[(plane + 1) * count + i] << 8)
    | (bytes[(plane + 2) * count + i] << 16) | (bytes[(plane + 3) * count + i] << 24)) >>> 0;
}

function unpackWords(bytes, count, slots) {
  const words = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    words[i] = word(bytes, i, count, 0) ^ (i < slots ? 0 : words[i - slots]);
  }

  return words;
}

// The lower half of a double comes first, as in the memory of every machine that runs a browser today.
function unpackDoubles(bytes, count, slots) {
  const words = new Uint32Array(2 * count);
  for (let i = 0; i < count; i++) {
    const before = 2 * (i - slots);
    words[2 * i] = word(bytes, i, count, 0) ^ (before < 0 ? 0 : words[before]);
    words[2 * i + 1] = word(bytes, i, count, 4) ^ (before < 0 ? 0 : words[before + 1]);
  }

  return new Float64Array(words.buffer);
}

function unpackDecimals(bytes, spec, count, slots) {
  const wholes = new Int32Array(count);
  const numbers = new Float64Array(count);
  const scale = 10 ** Math.abs(spec.decimals);
  for (let i = 0; i < count; i++) {
    const zigzag = word(bytes, i, count, 0);
    const rest = (zigzag >>> 1) ^ -(zigzag & 1);
    const one = i < slots ? 0 : wholes[i - slots];
    const two = !spec.steady || i < 2 * slots ? one : wholes[i - 2 * slots];
    wholes[i] = rest + one + (one - two);
    const whole = spec.base + wholes[i];
    numbers[i] = spec.decimals >= 0 ? whole / scale : whole * scale;
  }

  return numbers;
}
