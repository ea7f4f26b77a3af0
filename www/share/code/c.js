// The controller in C99, for a computer or, with float, for a small processor.
/** @import { Posture } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
/** @import { Words } from './parts.js' */
import { controlGroups, driveGroups, headOf, limitsOf, rows, slowly } from './parts.js';
import { beside, code, comment, literal, when } from './text.js';

const number = (/** @type {number} */ value) => literal(value, 'INFINITY');
const pose = (/** @type {Posture} */ { x, y, theta }) => `{${[x, y, theta].map(number).join(', ')}}`;

/** @param {import('./parts.js').Group} group @returns {[string, string]} */
const assigned = ([names, values, about]) => [
  `static const real ${names.map((name, i) => `${name} = ${number(values[i])}`).join(', ')};`,
  about,
];

/** @param {string} text */
const said = (text) => comment(text, '// ');

/** @param {Controller} controller @param {Words['comments']} words */
export function c(controller, words) {
  const { name, start, experiment, samples } = controller;
  const head = headOf(controller, words, `cc ${name}.c -lm && ./a.out`).map(said);
  /** @type {[string, string][]} */
  const poses = [
    [`static const Pose START = ${pose(start)};`, words.start],
    [`static const Pose GOAL = ${pose(experiment.goal)};`, words.goal],
    [`static const int SAMPLES = ${samples};`, words.samples],
  ];
  return code`
${head.join('\n')}

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

${beside(controlGroups(controller, words).map(assigned), ' // ')}
static const real PI = 3.141592653589793;

${command(controller, words)}

// ${words.driveTitle}

${beside([...poses, ...driveGroups(controller, words).map(assigned)], ' // ')}

${drive(controller, words)}`;
}

/** @param {Controller} controller @param {Words['comments']} words */
function command(controller, words) {
  const { law } = controller.experiment;
  const limits = limitsOf(controller);
  const isPaper = law === 'shim-kim';
  const axes = isPaper ? 'goal' : 'pose';
  return code`
${when(limits.any, clamp(words))}
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
    ${isPaper ? paperLaw : kanayamaRule}
    ${when(limits.any, `// ${words.limits}`)}
    ${when(limits.speed, 'v = clamp(v, -SPEED, SPEED);')}
    ${when(limits.turnRate, 'w = clamp(w, -TURN_RATE, TURN_RATE);')}
    ${when(limits.acceleration, 'v = clamp(v, previous.v - ACCELERATION * DT, previous.v + ACCELERATION * DT);')}
    ${when(limits.turnAcceleration, 'w = clamp(w, previous.w - TURN_ACCELERATION * DT, previous.w + TURN_ACCELERATION * DT);')}
    ${when(!limits.acceleration && !limits.turnAcceleration, '(void)previous;')}
    return (Velocity){v, w};
}`;
}

const paperLaw = `const real s = sin(te), c = cos(te);
const real cosec = inverse(s), sec = inverse(c);
const real steer = KY * ye * ye * ye * cosec;
real v = KX * xe * c - steer + V_R * sec;
real w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec;`;

const kanayamaRule = `real v = V_R * cos(te) + KX * xe;
real w = W_R + V_R * (KY * ye + KTHETA * sin(te));`;

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
    return fmax(low, fmin(high, value));
}
`;

/** @param {Controller} controller @param {Words['comments']} words */
function drive(controller, words) {
  const { isTracking, canDiverge, page } = controller;
  const { x, y, theta } = page.pose;
  const numbers = [page.time, page.cost, x, y, theta].map(number).join(', ');
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
        ${when(!isTracking, `const bool parked = dx * dx + dy * dy <= POSITION * POSITION && fabs(dtheta) <= HEADING${slowly(controller, { and: '&&', abs: 'fabs', v: 'q.v', w: 'q.w' })};`)}
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
    const double page[] = {${numbers}};
    for (int i = 0; i < 5; i++)
        printf("%-12s%-20.12gpage %.12g\n", names[i], own[i], page[i]);
    return 0;
}
`;
}
