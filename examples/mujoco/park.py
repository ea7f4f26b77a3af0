"""Drives a robot with mass, friction and weak motors by controllers that the page exported.

    pip install mujoco
    python park.py controllers/*.py
    python park.py --picture paths.svg controllers/*.py
"""

import argparse
import glob
import math
import pathlib
import types

import mujoco

RADIUS, TRACK = 0.05, 0.26  # m, of robot.xml
HERE = pathlib.Path(__file__).parent


def load(path):
    """A controller that the page exported, as a module; or one sentence says what is wrong."""
    module = types.ModuleType(path.stem)
    module.__file__ = str(path)
    try:
        text = path.read_bytes()
    except OSError as error:
        raise SystemExit(f"{path} cannot be read: {error.strerror}.")
    try:
        exec(compile(text, path, "exec"), vars(module))
    except Exception:
        module.__dict__.clear()
    if not hasattr(module, "command"):
        raise SystemExit(f"{path} is not a controller that the page exported as Python.")
    return module


def pose_of(data, turns):
    """Where the robot is: x, y, and the heading with its full turns counted on from `turns`."""
    x, y, _, qw, qx, qy, qz = data.qpos[:7]
    yaw = math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz))
    return float(x), float(y), yaw + 2 * math.pi * round((turns - yaw) / (2 * math.pi))


def place(data, pose):
    """Puts the robot on the floor at a pose, at rest."""
    x, y, theta = pose
    data.qpos[:7] = x, y, 0.05, math.cos(theta / 2), 0, 0, math.sin(theta / 2)


def park(controller):
    """Whether the robot parks, by the page's own rule, when, and the poses on its way."""
    model = mujoco.MjModel.from_xml_path(str(HERE / "robot.xml"))
    data = mujoco.MjData(model)
    place(data, controller.START)
    mujoco.mj_forward(model, data)
    steps = round(controller.DT / model.opt.timestep)
    pose, q, path = controller.START, (0, 0), []
    for n in range(round(controller.HORIZON / controller.DT)):
        pose = pose_of(data, pose[2])
        path.append(pose)
        distance = math.dist(pose[:2], controller.GOAL[:2])
        turn = abs(controller.wrap(controller.GOAL[2] - pose[2]))
        speed, turn_rate = map(abs, q)
        slow = speed <= getattr(controller, "SLOW", math.inf) and turn_rate <= getattr(controller, "SLOW_TURN", math.inf)
        if distance <= controller.POSITION and turn <= controller.HEADING and slow:
            return True, n * controller.DT, path
        v, w = q = controller.command(pose, controller.GOAL, q)
        data.actuator("left").ctrl = (v - w * TRACK / 2) / RADIUS
        data.actuator("right").ctrl = (v + w * TRACK / 2) / RADIUS
        mujoco.mj_step(model, data, steps)
    return False, controller.HORIZON, path


COLOURS = "#0067a8", "#00734f", "#b4480a", "#6a3d9a"


def picture(drives):
    """The paths seen from above, as SVG: 160 pixels a metre; dashed where the robot does not park."""
    places = [(x, y) for _, _, path in drives for x, y, _ in path]
    west, east = min(x for x, _ in places) - 0.4, max(x for x, _ in places) + 0.4
    south, north = min(y for _, y in places) - 0.4, max(y for _, y in places) + 0.4
    legend = 26 * len(drives) + 16
    width, height = max(640, 160 * (east - west)), 160 * (north - south) + legend
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" font-family="system-ui, sans-serif" font-size="15">',
        f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fcfcfa"/>',
        f'<path d="M{width - 180:.0f} {height - 28:.0f}h160m0-5v10m-160 0v-10" fill="none" stroke="#59626d"/>',
        f'<text x="{width - 100:.0f}" y="{height - 34:.0f}" fill="#59626d" text-anchor="middle">1 m</text>',
    ]
    for i, (text, has_parked, path) in enumerate(drives):
        colour = COLOURS[i % len(COLOURS)]
        dash = "" if has_parked else ' stroke-dasharray="6 4"'
        at = [(160 * (x - west), legend + 160 * (north - y), t) for x, y, t in path]
        points = " ".join(f"{x:.1f},{y:.1f}" for x, y, _ in at)
        lines.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2.5"{dash}/>')
        for x, y, t in [*at[:100:25], at[-1]]:
            turned = f'transform="translate({x:.1f} {y:.1f}) rotate({-math.degrees(t):.1f})"'
            lines.append(f'<path d="M-22-18h44v36h-44zM22 0h10" {turned} fill="none" stroke="{colour}" stroke-opacity="0.6"/>')
        y = 26 * (i + 1)
        lines.append(f'<path d="M16 {y - 5}h36" stroke="{colour}" stroke-width="2.5"{dash}/>')
        lines.append(f'<text x="60" y="{y}" fill="#1b1f24">{text}</text>')
    return "\n".join([*lines, "</svg>", ""])


def main():
    parser = argparse.ArgumentParser(description="Parks a robot in MuJoCo by controllers that the page exported.")
    parser.add_argument("--picture", help="where to draw the paths, as SVG")
    parser.add_argument("controllers", nargs="+")
    asked = parser.parse_args()
    # Not every shell puts names in the place of * and ~.
    given = [str(pathlib.Path(one).expanduser()) for one in asked.controllers]
    paths = [pathlib.Path(path) for one in given for path in sorted(glob.glob(one)) or [one]]
    drives = []
    for path in paths:
        controller = load(path)
        if not hasattr(controller, "POSITION"):
            raise SystemExit(f"{path.name} follows a goal that moves, and never parks.")
        has_parked, time, poses = park(controller)
        on_page = controller.drive()[0]
        here = f"parks in {time:.2f} s" if has_parked else f"does not park within {time:g} s"
        text = f"{path.stem}: {here} (on the page {on_page:.2f} s)"
        print(text)
        drives.append((text, has_parked, poses))
    if asked.picture:
        pathlib.Path(asked.picture).write_text(picture(drives), encoding="utf-8")


if __name__ == "__main__":
    main()
