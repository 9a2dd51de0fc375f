"""The calls that other emulators make on the host's CAN, each asking a unit for its device type: calls.py BIN-FOLDER

To be run by with-can, on a bus of its own. The calls are those of Zephyr's native driver, of NuttX's simulator and of
Renode's bridge, in their order; the last finds them by dlsym in what it takes for the C library.
"""

import ctypes
import fcntl
import os
import select
import socket
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, 'bus_e2e'))
import programs  # noqa: E402  pylint: disable=wrong-import-position

REQUEST = struct.pack('=IB3x8s', 0x605, 8, bytes.fromhex('4000100000000000'))  # SDO: read 1000h
ANSWER = struct.pack('=IB3x8s', 0x585, 8, bytes.fromhex('430010009201FFFF'))
FD_FRAME = struct.pack('=IB3x64s', 0x605, 12, bytes(64))
FD_ROOM = len(FD_FRAME)
SIOCGIFINDEX = 0x8933
CAN_RAW_XL_FRAMES = 7


def index_of(descriptor, name):
    request = bytearray(struct.pack('16s24x', name))
    fcntl.ioctl(descriptor, SIOCGIFINDEX, request)
    return struct.unpack_from('16xi', request)[0]


def can_answer(descriptor):
    return bool(select.select([descriptor], [], [], programs.PATIENCE)[0])


def refuses_fd_frames(descriptor):
    try:
        os.write(descriptor, FD_FRAME)
    except OSError:
        return True
    return False


def zephyr():
    """Own frames come back, which is how the driver knows that they have been sent."""
    with socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW) as can:
        assert index_of(can.fileno(), b'zcan0') > 0
        can.bind(('zcan0',))
        can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_RECV_OWN_MSGS, 1)
        os.write(can.fileno(), REQUEST)
        came = []
        for _ in range(2):
            assert can_answer(can)
            data, _, flags, _ = can.recvmsg(FD_ROOM, 0, socket.MSG_WAITALL)
            came.append((data, bool(flags & socket.MSG_CONFIRM)))
        assert came == [(REQUEST, True), (ANSWER, False)], came
        can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FD_FRAMES, 1)
        assert refuses_fd_frames(can.fileno())


def nuttx():
    with socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW) as can:
        assert socket.if_nametoindex('can0') > 0
        can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FD_FRAMES, 1)
        can.bind(('can0',))
        assert os.write(can.fileno(), REQUEST) == len(REQUEST)
        assert can_answer(can)
        data = os.read(can.fileno(), FD_ROOM)
        assert data == ANSWER, data
        can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_RECV_OWN_MSGS, 1)
        can.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_LOOPBACK, 1)


def renode():
    """A run-time system that asks the C library by name goes past the preload library, unless that has the name."""
    library = ctypes.CDLL('libc.so', use_errno=True)
    descriptor = library.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
    assert descriptor >= 0, os.strerror(ctypes.get_errno())
    on = ctypes.c_int(1)
    assert library.setsockopt(descriptor, socket.SOL_CAN_RAW, socket.CAN_RAW_FD_FRAMES, ctypes.byref(on), 4) == 0
    assert library.setsockopt(descriptor, socket.SOL_CAN_RAW, CAN_RAW_XL_FRAMES, ctypes.byref(on), 4) == -1
    assert ctypes.get_errno() == 92  # ENOPROTOOPT: a host without CAN XL
    request = ctypes.create_string_buffer(struct.pack('16s24x', b'vcan0'), 40)
    assert library.ioctl(descriptor, SIOCGIFINDEX, request) == 0
    address = struct.pack('=HxxiQQ', socket.AF_CAN, struct.unpack_from('16xi', request.raw)[0], 0, 0)
    assert library.bind(descriptor, address, len(address)) == 0
    assert library.write(descriptor, REQUEST, len(REQUEST)) == len(REQUEST)
    assert can_answer(descriptor)
    room = ctypes.create_string_buffer(FD_ROOM)
    assert library.read(descriptor, room, FD_ROOM) == len(ANSWER)
    assert room.raw[:len(ANSWER)] == ANSWER, room.raw


def main():
    if sys.argv[1] == 'renode':
        renode()
        return
    with programs.Folder(sys.argv[1]) as folder:
        programs.start_unit(folder)
        zephyr()
        nuttx()
        os.symlink(os.environ['LD_PRELOAD'].split(':')[-1], folder.path('libc.so'))
        subprocess.run([sys.executable, __file__, 'renode'], env={**os.environ, 'LD_LIBRARY_PATH': folder.folder.name},
                       check=True, timeout=programs.PATIENCE)


main()
