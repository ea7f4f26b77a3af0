// The controller in Python 3, which needs nothing but its own library.
/** @import { Controller } from './controller.js' */
/** @import { Words } from './parts.js' */
import { controlGroups, driveGroups, headOf, limitsOf, rows, slowly } from './parts.js';
import { beside, code, comment, literal, when } from './text.js';

const number = (/** @type {number} */ value) => literal(value, 'math.inf');
const pose = (/** @type {import('../../core/engine.js').Posture} */ { x, y, theta }) =>
  `(${[x, y, theta].map(number).join(', ')})`;

/** @param {import('./parts.js').Group} group @returns {[string, string]} */
const assigned = ([names, values, about]) => [
  `${names.join(', ')} = ${values.map(number).join(', ')}`,
  about,
];

/** @param {string} text */
const doc = (text) => comment(`"""${text}"""`, '');

/** @param {Controller} controller @param {Words['comments']} words */
export function python(controller, words) {
  const { name, start, experiment } = controller;
  const head = headOf(controller, words, `python3 ${name}.py`).map((text) => comment(text, '# '));
  /** @type {[string, string][]} */
  const poses = [
    [`START = ${pose(start)}`, words.start],
    [`GOAL = ${pose(experiment.goal)}`, words.goal],
  ];
  return code`
${head.join('\n')}

import math

${beside(controlGroups(controller, words).map(assigned), '  # ')}


${command(controller, words)}

# ${words.driveTitle}

${beside([...poses, ...driveGroups(controller, words).map(assigned)], '  # ')}


${drive(controller, words)}`;
}

/** @param {Controller} controller @param {Words['comments']} words */
function command(controller, words) {
  const { law } = controller.experiment;
  const limits = limitsOf(controller);
  const isPaper = law === 'shim-kim';
  return code`
def command(pose, goal, previous):
    """${comment(words.command, '').replaceAll('\n', '\n    ')}

    ${comment(words.ros, '')}

    ${comment(words.wheels, '')}
    """
    # ${words.law[law]}
    xe, ye, te = error(pose, goal)
    ${isPaper ? paperLaw : kanayamaRule}
    ${when(limits.any, `# ${words.limits}`)}
    ${when(limits.acceleration || limits.turnAcceleration, 'v0, w0 = previous')}
    ${when(limits.speed, 'v = clamp(v, -SPEED, SPEED)')}
    ${when(limits.turnRate, 'w = clamp(w, -TURN_RATE, TURN_RATE)')}
    ${when(limits.acceleration, 'v = clamp(v, v0 - ACCELERATION * DT, v0 + ACCELERATION * DT)')}
    ${when(limits.turnAcceleration, 'w = clamp(w, w0 - TURN_ACCELERATION * DT, w0 + TURN_ACCELERATION * DT)')}
    return v, w


def error(pose, goal):
    ${doc(words.error[law])}
    x, y, theta = pose
    xr, yr, thetar = goal
    s, c = math.sin(${isPaper ? 'thetar' : 'theta'}), math.cos(${isPaper ? 'thetar' : 'theta'})
    return c * (xr - x) + s * (yr - y), -s * (xr - x) + c * (yr - y), wrap(thetar - theta)


def wrap(angle):
    ${doc(words.wrap)}
    return angle - 2 * math.pi * math.ceil((angle - math.pi) / (2 * math.pi))


${when(isPaper, inverse(words))}
${when(limits.any, clamp(words))}`;
}

const paperLaw = `s, c = math.sin(te), math.cos(te)
cosec, sec = inverse(s), inverse(c)
steer = KY * ye**3 * cosec
v = KX * xe * c - steer + V_R * sec
w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec`;

const kanayamaRule = `v = V_R * math.cos(te) + KX * xe
w = W_R + V_R * (KY * ye + KTHETA * math.sin(te))`;

/** @param {Words['comments']} words */
const inverse = (words) => `def inverse(s):
    ${doc(words.inverse)}
    return 1 / math.copysign(max(abs(s), SMALLEST), s)

`;

/** @param {Words['comments']} words */
const clamp = (words) => `def clamp(value, low, high):
    ${doc(words.clamp)}
    return max(low, min(high, value))
`;

/** @param {Controller} controller @param {Words['comments']} words */
function drive(controller, words) {
  const { isTracking, canDiverge, page } = controller;
  const { x, y, theta } = page.pose;
  const numbers = [page.time, page.cost, x, y, theta].map(number).join(', ');
  return code`
def advance(pose, q):
    ${doc(words.advance)}
    x, y, theta = pose
    v, w = q
    h = w * DT / 2
    chord = v * DT * (math.sin(h) / h if h else 1)
    return x + chord * math.cos(theta + h), y + chord * math.sin(theta + h), theta + 2 * h


def drive():
    ${doc(words.drive)}
    pose, goal, q = START, GOAL, (0, 0)
    n, integral = 0, 0
    while True:
        dx, dy, dtheta = goal[0] - pose[0], goal[1] - pose[1], wrap(goal[2] - pose[2])
        square = dx * dx + dy * dy + dtheta * dtheta
        ${when(canDiverge, `if not math.isfinite(square):  # ${words.diverged}`)}
        ${when(canDiverge, '    return n * DT, math.inf, pose')}
        ${when(!isTracking, `parked = dx * dx + dy * dy <= POSITION**2 and abs(dtheta) <= HEADING${slowly(controller, { and: 'and', abs: 'abs', v: 'q[0]', w: 'q[1]' })}`)}
        if ${isTracking ? '' : 'parked or '}n * DT >= HORIZON:
            break
        v, w = q = command(pose, goal, q)
        integral += (square + R_V * v * v + R_W * w * w) * DT
        pose = advance(pose, q)
        ${when(isTracking, `goal = advance(goal, (V_R, W_R))  # ${words.goalMoves}`)}
        n += 1
    time = ${isTracking ? 'HORIZON' : 'n * DT if parked else HORIZON'}
    last = W_X * dx * dx + W_Y * dy * dy + W_THETA * dtheta * dtheta
    penalty = PENALTY * sum(max(0, -k) for k in (KX, KY, KTHETA))
    return time, time + last + integral / 2 + penalty, pose


def main():
    time, cost, pose = drive()
    # ${words.pageNumbers}
    page = ${numbers}
    for name, own, said in zip((${rows.map((name) => `"${name}"`).join(', ')}), (time, cost, *pose), page):
        print(f"{name:12}{own:<20.12g}page {said:.12g}")


if __name__ == "__main__":
    main()
`;
}
