# Kim and Shim's parking robot and its evolution, in the symbols of the lesson. Python 3, nothing else is needed.
import math
import random

START, GOAL = (0, 0, 0), (2, 2, math.pi / 4)     # x, y in m, θ in rad
DT, HORIZON = 0.01, 10                           # s
V_MAX, W_MAX = 2, 2 * math.pi                    # m/s, rad/s
R_V, R_W, W, KAPPA = 1, 1, 1, 1000               # weights of J
N, Q, SIGMA = 20, 10, 1                          # robots, bouts for each, first σ


def wrap(angle):
    return angle - 2 * math.pi * round(angle / (2 * math.pi))


def error(x, y, theta):                          # (3)
    dx, dy, s, c = GOAL[0] - x, GOAL[1] - y, math.sin(GOAL[2]), math.cos(GOAL[2])
    return c * dx + s * dy, -s * dx + c * dy, wrap(GOAL[2] - theta)


def law(gains, xe, ye, te):                      # (5), for a goal at rest
    (kx, ky, kt), s, c = gains, math.sin(te), math.cos(te)
    d = math.copysign(max(abs(s), 1e-6), s)      # never divide by less
    cube = ky * ye ** 3 / d
    return kx * xe * c - cube, kt * s + cube * xe * c / d + kx * xe * ye * c


def drive(gains):
    x, y, theta = START
    t, integral, n = 0, 0, 0
    while True:
        xe, ye, te = error(x, y, theta)
        arrived = math.hypot(xe, ye) <= 0.05 and abs(te) <= 0.05
        if arrived or t >= HORIZON:
            break
        v, w = law(gains, xe, ye, te)
        v, w = max(-V_MAX, min(V_MAX, v)), max(-W_MAX, min(W_MAX, w))
        integral += (xe * xe + ye * ye + te * te + R_V * v * v + R_W * w * w) * DT
        h = w * DT / 2                           # (2) along an exact arc
        chord = v * DT * (math.sin(h) / h if h else 1)
        x, y, theta = x + chord * math.cos(theta + h), y + chord * math.sin(theta + h), theta + 2 * h
        n += 1
        t = n * DT
    final = W * (xe * xe + ye * ye + te * te)
    penalty = KAPPA * sum(max(0, -k) for k in gains)
    return t + final + integral / 2 + penalty, t, arrived   # (9): J, t_f


def generation(parents):                         # each is (gains, sigmas, J)
    tau, common = 1 / math.sqrt(2 * math.sqrt(3)), 1 / math.sqrt(6)
    everyone = list(parents)
    for gains, sigmas, _ in parents:             # mutate, with the parent's σ
        child = [k + s * random.gauss(0, 1) for k, s in zip(gains, sigmas)]
        shared = common * random.gauss(0, 1)
        steps = [s * math.exp(shared + tau * random.gauss(0, 1)) for s in sigmas]
        everyone.append((child, steps, drive(child)[0]))
    wins = []
    for i, (_, _, cost) in enumerate(everyone):  # tournament
        others = everyone[:i] + everyone[i + 1:]
        wins.append(sum(cost <= random.choice(others)[2] for _ in range(Q)))
    order = sorted(range(2 * N), key=lambda i: (-wins[i], everyone[i][2]))
    return [everyone[i] for i in order[:N]]      # survive


if __name__ == "__main__":
    print(*drive((3.23673, 0.09678, 5.17891)), *drive((10, 10, 10)), sep="\n")
    robots = [([random.uniform(0.01, 10) for _ in range(3)], [SIGMA] * 3) for _ in range(N)]
    population = [(gains, sigmas, drive(gains)[0]) for gains, sigmas in robots]
    for g in range(1, 101):
        population = generation(population)
    best = min(population, key=lambda one: one[2])
    print("after 100 generations: J", best[2], "with", best[0])
