// The episode in plain JavaScript, as one would write it without Rust: what the core is measured against.
// Parking with the paper's law and limits of velocity only; nothing else is needed for the comparison.

const { abs, cos, max, min, sin, PI } = Math;

const wrap = (/** @type {number} */ angle) => {
  const turns = Math.ceil((angle - PI) / (2 * PI));
  return angle - 2 * PI * turns;
};

const awayFromZero = (/** @type {number} */ s) => {
  if (abs(s) >= 1e-6) return s;
  return s < 0 || Object.is(s, -0) ? -1e-6 : 1e-6;
};

/**
 * J of one run.
 * @param {{ x: number, y: number, theta: number }} start
 * @param {{ x: number, y: number, theta: number }} goal
 * @param {{ position: number, horizon: number }} options
 * @param {number} kx @param {number} ky @param {number} ktheta
 */
export function drive(start, goal, { position, horizon }, kx, ky, ktheta) {
  const dt = 0.01;
  const [cosGoal, sinGoal] = [cos(goal.theta), sin(goal.theta)];
  let { x, y, theta } = start;
  let integral = 0;
  for (let n = 0; ; n++) {
    const dx = goal.x - x;
    const dy = goal.y - y;
    const xe = cosGoal * dx + sinGoal * dy;
    const ye = -sinGoal * dx + cosGoal * dy;
    const te = wrap(goal.theta - theta);
    const t = n * dt;
    const arrived = xe * xe + ye * ye <= position * position && abs(te) <= 0.05;
    if (arrived || t >= horizon) return (arrived ? t : horizon) + dx * dx + dy * dy + te * te + integral;

    const s = sin(te);
    const c = cos(te);
    const cosec = 1 / awayFromZero(s);
    const aside = ky * ye * ye * ye * cosec;
    let v = kx * xe * c - aside;
    let w = ktheta * s + aside * cosec * xe * c + kx * xe * ye * c;
    v = min(2, max(-2, v));
    w = min(2 * PI, max(-2 * PI, w));
    integral += 0.5 * dt * (dx * dx + dy * dy + te * te + v * v + w * w);

    const h = 0.5 * w * dt;
    const chord = v * dt * (h === 0 ? 1 : sin(h) / h);
    x += chord * cos(theta + h);
    y += chord * sin(theta + h);
    theta += 2 * h;
  }
}
