"""Work survives crashes. usage: test_recovery.py KATAGAMI"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import script  # noqa: E402

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
ADD = ('command patch.add {"points": [[0,-40,0],[0,-20,30],[0,20,30],[0,40,0]], '
       '"extent": [-60,60]}')
DEADLINE_S = 120  # for what takes a second
GESTURE = ['command select.patches {"patches": [1]}', "command view.front", "key G", "key X",
           "key 7"]


def start(folder, lines):
    text = pathlib.Path(folder) / "script.txt"
    text.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return subprocess.Popen([PROGRAM, "edit", "--headless", "--script", text], cwd=folder,
                            env=script.environment(folder), stderr=subprocess.PIPE, text=True)


def run(folder, *lines):
    process = start(folder, lines)
    said = process.communicate()[1]
    if "EGL" in said or "OpenGL" in said:
        raise script.Skip("nothing can be drawn here")
    assert process.returncode == 0, said


def left_behind(folder):
    return list(pathlib.Path(folder, "state", "katagami").glob("autosave-*.katagami"))


def test_work_is_autosaved_after_two_minutes_and_not_before():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, "autosave 2", ADD, "wait 119")
        assert not left_behind(folder)
        run(folder, "autosave 2", ADD, "wait 119", "wait 2")
        assert len(left_behind(folder)) == 1


def test_a_crash_leaves_work_that_is_offered_and_taken():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ADD, "save one.katagami", "autosave 2", ADD, "wait 121")
        run(folder, "recover", "expect shown Recover", 'click "Recover"', "expect patches 2",
            "expect modified", "expect title ● one.katagami — katagami", "key Ctrl+Z",
            "expect patches 1", "key Ctrl+Y", "key Ctrl+S", "expect unmodified")
        assert len(json.loads(pathlib.Path(folder, "one.katagami").read_text())["patches"]) == 2


def test_work_given_up_is_not_offered_again():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, "autosave 2", ADD, "wait 121")
        run(folder, "recover", 'click "Discard"', "expect patches 0")
        assert not left_behind(folder)


def test_saved_work_is_not_offered():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, "autosave 2", ADD, "save one.katagami", ADD, "wait 121", "key Ctrl+S",
            "expect unmodified")
        assert not left_behind(folder)


def points(path):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["patches"][0]["points"]


def test_a_gesture_that_goes_on_for_minutes_is_autosaved_too():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ADD, "save one.katagami", "autosave 2", "command patch.flip {\"patch\": 1}",
            *GESTURE, "wait 121")
        assert points(left_behind(folder)[0])[0] == [7, -40, 0]
        run(folder, "recover", 'click "Recover"', "expect point 1 0 7 -40 0", "expect modified",
            "key Ctrl+Z", "expect point 1 0 0 -40 0", "expect patch 1 flipped", "key Ctrl+Z",
            "expect patch 1 not flipped", "key Ctrl+Z", "expect patches 0", "key Ctrl+Y",
            "key Ctrl+Y", "key Ctrl+Y", "expect point 1 0 7 -40 0")


def test_a_gesture_given_up_after_its_autosave_is_not_what_is_recovered():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ADD, "save one.katagami", "autosave 2", "command patch.flip {\"patch\": 1}",
            *GESTURE, "wait 121", "key Esc", "expect tool select", "wait 121")
        assert points(left_behind(folder)[0])[0] == [0, -40, 0]
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ADD, "save one.katagami", "autosave 2", *GESTURE, "wait 121", "key Esc",
            "expect unmodified")
        assert not left_behind(folder)


def test_an_autosave_in_a_gesture_leaves_the_history_right():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, ADD, "autosave 2", "command patch.rename {\"patch\": 1, \"name\": \"a\"}",
            *GESTURE, "wait 121", "key Enter", "save one.katagami", "open one.katagami",
            "expect point 1 0 7 -40 0", "key Ctrl+Z", "expect point 1 0 0 -40 0", "expect name 1 a",
            "key Ctrl+Z", "expect name 1 ", "key Ctrl+Z", "expect patches 0")


def test_of_several_crashes_the_last_is_offered_first():
    with tempfile.TemporaryDirectory() as folder:
        for number, name in enumerate(["first", "second", "third"], 1):
            before = left_behind(folder)
            run(folder, ADD, f'command patch.rename {{"patch": 1, "name": "{name}"}}', "autosave 2",
                "wait 121")
            [newest] = set(left_behind(folder)) - set(before)
            os.utime(newest, (number, number))  # clocks of files may be coarse
        state = pathlib.Path(folder, "state", "katagami")
        half = state / "autosave-999999.katagami.a1B2c3"
        half.write_text("{")
        newest.rename(state / "autosave-1.katagami")  # the number is another program's by now
        run(folder, "recover", 'click "Discard"', "expect shown Recover", 'click "Recover"',
            "expect name 1 second", "save two.katagami", "recover", 'click "Recover"',
            "expect name 1 first")
        assert not half.exists()


def test_a_card_comes_back_with_its_history():
    with tempfile.TemporaryDirectory() as folder:
        run(folder, 'command file.new_card {"size": [12, 8, 8]}', "save card.katagami",
            "autosave 2", 'command card.box {"from": [3, 0, 0], "to": [8, 3, 5]}',
            'command card.window {"x": 5, "z": 2}', "wait 121")
        run(folder, "recover", 'click "Recover"', "expect modified", "expect size 12 8 8",
            "expect depth 3 5 4", "expect window 5 2", "expect loose 1", "key Ctrl+Z",
            "expect windows 0", "key Ctrl+Z", "expect depth 3 5 0", "key Ctrl+Y", "key Ctrl+Y",
            "expect window 5 2", "key Ctrl+S", "expect unmodified")
        card = json.loads(pathlib.Path(folder, "card.katagami").read_text(encoding="utf-8"))
        assert card["oa"]["windows"] == [[5, 2]], card


def test_killed_while_saving_the_file_is_the_old_or_the_new_one():
    chance = random.Random(4)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "one.katagami")
        run(folder, ADD, f"save {path}")
        lines = [f"open {path}"]
        for _ in range(400):
            lines += ['command point.move {"patch": 1, "point": 0, "by": [0, 0, 0.01]}', "save"]
        for _ in range(12):
            before, saves = points(path)[0][2], chance.randint(1, 40)
            process, end = start(folder, lines), time.monotonic() + DEADLINE_S
            while (process.poll() is None and time.monotonic() < end and
                   points(path)[0][2] - before < 0.01 * saves - 1e-9):
                time.sleep(0.001)
            time.sleep(chance.uniform(0, 0.01))
            process.kill()
            said = process.communicate()[1]
            assert process.returncode in (-9, 0), said  # 0: it was through before the kill came
            assert points(path)[0][2] - before > 0.01 * saves - 1e-9, "it was not saved"
            checked = subprocess.run([PROGRAM, "check", path], capture_output=True, check=False)
            assert checked.returncode == 0, checked.stderr


sys.exit(script.run(globals()))
