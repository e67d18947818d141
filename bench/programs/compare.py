#!/usr/bin/env python3
"""Frames a second of programs on two implementations of OpenGL: compare.py [--only NAMES] [--sizes
WxH ..] [--threads N ..] [--real]

Each program runs on the machine's libGL.so.1 and on Mesa's llvmpipe in turn, in windows of one X
server. Prints frames a second of both, medians of the repeats, the ratio, and the share of pixels
of a last frame that differ by more than 8 of 255.

--real: programs of Debian, unmodified, in place of those of bench_programs. A preloaded library
fixes their clock, so both sides draw the same frames.
"""
import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile


HACKS = "/usr/libexec/xscreensaver"
REAL = {"glxgears": ["glxgears"]} | {
    name: [f"{HACKS}/{name}", "--window", "--delay", "0"]
    for name in ["gears", "atlantis", "bouncingcow", "cage", "circuit", "flurry", "glmatrix",
                 "glplanet", "lament", "molecule", "morph3d",
                 "pipes", "rubik", "sballs", "sproingies", "starwars", "superquadrics"]}


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", default="build/release/bin/bench_programs")
    parser.add_argument("--lib", default="build/release/lib/opengl",
                        help="folder of our libGL.so.1")
    parser.add_argument("--only", nargs="*", default=[], help="names of programs")
    parser.add_argument("--sizes", nargs="*", default=["640x480", "1280x960"])
    parser.add_argument("--threads", nargs="*", type=int, default=[1, 2])
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--real", action="store_true")
    parser.add_argument("--meter", default="build/release/lib/bench_frame_meter.so",
                        help="ends a real program after 100 frames")
    parser.add_argument("--json", help="a file for the figures")
    return parser.parse_args()


def environment(side, threads, lib):
    """llvmpipe draws in the calling thread for 1, else with as many workers."""
    env = dict(os.environ, vblank_mode="0")
    if side == "ours":
        return dict(env, LD_LIBRARY_PATH=lib, GW_THREADS=str(threads))
    return dict(env, LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe",
                LP_NUM_THREADS="0" if threads == 1 else str(threads))


def run(args, side, name, size, threads, picture):
    """Seconds of wall time and of the processor, a frame."""
    width, height = size.split("x")
    pinned = ["taskset", "-c", ",".join(str(i) for i in range(threads))]
    env = environment(side, threads, args.lib)
    if args.real:
        command = pinned + REAL[name] + ["-geometry", size]
        env |= {"LD_PRELOAD": os.path.abspath(args.meter), "FRAME_METER": picture + ".txt",
                "FRAME_METER_PICTURE": picture}
    else:
        command = pinned + [args.bin, name, "--width", width, "--height", height, "--picture",
                            picture]
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"compare.py: {' '.join(command)} on {side}: {done.stderr}")
    printed = done.stdout
    if args.real:
        with open(picture + ".txt", encoding="utf-8") as file:
            printed = file.read()
    wall, processor, frames, renderer = printed.split(None, 3)
    if (side == "ours") == ("llvmpipe" in renderer):
        sys.exit(f"compare.py: {side} was drawn by {renderer}")
    return float(wall) / int(frames), float(processor) / int(frames)


def pixels_off(a, b):
    """Share of pixels of two PPM files of one size with a channel that differs by more than 8."""
    with open(a, "rb") as first, open(b, "rb") as second:
        x, y = first.read(), second.read()
    header = x.index(b"255\n") + 4
    starts = range(header, len(x), 3)
    off = sum(1 for i in starts if x[i:i + 3] != y[i:i + 3]
              and max(abs(x[i + k] - y[i + k]) for k in range(3)) > 8)
    return off / len(starts)


def compare(args, name, size, threads, folder):
    times = {"ours": [], "llvmpipe": []}
    pictures = {side: f"{folder}/{side}.ppm" for side in times}
    for _ in range(args.repeats):
        for side, each in times.items():
            each.append(run(args, side, name, size, threads, pictures[side]))
    wall = {side: statistics.median(t[0] for t in each) for side, each in times.items()}
    processor = {side: statistics.median(t[1] for t in each) for side, each in times.items()}
    return {"program": name, "size": size, "threads": threads,
            "ours": 1 / wall["ours"], "llvmpipe": 1 / wall["llvmpipe"],
            "ratio": wall["llvmpipe"] / wall["ours"],
            "processor ratio": processor["llvmpipe"] / processor["ours"],
            "pixels off": pixels_off(*pictures.values())}


def main():
    args = arguments()
    listed = subprocess.run([args.bin], capture_output=True, text=True,
                            check=True).stdout.splitlines()
    if args.real and not os.path.exists(args.meter):
        sys.exit(f"compare.py: {args.meter} is not there; expected a build of bench_frame_meter")
    every = REAL if args.real else [line.split()[0] for line in listed]
    names = [name for name in every if not args.only or name in args.only]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for size in args.sizes:
            for threads in args.threads:
                print(f"\n{size}, {threads} thread(s); frames a second, medians of {args.repeats}")
                print(f"{'program':14}{'ours':>9}{'llvmpipe':>10}{'ratio':>8}{'processor':>11}"
                      f"{'pixels off':>12}", flush=True)
                part = []
                for name in names:
                    row = compare(args, name, size, threads, folder)
                    part.append(row)
                    print(f"{name:14}{row['ours']:9.1f}{row['llvmpipe']:10.1f}{row['ratio']:8.2f}"
                          f"{row['processor ratio']:11.2f}{row['pixels off']:11.2%}", flush=True)
                print(f"{'median':14}{'':19}{statistics.median(r['ratio'] for r in part):8.2f}"
                      f"{statistics.median(r['processor ratio'] for r in part):11.2f}")
                rows += part
    if args.json:
        with open(args.json, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)


main()
