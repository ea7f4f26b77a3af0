// A drawing as an SVG file: shapes and texts as such, the cells of maps as images, and what made it.
/** @import { About, Drawing, Gradient, Mark, Paint, Pattern, Stroke } from './marks.js' */
import { escaped } from '../kit/markup.js';
import { isGradient } from './marks.js';

/** @typedef {ReturnType<typeof createDefinitions>} Definitions */

/** @param {Drawing} drawing @param {About} about */
export function svgOf({ width, height, paper, marks }, { title, description, link, version }) {
  const definitions = createDefinitions();
  const clip = (/** @type {Mark} */ mark) => clipOf(mark, definitions);
  const place = (/** @type {Mark} */ { matrix }) => attributes({ transform: transformOf(matrix) });
  const write = (/** @type {Mark[]} */ placed) => placed.map((mark) => element(mark, definitions)).join('\n');
  const content = grouped(marks, clip, (clipped) => grouped(clipped, place, write));
  return `<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" ${attributes({ width, height, viewBox: `0 0 ${width} ${height}`, role: 'img', 'stroke-miterlimit': 10 })}>
<title>${escaped(title)}</title>
<desc>${escaped(description)}</desc>
<metadata><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" xmlns:dc="http://purl.org/dc/elements/1.1/"><rdf:Description><dc:title>${escaped(title)}</dc:title><dc:creator>${escaped(version)}</dc:creator><dc:source>${escaped(link)}</dc:source></rdf:Description></rdf:RDF></metadata>
<defs>
${definitions.list.join('\n')}
</defs>
<rect ${attributes({ width, height, ...paintAs('fill', paper) })}/>
${content}
</svg>
`;
}

/** Neighbours that share their attributes share a group. @param {Mark[]} marks @param {(mark: Mark) => string} sharedOf @param {(marks: Mark[]) => string} write */
function grouped(marks, sharedOf, write) {
  /** @type {{ shared: string, marks: Mark[] }[]} */
  const groups = [];
  for (const mark of marks) {
    const shared = sharedOf(mark);
    const last = groups[groups.length - 1];
    if (last?.shared === shared) last.marks.push(mark);
    else groups.push({ shared, marks: [mark] });
  }
  return groups
    .map(({ shared, marks: own }) => (shared ? `<g ${shared}>\n${write(own)}\n</g>` : write(own)))
    .join('\n');
}

/** Each definition once, and under which name. */
function createDefinitions() {
  /** @type {Map<string, string>} */
  const names = new Map();
  /** @type {string[]} */
  const list = [];
  return {
    list,
    /** @param {string} tag @param {string} content With its attributes, up to the end tag. @returns {string} */
    name(tag, content) {
      const known = names.get(content);
      if (known) return known;
      const name = `${tag}-${names.size + 1}`;
      names.set(content, name);
      list.push(`<${tag} id="${name}"${content}</${tag}>`);
      return name;
    },
  };
}

/** @param {Mark} mark @param {Definitions} definitions */
function clipOf({ clips }, definitions) {
  let clip = '';
  for (const { d, matrix } of clips) {
    const path = `<path ${attributes({ d, transform: transformOf(matrix) })}/>`;
    clip = `clip-path="url(#${definitions.name('clipPath', ` ${clip}>${path}`)})"`;
  }
  return clip;
}

/** @param {Mark} mark @param {Definitions} definitions */
function element(mark, definitions) {
  const { fill, fillOpacity, stroke, alpha } = mark;
  const opacity = alpha === 1 ? null : rounded(alpha);
  if (mark.kind === 'image') {
    const [x, y, width, height] = mark.box;
    const rendering = mark.smooth ? null : 'pixelated';
    return `<image ${attributes({ x, y, width, height, opacity, 'image-rendering': rendering, preserveAspectRatio: 'none', ...imageAs(mark.smooth ? mark.source : enlarged(mark.source)) })}/>`;
  }
  const inside = paintAs('fill', fill ?? 'none', definitions, fillOpacity);
  const edge = stroke && strokeAs(stroke, definitions);
  if (mark.kind === 'shape')
    return mark.d ? `<path ${attributes({ d: mark.d, ...inside, ...edge, opacity })}/>` : '';
  const { text, x, y, anchor, font } = mark;
  const letters = {
    x: rounded(x),
    y: rounded(y),
    'text-anchor': anchor === 'start' ? null : anchor,
    'font-family': font.family,
    'font-size': rounded(font.size),
    'font-weight': font.weight === '400' ? null : font.weight,
    'font-style': font.style === 'normal' ? null : font.style,
  };
  const write = (/** @type {Record<string, string | null>} */ paint) =>
    `<text ${attributes({ ...letters, ...paint })}>${escaped(text)}</text>`;
  if (!edge || !fill) return write({ ...inside, ...edge, opacity });
  // Not every program knows that a stroke may lie under its fill.
  return `<g ${attributes({ opacity })}>${write({ fill: 'none', ...edge })}${write(inside)}</g>`;
}

/** @param {Stroke} stroke @param {Definitions} definitions @returns {Record<string, string | null>} */
const strokeAs = ({ paint, opacity, width, dash, cap, join }, definitions) => ({
  ...paintAs('stroke', paint, definitions, opacity),
  'stroke-width': rounded(width, 5),
  'stroke-dasharray': dash.length > 0 ? dash.map((length) => rounded(length, 5)).join(' ') : null,
  'stroke-linecap': cap === 'butt' ? null : cap,
  'stroke-linejoin': join === 'miter' ? null : join,
});

/** So that cells keep their edges in programs that smooth every image. @param {HTMLCanvasElement} source */
function enlarged(source) {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [8 * source.width, 8 * source.height];
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.imageSmoothingEnabled = false;
  context.drawImage(source, 0, 0, canvas.width, canvas.height);
  return canvas;
}

/** By the older name of it: Inkscape before 1.3 knows no other. @param {HTMLCanvasElement} source */
const imageAs = (source) => ({ 'xlink:href': source.toDataURL() });

/** A mixed colour as other programs know them. @param {string} paint */
function withoutSpace(paint) {
  const [, mixed, alpha = '1'] = /^color\(srgb ([^/)]*?)(?: \/ ([\d.]+))?\)$/.exec(paint) ?? [];
  if (!mixed) return paint;
  return `rgba(${mixed
    .split(' ')
    .map((part) => Math.round(255 * Number(part)))
    .join(', ')}, ${alpha})`;
}

/** @param {'fill' | 'stroke'} property @param {Paint} paint @param {Definitions} [definitions] @param {number} [opacity] @returns {Record<string, string | null>} */
function paintAs(property, paint, definitions, opacity = 1) {
  const own = typeof paint === 'string' ? withoutSpace(paint) : '';
  // Not every program knows a colour with an alpha.
  const [, rgb, alpha = 1] = /^rgba\((.*), ([\d.]+)\)$/.exec(own) ?? [];
  const whole = opacity * Number(alpha);
  return {
    [property]: rgb
      ? `rgb(${rgb})`
      : typeof paint === 'string'
        ? paint
        : `url(#${definitions && paintServer(paint, definitions)})`,
    [`${property}-opacity`]: whole === 1 ? null : rounded(whole, 4),
  };
}

/** @param {Gradient | Pattern} paint @param {Definitions} definitions */
function paintServer(paint, definitions) {
  if (isGradient(paint)) {
    const { from, to, stops } = paint;
    const line = attributes({
      gradientUnits: 'userSpaceOnUse',
      x1: from[0],
      y1: from[1],
      x2: to[0],
      y2: to[1],
    });
    const colours = stops.map(
      ([offset, colour]) => `<stop ${attributes({ offset: rounded(offset, 4), 'stop-color': colour })}/>`,
    );
    return definitions.name('linearGradient', ` ${line}>${colours.join('')}`);
  }
  const { tile, scale } = paint;
  const [width, height] = [tile.width * scale, tile.height * scale];
  const image = `<image ${attributes({ width, height, ...imageAs(tile) })}/>`;
  const size = attributes({ patternUnits: 'userSpaceOnUse', width, height });
  return definitions.name('pattern', ` ${size}>${image}`);
}

/** @param {DOMMatrix} matrix */
function transformOf({ a, b, c, d, e, f }) {
  if (a === 1 && b === 0 && c === 0 && d === 1)
    return e === 0 && f === 0 ? null : `translate(${rounded(e)} ${rounded(f)})`;
  return `matrix(${[a, b, c, d, e, f].map((n) => rounded(n, 6)).join(' ')})`;
}

const rounded = (/** @type {number} */ value, digits = 2) => String(+value.toFixed(digits));

/** @param {Record<string, string | number | null>} values Null: not said. */
const attributes = (values) =>
  Object.entries(values)
    .filter(([, value]) => value !== null)
    .map(([name, value]) => `${name}="${escaped(String(value))}"`)
    .join(' ');
