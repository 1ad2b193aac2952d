// Recordings in links: the header and the inputs of a .replay file, without its hashes, which a link needs no room for.
// engine/replay/replay.h describes the file. A link that is damaged gives a file that the game refuses with its own words.
'use strict';

const Recording = (() => {
  const crcTable = Uint32Array.from({length: 256}, (_, n) => {
    for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
    return n;
  });
  const crc32 = (crc, bytes) => {
    crc = ~crc;
    for (const byte of bytes) crc = crcTable[(crc ^ byte) & 0xff] ^ (crc >>> 8);
    return ~crc >>> 0;
  };
  const little = (value, size) => Array.from({length: size}, (_, k) => Math.floor(value / 2 ** (8 * k)) & 0xff);

  const throughStream = async (bytes, stream) =>
    new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

  // The end of the two lines of the header.
  const headerEnd = file => file.indexOf(10, file.indexOf(10) + 1) + 1;
  const inputSize = header => (/"players": ?2/.test(new TextDecoder().decode(header)) ? 8 : 6);

  // The header, then the inputs byte by byte across all ticks, so that they compress well.
  const shortOf = file => {
    const start = headerEnd(file);
    const header = file.subarray(0, start);
    const size = inputSize(header);
    const inputs = [];
    for (let at = start + 4; at + 5 <= file.length && file[at] === 0x54;) {
      const parts = file[at + 1] | file[at + 2] << 8;
      inputs.push(file.subarray(at + 5, at + 5 + size));
      at += 5 + size + parts * 7 + 8 + 4;
    }
    const columns = [];
    for (let k = 0; k < size; ++k) for (const input of inputs) columns.push(input[k]);
    return Uint8Array.from([...header, ...columns]);
  };

  const fileOf = short => {
    const start = headerEnd(short);
    const header = short.subarray(0, start);
    const size = inputSize(header);
    const ticks = (short.length - start) / size;
    const file = [];
    let crc = 0;
    const record = bytes => {
      crc = crc32(crc, bytes);
      for (const byte of bytes) file.push(byte);
      file.push(...little(crc, 4));
    };
    record(header);
    for (let tick = 0; tick < ticks; ++tick) {
      const input = Array.from({length: size}, (_, k) => short[start + k * ticks + tick]);
      record([0x54, 0, 0, 0xff, 0xff, ...input, 0, 0, 0, 0, 0, 0, 0, 0]);
    }
    record([0x45, ...little(ticks, 4)]);
    return Uint8Array.from(file);
  };

  return {
    async toLink(file) {
      const packed = await throughStream(shortOf(file), new CompressionStream('deflate'));
      return btoa(String.fromCharCode(...packed)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
    },
    async fromLink(text) {
      try {
        const packed = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0));
        return fileOf(await throughStream(packed, new DecompressionStream('deflate')));
      } catch {
        return new TextEncoder().encode(text);  // not a recording, as the game will say
      }
    },
  };
})();
if (typeof module !== 'undefined') module.exports = Recording;
