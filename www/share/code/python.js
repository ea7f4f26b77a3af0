// The controller in Python 3, which needs nothing but its own library.
/** @import { Experiment } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
/** @import { Pieces, Syntax, Words } from './parts.js' */
import { piecesOf, rows, slowly } from './parts.js';
import { beside, code, comment, when } from './text.js';

/** @type {Syntax} */
const syntax = {
  mark: '# ',
  infinity: 'math.inf',
  posture: (name, numbers) => `${name} = (${numbers.join(', ')})`,
  numbers: (names, numbers) => `${names.join(', ')} = ${numbers.join(', ')}`,
};

/** @param {string} text */
const doc = (text) => comment(`"""${text}"""`, '');

/** @param {Controller} controller @param {Words['comments']} words */
export function python(controller, words) {
  const pieces = piecesOf(controller, words, syntax, `python3 ${controller.name}.py`);
  return code`
${pieces.head}

import math

${beside(pieces.control, '  # ')}


${command(pieces, words)}

# ${words.driveTitle}

${beside([...pieces.ends, ...pieces.drive], '  # ')}


${drive(pieces, words)}`;
}

/** @param {Pieces} pieces @param {Words['comments']} words */
function command({ experiment: { law }, isPaper, limits, isLimited }, words) {
  return code`
def command(pose, goal, previous):
    """${comment(words.command, '').replaceAll('\n', '\n    ')}

    ${comment(words.ros, '')}

    ${comment(words.wheels, '')}
    """
    # ${words.law[law]}
    xe, ye, te = error(pose, goal)
    ${laws[law]}
    ${when(isLimited, `# ${words.limits}`)}
    ${when((limits.acceleration ?? limits.turnAcceleration) !== null, 'v0, w0 = previous')}
    ${when(limits.speed !== null, 'v = clamp(v, -SPEED, SPEED)')}
    ${when(limits.turnRate !== null, 'w = clamp(w, -TURN_RATE, TURN_RATE)')}
    ${when(limits.acceleration !== null, 'v = clamp(v, v0 - ACCELERATION * DT, v0 + ACCELERATION * DT)')}
    ${when(limits.turnAcceleration !== null, 'w = clamp(w, w0 - TURN_ACCELERATION * DT, w0 + TURN_ACCELERATION * DT)')}
    return v, w


def error(pose, goal):
    ${doc(words.error[law])}
    x, y, theta = pose
    xr, yr, thetar = goal
    s, c = math.sin(${isPaper ? 'thetar' : 'theta'}), math.cos(${isPaper ? 'thetar' : 'theta'})
    return c * (xr - x) + s * (yr - y), -s * (xr - x) + c * (yr - y), wrap(thetar - theta)


def wrap(angle):
    ${doc(words.wrap)}
    if not math.isfinite(angle):
        return math.nan
    return angle - 2 * math.pi * math.ceil((angle - math.pi) / (2 * math.pi))


${when(isPaper, inverse(words))}
${when(isLimited, clamp(words))}`;
}

/** @type {Record<Experiment['law'], string>} */
const laws = {
  'shim-kim': `s, c = math.sin(te), math.cos(te)
cosec, sec = inverse(s), inverse(c)
steer = KY * ye * ye * ye * cosec
v = KX * xe * c - steer + V_R * sec
w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec`,
  kanayama: `v = V_R * math.cos(te) + KX * xe
w = W_R + V_R * (KY * ye + KTHETA * math.sin(te))`,
};

/** @param {Words['comments']} words */
const inverse = (words) => `def inverse(s):
    ${doc(words.inverse)}
    return 1 / math.copysign(max(abs(s), SMALLEST), s)

`;

/** @param {Words['comments']} words */
const clamp = (words) => `def clamp(value, low, high):
    ${doc(words.clamp)}
    return low if value < low or math.isnan(low) else min(value, high)
`;

/** @param {Pieces} pieces @param {Words['comments']} words */
function drive(pieces, words) {
  const { isTracking, canDiverge } = pieces;
  return code`
def advance(pose, q):
    ${doc(words.advance)}
    x, y, theta = pose
    v, w = q
    h = w * DT / 2
    ${when(canDiverge, `if not math.isfinite(theta + h):  # ${words.diverged}`)}
    ${when(canDiverge, '    return math.nan, math.nan, math.nan')}
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
        ${when(!isTracking, `parked = dx * dx + dy * dy <= POSITION**2 and abs(dtheta) <= HEADING${slowly(pieces, { and: 'and', abs: 'abs', v: 'q[0]', w: 'q[1]' })}`)}
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
    page = ${pieces.said.join(', ')}
    for name, own, said in zip((${rows.map((name) => `"${name}"`).join(', ')}), (time, cost, *pose), page):
        print(f"{name:12}{own:<20.12g}page {said:.12g}")


if __name__ == "__main__":
    main()
`;
}
