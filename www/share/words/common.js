// Of Share, what is the same in every language.

/** @param {string} version @param {string} link */
export const origin = (version, link) => [`ep-locomotion ${version}`, link];

/** @param {number} seed @param {number} generation */
export const fileName = (seed, generation) => `robot-seed-${seed}-generation-${generation}`;

/** @param {string} kind */
export const kindName = (kind) => kind.toUpperCase();

/** @param {number} width @param {number} height */
export const sizeText = (width, height) => `${width} × ${height}`;
