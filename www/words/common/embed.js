// Of the frame, what is the same in every language.

/** @param {number} width @param {number} height */
export const sizeText = (width, height) => `${width} × ${height}`;
