#!/usr/bin/env python3
"""Checks that includes between rooms go one way: down, as rooms.txt lists them.

arrows.py [ROOT]         says each wrong include with its file and line; exit status 1 if there is one
arrows.py --draw [ROOT]  prints the rooms, upper ones first, each with those that it knows and no other of these does
"""
import collections
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
INCLUDE = re.compile(r'\s*#\s*include\s+[<"]([^>"]+)[>"]')
BULLET = re.compile(r"(bullet/)?(Bullet[A-Za-z0-9]*/|LinearMath/|bt[A-Z])")
SEARCHED = ("src", "include", "demos")  # where the path in an include begins


def read_rooms(path):
    """@return the floor of each room, from 0, and the rooms that know no Bullet"""
    floors, without_bullet, floor = {}, set(), 0
    with open(path, encoding="utf-8") as text:
        for line in text:
            names = line.split("#")[0].split()
            for name in names:
                floors[name.rstrip("*")] = floor
                if name.endswith("*"):
                    without_bullet.add(name.rstrip("*"))
            floor += bool(names)
    return floors, without_bullet


def stem(path):
    return os.path.splitext(os.path.basename(path))[0]


class Tree:
    """All sources below a root, and what each includes: (line, path as written, file or None)."""

    def __init__(self, root):
        self.root = root
        self.includes = {}
        for top in SEARCHED:
            for folder, _, names in os.walk(os.path.join(root, top)):
                for name in names:
                    if name.endswith((".h", ".cpp", ".inc")):
                        path = os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")
                        self.includes[path] = None
        for path in self.includes:
            self.includes[path] = list(self.read(path))
        self.home = {}  # of a public header: the room of the source that includes it first, best one of its name
        for path in sorted(self.includes):
            header = self.includes[path][0][2] if self.includes[path] else None
            if path.endswith(".cpp") and header and header.startswith("include/"):
                if header not in self.home or stem(path) == stem(header):
                    self.home[header] = os.path.dirname(path)

    def read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as text:
            for number, line in enumerate(text, 1):
                match = INCLUDE.match(line)
                if match:
                    yield number, match[1], self.find(path, match[1])

    def find(self, path, written):
        for folder in SEARCHED + (os.path.dirname(path),):
            whole = os.path.normpath(f"{folder}/{written}")
            if whole in self.includes:
                return whole
        return None

    def room_of(self, path):
        """None for a public header that stands for itself."""
        return self.home.get(path) if path.startswith("include/") else os.path.dirname(path)


def wrong_arrows(tree, floors):
    for path, includes in tree.includes.items():
        room = tree.room_of(path)
        if room is None:
            continue
        if room not in floors:
            yield f"{path}:1: the room {room} is not in rooms.txt"
            continue
        for line, written, target in includes:
            other = tree.room_of(target) if target else None
            if other in floors and other != room and floors[other] >= floors[room]:
                where = "beside" if floors[other] == floors[room] else "above"
                yield f'{path}:{line}: includes "{written}" of {other}, which is {where} {room}'


def way_to_bullet(tree, path, seen):
    """@return the includes from a file to a header of Bullet's or of the rooms that know it, or None"""
    for _, written, target in tree.includes[path]:
        if BULLET.match(written) and not target:
            return [written]
        if target in seen or not target:
            continue
        seen.add(target)
        way = way_to_bullet(tree, target, seen)
        if way:
            return [written] + way
    return None


def bullet_where_none_is(tree, without_bullet):
    for path, includes in tree.includes.items():
        if tree.room_of(path) not in without_bullet:
            continue
        for line, written, target in includes:
            if BULLET.match(written) and not target:
                yield f'{path}:{line}: includes "{written}", but {tree.room_of(path)} knows no Bullet'
            way = way_to_bullet(tree, target, {target}) if target else None
            if way:
                yield (f'{path}:{line}: includes "{written}", and so {", ".join(way)}, '
                       f"but {tree.room_of(path)} knows no Bullet")


def circles(tree):
    """Files that include themselves by way of others."""
    state = {}

    def visit(path):
        state[path] = "open"
        for line, written, target in tree.includes[path]:
            if state.get(target) == "open":
                yield f'{path}:{line}: includes "{written}", which includes it'
            elif target and target not in state:
                yield from visit(target)
        state[path] = "done"

    for path in tree.includes:
        if path not in state:
            yield from visit(path)


def drawing(tree, floors):
    """@return a line for each room, upper ones first, with those that it knows and no other of these does"""
    known = collections.defaultdict(set)
    for path, includes in tree.includes.items():
        room = tree.room_of(path)
        known[room].update(tree.room_of(target) for _, _, target in includes if target)
    for room in list(known):
        known[room] = {other for other in known[room] if floors.get(other, sys.maxsize) < floors.get(room, 0)}

    def below(room):
        return known[room].union(*(below(other) for other in known[room]))

    def from_above(rooms):
        return sorted(rooms, key=lambda room: (-floors[room], room))

    for room in from_above(floors):
        direct = known[room] - set().union(*(below(other) for other in known[room]))
        yield f"{room:<26}{'-> ' if direct else ''}{'  '.join(from_above(direct))}".rstrip()


def shown_otherwise(root, lines):
    """What CONTRIBUTING.md draws of the library must be so."""
    with open(os.path.join(root, "CONTRIBUTING.md"), encoding="utf-8") as text:
        shown = text.read().splitlines()
    for line in lines:
        if line.startswith("src/") and line not in shown:
            yield f"CONTRIBUTING.md:1: lacks what arrows.py --draw prints: {line}"


def check(root):
    floors, without_bullet = read_rooms(os.path.join(HERE, "rooms.txt"))
    tree = Tree(root)
    found = [*wrong_arrows(tree, floors), *bullet_where_none_is(tree, without_bullet), *circles(tree)]
    empty = set(floors) - {tree.room_of(path) for path in tree.includes}
    found += [f"rooms.txt:1: there is no room {room}" for room in sorted(empty)]
    return found or list(shown_otherwise(root, drawing(tree, floors)))


def main():
    arguments = sys.argv[1:]
    rest = [argument for argument in arguments if argument != "--draw"]
    root = rest[0] if rest else os.path.join(HERE, "..", "..")
    if "--draw" in arguments:
        print("\n".join(drawing(Tree(root), read_rooms(os.path.join(HERE, "rooms.txt"))[0])))
        return 0
    found = check(root)
    print("\n".join(found) if found else "all includes go down")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
