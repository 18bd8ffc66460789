"""How long tests wait: until a hang is certain, however busy the machine is."""

import os
import time

# seconds, from tests/CMakeLists.txt; a test that is started by hand waits for ever
LONGEST = float(os.environ["CREEPCONTACT_LONGEST_WAIT"]) if "CREEPCONTACT_LONGEST_WAIT" in os.environ else None


def wait_until(condition, what, pause=0.02):
    end = None if LONGEST is None else time.monotonic() + LONGEST
    while not condition():
        if end is not None and time.monotonic() > end:
            raise AssertionError(f"{what}: not within {LONGEST:g} s")
        time.sleep(pause)
