// The controller in C99, for a computer or, with float, for a small processor.
/** @import { Experiment } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
/** @import { Pieces, Syntax, Words } from './parts.js' */
import { piecesOf, rows, slowly } from './parts.js';
import { beside, code, comment, when } from './text.js';

/** @type {Syntax} */
const syntax = {
  mark: '// ',
  infinity: 'INFINITY',
  posture: (name, numbers) => `static const Pose ${name} = {${numbers.join(', ')}};`,
  numbers: (names, numbers) =>
    `static const real ${names.map((name, i) => `${name} = ${numbers[i]}`).join(', ')};`,
};

/** @param {string} text */
const said = (text) => comment(text, syntax.mark);

/** @param {Controller} controller @param {Words['comments']} words */
export function c(controller, words) {
  const { name, samples } = controller;
  const pieces = piecesOf(controller, words, syntax, `cc ${name}.c -lm && ./a.out`);
  /** @type {import('./parts.js').Line} */
  const count = [`static const int SAMPLES = ${samples};`, words.samples];
  return code`
${pieces.head}

#include <stdbool.h>
#include <stdio.h>
#include <tgmath.h>

// ${words.float}
#ifndef REAL
#define REAL double
#endif
typedef REAL real;

typedef struct { real x, y, theta; } Pose; // m, m, rad
typedef struct { real v, w; } Velocity;    // m/s, rad/s

${beside(pieces.control, ' // ')}
static const real PI = 3.141592653589793;

${command(pieces, words)}

// ${words.driveTitle}

${beside([...pieces.ends, count, ...pieces.drive], ' // ')}

${drive(pieces, words)}`;
}

/** @param {Pieces} pieces @param {Words['comments']} words */
function command({ experiment: { law }, isPaper, limits, isLimited }, words) {
  const axes = isPaper ? 'goal' : 'pose';
  return code`
${when(isLimited, clamp(words))}
${when(isPaper, inverse(words))}
${said(words.wrap)}
static real wrap(real angle)
{
    return angle - 2 * PI * ceil((angle - PI) / (2 * PI));
}

${said(words.error[law])}
static Pose error(Pose pose, Pose goal)
{
    const real dx = goal.x - pose.x, dy = goal.y - pose.y;
    const real s = sin(${axes}.theta), c = cos(${axes}.theta);
    return (Pose){c * dx + s * dy, -s * dx + c * dy, wrap(goal.theta - pose.theta)};
}

${said(words.command)}
//
${said(words.ros)}
//
${said(words.wheels)}
Velocity command(Pose pose, Pose goal, Velocity previous)
{
    // ${words.law[law]}
    const Pose e = error(pose, goal);
    const real xe = e.x, ye = e.y, te = e.theta;
    ${laws[law]}
    ${when(isLimited, `// ${words.limits}`)}
    ${when(limits.speed !== null, 'v = clamp(v, -SPEED, SPEED);')}
    ${when(limits.turnRate !== null, 'w = clamp(w, -TURN_RATE, TURN_RATE);')}
    ${when(limits.acceleration !== null, 'v = clamp(v, previous.v - ACCELERATION * DT, previous.v + ACCELERATION * DT);')}
    ${when(limits.turnAcceleration !== null, 'w = clamp(w, previous.w - TURN_ACCELERATION * DT, previous.w + TURN_ACCELERATION * DT);')}
    ${when(limits.acceleration === null && limits.turnAcceleration === null, '(void)previous;')}
    return (Velocity){v, w};
}`;
}

/** @type {Record<Experiment['law'], string>} */
const laws = {
  'shim-kim': `const real s = sin(te), c = cos(te);
const real cosec = inverse(s), sec = inverse(c);
const real steer = KY * ye * ye * ye * cosec;
real v = KX * xe * c - steer + V_R * sec;
real w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec;`,
  kanayama: `real v = V_R * cos(te) + KX * xe;
real w = W_R + V_R * (KY * ye + KTHETA * sin(te));`,
};

/** @param {Words['comments']} words */
const inverse = (words) => `${said(words.inverse)}
static real inverse(real s)
{
    return 1 / copysign(fmax(fabs(s), SMALLEST), s);
}
`;

/** @param {Words['comments']} words */
const clamp = (words) => `${said(words.clamp)}
static real clamp(real value, real low, real high)
{
    return value < low || isnan(low) ? low : value > high ? high : value;
}
`;

/** @param {Pieces} pieces @param {Words['comments']} words */
function drive(pieces, words) {
  const { isTracking, canDiverge } = pieces;
  return code`
typedef struct { real time, cost; Pose pose; } Run;

${said(words.advance)}
static Pose advance(Pose p, Velocity q)
{
    const real h = q.w * DT / 2;
    const real chord = q.v * DT * (h == 0 ? 1 : sin(h) / h);
    return (Pose){p.x + chord * cos(p.theta + h), p.y + chord * sin(p.theta + h), p.theta + 2 * h};
}

${said(words.drive)}
static Run drive(void)
{
    Pose pose = START, goal = GOAL;
    Velocity q = {0, 0};
    real integral = 0;
    for (int n = 0;; n++) {
        const real dx = goal.x - pose.x, dy = goal.y - pose.y, dtheta = wrap(goal.theta - pose.theta);
        const real square = dx * dx + dy * dy + dtheta * dtheta;
        ${when(canDiverge, `if (!isfinite(square)) return (Run){n * DT, INFINITY, pose}; // ${words.diverged}`)}
        ${when(!isTracking, `const bool parked = dx * dx + dy * dy <= POSITION * POSITION && fabs(dtheta) <= HEADING${slowly(pieces, { and: '&&', abs: 'fabs', v: 'q.v', w: 'q.w' })};`)}
        if (${isTracking ? '' : 'parked || '}n == SAMPLES) {
            const real time = ${isTracking ? 'HORIZON' : 'parked ? n * DT : HORIZON'};
            const real last = W_X * dx * dx + W_Y * dy * dy + W_THETA * dtheta * dtheta;
            const real penalty = PENALTY * (fmax(0, -KX) + fmax(0, -KY) + fmax(0, -KTHETA));
            return (Run){time, time + last + integral / 2 + penalty, pose};
        }
        q = command(pose, goal, q);
        integral += (square + R_V * q.v * q.v + R_W * q.w * q.w) * DT;
        pose = advance(pose, q);
        ${when(isTracking, `goal = advance(goal, (Velocity){V_R, W_R}); // ${words.goalMoves}`)}
    }
}

int main(void)
{
    const Run run = drive();
    const char *names[] = {${rows.map((name) => `"${name}"`).join(', ')}};
    const double own[] = {run.time, run.cost, run.pose.x, run.pose.y, run.pose.theta};
    // ${words.pageNumbers}
    const double page[] = {${pieces.said.join(', ')}};
    for (int i = 0; i < 5; i++)
        printf("%-12s%-20.12gpage %.12g\n", names[i], own[i], page[i]);
    return 0;
}
`;
}
