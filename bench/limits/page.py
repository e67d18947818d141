#!/usr/bin/env python3
"""One page: what each quantity takes on the machine and on Mesa's llvmpipe, and what this processor
could do at best, all measured in one run on one core: page.py [--repeats N]

The limit counts only the work that nobody can leave out, by the figures of bench_limits. The
machine may be faster: blocks that hold one value are not written pixel by pixel. Milliseconds of
processor time; scripts/compare-peers limits builds what it needs.
"""
import argparse
import json
import os
import resource
import subprocess
import tempfile

BIN, OPENGL = "build/release/bin", "build/release/lib/opengl"
FILL = 100 * 1024 * 1024
WINDOW = 640 * 480
CLASS_VERTICES = 77628 // 2
FLOOR_CORNERS = 4 * 200 * 200


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--repeats", type=int, default=5)
    return parser.parse_args()


def output(*command, **environment):
    return subprocess.run(command, env=dict(os.environ, **environment), capture_output=True,
                          text=True, check=True).stdout


def frames(limit, repeats):
    """The workloads of bench_peers: the best of llvmpipe's ways, a view's first frame of ours."""
    texel = max(limit["load 4 texels"], limit["multiply a pixel"])
    vertex, color = limit["transform a vertex"], limit["add a colour"]
    depth = 4 * limit["set a byte of cache"]
    least = {"a": CLASS_VERTICES * vertex + WINDOW * depth,
             "c": 2 * CLASS_VERTICES * vertex + WINDOW * color,
             "d": 4 * WINDOW * texel, "e": 13 * WINDOW * texel, "f": 4 * WINDOW * texel,
             "g": 32 * WINDOW * texel, "h": 4 * WINDOW * texel,
             "j": FILL * color, "k": FILL * depth, "l": FILL * texel, "m": FILL * color,
             "n": FILL * depth}
    with tempfile.TemporaryDirectory() as folder:
        file = f"{folder}/frames.json"
        output(f"{BIN}/bench_peers", "--repeats", str(repeats), "--only", "".join(least), "--json",
               file)
        with open(file, encoding="utf-8") as text:
            rows = json.load(text)["workloads"]
    for row in rows:
        yield (f"{row['key']}  {row['name']}", least[row["key"]] * 1e-6, row["first_cpu_ms"],
               row["peer_cpu_ms"])


def draws(limit, repeats):
    """10,000 draws: their list has to be read, about 1,500 bytes for each state and draw."""
    printed = output(f"{BIN}/bench_draws", "--counts", "10000", "--repeats", str(repeats))
    least = 10000 * 1500 * limit["copy a byte of memory"] * 1e-6
    for line in printed.splitlines()[2:]:
        name, numbers = line[:26].strip(), line[26:].split()
        yield f"10,000 draws: {name}", least, float(numbers[1]), min(map(float, numbers[3:6]))


def robots(limit, repeats):
    """A robot simulator's picture: two maps are set, the floor's corners moved in six passes."""
    for shadow, samples in ((2048, 0), (4096, 0), (4096, 4), (8192, 4)):
        command = [f"{BIN}/bench_robot", "--shadow", str(shadow), "--samples", str(samples),
                   "--pictures", str(repeats)]
        times = {OPENGL: [], "": []}
        for _ in range(2):
            for library, each in times.items():
                each.append(float(output(*command, LD_LIBRARY_PATH=library, GW_THREADS="1",
                                         LP_NUM_THREADS="0").split()[0]))
        least = (2 * shadow * shadow * 4 * limit["set a byte of memory"]
                 + 6 * FLOOR_CORNERS * limit["transform a vertex"]) * 1e-6
        yield (f"robot 256x256, maps of {shadow}, {samples} samples", least, min(times[OPENGL]),
               min(times[""]))


def starts(_limit, repeats):
    """Whole processes; llvmpipe has none of its own."""
    def took(*command):
        best = None
        for _ in range(repeats):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            used = (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) * 1e3
            best = used if best is None else min(best, used)
        return best
    nothing = took("/bin/true")
    with tempfile.TemporaryDirectory() as folder:
        yield "gw --version, the whole process", nothing, took(f"{BIN}/gw", "--version"), None
        yield ("gw render of the teapot, 640x480", nothing,
               took(f"{BIN}/gw", "render", "scenes/teapot.toml", "--size", "640x480", "-o",
                    f"{folder}/teapot.png"), None)


def main():
    args = arguments()
    limit = json.loads(output(f"{BIN}/bench_limits"))
    print(f"{'one core can':32}{'ns':>8}")
    for name, value in limit.items():
        print(f"{name:32}{value:8.3f}")
    print(f"\n{'milliseconds':44}{'limit':>9}{'ours':>9}{'llvmpipe':>9}{'of limit':>10}"
          f"{'ratio':>8}")
    for rows in (frames, draws, robots, starts):
        for name, least, ours, theirs in rows(limit, args.repeats):
            of_limit = f"{ours / least:10.1f}" if least else f"{'':10}"
            beside = f"{theirs:9.2f}" if theirs else f"{'-':>9}"
            ratio = f"{theirs / ours:8.2f}" if theirs else ""
            print(f"{name:44}{least:9.2f}{ours:9.2f}{beside}{of_limit}{ratio}", flush=True)


main()
