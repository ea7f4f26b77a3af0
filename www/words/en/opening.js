// Every word about what is loaded on demand.

export const waits = 'This part is being loaded …';
export const failed =
  'This part of the page could not be loaded: there is no network, a newer version has taken the place of its files, or one must log in again. Everything else goes on.';
export const anew = 'To try again loads the page anew, and brings back what is there.';
/** Of a run of which another has taken the place. */
export const back = 'The browser’s Back leads to the run that was here before.';
export const still = 'Still not there.';
export const again = 'Try again';

export const texts = {
  keepButton: 'Share',
  keepTitle: 'Share or keep this run',
  checksButton: 'Check its numbers',
  checksTitle: 'Are the numbers right?',
  codeTitle: 'The controller as code',
  collectTitle: 'Check hand-ins',
  close: 'Close',
};
