// Every word about the keyboard.

export const texts = {
  keysButton: 'Keys',
  keysTitle: 'The keyboard',
  keysSingle: 'The single keys work (not while you type)',
  keysEverywhere: 'Every button, slider and picture is also reached by Tab.',
};

/** Single keys: what they press. Those of a presenter’s clicker do where they move nothing else. */
/** @type {readonly (readonly [key: string, meaning: string, id: string])[]} */
export const single = [
  ['r', 'run evolution, or pause it', 'run'],
  ['n', '1 generation', 'one-generation'],
  ['b', '1 generation back; with some presenters’ clickers the key for a black screen', 'one-back'],
  ['p', 'let the robots drive, or hold them', 'play'],
  ['PageDown', 'the next phase of the generation, where the page scrolls no further', 'generation-next'],
  ['PageUp', 'the phase before', 'generation-back'],
  ['s', 'settings', 'settings-button'],
];

/** Keys of what has the focus. */
/** @type {readonly (readonly [keys: string, meaning: string])[]} */
export const focused = [
  [
    '← → ↑ ↓',
    'move what has the focus: a slider, the start, the goal, the cursor of a map; in a formula, go from term to term',
  ],
  ['Shift + arrows', 'turn start or goal by 5°, or move the cursor of a map by larger steps'],
  ['Alt + arrows', 'move or turn start or goal by small steps'],
  ['Enter', 'press a button; on a map: drive what is under the cursor'],
  ['Esc', 'close what is open, take back start or goal that is being dragged'],
  [
    'Ctrl + Z, Ctrl + Shift + Z',
    'undo and redo a change of the experiment, or gains that took the place of yours',
  ],
  ['?', 'this sheet'],
];
