// The link that the author of another page gives a figure.

/** Of an address what follows its #; who works on it also where only the address says so. @param {string} address */
export function linkIn(address) {
  const end = address.indexOf('#');
  const link = address.slice(end + 1);
  const who = new URLSearchParams(address.slice(0, Math.max(0, end)).split('?')[1]).get('who');
  return who && !/[&?]who=/.test(link) ? `${link}&who=${encodeURIComponent(who)}` : link;
}
