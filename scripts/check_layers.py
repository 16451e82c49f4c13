#!/usr/bin/env python3
"""Reads the includes of modules/gmlpnp/src and fails where one breaks a law of doc/architecture.md.

Each folder is a room. A room may include rooms of lower floors only: no arrow runs upward, none across a floor, and so
there is no circle. Some rooms are stricter, see LAWS.
"""

import argparse
import pathlib
import re
import sys

# Floors from the ground up. Rooms of one floor do not know each other.
FLOORS = [
    ["math", "kernels"],
    ["arrays", "rays"],
    ["camera", "noise", "ransac"],
    ["estimator"],
    ["api", "draw"],
]

# What a room may include, where that is less than all lower floors: the reason is the law.
LAWS = {
    "kernels": (set(), "an inline function compiled for one instruction set must not be linked for all"),
    "arrays": ({"math"}, "arrays of a caller know neither points nor rays"),
    "rays": ({"math", "kernels"}, "correspondences know nothing of the caller's arrays"),
    "camera": ({"arrays"}, "a lens knows no solver: the solver sees rays alone"),
    "noise": ({"math", "kernels", "rays"}, "a noise knows neither the search nor the start"),
    "ransac": ({"math", "kernels", "rays"}, "the search knows no solve"),
    "estimator": ({"math", "kernels", "rays", "noise", "ransac"}, "the estimator sees neither pixels nor arrays"),
    "draw": ({"arrays"}, "drawing needs the public result alone"),
}

# Headers of no room: what every source may include.
COMMON = {"precomp.hpp"}

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def rooms_below(room):
    floor = next(k for k, rooms in enumerate(FLOORS) if room in rooms)
    return {below for rooms in FLOORS[:floor] for below in rooms}


def includes_of(path, source):
    """The rooms and files of the module that a file includes."""
    for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
        if name.startswith("opencv2/"):
            continue
        target = (path.parent / name).resolve()
        yield target.relative_to(source) if source in target.parents else pathlib.PurePath(name)


def violations(source):
    rooms = {room for floor in FLOORS for room in floor}
    for path in sorted(source.rglob("*.?pp")):
        here = path.relative_to(source)
        if len(here.parts) == 1:
            if here.name not in COMMON:
                yield f"{here}: stands in no room"
            continue
        room = here.parts[0]
        if room not in rooms:
            yield f"{here}: '{room}' is no room; add it to FLOORS and to doc/architecture.md"
            continue
        allowed, reason = LAWS.get(room, (rooms_below(room), "it is not on a lower floor"))
        for target in includes_of(path, source):
            if str(target) in COMMON or target.parts[0] == room:
                continue
            if not (source / target).exists():
                yield f"{here}: includes {target}, which is no file of the module"
            elif target.parts[0] not in allowed:
                yield f"{here}: '{room}' must not include {target}: {reason}"


def arrows(source):
    """The distinct pairs of rooms of which one includes the other."""
    found = set()
    for path in sorted(source.rglob("*.?pp")):
        room = path.relative_to(source).parts[0]
        for target in includes_of(path, source):
            if str(target) not in COMMON and target.parts[0] != room:
                found.add((room, target.parts[0]))
    return sorted(found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent / "modules" / "gmlpnp" / "src",
                        help="folder of the rooms (default: the module's)")
    parser.add_argument("--arrows", action="store_true", help="print which room includes which, and end")
    arguments = parser.parse_args()
    source = arguments.source.resolve()
    if not source.is_dir():
        parser.error(f"{source} is no folder")
    if arguments.arrows:
        print("\n".join(f"{room} -> {target}" for room, target in arrows(source)))
        return 0
    found = list(violations(source))
    print("\n".join(found) if found else f"{len(FLOORS)} floors, {len(arrows(source))} arrows between rooms, all downward")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
