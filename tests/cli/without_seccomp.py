"""A process whose kernel seems to have no seccomp: by seccomp."""

import ctypes
import os
import struct
import unittest

PR_SET_NO_NEW_PRIVS, PR_SET_SECCOMP, SECCOMP_MODE_FILTER = 38, 22, 2
LOAD, JUMP_IF_EQUAL, RETURN = 0x20, 0x15, 0x06
ALLOW, FAIL = 0x7FFF0000, 0x00050000 | 22  # EINVAL
CALL, FIRST_ARGUMENT = 0, 16  # places in struct seccomp_data
SYSTEM_CALLS = {"x86_64": (157, 317), "aarch64": (167, 277)}  # prctl, seccomp


def forbid_seccomp():
    """For preexec_fn: seccomp() and prctl(PR_SET_SECCOMP) fail from here on."""
    prctl, seccomp = SYSTEM_CALLS[os.uname().machine]
    program = [(LOAD, 0, 0, CALL), (JUMP_IF_EQUAL, 4, 0, seccomp), (JUMP_IF_EQUAL, 0, 2, prctl),
               (LOAD, 0, 0, FIRST_ARGUMENT), (JUMP_IF_EQUAL, 1, 0, PR_SET_SECCOMP), (RETURN, 0, 0, ALLOW),
               (RETURN, 0, 0, FAIL)]
    code = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *one) for one in program))
    header = struct.pack("HxxxxxxP", len(program), ctypes.addressof(code))
    libc = ctypes.CDLL(None)
    if libc.prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 or \
            libc.prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, header, 0, 0) != 0:
        raise unittest.SkipTest("the system has no seccomp to begin with")
