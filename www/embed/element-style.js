// What the element looks like around its figure: as wide as what holds it, also among flexible things and in a grid that centres.

export const sheet = new CSSStyleSheet();
sheet.replaceSync(`
  :host { display: block; width: -moz-available; width: -webkit-fill-available; width: stretch; }
  :host([hidden]) { display: none; }
  iframe { display: block; width: 100%; height: 420px; border: 0; }
  p { margin: 0 0 8px; padding: 8px 12px; border: 2px solid #b3261e; background: #fff; color: #b3261e; font: 1rem/1.4 sans-serif; white-space: pre-line; }
  p:empty { display: none; }
`);
