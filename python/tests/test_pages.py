"""The Python blocks of the pages: they run as they stand there, in order, in an empty folder."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy as np
from support import PROGRAM

import steplab

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
BEGIN = re.compile(r"^ *```\s*(?:python|py)", re.MULTILINE)


def blocks_of(text: str) -> list[str]:
    """Each with empty lines before it, so that messages have the lines of the page."""
    found = ["\n" * text.count("\n", 0, block.start(1)) + block[1] for block in BLOCK.finditer(text)]
    if len(found) != len(BEGIN.findall(text)):
        raise ValueError("a block of Python is not between lines ```python and ```")
    return found


def names_of(text: str, page: str) -> dict[str, object]:
    """What the blocks of a page leave behind, as a reader would have it who types them in."""
    names: dict[str, object] = {"__name__": "__main__"}
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            for block in blocks_of(text):
                exec(compile(block, page, "exec"), names)
        finally:
            os.chdir(before)
    return names


def names_of_page(page: pathlib.Path) -> dict[str, object]:
    return names_of(page.read_text(encoding="utf-8"), str(page.relative_to(ROOT)))


class Pages(unittest.TestCase):
    def test_blocks_run(self):
        ran = []
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            if not blocks_of(text):
                continue
            with self.subTest(page=page.name):
                names_of_page(page)
            ran.append(page.name)
        self.assertEqual(ran, ["python.md", "trajectory-format.md"])

    def test_broken_blocks_fail(self):
        whole = "```python\nimport steplab\nchain = steplab.Scene.model('chain', n=3)\n```\n"
        self.assertEqual(names_of(whole, "page")["chain"].particles, 3)
        with self.assertRaisesRegex(steplab.UsageError, "chian"):
            names_of(whole.replace("chain", "chian"), "page")
        with self.assertRaises(SyntaxError) as raised:
            names_of(whole.replace("3)", "3"), "page")
        self.assertEqual(raised.exception.lineno, 3, "the line of the page")
        for wrong in (whole[:-4], whole.replace("```python", "``` python"), whole.replace("```python", "```py")):
            with self.assertRaisesRegex(ValueError, "between lines"):
                blocks_of(wrong)

    def test_reader_of_trajectories_reads_what_the_module_reads(self):
        read = names_of_page(ROOT / "docs/trajectory-format.md")["read"]
        for precision in ("double", "float"):
            with self.subTest(precision=precision), tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "chain.trajectory")
                run = [PROGRAM, "run", "--model", "chain", "--steps", "30", "--every", "3", "--out", file]
                subprocess.run([*run, "--precision", precision], check=True, capture_output=True)
                steps, times, displacements, velocities = (np.array(rows) for rows in zip(*read(file), strict=True))
                expected = steplab.read(file)
                np.testing.assert_array_equal(steps, expected.steps)
                np.testing.assert_array_equal(times, expected.times)
                np.testing.assert_array_equal(velocities, expected.velocities)
                moved = expected.positions - expected.positions[0]
                np.testing.assert_allclose(displacements - displacements[0], moved, atol=1e-6, rtol=0)


if __name__ == "__main__":
    unittest.main()
