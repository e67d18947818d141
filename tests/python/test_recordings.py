"""Recordings, goldens and the conformance suite from Python, beside the command's answers."""
import json
import os
import subprocess

import gw
import gw.conformance
import pytest
from gw.testing import expect_passes_equal

from test_machine import triangle_list

COMMAND = os.environ.get("GW")


def recorded(list_=None):
    return gw.Recording([list_ or triangle_list()], "vgx", 64, 48)


def test_a_saved_recording_is_the_same_and_replays(tmp_path):
    recording = recorded()
    recording.save(tmp_path / "t.gwt")
    again = gw.Recording.open(tmp_path / "t.gwt")
    assert again.encode() == recording.encode() == gw.Recording.decode(recording.encode()).encode()
    assert again.replay().digests() == again.replay(reference=True).digests()
    assert again.compare(recording) is None


def test_the_command_verifies_what_python_saved(tmp_path):
    if not COMMAND or not os.path.exists(COMMAND):
        pytest.skip("no command gw")
    recording = recorded()
    recording.save(tmp_path / "t.gwt")
    recording.save_manifest(tmp_path / "t.json")
    done = subprocess.run([COMMAND, "verify", tmp_path / "t.gwt", tmp_path / "t.json"],
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    said = subprocess.run([COMMAND, "pixel", tmp_path / "t.gwt", "30", "20", "--json"],
                          capture_output=True)
    assert json.loads(said.stdout)["events"] == recording.pixel_history(30, 48 - 1 - 20)["events"]


def test_a_truncated_file_is_an_error(tmp_path):
    recorded().save(tmp_path / "t.gwt")
    whole = (tmp_path / "t.gwt").read_bytes()
    for length in (0, 3, 100, len(whole) // 2):
        (tmp_path / "cut.gwt").write_bytes(whole[:length])
        with pytest.raises(gw.Error, match="cut.gwt"):
            gw.Recording.open(tmp_path / "cut.gwt")


def test_a_golden_is_written_by_the_flag_only_and_compared(tmp_path, goldens, monkeypatch):
    monkeypatch.setenv("GW_TESTING_OUTPUT", str(tmp_path / "failures"))
    golden = tmp_path / "goldens" / "of lines" / "triangle.json"
    with pytest.raises(pytest.fail.Exception, match="--gw-update-goldens"):
        expect_passes_equal(recorded(), golden)
    assert not golden.exists()
    goldens.update = True
    goldens.expect(recorded(), golden)
    goldens.update = False
    goldens.expect(recorded(), golden)

    other = triangle_list()
    other.draw(gw.Mesh("Points", [[0, 0, -0.9]]), color=(1, 1, 1, 1))
    with pytest.raises(pytest.fail.Exception) as failure:
        goldens.expect(recorded(other), golden)
    text = str(failure.value)
    assert "pass 0 'triangle'" in text and "pixel" in text and "stage" in text
    pictures = [line.strip() for line in text.splitlines() if line.strip().endswith(".png")]
    assert len(pictures) == 3 and all(open(p, "rb").read(8) == b"\x89PNG\r\n\x1a\n"
                                      for p in pictures)


def test_two_recordings_are_compared():
    other = triangle_list()
    other.clear(stencil=4)
    difference = recorded().compare(recorded(other))
    assert difference is not None and difference.what.startswith("plane stencil")
    assert difference.expected == "3" and difference.actual == "4"


def test_the_reference_machine_conforms_and_a_wrong_one_does_not():
    def play(recording):
        for row in recording.passes():
            yield row["pass"], row, row["digests"]

    results = list(gw.conformance.run(play, ["raster"]))
    assert results and all(result.agrees for result in results), results

    def wrong(recording):
        for name, counters, digests in play(recording):
            yield name, {**counters, "written": counters["written"] + 1}, digests

    assert not any(result.agrees for result in gw.conformance.run(wrong, ["raster"])
                   if result.passes)
    with pytest.raises(gw.Error, match="expected one of"):
        list(gw.conformance.run(play, ["no such group"]))


def test_what_a_screen_shows_is_part_of_the_suite():
    def play(recording, change):
        for row in recording.passes():
            yield row["pass"], row, change(row["digests"])

    def agree(group, change):
        results = list(gw.conformance.run(lambda r: play(r, change), [group]))
        return [result.agrees for result in results if result.passes]

    assert all(agree("indices", lambda digests: digests))
    assert not any(agree("indices", lambda digests: {**digests, "shown": "0" * 32}))
    assert not all(agree("indices", lambda digests: {**digests, "shown": None}))
    assert not any(agree("raster", lambda digests: {**digests, "shown": "0" * 32}))
