// Kim and Shim's parking robot and its evolution, in the symbols of the lesson. For a browser or Node: node park.mjs
const START = [0, 0, 0]; // x, y in m, θ in rad
const GOAL = [2, 2, Math.PI / 4];
const [DT, HORIZON] = [0.01, 10]; // s
const [V_MAX, W_MAX] = [2, 2 * Math.PI]; // m/s, rad/s
const [R_V, R_W, W, KAPPA] = [1, 1, 1, 1000]; // weights of J
const [N, Q, SIGMA] = [20, 10, 1]; // robots, bouts for each, first σ

const wrap = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

// (3)
export function error(x, y, theta) {
  const [dx, dy, s, c] = [GOAL[0] - x, GOAL[1] - y, Math.sin(GOAL[2]), Math.cos(GOAL[2])];
  return [c * dx + s * dy, -s * dx + c * dy, wrap(GOAL[2] - theta)];
}

// (5), for a goal at rest
export function law([kx, ky, kt], xe, ye, te) {
  const [s, c] = [Math.sin(te), Math.cos(te)];
  // Never divide by less.
  const d = (s < 0 || Object.is(s, -0) ? -1 : 1) * Math.max(Math.abs(s), 1e-6);
  const cube = (ky * ye ** 3) / d;
  return [kx * xe * c - cube, kt * s + (cube * xe * c) / d + kx * xe * ye * c];
}

export function drive(gains) {
  let [x, y, theta] = START;
  let integral = 0;
  for (let n = 0; ; n += 1) {
    const t = n * DT;
    const [xe, ye, te] = error(x, y, theta);
    const gap = xe * xe + ye * ye + te * te;
    const arrived = Math.hypot(xe, ye) <= 0.05 && Math.abs(te) <= 0.05;
    if (arrived || t >= HORIZON) {
      const penalty = KAPPA * gains.reduce((sum, k) => sum + Math.max(0, -k), 0);
      return { J: t + W * gap + integral / 2 + penalty, time: t, arrived }; // (9)
    }
    const asked = law(gains, xe, ye, te);
    const [v, w] = [clamp(asked[0], V_MAX), clamp(asked[1], W_MAX)];
    integral += (gap + R_V * v * v + R_W * w * w) * DT;
    const h = (w * DT) / 2; // (2) along an exact arc
    const chord = v * DT * (h ? Math.sin(h) / h : 1);
    [x, y, theta] = [x + chord * Math.cos(theta + h), y + chord * Math.sin(theta + h), theta + 2 * h];
  }
}

const gauss = () => Math.sqrt(-2 * Math.log(1 - Math.random())) * Math.cos(2 * Math.PI * Math.random());
const born = (gains, sigmas) => ({ gains, sigmas, J: drive(gains).J });

export function generation(parents) {
  const [tau, common] = [1 / Math.sqrt(2 * Math.sqrt(3)), 1 / Math.sqrt(6)];
  const offspring = parents.map(({ gains, sigmas }) => {
    const child = gains.map((k, j) => k + sigmas[j] * gauss()); // mutate, with the parent's σ
    const shared = common * gauss();
    return born(
      child,
      sigmas.map((s) => s * Math.exp(shared + tau * gauss())),
    );
  });
  const all = [...parents, ...offspring];
  const met = (i) => all[(i + 1 + Math.floor(Math.random() * (2 * N - 1))) % (2 * N)]; // tournament
  const ranked = all.map((one, i) => ({
    one,
    wins: Array.from({ length: Q }).filter(() => one.J <= met(i).J).length,
  }));
  ranked.sort((a, b) => b.wins - a.wins || a.one.J - b.one.J);
  return ranked.slice(0, N).map(({ one }) => one); // survive
}

console.log(drive([3.23673, 0.09678, 5.17891]), drive([10, 10, 10]));
const first = () => 0.01 + 9.99 * Math.random();
let robots = Array.from({ length: N }, () => born([first(), first(), first()], [SIGMA, SIGMA, SIGMA]));
for (let g = 1; g <= 100; g += 1) robots = generation(robots);
console.log(
  'after 100 generations:',
  robots.reduce((a, b) => (b.J < a.J ? b : a)),
);
