// Whether the page stands in a frame of another page, which its address says, ?embed, or the name of the frame.

/** A frame of this name holds a figure even if its address does not say ?embed, as that of a Blob cannot. */
export const frameName = 'ep-locomotion figure';

const asked = new URLSearchParams(globalThis.location?.search);

/** By <ep-locomotion>. */
export const isHeldByElement = globalThis.window?.name === frameName;

export const isEmbedded = asked.has('embed') || isHeldByElement;

let used = !isEmbedded;
if (isEmbedded)
  for (const type of ['pointerdown', 'keydown'])
    addEventListener(
      type,
      () => {
        used = true;
      },
      { capture: true, once: true },
    );

/** In a frame nothing moves until someone has used the figure, and nowhere for who wants less motion. */
export const isStill = () => !used || matchMedia('(prefers-reduced-motion: reduce)').matches;

/** Said when the page loads itself again: who keeps something of it lays it aside. */
export const leaving = 'page-leaves';

/** Whether the page can be loaded again now, and not one that asks to log in; a file on a disk cannot be asked for, and is there. */
export async function canLoad() {
  if (location.protocol === 'file:') return true;
  // A network that has fallen silent never answers.
  const signal = AbortSignal.timeout(10_000);
  const answer = await fetch(location.href, { cache: 'no-store', signal })
    .then((response) => response.text())
    .catch(() => '');
  return answer.includes('id="instrument"');
}

/** @param {string} letter One of ASCII. */
export const percent = (letter) => `%${letter.charCodeAt(0).toString(16).toUpperCase()}`;

/** What programs take for the end of an address in a text, or for its emphasis, is written otherwise. @param {string} link */
export const amongWords = (link) => link.replaceAll(/[!'()*]|[,.;~_]$/g, percent);

/** The address of the whole page, or with `embed` of its figure for a frame; who works on it only the link says. @param {string} page @param {string} link the text after # @param {boolean} embed */
export function addressOf(page, link, embed) {
  const address = new URL(page);
  for (const own of ['embed', 'who']) address.searchParams.delete(own);
  // URL would write ?embed=, which is longer to no end.
  const others = address.searchParams.toString();
  address.search = [embed ? 'embed' : '', others].filter(Boolean).join('&');
  address.hash = amongWords(link);
  return address.href;
}
