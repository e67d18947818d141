"""Schumacker's clusters: the tree's numbers, priorities for every eye, the eye's sides."""
from oracle.compare import Spread, Near, Oracle, of
from oracle.pieces import Pieces
from oracle.trees import eye_side
from oracle.vectors import dot

LARGEST = 512  # faces of a cluster that are compared with each other


class Node:
    def __init__(self, number, pieces, plane):
        self.number, self.pieces, self.plane = number, list(pieces), plane
        self.front = self.back = None


class Schumacker(Oracle):
    def __init__(self, run):
        super().__init__(run)
        self.pieces, self.priorities, self.visits = Pieces(run), {}, None
        clusters = (s for s in run.steps if s["test"] == "cluster")
        self.nodes = []
        self.root = self.read(clusters)
        self.next = 0

    def read(self, clusters):
        """A separating plane, then all of its front side, then all of its back side."""
        step = next(clusters)
        node = Node(len(self.nodes), step.get("pieces", []), step["values"].get("plane"))
        self.nodes.append(node)
        if step["result"] == "separated":
            node.front, node.back = self.read(clusters), self.read(clusters)
            node.pieces = node.front.pieces + node.back.pieces
        return node

    @of("split plane")
    def split(self, said):
        first, second = said.pieces
        distances = [Near(d) for d in self.pieces.distances(first, self.pieces.plane(second))]
        wrong = self.pieces.cut(first, second, said.made)
        return wrong or {"distances": Spread(distances)}

    def separates(self, node):
        """The plane that was chosen keeps its two sides apart, and is that of a face, or lies
        across an axis in the middle of a gap."""
        plane, tolerance = node.plane, self.pieces.tolerance
        front = [p for name in node.front.pieces for p in self.pieces.corners(name)]
        back = [p for name in node.back.pieces for p in self.pieces.corners(name)]
        def distance(p):
            return dot(plane, p) + plane[3]
        if min(map(distance, front)) < -tolerance or max(map(distance, back)) > tolerance:
            return False
        for axis in range(3):
            if plane[axis] == 1:
                middle = (min(p[axis] for p in front) + max(p[axis] for p in back)) / 2
                if abs(plane[3] + middle) < 1e-9:
                    return True
        return any(max(abs(a - b) for a, b in zip(self.pieces.plane(name), plane)) < 1e-9
                   for name in node.pieces)

    @of("cluster separated")
    def separated(self, said):
        node, self.next = self.nodes[self.next], self.next + 1
        if not self.separates(node):
            return f"the plane {node.plane} does not separate"
        return {"node": node.number, "front": node.front.number, "back": node.back.number}

    @of("cluster ranked")
    def ranked(self, said):
        node, self.next = self.nodes[self.next], self.next + 1
        found = self.rank(node.pieces)
        self.priorities.update(zip(node.pieces, found))
        return {"node": node.number, "front": [f for f, _ in found], "back": [b for _, b in found]}

    def rank(self, names):
        """For each face (its front's, its back's): 1 more than the greatest priority of a side
        that may hide it."""
        size, tolerance = len(names), self.pieces.tolerance
        planes = [self.pieces.plane(name) for name in names]
        if size > LARGEST:
            return self.solid(names, planes)
        reach = [[self.reach(a, plane, tolerance) for plane in planes] for a in names]
        hides = {}
        for i in range(size):
            for k in range(size):
                if i == k:
                    continue
                of_i, of_k = reach[i][k], reach[k][i]
                for a in (0, 1):
                    for b in (0, 1):
                        if not any(of_i + of_k):  # one plane: the first is seen
                            same = dot(planes[i], planes[k]) > 0
                            yes = i < k and same == (a == b)
                        else:
                            yes = of_i[b] and of_k[1 - a]
                        if yes:
                            hides.setdefault((i, a), []).append((k, b))
        rank, waiting = {(i, a): 1 for i in range(size) for a in (0, 1)}, {}
        for targets in hides.values():
            for b in targets:
                waiting[b] = waiting.get(b, 0) + 1
        free, done = [s for s in rank if s not in waiting], 0
        while free:
            a = free.pop()
            done += 1
            for b in hides.get(a, []):
                rank[b] = max(rank[b], rank[a] + 1)
                waiting[b] -= 1
                if not waiting[b]:
                    free.append(b)
        if done < 2 * size:
            return self.solid(names, planes)
        return [(rank[i, 0], rank[i, 1]) for i in range(size)]

    def reach(self, name, plane, tolerance):
        """Whether the piece has points in front of the plane, and behind it."""
        d = self.pieces.distances(name, plane)
        return max(d) > tolerance, min(d) < -tolerance

    def solid(self, names, planes):
        """No face lies before another's plane: outer sides 1, the inner sides of a solid 2."""
        tolerance = self.pieces.tolerance
        inner = 2 if any(self.reach(n, planes[0], tolerance)[1] for n in names) else 1
        return [(1, inner)] * len(names)

    @of("eye-side front", "eye-side back", "eye-side front-parallel", "eye-side back-parallel")
    def eye_side(self, said):
        if self.visits is None:
            self.visits, todo = [], [self.root]
            while todo:
                node = todo.pop()
                if not node.front:
                    continue
                self.visits.append(node)
                before = self.camera.before(node.plane) >= 0
                todo += [node.front, node.back] if before else [node.back, node.front]
            self.visits.reverse()
        node = self.visits.pop()
        return eye_side(self.camera, said, node)

    @of("priority front", "priority back")
    def priority(self, said):
        name = said.pieces[0]
        before = self.camera.before(self.pieces.plane(name))
        if abs(before) > 1e-9 and (before > 0) != (said.result == "front"):
            return "the eye sees the other side"
        return {"priority": self.priorities[name][said.result == "back"]}

    @of("draw piece")
    def draw(self, said):
        return {"pixels": self.pieces.pixels(said.pieces[0])}

    def finish(self):
        return ["nodes are missing"] if self.visits or self.next < len(self.nodes) else []
