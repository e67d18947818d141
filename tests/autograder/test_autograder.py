#!/usr/bin/env python3
"""gw autograde: a submission costs its own student's mark only, whatever it does. The files of
marks are read by other readers than ours.
Usage: test_autograder.py GW SOURCE_DIR WORK_DIR
"""
import csv
import html.parser
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

gw, source, work = (pathlib.Path(word).absolute() for word in sys.argv[1:4])
scene = source / "scenes/hidden/centroid_fails.toml"
examples = source / "examples/autograder/class"
width, height = 64, 48
secret, marker = work / "secret", f"gw-autograder-{os.getpid()}"

answer = "\\n".join('{"kind": "draw", "pieces": ["%d"]}' % number for number in (3, 1, 2))
bad_name = '=1+1"<b>&amp;'
# Program or folder, and its outcome. Those of the examples are copied.
outcomes = {
    "right": "right", "wrong": "wrong", "endless": "endless", "broken": "broken",
    "hostile": "crashed", "in_c": "right", "with_run": "right", "answer": "right",
    "fork_bomb": "crashed", "floods": "flooding", "hogs": "memory", "spies": "right",
    "leaves": "right", "linked": "no program", "empty": "no program", "two": "no program",
    "silent": "broken", "dies": "crashed", bad_name: "right",
}


def write_class(folder, address):
    folder.mkdir()
    for name in ("right.py", "wrong.py", "endless.sh", "broken.py", "hostile.py"):
        shutil.copy(examples / name, folder)
    printed = answer.replace("\\n", "\n") + "\n"
    (folder / "in_c.c").write_text(
        '#include <stdio.h>\nint main(void) { return puts("%s") < 0; }\n' %
        answer.replace('"', '\\"'))
    for name in ("with_run/inner", "empty", "two"):
        (folder / name).mkdir(parents=True)
    (folder / "with_run/inner/run").write_text("#!/bin/sh\ncat data.txt\n")
    (folder / "with_run/inner/data.txt").write_text(printed)
    (folder / "answer.jsonl").write_text(printed)
    (folder / "two/a.py").write_text("")
    (folder / "two/b.sh").write_text("")
    (folder / "fork_bomb.sh").write_text("f() { f | f & f; }\nf\n")
    (folder / "floods.sh").write_text("exec yes\n")
    (folder / "hogs.py").write_text(
        "import os, time\nkept = []\nfor _ in range(20): os.fork() or (kept.append(b'1' * (20 << "
        "20)), time.sleep(1000))\ntime.sleep(1000)\n")
    (folder / "spies.py").write_text(f"""
import os, pathlib, socket
print({printed!r}, end="")
places = [{str(secret)!r}, {str(gw)!r}, {str(work)!r}, {str(source)!r}, "/etc/passwd", "/root"]
assert not [place for place in places if os.path.exists(place)], os.listdir("/")
assert set(os.listdir("/")) <= set("bin dev etc lib lib32 lib64 polygons.json proc sbin submission "
                                   "tmp usr".split()), os.listdir("/")
assert os.listdir("/submission") == ["spies.py"]
for place in ("/submission/x", "/usr/x", "/x", "/dev/x", "/polygons.json"):
    try:
        open(place, "a")
    except OSError:
        continue
    raise SystemExit(place + " can be written")
try:
    socket.create_connection({address!r}, 1)
except OSError:
    pass
else:
    raise SystemExit("network")
""")
    (folder / "leaves.py").write_text(
        f"import subprocess\nsubprocess.Popen(['sh', '-c', 'sleep 1000; : {marker}'], "
        f"start_new_session=True)\nprint({printed!r}, end='')\n")
    (folder / "linked").symlink_to(secret)
    (folder / "silent.sh").write_text("")
    (folder / "dies.sh").write_text("printf 'what\\033[31m <b>' >&2; kill -SEGV $$\n")
    (folder / (bad_name + ".jsonl")).write_text(printed)


def autograde(*words, **more):
    return subprocess.run([gw, "autograde", *map(str, words), "--scene", scene, "--size",
                           f"{width}x{height}"], capture_output=True, text=True, check=False, **more)


class Page(html.parser.HTMLParser):
    """The words of the table's cells, links, and elements."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.links, self.elements, self.in_cell = [], [], set(), False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.elements.add(tag)
        self.links += [value for name, value in attributes if name in ("href", "src")]
        if tag == "tr":
            self.rows.append([])
        self.in_cell = self.in_cell or tag in ("td", "th")
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        self.in_cell = self.in_cell and tag not in ("td", "th")

    def handle_data(self, data):
        if self.in_cell:
            self.rows[-1][-1] += data


class Class(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(work, ignore_errors=True)
        work.mkdir(parents=True)
        secret.mkdir()
        (secret / "run").write_text("cat /dev/null\n")
        cls.server = socket.create_server(("127.0.0.1", 0))
        write_class(work / "class", cls.server.getsockname())
        cls.ran = autograde(work / "class", "-o", work / "grades", "--time", "2", "--memory", "128")
        cls.results = {
            name: json.loads((work / "grades/students" / name / "results.json").read_text())
            for name in outcomes}
        cls.outcome = {name: result["tests"][0]["extra_data"]["outcome"]
                       for name, result in cls.results.items()}
        cls.feedback = {name: result["tests"][0]["output"] for name, result in cls.results.items()}

    @classmethod
    def tearDownClass(cls):
        cls.server.close()

    def test_each_submission_costs_its_own_mark_only(self):
        self.assertEqual(self.ran.returncode, 3, self.ran.stderr)
        self.assertEqual(self.ran.stderr, "")
        self.assertEqual(self.outcome, outcomes, self.feedback)

    def test_results_are_gradescopes(self):
        for name, result in self.results.items():
            (test,) = result["tests"]
            full = outcomes[name] == "right"
            self.assertEqual((test["name"], test["score"], test["max_score"], test["status"]),
                             ("centroid_fails", 10 if full else 0, 10,
                              "passed" if full else "failed"))
            self.assertEqual(result["score"], test["score"])
            self.assertLessEqual(set(result), {"score", "execution_time", "visibility",
                                               "stdout_visibility", "extra_data", "tests"})

    def test_junit_table_and_page_agree(self):
        suites = xml.etree.ElementTree.parse(work / "grades/junit.xml").getroot()
        self.assertEqual(len(suites), len(outcomes))
        for suite in suites:
            (case,) = suite
            outcome = outcomes[suite.get("name")]
            kind = {"right": [], "wrong": ["failure"]}.get(outcome, ["error"])
            self.assertEqual([child.tag for child in case], kind)
            self.assertEqual([child.get("message") for child in case], [outcome] * len(kind))
            self.assertEqual((suite.get("failures"), suite.get("errors")),
                             (str(kind.count("failure")), str(kind.count("error"))))
        with open(work / "grades/grades.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["student", "points", "of", "centroid_fails"])
        # A spreadsheet computes no name.
        self.assertEqual({row[0].lstrip("'"): row[3] for row in rows[1:]}, outcomes)
        self.assertFalse([row for row in rows if row[0][0] in "=+-@"])
        page = Page((work / "grades/index.html").read_text())
        self.assertEqual({row[0]: row[2] for row in page.rows[1:]}, outcomes)
        self.assertEqual(page.rows[0][:2], ["student", "points"])
        self.assertNotIn("b", page.elements)
        for link in page.links:
            if not link.startswith("#"):
                path = re.sub("%(..)", lambda hit: chr(int(hit[1], 16)), link)
                self.assertTrue((work / "grades" / path).exists(), link)

    def test_feedback_blames_the_step(self):
        first, second = self.feedback["wrong"].splitlines()[:2]
        self.assertRegex(first, rf"^[1-9]\d* of {width * height} pixels are wrong\.$")
        blame = re.fullmatch(r"Step \d+ painted (\d+) over (\d+|the background) at (\d+) pixels?, "
                             r"first at \((\d+), (\d+)\)\. Expected: (\d+)\.", second)
        painted, over, _, x, y, expected = blame.groups()
        polygons = work / "polygons.json"
        subprocess.run([gw, "play", scene, "--size", f"{width}x{height}", "--polygons", polygons],
                       check=True)
        rows = subprocess.run([sys.executable, examples / "right.py", polygons], check=True,
                              capture_output=True, text=True).stdout.splitlines()
        shown = {(row, pixel): number for line in rows
                 for row, pixel, _, number in json.loads(line)["painted"]}
        self.assertEqual(shown[int(y), int(x)], int(expected))
        self.assertNotEqual(painted, expected)
        self.assertIn(expected, over)

    def test_feedback_says_what_happened(self):
        for name, words in {
                "endless": "did not end after 2 s", "broken": "steps.jsonl:1: unknown polygon '999'",
                "floods": "printed more than 16 MB", "hogs": "more than 128 MB of memory",
                "linked": "is a link", "empty": "has no program", "two": "has 2 programs",
                "silent": "no step", "dies": "signal 11 (Segmentation fault)"}.items():
            self.assertIn(words, self.feedback[name])
        self.assertIn("what\\x1b[31m <b>", self.feedback["dies"])
        self.assertRegex(self.feedback["hostile"], "the submission: (Permission|Read-only)")
        for words in ("network: Network is unreachable", "disk: No space left on device",
                      "processes: Resource temporarily unavailable",
                      "other files: No such file"):
            self.assertIn(words, self.feedback["hostile"])

    def test_feedback_and_page_are_japanese_but_for_the_words_of_programs(self):
        names = ("wrong", "endless", "broken", "empty", "two", "linked", "silent", "dies", "right")
        shutil.copytree(work / "class", work / "japanese", symlinks=True,
                        ignore=lambda folder, found: [
                            name for name in found if pathlib.Path(folder) == work / "class"
                            and name.split(".")[0] not in names])
        autograde(work / "japanese", "-o", work / "seiseki", "--time", "2", "--language", "ja")
        said = {name: json.loads((work / "seiseki/students" / name / "results.json").read_text())
                ["tests"][0]["output"] for name in names}
        for name, words in {
                "wrong": "画素が誤りです。\nステップ ", "endless": "計算時間 2 秒",
                "broken": "知らないポリゴン '999'", "empty": "プログラムがない", "two": "2 個ある",
                "linked": "リンク", "silent": "ステップがありません", "right": "すべての画素が正解です。",
                "dies": "シグナル 11 (Segmentation fault)"}.items():
            self.assertIn(words, said[name])
        self.assertIn("what\\x1b[31m <b>", said["dies"])
        for name in set(names) - {"dies"}:
            self.assertNotRegex(said[name], "[A-Za-z]+ [a-z]+ [a-z]+", name)
        page = Page((work / "seiseki/index.html").read_text())
        self.assertEqual(page.rows[0][:2], ["学生", "得点"])
        self.assertEqual({row[0].split(".")[0]: row[2] for row in page.rows[1:]}, {
            "right": "正解", "wrong": "不正解", "endless": "終わらない", "dies": "異常終了",
            "broken": "読めない答え", "silent": "読めない答え", "empty": "プログラムなし",
            "two": "プログラムなし", "linked": "プログラムなし"})

    def test_nothing_is_reached_or_left(self):
        self.server.setblocking(False)
        with self.assertRaises(BlockingIOError):
            self.server.accept()
        self.assertEqual(sorted(path.name for path in secret.iterdir()), ["run"])
        self.assertEqual(sorted(path.name for path in (work / "grades").iterdir()),
                         ["grades.csv", "index.html", "junit.xml", "students"])
        self.assertNotIn(marker, processes())

    def test_resume_runs_only_what_changed(self):
        shutil.copytree(work / "class", work / "changed", symlinks=True,
                        ignore=lambda _, names: set(names) - {"in_c.c", "broken.py", "wrong.py"})
        shutil.copytree(work / "grades", work / "resumed")
        shutil.copy(work / "changed/in_c.c", work / "changed/broken.c")
        (work / "changed/broken.py").unlink()
        files = [work / "resumed/students" / name / "results.json" for name in ("in_c", "wrong")]
        before = [file.stat().st_mtime_ns for file in files]
        again = autograde(work / "changed", "-o", work / "resumed", "--resume", "--time", "2",
                          "--memory", "128", "--csv")
        self.assertEqual([file.stat().st_mtime_ns for file in files], before)
        self.assertEqual(again.stdout.splitlines()[1:],
                         ['"broken","10","10","right"', '"in_c","10","10","right"',
                          '"wrong","0","10","wrong"'])
        other = autograde(work / "changed", "-o", work / "resumed", "--resume", "--points", "7",
                          "--csv")
        self.assertIn('"in_c","7","7","right"', other.stdout)

    @unittest.skipIf(shutil.which("julia"), "julia is installed")
    def test_lacking_language_is_told_to_the_teacher_and_tried_again(self):
        (work / "far").mkdir()
        (work / "far/juliet.jl").write_text("println()")
        words = [work / "far", "-o", work / "far_grades", "--csv"]
        for more, said in (([], "The submission needs julia, which the grading computer does not"),
                           (["--language", "ja"], "julia が必要だが、採点するコンピュータにない")):
            lacking = autograde(*words, *more)
            self.assertEqual(lacking.returncode, 3)
            self.assertIn('"juliet","0","10","no program"', lacking.stdout)
            self.assertRegex(lacking.stderr, "julia: no such program, .*: juliet; expected")
            feedback = json.loads((work / "far_grades/students/juliet/results.json").read_text())
            self.assertIn(said, feedback["tests"][0]["output"])
        (work / "far_tools/bin").mkdir(parents=True)
        julia = work / "far_tools/bin/julia"
        julia.write_text("#!/bin/sh\nprintf '%s\\n' '" + answer.replace("\\n", "' '") + "'\n")
        julia.chmod(0o755)
        there = autograde(*words, "--resume", "--tools", work / "far_tools")
        self.assertIn('"juliet","10","10","right"', there.stdout)
        self.assertEqual(there.stderr, "")

    def test_interrupted_class_keeps_its_rows(self):
        folder = work / "interrupted"
        folder.mkdir()
        (folder / "a.jsonl").write_text(answer.replace("\\n", "\n"))
        (folder / "b.sh").write_text(f"sh -c 'sleep 1000; : {marker}-2'\n")
        run = subprocess.Popen([gw, "autograde", folder, "-o", work / "half", "--jobs", "1",
                                "--scene", scene], stderr=subprocess.PIPE, text=True)
        while not (work / "half/grades.csv").exists() or f"{marker}-2" not in processes():
            self.assertIsNone(run.poll())
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        self.assertIn("1 of 2 submissions graded; --resume goes on", run.communicate()[1])
        self.assertEqual(run.returncode, -signal.SIGINT)
        rows = (work / "half/grades.csv").read_text().splitlines()
        self.assertEqual(rows[1:], ['"a","10","10","right"', '"b","","","not graded yet"'])
        while f"{marker}-2" in processes():  # ends with the command
            time.sleep(0.02)

    def test_single_submission_has_its_results_in_the_folder(self):
        ran = autograde(work / "class/with_run", "--single", "-o", work / "single")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(json.loads((work / "single/results.json").read_text())["score"], 10)
        self.assertEqual(ran.stdout, "centroid_fails: right, 10 of 10\nEvery pixel is right.\n\n")

    def test_limits_alone_need_root_and_bind_too(self):
        folder = work / "limited"
        folder.mkdir()
        shutil.copy(examples / "hostile.py", folder)
        shutil.copy(work / "class/in_c.c", folder)
        ran = autograde(folder, "-o", work / "limits", "--isolation", "limits", "--csv")
        if os.geteuid() != 0:
            self.assertIn("needs root", ran.stderr)
            return
        self.assertEqual(ran.stdout.splitlines()[1:],
                         ['"hostile","0","10","crashed"', '"in_c","10","10","right"'])
        text = (work / "limits/students/hostile/results.json").read_text()
        self.assertIn("processes: Resource temporarily unavailable", text)
        self.assertIn("disk: File too large", text)

    def test_without_isolation_nothing_runs(self):
        bin_folder = work / "bin"
        bin_folder.mkdir()
        for name in ("sh", "setpriv", "prlimit", "true"):
            (bin_folder / name).symlink_to(shutil.which(name))
        words = (work / "class", "-o", work / "none")
        ran = autograde(*words, env={"PATH": str(bin_folder)})
        self.assertEqual(ran.returncode, 1)
        self.assertRegex(ran.stderr, r"^gw: bwrap: no such program; expected bubblewrap.*\n$")
        (bin_folder / "bwrap").write_text(
            "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n")
        (bin_folder / "bwrap").chmod(0o755)
        ran = autograde(*words, env={"PATH": str(bin_folder)})
        self.assertEqual(ran.returncode, 1)
        self.assertRegex(ran.stderr, r"^gw: bwrap cannot isolate a program here: .*No permissions.*"
                         r"expected .*--isolation limits.*\n$")
        self.assertFalse((work / "none").exists())

    def test_bad_words_are_refused(self):
        for words, code, part in (
                ((work / "none", "-o", work / "x"), 1, "is no folder"),
                ((work / "class/empty", "-o", work / "x"), 1, "has no submission"),
                ((work / "class", "-o", work / "x", "--scene", scene), 2, "another name"),
                ((work / "class", "-o", work / "x", "--time", "0"), 2, "--time"),
                ((work / "class", "-o", work / "x", "--isolation", "none"), 2, "--isolation"),
                ((work / "class", "-o", work / "x", "--tools", work / "y"), 1, "is no folder")):
            ran = autograde(*words)
            self.assertEqual((ran.returncode, ran.stdout), (code, ""), words)
            self.assertIn(part, ran.stderr)
            self.assertEqual(ran.stderr.count("\n"), 1)


def processes():
    """The words of all."""
    found = b""
    for file in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            found += file.read_bytes()
        except OSError:  # has ended
            continue
    return found.decode(errors="replace")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
