"""BSP trees and Quake's sorted spans: nodes, the eye's side of their planes, keys, and the edges
and surfaces of each line."""
from oracle.compare import Spread, Near, Oracle, of, window
from oracle.pieces import Pieces


class Node:
    def __init__(self, parent, side, pieces):
        self.parent, self.side, self.waiting = parent, side, pieces
        self.number, self.plane, self.pieces, self.front, self.back = None, None, [], None, None


def eye_side(camera, said, node):
    """The numbers of the eye's side of a node's plane."""
    before = camera.before(node.plane)
    if abs(before) > 1e-9 and said.result.startswith("front") != (before > 0):
        return f"the eye is {before} before it"
    if said.result.endswith("parallel") != camera.parallel:
        return "lines of sight are parallel, or not"
    return {"node": node.number, "N_d" if camera.parallel else "D": Near(before)}


class Bsp(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.pieces, self.cuts = Pieces(run), set()
        self.root = Node(None, "root", list(self.pieces.world))
        self.open, self.nodes, self.visits, self.drawn = [self.root], [], None, []

    @of("split plane")
    def split(self, said):
        first, second = said.pieces
        distances = [Near(d) for d in self.pieces.distances(first, self.pieces.plane(second))]
        wrong = self.pieces.cut(first, second, said.made)
        self.cuts.add(first)
        return wrong or {"distances": Spread(distances)}

    @of("tree-node root", "tree-node front", "tree-node back")
    def node(self, said):
        name = said.pieces[0]
        node = next((n for n in self.open if name in n.waiting), None)
        if node is None or node.side != said.result:
            return "no node waits there"
        self.open.remove(node)
        node.number, node.plane = len(self.nodes), self.pieces.plane(name)
        self.nodes.append(node)
        front, back, in_plane = [], [], {name}
        for piece in node.waiting:
            if piece == name:
                continue
            if piece in self.cuts:
                front.append(piece + "a")
                back.append(piece + "b")
                continue
            d = self.pieces.distances(piece, node.plane)
            least, most = min(d), max(d)
            tolerance = self.pieces.tolerance
            if most <= tolerance and least >= -tolerance:
                in_plane.add(piece)
            elif least >= -tolerance:
                front.append(piece)
            elif most <= tolerance:
                back.append(piece)
            else:
                return f"{piece} is not cut"
        if in_plane != set(said.pieces):
            return f"in the plane are {sorted(in_plane)}"
        node.pieces = said.pieces
        if front:
            node.front = Node(node, "front", front)
            self.open.append(node.front)
        if back:
            node.back = Node(node, "back", back)
            self.open.append(node.back)
        found = {"node": node.number, "in_front": len(front), "behind": len(back),
                 "plane": [Near(v) for v in node.plane]}
        if node.parent:
            found["parent"] = node.parent.number
        return found

    def walk(self):
        """Far to near. Fills `visits`, the nodes in the order in which the eye's side is asked,
        and `drawn`."""
        self.visits, todo = [], [self.root]
        while todo:
            node = todo.pop()
            if isinstance(node, list):
                self.drawn += node
                continue
            self.visits.append(node)
            far, near = node.front, node.back
            if self.camera.before(node.plane) >= 0:
                far, near = near, far
            todo += [n for n in (near, node.pieces[::-1], far) if n]
        self.visits.reverse()

    @of("eye-side front", "eye-side back", "eye-side front-parallel", "eye-side back-parallel")
    def eye_side(self, said):
        if self.visits is None:
            self.walk()
        if not self.visits:
            return "one node too many"
        node = self.visits.pop()
        return eye_side(self.camera, said, node)

    @of("draw piece")
    def draw(self, said):
        self.drawn = self.drawn[self.drawn.index(said.pieces[0]) + 1:]
        return {"pixels": self.pieces.pixels(said.pieces[0])}

    def finish(self):
        return ["nodes are missing"] if self.visits or self.open else []


class Quake(Bsp):
    kinds = {kind: method for kind, method in Bsp.kinds.items() if kind != ("draw", "piece")}

    def __init__(self, run):
        super().__init__(run)
        self.keys, self.rows, self.last_key = {}, None, None
        self.lines = set()
        stacks = [s for s in run.steps if s["test"] == "surface-stack"]
        self.last_at = {tuple(s["window"][:2]): s["step"] for s in stacks if "window" in s}

    @of("key given")
    def key(self, said):
        name = said.pieces[0]
        if not self.keys:
            self.order = {p: len(self.drawn) - 1 - i for i, p in enumerate(self.drawn)}
        self.keys[name] = self.order[name]
        if self.last_key is not None and self.last_key <= self.keys[name]:
            return "keys are not far to near"
        self.last_key = self.keys[name]
        return {"key": self.keys[name]}

    def surfaces(self):
        """{row: {piece: [(first, after the last)]}}, runs that touch joined."""
        if self.rows is None:
            self.rows = {}
            for name in self.keys:
                for y, x in sorted(self.pieces.pixels_of(name)[0]):
                    found = self.rows.setdefault(y, {}).setdefault(name, [])
                    if found and found[-1][1] == x:
                        found[-1] = found[-1][0], x + 1
                    else:
                        found.append((x, x + 1))
        return self.rows

    def finish(self):
        rest = set(self.surfaces()) - self.lines
        return super().finish() + ([f"rows {rest} are missing"] if rest else [])

    @of("active-edges sorted")
    def edges(self, said):
        self.lines.add(said.window[1])
        row = self.surfaces().get(said.window[1], {})
        ends = sorted((x, name) for name, runs in row.items() for run in runs for x in run)
        if sorted(said.pieces) != sorted(name for _, name in ends):
            return f"the edges are {ends}"
        self.left = {x for x, _ in ends}
        return {"x": [x for x, _ in ends], **window(0, said.window[1], self.size[0])}

    @of("surface-stack top", "surface-stack empty")
    def stack(self, said):
        if said.window is None:
            x, over = self.size[0], None
        else:
            x, row = said.window[0], self.surfaces()[said.window[1]]
            if x not in self.left:
                return "no edge is there"
            over = {n for n, runs in row.items() if any(a <= x < b for a, b in runs)}
            ended = {n for n, runs in row.items() if any(x == b for a, b in runs)}
            if not set(said.pieces) <= over | ended:
                return f"over the pixel are {sorted(over)}"
            if self.last_at[x, said.window[1]] == said.number:
                top = min(over, key=self.keys.get, default=None)
                if (said.pieces or [None])[0] != top:
                    return f"on top is {top}"
        found = {"x": x, "keys": sorted(self.keys[name] for name in said.pieces)}
        return found | (window(x, said.window[1], 1) if said.window else {})

    @of("draw line")
    def line(self, said):
        row, spans, last = self.surfaces()[said.window[1]], 0, None
        for x in range(self.size[0]):
            over = [(self.keys[name], name) for name, runs in row.items()
                    if any(a <= x < b for a, b in runs)]
            top = int(min(over)[1].rstrip("ab").split(".")[0]) if over else None
            spans += top is not None and top != last
            last = top
        return {"spans": spans, **window(0, said.window[1], self.size[0])}
