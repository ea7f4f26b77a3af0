// The fonts of texts in canvases: those of --sans in style.css, at the size of plots.

const family =
  'system-ui, "Apple SD Gothic Neo", "Malgun Gothic", "Noto Sans KR", "Noto Sans CJK KR", sans-serif';

export const textFont = `13px ${family}`;
export const strongFont = `600 13px ${family}`;
/** As letters stand in formulas. @param {number} size */
export const italicFont = (size) => `italic ${size}px "STIX Two Text", "Cambria Math", Georgia, serif`;
export const symbolFont = italicFont(17);
