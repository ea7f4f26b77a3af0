# The posture controller of Kim and Shim (1995) with the gains of one drive.
# From ep-locomotion 0.1.0:
# index.html#lab&v=1&generation=100
# On the page J = 7.708613859783892; the robot parks in 1.91 s.
# To run it: python3 evolved.py

import math

KX, KY, KTHETA = 3.21543085583058, 6.971949641316123e-5, 4.34504855513044  # kx (1/s), ky (1/(m² s)), kθ (rad/s); lengths in m only: ω has a hidden 1/m²
V_R, W_R = 0, 0                                                            # how the goal moves: m/s, rad/s
DT = 0.01                                                                  # s from one command to the next
SPEED, TURN_RATE = 2, 6.283185307179586                                    # limits of velocity: m/s, rad/s
SMALLEST = 1e-6                                                            # never divide by less


def command(pose, goal, previous):
    """The velocity (v, w), in m/s and rad/s, that the robot shall have until the next command:
    for its pose (x, y, theta), the goal, and the velocity that it had until now, (0, 0) at
    rest.

    In ROS 2, v is linear.x and w is angular.z of a geometry_msgs/msg/Twist, and all else in
    it is 0. Publish one every DT seconds; the pose is x, y and yaw of the odometry or of
    tf, in the frame in which the goal is given.

    Two wheels of radius r, with b between them, turn at (v + w b / 2) / r on the right and
    (v - w b / 2) / r on the left, in rad/s.
    """
    # the law (5)
    xe, ye, te = error(pose, goal)
    s, c = math.sin(te), math.cos(te)
    cosec, sec = inverse(s), inverse(c)
    steer = KY * ye * ye * ye * cosec
    v = KX * xe * c - steer + V_R * sec
    w = W_R + KTHETA * s + steer * xe * c * cosec + KX * xe * ye * c + ye * V_R * sec
    # what the motors can do of it: the velocity first, then its change
    v = clamp(v, -SPEED, SPEED)
    w = clamp(w, -TURN_RATE, TURN_RATE)
    return v, w


def error(pose, goal):
    """The error posture (3): from the robot to the goal, along the axes of the goal."""
    x, y, theta = pose
    xr, yr, thetar = goal
    s, c = math.sin(thetar), math.cos(thetar)
    return c * (xr - x) + s * (yr - y), -s * (xr - x) + c * (yr - y), wrap(thetar - theta)


def wrap(angle):
    """The same angle, in (-pi, pi]."""
    if not math.isfinite(angle):
        return math.nan
    return angle - 2 * math.pi * math.ceil((angle - math.pi) / (2 * math.pi))


def inverse(s):
    """1 / s, as if |s| were never less than the smallest divisor."""
    return 1 / math.copysign(max(abs(s), SMALLEST), s)


def clamp(value, low, high):
    """The value, within low and high; NaN stays NaN."""
    return low if value < low or math.isnan(low) else min(value, high)


# the drive of the page

START = (0, 0, 0)                  # x (m), y (m), θ (rad); at rest
GOAL = (2, 2, 0.7853981633974483)  # x (m), y (m), θ (rad)
HORIZON = 10                       # s; then it is over
POSITION, HEADING = 0.05, 0.05     # m, rad: so near is parked
W_X, W_Y, W_THETA = 1, 1, 1        # W, on the last error
R_V, R_W = 1, 1                    # R, on the velocity
PENALTY = 1000                     # κ, on negative gains


def advance(pose, q):
    """The pose one sample later: along an exact arc (2)."""
    x, y, theta = pose
    v, w = q
    h = w * DT / 2
    chord = v * DT * (math.sin(h) / h if h else 1)
    return x + chord * math.cos(theta + h), y + chord * math.sin(theta + h), theta + 2 * h


def drive():
    """Drives as the page does, and gives t_f, the cost J (9) and the last pose."""
    pose, goal, q = START, GOAL, (0, 0)
    n, integral = 0, 0
    while True:
        dx, dy, dtheta = goal[0] - pose[0], goal[1] - pose[1], wrap(goal[2] - pose[2])
        square = dx * dx + dy * dy + dtheta * dtheta
        parked = dx * dx + dy * dy <= POSITION**2 and abs(dtheta) <= HEADING
        if parked or n * DT >= HORIZON:
            break
        v, w = q = command(pose, goal, q)
        integral += (square + R_V * v * v + R_W * w * w) * DT
        pose = advance(pose, q)
        n += 1
    time = n * DT if parked else HORIZON
    last = W_X * dx * dx + W_Y * dy * dy + W_THETA * dtheta * dtheta
    penalty = PENALTY * sum(max(0, -k) for k in (KX, KY, KTHETA))
    return time, time + last + integral / 2 + penalty, pose


def main():
    time, cost, pose = drive()
    # what the page says: t_f, J, and the last pose
    page = 1.9100000000000001, 7.708613859783892, 1.9631679198156953, 1.9665637036157229, 0.7868074886504495
    for name, own, said in zip(("t_f (s)", "J", "x (m)", "y (m)", "theta (rad)"), (time, cost, *pose), page):
        print(f"{name:12}{own:<20.12g}page {said:.12g}")


if __name__ == "__main__":
    main()
