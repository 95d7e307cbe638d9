"""What the tests share: the program of the same build."""

import json
import os
import subprocess

PROGRAM = os.environ["STEPLAB_PROGRAM"]


def summary(arguments: str) -> dict:
    """What `steplab run ... --summary -` prints."""
    command = [PROGRAM, "run", *arguments.split(), "--summary", "-"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
