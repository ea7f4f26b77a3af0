// The controller for MATLAB and for GNU Octave: a function file, whose functions of its own follow it.
/** @import { Experiment } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
/** @import { Pieces, Syntax, Words } from './parts.js' */
import { piecesOf, rows, slowly } from './parts.js';
import { beside, code, comment, when } from './text.js';

/** @type {Syntax} */
const syntax = {
  mark: '% ',
  infinity: 'Inf',
  posture: (name, numbers) => `p.${name} = [${numbers.join(' ')}];`,
  numbers: (names, numbers) => names.map((name, i) => `p.${name} = ${numbers[i]};`).join(' '),
};

/** @param {string} text */
const said = (text) => comment(text, syntax.mark);

/** @param {Controller} controller @param {Words['comments']} words */
export function matlab(controller, words) {
  const { name } = controller;
  const pieces = piecesOf(controller, words, syntax, name);
  return code`
function control = ${name}
${pieces.head}
% ${words.handle} control = ${name}; q = control(pose, goal, previous)
if nargout == 0
    main
else
    control = @command;
end
end

function p = numbers
${beside(pieces.control, ' % ')}

% ${words.driveTitle}
${beside([...pieces.ends, ...pieces.drive], ' % ')}
end

${command(pieces, words)}
${drive(pieces, words)}`;
}

/** @param {Pieces} pieces @param {Words['comments']} words */
function command({ experiment: { law }, isPaper, limits, isLimited }, words) {
  return code`
function q = command(pose, goal, previous)
${said(words.command)}
%
${said(words.ros)}
%
${said(words.wheels)}
p = numbers;
% ${words.law[law]}
[xe, ye, te] = error_posture(pose, goal);
${laws[law]}
${when(isLimited, `% ${words.limits}`)}
${when(limits.speed !== null, 'v = clamp(v, -p.SPEED, p.SPEED);')}
${when(limits.turnRate !== null, 'w = clamp(w, -p.TURN_RATE, p.TURN_RATE);')}
${when(limits.acceleration !== null, 'v = clamp(v, previous(1) - p.ACCELERATION * p.DT, previous(1) + p.ACCELERATION * p.DT);')}
${when(limits.turnAcceleration !== null, 'w = clamp(w, previous(2) - p.TURN_ACCELERATION * p.DT, previous(2) + p.TURN_ACCELERATION * p.DT);')}
q = [v w];
end

function [xe, ye, te] = error_posture(pose, goal)
${said(words.error[law])}
d = goal(:)' - pose(:)';
s = sin(${isPaper ? 'goal' : 'pose'}(3)); c = cos(${isPaper ? 'goal' : 'pose'}(3));
xe = c * d(1) + s * d(2);
ye = -s * d(1) + c * d(2);
te = wrap(d(3));
end

function angle = wrap(angle)
${said(words.wrap)}
angle = angle - 2 * pi * ceil((angle - pi) / (2 * pi));
end

${when(isPaper, inverse(words))}
${when(isLimited || isPaper, clamp(words))}`;
}

/** @type {Record<Experiment['law'], string>} */
const laws = {
  'shim-kim': `s = sin(te); c = cos(te);
cosec = inverse(s, p.SMALLEST); sec = inverse(c, p.SMALLEST);
steer = p.KY * ye^3 * cosec;
v = p.KX * xe * c - steer + p.V_R * sec;
w = p.W_R + p.KTHETA * s + steer * xe * c * cosec + p.KX * xe * ye * c + ye * p.V_R * sec;`,
  kanayama: `v = p.V_R * cos(te) + p.KX * xe;
w = p.W_R + p.V_R * (p.KY * ye + p.KTHETA * sin(te));`,
};

/** @param {Words['comments']} words */
const inverse = (words) => `function r = inverse(s, smallest)
${said(words.inverse)}
r = clamp(1 / s, -1 / smallest, 1 / smallest);
end
`;

/** @param {Words['comments']} words */
const clamp = (words) => `function value = clamp(value, low, high)
${said(words.clamp)}
if value < low || isnan(low)
    value = low;
elseif value > high
    value = high;
end
end
`;

/** @param {Pieces} pieces @param {Words['comments']} words */
function drive(pieces, words) {
  const { isTracking, canDiverge } = pieces;
  return code`
function pose = advance(pose, q, dt)
${said(words.advance)}
h = q(2) * dt / 2;
chord = q(1) * dt;
if h ~= 0
    chord = chord * sin(h) / h;
end
pose = pose + [chord * cos(pose(3) + h), chord * sin(pose(3) + h), 2 * h];
end

function [time, cost, pose] = drive
${said(words.drive)}
p = numbers;
pose = p.START; goal = p.GOAL; q = [0 0];
n = 0; integral = 0;
while true
    d = goal - pose;
    d(3) = wrap(d(3));
    ${when(canDiverge, `if ~isfinite(d * d') % ${words.diverged}`)}
    ${when(canDiverge, '    time = n * p.DT; cost = Inf;')}
    ${when(canDiverge, '    return')}
    ${when(canDiverge, 'end')}
    ${when(!isTracking, `parked = d(1)^2 + d(2)^2 <= p.POSITION^2 && abs(d(3)) <= p.HEADING${slowly(pieces, { and: '&&', abs: 'abs', v: 'q(1)', w: 'q(2)', of: 'p.' })};`)}
    if ${isTracking ? '' : 'parked || '}n * p.DT >= p.HORIZON
        break
    end
    q = command(pose, goal, q);
    integral = integral + (d * d' + p.R_V * q(1)^2 + p.R_W * q(2)^2) * p.DT;
    pose = advance(pose, q, p.DT);
    ${when(isTracking, `goal = advance(goal, [p.V_R p.W_R], p.DT); % ${words.goalMoves}`)}
    n = n + 1;
end
time = p.HORIZON;
${when(!isTracking, 'if parked')}
${when(!isTracking, '    time = n * p.DT;')}
${when(!isTracking, 'end')}
last = d * diag([p.W_X p.W_Y p.W_THETA]) * d';
penalty = p.PENALTY * sum(max(0, -[p.KX p.KY p.KTHETA]));
cost = time + last + integral / 2 + penalty;
end

function main
[time, cost, pose] = drive;
names = {${rows.map((name) => `'${name}'`).join(', ')}};
own = [time cost pose];
% ${words.pageNumbers}
page = [${pieces.said.join(' ')}];
for i = 1:5
    fprintf('%-12s%-20.12gpage %.12g\n', names{i}, own(i), page(i));
end
end
`;
}
