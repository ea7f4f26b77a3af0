// Every word of Share: links, frames, exercises, files, tables, pictures.
import { kindName } from './common.js';

export * from './common.js';

export const texts = {
  keepLink: 'Link',
  keepLinkHelp: 'Opens this very run anywhere: the same robots, the same evolution, the same view.',
  keepLinkHere: 'Opens this very run: the same robots, the same evolution, the same view.',
  keepLinkOnDisk:
    'This page is a file on your disk. For others the link opens in their own copy of it: by adding the # and what follows it to its address.',
  keepCopy: 'Copy link',
  keepParkHelp:
    'Opens Park with the sliders as they are, for whoever wants to try. What evolution found is not in it.',
  keepParkTitle: 'What is found here',
  keepParkFound:
    'It can be shared as a run of the lab: as a link, as code for a robot, as a file, as tables.',
  keepParkEmpty: 'Move a slider, or let evolution try: what comes of it can be shared as a run of the lab.',
  keepParkLab: 'Open it in the lab',
  keepFile: 'File',
  keepSave: 'Save the run',
  keepOpen: 'Open a run',
  keepFileHelp: 'A file that this page opens again. It can also be dropped anywhere on the page.',
  keepPictures: 'Pictures of what is on screen',
  keepPicturesHelp: 'As it looks now, with this link inside. SVG stays sharp at any size.',
  keepTables: 'Tables (CSV)',
  keepGenerations: 'Generations',
  keepDrive: 'The drive',
  embedTitle: 'Embed',
  embedHelp:
    'Puts this view into another page, as it is now: a course page, a blog, slides. It stands still until someone uses it.',
  embedParkHelp:
    'Puts Park into another page, with the sliders as they are: a course page, a blog, slides. It stands still until someone uses it.',
  embedText: 'The text to paste',
  embedCopy: 'Copy',
  embedDisk: 'This page was opened from a disk: put its file beside the page into which you paste this.',
  keepExerciseTitle: 'Exercise',
  keepExerciseHelp:
    'Gives students this run with a task of yours; what would distract or tell too much is locked or hidden. What they hand in is checked here, a whole class at once.',
  keepExercise: 'Make an exercise',
  keepCollect: 'Check hand-ins',
  keepCodeTitle: 'Code',
  keepCodeHelp:
    'The controller of this drive, for a robot or a simulator: in Python, C, MATLAB or Octave, JavaScript.',
  keepCode: 'Show the code',
  makerTitle: 'Make an exercise',
  makerHelp:
    'The page shows at once what your students will see. Nothing is secret: they can open the whole page.',
  makerWithin: 'What the open exercise locks or hides stays so here: to set it, open the whole page first.',
  makerTask: 'Your task',
  makerLink: 'Link to the exercise',
  makerCopyLink: 'Copy link',
  makerFrame: 'Frame for another page',
  makerCopyFrame: 'Copy frame',
  makerPage: 'Page',
  makerPreview: 'What students will see',
  makerAim: 'Solved when',
  makerValue: 'The value',
  makerDrives: 'Within so many drives (or empty)',
  makerPoints: 'Points at two values, linear between them (or empty)',
  makerPointsAt: 'points at',
  makerVary: 'Drawn for each student from their number',
  makerUneven:
    'What J can be reached differs then from student to student. Ask for a J that all can reach, or for parking.',
  makerSeeds:
    'The drives of one evolution are counted: while the seed or the settings are free, students can try many and hand in the best.',
  makerWrong: 'Nothing is copied or saved as long as a field above is wrong.',
  makerTurned: 'The better result has fewer points here: exchange the two values if that is not meant.',
  makerPaperInLesson: 'The lesson tells the paper’s gains: it is hidden with them.',
  makerPark:
    'What is tried in Park cannot be handed in. The lab has the same 32 starts, the sliders and evolution.',
  makerToLab: 'Go on in the lab',
  makerOnDisk:
    'This page is a file on your disk. Your students need the file too, and open it with what follows the # of the link; or give them the package.',
  scormButton: 'Package for Moodle (SCORM 1.2)',
  scormTitle: 'Exercise: gains of a robot',
  scormFile: 'The page as one file',
  makerClose: 'Close the exercise',
};

/** @param {string} hash @param {number} generations */
export const fingerprint = (hash, generations) =>
  `Fingerprint of ${generations === 0 ? 'generation 0' : `generations 0 to ${generations}`}: ${hash}. It is the same wherever this link is opened.`;

export const copied = 'The link is copied.';
export const notCopied = 'This browser lets no page copy: the link is selected, copy it with the keyboard.';

/** The exercise as a package for a learning platform. */
export const scorm = {
  /** What the package says by itself; … is what the platform says. */
  sentences: {
    refused:
      'The learning platform did not keep this (…). Press Hand in, copy the receipt, and hand it in by hand.',
    tooLong:
      'The receipt is too long for this platform. Press Hand in, copy the receipt, and hand it in by hand.',
    noRoom:
      'This platform has no room for what you do now. Hand in before you leave, or it will not be there when you come back.',
    changed:
      'The exercise has changed since you worked on it, so it begins anew. A result that the platform has stays until you hand in again.',
    kept: 'The learning platform has this result. Handing in again replaces it.',
    nobody: 'No learning platform answers here, so nothing is kept. Press Hand in, and copy the receipt.',
  },
  writing: 'The package is being written …',
  /** @param {number} bytes */
  written: (bytes) =>
    `The package is saved (${(bytes / 1e6).toFixed(1)} MB). Upload it as a SCORM package; in Moodle: Add an activity, SCORM package.`,
  /** @param {number} characters */
  long: (characters) =>
    `Its link is long (${characters} characters): platforms may have no room for what students do after a hand-in. A shorter task, or fewer pins, make it shorter.`,
  /** @param {string} file */
  choose: (file) => `This page cannot read its own file here. Choose ${file}, the page as one file.`,
  /** @param {string} reason */
  failed: (reason) => `The package was not written: ${reason}`,
};

export const foreignFile = 'it is no run that this page has saved.';
export const handInFile =
  'it is a hand-in: “Check hand-ins” reads it, and the address bar opens the link in it.';

/** @param {unknown} found @param {number} own */
export const otherVersion = (found, own) =>
  `it was written by version ${String(found)} of the format, this page reads version ${own}.`;

/** @param {string} fields */
export const damagedFile = (fields) => `it is damaged: ${fields} cannot be read.`;

/** @param {readonly string[]} problems */
export const damagedLink = (problems) => `it is damaged. ${problems.join(' ')}`;

/** @param {string} said @param {string} found */
export const otherHash = (said, found) =>
  `it says that its evolution has the fingerprint ${said}, but it has ${found}: the file was changed.`;

/** @param {string} said @param {string} found */
export const otherGains = (said, found) =>
  `it says that its robot drives with the gains ${said}, but it drives with ${found}: the file was changed.`;

/** @param {string} said @param {number} found */
export const otherCost = (said, found) =>
  `it says that J of its drive is ${said}, but it is ${found}: the file was changed.`;

/** @param {string} field */
export const changedFile = (field) => `${field} in it is not that of its run: the file was changed.`;

export const cutFile = 'it is damaged: its end is missing.';

export const largeFile = 'it is too large for a run.';

export const reading = 'The file is read, and its run made again. Closing this gives it up.';

/** @param {string} name @param {string} reason */
export const notOpened = (name, reason) => `“${name}” was not opened: ${reason}`;

/** @param {string} name @param {number} generations @param {boolean} hasDrive */
export const opened = (name, generations, hasDrive) =>
  `“${name}” is open: all ${generations} generations${hasDrive ? ', and the drive,' : ''} came out as they were saved.`;

/** What of the lab is on screen, by its data-picture; parts name their own. @type {Readonly<Record<string, string>>} */
export const pictures = {
  plane: 'The plane',
  fitness: 'The fitness curve',
  sigmas: 'The mean step sizes σ',
  step: 'The picture of this step',
};

/** @param {string} picture @param {string} kind */
export const savePicture = (picture, kind) => `${picture}: save as ${kindName(kind)}`;

/** Why. */
export const unreadable = 'this browser lets no page read what it has drawn; SVG can be saved';
/** @param {string} picture @param {string} reason */
export const pictureNotSaved = (picture, reason) => `“${picture}” was not saved: ${reason}.`;

export const sizeLegend = 'Size of the frame';

export const textCopied = 'The text is copied.';

export const textNotCopied =
  'This browser lets no page copy: the text is selected, copy it with the keyboard.';

/** What a screen reader says of the frame. @param {string} part */
export const frameTitle = (part) => `Evolving a robot’s controller: ${part}`;

/** @type {import('../../kit/segmented.js').Choices<import('../../words/common/kinds.js').Way>} */
export const ways = {
  free: 'Free',
  locked: 'Locked',
  hidden: 'Hidden',
};

/** @param {readonly string[]} names @param {string} group */
export const easyText = (names, group) =>
  `Met already by one press: ${names.join(', ')}. Ask for more, or lock or hide “${group}”.`;

/** @param {readonly string[]} groups */
export const uncountedText = (groups) =>
  `Not counted is what is driven in: ${groups.join(', ')}. Where the budget is to hold, lock or hide that.`;

/** @param {number} drives */
export const manyText = (drives) =>
  `What is given has taken ${drives} drives already: allow more, or give generation 0 by hand.`;

/** @param {number} count @param {number} most */
export const countText = (count, most) => `${count} of at most ${most} characters`;

/** @typedef {typeof import('../../run/aim.js').most} Most */

/** @param {Exclude<import('../exercise/asked.js').Fields['kind'], 'none'>} kind @param {Most} most */
export const wrongValue = (kind, most) =>
  ({
    cost: `The value of J must be a number above 0 and at most ${most.cost}, for instance 8.1.`,
    parks: `The number of starts must be written like 28/32: the first at most the second, and that at most ${most.starts}.`,
    unseen: 'The share must be above 0 and at most 1, for instance 0.9 or 90 %.',
  })[kind];

/** @param {Most} most */
export const wrongDrives = (most) =>
  `The number of drives must be a whole number from 1 to ${most.drives}, or nothing.`;

/** Where they are not all there. */
export const lacksPoints =
  'Points need all four: points at one value, and at another value. Or leave all four empty.';

/** @param {number} i @param {Most} most */
export const wrongPoints = (i, most) => `${pointsLabel(i)} must be a number from 0 to ${most.points}.`;

/** @param {number} i @param {import('../../run/aim.js').Wanted} wanted @param {Most} most */
export const wrongAt = (i, wanted, most) =>
  `${pointsAtLabel(i)} must be ${
    wanted.kind === 'cost'
      ? `a J from 0 to ${most.cost}`
      : wanted.kind === 'parks'
        ? `a number of starts from 0 to ${wanted.of}`
        : 'a share from 0 to 1, for instance 0.3 or 30 %'
  }.`;

export const sameAt = 'The second value must differ from the first.';

/** @type {Readonly<Record<'none' | 'cost' | 'parks' | 'unseen', string>>} */
export const aims = {
  none: 'nobody checks',
  cost: 'J is below',
  parks: 'it parks from … of … starts',
  unseen: 'share of unseen starts',
};

/** @type {Readonly<Record<'goal' | 'starts' | 'seed', string>>} */
export const varied = {
  goal: 'the goal, by up to 25 cm',
  starts: 'the start, by up to 25 cm and 15°',
  seed: 'the seed of evolution',
};

/** @param {number} i */
export const pointsLabel = (i) => `Points at the ${i === 0 ? 'first' : 'second'} value`;

/** @param {number} i */
export const pointsAtLabel = (i) => `The ${i === 0 ? 'first' : 'second'} value`;
