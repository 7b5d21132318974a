"""Modules that the first Python in the PATH may lack, and the system's has."""
import importlib.util
import os
import sys
from pathlib import Path

SYSTEM = "/usr/bin/python3"


def is_there(module):
    """True if it is; otherwise the program starts again in the system's Python, or this is it."""
    if importlib.util.find_spec(module) is not None:
        return True
    if Path(SYSTEM).exists() and not os.path.samefile(SYSTEM, sys.executable):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    return False
