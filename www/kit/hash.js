// A number that stands for a text, the same everywhere.

/** FNV-1a, 32 bits, of the text's UTF-8. @param {string} text */
export function fnv1a(text) {
  let hash = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 0x01000193);
  return hash >>> 0;
}

/** Spreads what differs in a few bits over all 32, as MurmurHash3 ends. @param {number} hash */
export function spread(hash) {
  let mixed = hash ^ (hash >>> 16);
  mixed = Math.imul(mixed, 0x85ebca6b);
  mixed = Math.imul(mixed ^ (mixed >>> 13), 0xc2b2ae35);
  return (mixed ^ (mixed >>> 16)) >>> 0;
}

/** Eight digits. @param {string} text */
export const digitsOf = (text) => fnv1a(text).toString(16).padStart(8, '0');
