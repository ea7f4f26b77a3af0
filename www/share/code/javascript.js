// The controller in JavaScript, a module for Node and for browsers.
/** @import { Experiment } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
/** @import { Pieces, Syntax, Words } from './parts.js' */
import { piecesOf, rows, slowly } from './parts.js';
import { beside, code, comment, when } from './text.js';

/** @type {Syntax} */
const syntax = {
  mark: '// ',
  infinity: 'Infinity',
  posture: (name, [x, y, theta]) => `const ${name} = { x: ${x}, y: ${y}, theta: ${theta} };`,
  numbers: (names, numbers) =>
    names.length === 1
      ? `const ${names[0]} = ${numbers[0]};`
      : `const [${names.join(', ')}] = [${numbers.join(', ')}];`,
};

/** @param {string} text */
const said = (text) => comment(text, syntax.mark);

/** @param {Controller} controller @param {Words['comments']} words */
export function javascript(controller, words) {
  const pieces = piecesOf(controller, words, syntax, `node ${controller.name}.mjs`);
  return code`
${pieces.head}

${beside(pieces.control, ' // ')}

${command(pieces, words)}

// ${words.driveTitle}

${beside([...pieces.ends, ...pieces.drive], ' // ')}

${drive(pieces, words)}`;
}

/** @param {Pieces} pieces @param {Words['comments']} words */
function command({ experiment: { law }, isPaper, limits, isLimited }, words) {
  return code`
${said(words.command)}
//
${said(words.ros)}
//
${said(words.wheels)}
export function command(pose, goal, previous) {
  // ${words.law[law]}
  const { xe, ye, te } = error(pose, goal);
  ${laws[law]}
  ${when(isLimited, `// ${words.limits}`)}
  ${when(limits.speed !== null, 'v = clamp(v, -SPEED, SPEED);')}
  ${when(limits.turnRate !== null, 'w = clamp(w, -TURN_RATE, TURN_RATE);')}
  ${when(limits.acceleration !== null, 'v = clamp(v, previous.v - ACCELERATION * DT, previous.v + ACCELERATION * DT);')}
  ${when(limits.turnAcceleration !== null, 'w = clamp(w, previous.w - TURN_ACCELERATION * DT, previous.w + TURN_ACCELERATION * DT);')}
  return { v, w };
}

${said(words.error[law])}
function error(pose, goal) {
  const [dx, dy] = [goal.x - pose.x, goal.y - pose.y];
  const [s, c] = [Math.sin(${isPaper ? 'goal' : 'pose'}.theta), Math.cos(${isPaper ? 'goal' : 'pose'}.theta)];
  return { xe: c * dx + s * dy, ye: -s * dx + c * dy, te: wrap(goal.theta - pose.theta) };
}

${said(words.wrap)}
function wrap(angle) {
  return angle - 2 * Math.PI * Math.ceil((angle - Math.PI) / (2 * Math.PI));
}

${when(isPaper, inverse(words))}
${when(isLimited || isPaper, clamp(words))}`;
}

/** @type {Record<Experiment['law'], string>} */
const laws = {
  'shim-kim': `const [s, c] = [Math.sin(te), Math.cos(te)];
const [cosec, sec] = [inverse(s), inverse(c)];
const steer = KY * ye ** 3 * cosec;
let v = KX * xe * c - steer + V_R * sec;
let w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec;`,
  kanayama: `let v = V_R * Math.cos(te) + KX * xe;
let w = W_R + V_R * (KY * ye + KTHETA * Math.sin(te));`,
};

/** @param {Words['comments']} words */
const inverse = (words) => `${said(words.inverse)}
function inverse(s) {
  return clamp(1 / s, -1 / SMALLEST, 1 / SMALLEST);
}
`;

/** @param {Words['comments']} words */
const clamp = (words) => `${said(words.clamp)}
function clamp(value, low, high) {
  return Math.max(low, Math.min(high, value));
}
`;

/** @param {Pieces} pieces @param {Words['comments']} words */
function drive(pieces, words) {
  const { isTracking, canDiverge } = pieces;
  return code`
${said(words.advance)}
function advance({ x, y, theta }, { v, w }) {
  const h = (w * DT) / 2;
  const chord = v * DT * (h === 0 ? 1 : Math.sin(h) / h);
  return { x: x + chord * Math.cos(theta + h), y: y + chord * Math.sin(theta + h), theta: theta + 2 * h };
}

${said(words.drive)}
export function drive() {
  let pose = START;
  ${isTracking ? 'let' : 'const'} goal = GOAL;
  let q = { v: 0, w: 0 };
  let integral = 0;
  for (let n = 0; ; n += 1) {
    const [dx, dy, dtheta] = [goal.x - pose.x, goal.y - pose.y, wrap(goal.theta - pose.theta)];
    const square = dx * dx + dy * dy + dtheta * dtheta;
    ${when(canDiverge, `if (!Number.isFinite(square)) return { time: n * DT, cost: Infinity, pose }; // ${words.diverged}`)}
    ${when(!isTracking, `const parked = dx * dx + dy * dy <= POSITION ** 2 && Math.abs(dtheta) <= HEADING${slowly(pieces, { and: '&&', abs: 'Math.abs', v: 'q.v', w: 'q.w' })};`)}
    if (${isTracking ? '' : 'parked || '}n * DT >= HORIZON) {
      const time = ${isTracking ? 'HORIZON' : 'parked ? n * DT : HORIZON'};
      const last = W_X * dx * dx + W_Y * dy * dy + W_THETA * dtheta * dtheta;
      const penalty = PENALTY * (Math.max(0, -KX) + Math.max(0, -KY) + Math.max(0, -KTHETA));
      return { time, cost: time + last + integral / 2 + penalty, pose };
    }
    q = command(pose, goal, q);
    integral += (square + R_V * q.v ** 2 + R_W * q.w ** 2) * DT;
    pose = advance(pose, q);
    ${when(isTracking, `goal = advance(goal, { v: V_R, w: W_R }); // ${words.goalMoves}`)}
  }
}

function main() {
  const { time, cost, pose } = drive();
  const own = [time, cost, pose.x, pose.y, pose.theta];
  // ${words.pageNumbers}
  const page = [${pieces.said.join(', ')}];
  const digits = (value) => String(Number(value.toPrecision(12)));
  for (const [i, name] of [${rows.map((name) => `'${name}'`).join(', ')}].entries())
    console.log(name.padEnd(12) + digits(own[i]).padEnd(19) + ' page ' + digits(page[i]));
}

// ${words.mainOfModule}
const file = import.meta.url.split('/').pop();
if (globalThis.process?.argv[1]?.endsWith(decodeURIComponent(file))) main();
`;
}
