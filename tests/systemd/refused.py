"""What a service may not do, tried in the sandbox of its unit: refused.py UNIT-FILE

Each row is tried by a process of its own: with the filters that end it, which tells a call that the unit refuses from one that the kernel
refuses for another reason, and with the errors that it gets under systemd. Without a sandbox none of the calls does harm.
"""

import ctypes
import errno
import functools
import mmap
import os
import platform
import signal
import socket
import stat
import sys
import tempfile

import sandbox
import seccomp

HERE = -100  # AT_FDCWD
LONG = -1
NEW_USER, NEW_NET = 0x10000000, 0x40000000
PERSONALITY_NO_RANDOM = 0x0040000
PRIO_PROCESS, CLOCK_REALTIME, PTRACE_TRACEME = 0, 0, 0
PAGE = mmap.PAGESIZE
READ_WRITE, ALL = mmap.PROT_READ | mmap.PROT_WRITE, mmap.PROT_READ | mmap.PROT_WRITE | mmap.PROT_EXEC
OWN = mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS
PATH = os.path.join(tempfile.gettempdir(), f'axisd-refused-{os.getpid()}').encode()

# System call, arguments, the error under systemd.
REFUSED = [
    # the file system of the machine
    ('mount', (None, None, None, 0, None), errno.EPERM),
    ('umount2', (None, 0), errno.EPERM),
    ('pivot_root', (None, None), errno.EPERM),
    ('open_tree', (LONG, None, 0), errno.EPERM),
    ('move_mount', (LONG, None, LONG, None, 0), errno.EPERM),
    ('chroot', (None,), errno.EPERM),
    ('open_by_handle_at', (LONG, None, 0), errno.EPERM),
    ('quotactl', (0, None, 0, None), errno.EPERM),
    ('fanotify_init', (LONG, 0), errno.EPERM),
    # its owners, and modes that give rights away
    ('chown', (None, 0, 0), errno.EPERM),
    ('fchownat', (LONG, None, 0, 0, 0), errno.EPERM),
    ('chmod', (None, stat.S_ISUID | 0o755), errno.EPERM),
    ('fchmodat', (LONG, None, stat.S_ISGID | 0o755), errno.EPERM),
    ('mknod', (None, stat.S_IFREG | stat.S_ISUID, 0), errno.EPERM),
    ('openat', (HERE, PATH, os.O_CREAT | os.O_WRONLY, stat.S_ISUID | 0o700), errno.EPERM),
    # its clock, name and power
    ('clock_settime', (CLOCK_REALTIME, None), errno.EPERM),
    ('settimeofday', (None, None), errno.EPERM),
    ('adjtimex', (None,), errno.EPERM),
    ('sethostname', (None, LONG), errno.EPERM),
    ('setdomainname', (None, LONG), errno.EPERM),
    ('reboot', (0, 0, 0, None), errno.EPERM),
    ('swapon', (None, 0), errno.EPERM),
    # its kernel
    ('init_module', (None, 0, None), errno.EPERM),
    ('finit_module', (LONG, None, 0), errno.EPERM),
    ('delete_module', (None, 0), errno.EPERM),
    ('kexec_load', (0, 0, None, LONG), errno.EPERM),
    ('bpf', (LONG, None, 0), errno.EPERM),
    ('perf_event_open', (None, 0, 0, LONG, 0), errno.EPERM),
    ('syslog', (LONG, None, 0), errno.EPERM),
    ('iopl', (0,), errno.EPERM),
    ('ioperm', (0, 0, 0), errno.EPERM),
    # other processes, namespaces and users
    ('kcmp', (0, 0, LONG, 0, 0), errno.EPERM),
    ('ptrace', (PTRACE_TRACEME, 0, None, None), errno.EPERM),
    ('process_vm_readv', (LONG, None, 0, None, 0, 0), errno.EPERM),
    ('process_vm_writev', (LONG, None, 0, None, 0, 0), errno.EPERM),
    ('unshare', (NEW_USER,), errno.EPERM),
    ('unshare', (NEW_NET,), errno.EPERM),
    ('setns', (LONG, 0), errno.EPERM),
    ('setuid', (0,), errno.EPERM),
    ('setgroups', (LONG, None), errno.EPERM),
    ('personality', (PERSONALITY_NO_RANDOM,), errno.EPERM),
    ('keyctl', (LONG, 0, 0, 0, 0), errno.EPERM),
    ('add_key', (None, None, None, 0, 0), errno.EPERM),
    # a share of the machine that is not its own
    ('sched_setscheduler', (0, os.SCHED_FIFO, None), errno.EPERM),
    ('sched_setattr', (0, None, 0), errno.EPERM),
    ('sched_setaffinity', (0, 0, None), errno.EPERM),
    ('setpriority', (PRIO_PROCESS, 0, 0), errno.EPERM),
    # ways into the kernel that none of the programs takes
    ('io_uring_setup', (0, None), errno.EPERM),
    ('io_setup', (0, None), errno.EPERM),
    ('userfaultfd', (LONG,), errno.EPERM),
    # code that comes from elsewhere than a file
    ('mmap', (None, PAGE, ALL, OWN, LONG, 0), errno.EPERM),
    ('mprotect', (None, 0, mmap.PROT_READ | mmap.PROT_EXEC), errno.EPERM),
    ('pkey_mprotect', (None, 0, ALL, LONG), errno.EPERM),
    ('shmat', (LONG, None, sandbox.SHM_EXEC), errno.EPERM),
    # sockets that are neither of a bus nor of a client
    ('socket', (socket.AF_PACKET, socket.SOCK_RAW, 0), errno.EAFNOSUPPORT),
    ('socket', (socket.AF_ALG, socket.SOCK_SEQPACKET, 0), errno.EAFNOSUPPORT),
    ('socket', (socket.AF_VSOCK, socket.SOCK_STREAM, 0), errno.EAFNOSUPPORT),
    ('socket', (socket.AF_BLUETOOTH, socket.SOCK_RAW, 0), errno.EAFNOSUPPORT),
    ('socket', (LONG, socket.SOCK_STREAM, 0), errno.EAFNOSUPPORT),
]

# The families of each unit; it may have no other one of these.
FAMILIES = {'AF_UNIX', 'AF_NETLINK', 'AF_CAN', 'AF_INET', 'AF_INET6'}
OF_UNIT = {
    'axisd@.service': {'AF_UNIX', 'AF_NETLINK', 'AF_CAN'},
    'axisd-bus@.service': {'AF_UNIX', 'AF_NETLINK', 'AF_INET', 'AF_INET6'},
    'axisd.service': FAMILIES,
    'axisd-agent.service': FAMILIES,
    'axisd-http.service': {'AF_UNIX', 'AF_INET', 'AF_INET6'},
    'axisd-nats.service': {'AF_UNIX', 'AF_INET', 'AF_INET6'},
    'vcan@.service': {'AF_NETLINK'},
}

# Refused with an error for which callers have another way.
UNKNOWN = [('clone3', (None, 0), errno.ENOSYS), ('openat2', (LONG, None, None, 0), errno.ENOSYS)]

# Refused for want of a capability, which root outside of a sandbox has.
RAW = ('socket', (socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_ICMP), errno.EPERM)

# What it needs is not refused by mistake: a list that refuses everything would pass all rows above.
ALLOWED = [
    ('getpid', ()),
    ('mmap', (None, PAGE, READ_WRITE, OWN, LONG, 0)),
    ('mprotect', (None, 0, READ_WRITE)),
    ('chmod', (None, 0o700)),
    ('openat', (LONG, None, os.O_RDONLY, 0)),
    ('timerfd_create', (1, 0)),
    ('memfd_create', (b'name', 0)),
    ('epoll_create1', (0,)),
    ('pidfd_send_signal', (LONG, 0, None, 0)),
    ('prctl', (LONG, 0, 0, 0, 0)),
]

KILLED = 'is ended'
FOREIGN_GETPID = bytes.fromhex('b8 14 00 00 00 cd 80 c3')  # mov $20, %eax; int $0x80; ret


def call(name, arguments):
    """The error of a system call, 0 if there is none."""
    number = seccomp.resolve_syscall(seccomp.Arch(), name)
    words = [each if isinstance(each, bytes) else ctypes.c_long(each or 0) for each in arguments]
    ctypes.set_errno(0)
    return 0 if sandbox.LIBC.syscall(ctypes.c_long(number), *words) >= 0 else ctypes.get_errno()


def foreign_call():
    """A system call of a 32 bit program, which filters of those of 64 bits do not see."""
    file = os.memfd_create('code')
    os.write(file, FOREIGN_GETPID)
    sandbox.LIBC.mmap.restype = ctypes.c_void_p
    code = sandbox.LIBC.mmap(None, ctypes.c_size_t(PAGE), mmap.PROT_READ | mmap.PROT_EXEC, mmap.MAP_PRIVATE, file, ctypes.c_long(0))
    return 0 if ctypes.CFUNCTYPE(ctypes.c_int)(code)() == os.getpid() else 1


@functools.cache
def has_foreign_calls():
    return platform.machine() == 'x86_64' and outcome(foreign_call) == 0


def outcome(function):
    """What becomes of a process that does FUNCTION: the number that this returns, or that it was ended by a filter."""
    child = os.fork()
    if child == 0:
        try:
            os._exit(function())
        finally:
            os._exit(255)
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return KILLED if status == -signal.SIGSYS else status


def is_there(name):
    return seccomp.resolve_syscall(seccomp.Arch(), name) >= 0


def rows_of(unit):
    families = OF_UNIT[os.path.basename(unit)]
    sockets = [('socket', (getattr(socket, family), socket.SOCK_DGRAM, 0), errno.EAFNOSUPPORT) for family in sorted(FAMILIES - families)]
    allowed = [('socket', (getattr(socket, family), LONG, LONG)) for family in families]
    return REFUSED + sockets, ALLOWED + allowed


def check(unit, errors):
    """Whether each row is as it should be, said line by line where it is not."""
    refused, allowed = rows_of(unit)
    wanted = [(*row[:2], row[2] if errors else KILLED) for row in refused if is_there(row[0])]
    wanted += [row for row in UNKNOWN if is_there(row[0])]
    wanted += [(*row, None) for row in allowed if is_there(row[0])]
    if 'AF_INET' in OF_UNIT[os.path.basename(unit)]:
        wanted.append(RAW)
    wrong = 0
    if has_foreign_calls() and outcome(foreign_call) != KILLED:
        wrong += 1
        print('a system call of a 32 bit program is possible', flush=True)
    for name, arguments, expected in wanted:
        found = outcome(lambda: call(name, arguments))
        good = found == expected if expected is not None else found not in (KILLED, errno.EPERM, errno.EAFNOSUPPORT)
        if not good:
            wrong += 1
            print(f'{name}{arguments}: expected {expected or "that it is allowed"}, got {found}', flush=True)
    may = sum(expected is None for *_, expected in wanted)
    print(f'{len(wanted) - may} calls {"with errors" if errors else "that end it"}, {may} that it may make, {wrong} wrong', flush=True)
    return wrong


def confined(unit, errors):
    sandbox.Sandbox(sandbox.Unit(unit), errors=errors).apply()
    return min(check(unit, errors), 100)


def main():
    unit = sys.argv[1]
    has_foreign_calls()  # before there is a sandbox
    wrong = [outcome(lambda: confined(unit, errors)) for errors in (False, True)]
    assert not os.path.exists(PATH), 'a file with a mode that gives rights away was made'
    sys.exit(0 if wrong == [0, 0] else 1)


main()
