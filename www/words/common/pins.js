// Of pinned drives, what is the same in every language.

/** @param {string} name @param {number} count */
export const again = (name, count) => `${name} (${count})`;
