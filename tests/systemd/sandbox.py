"""The sandbox of a unit file, for a process that takes it on itself: its seccomp filters and its set of capabilities.

The filters are those of systemd 252 (src/shared/seccomp-util.c), with one difference: a system call that is refused ends the process by
SIGSYS, so that none is overlooked. Those of SURVIVED, and all with ERRORS, fail as they do under systemd.
"""

import ctypes
import errno
import functools
import mmap
import os
import pathlib
import socket
import stat
import struct
import subprocess

import seccomp

NAMESPACES = (0x80, 0x20000, 0x2000000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000)  # CLONE_NEW*
SHM_EXEC = 0o100000
ANY_FAMILY = 46  # more than there are
PR_CAPBSET_DROP = 24
CAPABILITIES = {'CAP_NET_BIND_SERVICE': 10, 'CAP_NET_ADMIN': 12}  # those that a unit or a drop-in leaves
CAPABILITY_VERSION = 0x20080522
PERSONALITY = 0  # that of Linux
MODES = {'chmod': 1, 'fchmod': 1, 'fchmodat': 2, 'fchmodat2': 2, 'mkdir': 1, 'mkdirat': 2, 'mknod': 1, 'mknodat': 2, 'creat': 1}
OPEN_MODES = {'open': 1, 'openat': 2}  # flags, and the mode behind them
# What a setting refuses whole. None of it is in the list of SystemCallFilter=, which would do alone.
GROUPS = {'ProtectClock': '@clock', 'ProtectKernelModules': '@module', 'ProtectKernelLogs': 'syslog', 'PrivateDevices': '@raw-io'}
CALLS = {'ProtectHostname': ('sethostname', 'setdomainname'), 'ProtectKernelTunables': ('_sysctl',)}

LIBC = ctypes.CDLL(None, use_errno=True)


class Unit:
    """The lines of [Service] of the unit file PATH and of the drop-ins beside it."""

    def __init__(self, path):
        self.lines = []
        for file in [pathlib.Path(path), *sorted(pathlib.Path(f'{path}.d').glob('*.conf'))]:
            section = None
            for line in map(str.strip, file.read_text(encoding='utf-8').splitlines()):
                if line.startswith('['):
                    section = line
                elif section == '[Service]' and line and line[0] not in '#;':
                    key, _, value = line.partition('=')
                    self.lines.append((key.strip(), value.strip()))

    def values(self, key):
        """Those of KEY behind the last empty one, which takes back what stands before."""
        values = [value for name, value in self.lines if name == key]
        empty = max((index for index, value in enumerate(values) if not value), default=-1)
        return values[empty + 1:]

    def value(self, key):
        return next((value for name, value in reversed(self.lines) if name == key), None)

    def is_on(self, key):
        return self.value(key) in ('yes', 'true', 'on', '1')


@functools.cache
def call_groups():
    """What systemd has in each group of system calls: calls, and further groups."""
    text = subprocess.run(['systemd-analyze', '--no-pager', 'syscall-filter'], capture_output=True, check=True, text=True).stdout
    groups, group = {}, None
    for line in text.splitlines():
        word = line.strip()
        if line.startswith('@'):
            group = groups[word] = set()
        elif not word or not line[0].isspace():
            group = None  # a remark behind the groups
        elif group is not None and not word.startswith('#'):
            group.add(word)
    return groups


def calls_of(word):
    """The system calls of a WORD of SystemCallFilter=."""
    if not word.startswith('@'):
        return {word}
    return set().union(*map(calls_of, call_groups()[word]))


def listed_calls(unit):
    """Whether the list of SystemCallFilter= is of what is allowed, and the list; (None, nothing) if there is none."""
    is_allowed, calls = None, set()
    for value in unit.values('SystemCallFilter'):
        denies = value.startswith('~')
        found = set().union(*map(calls_of, value.removeprefix('~').split()))
        if is_allowed is None:  # the first line says what the list is
            is_allowed = not denies
            calls = calls_of('@default') if is_allowed else set()
        calls = calls | found if denies != is_allowed else calls - found
    return is_allowed, calls


def permitted_capabilities():
    status = pathlib.Path('/proc/self/status').read_text(encoding='ascii')
    return int(next(line for line in status.splitlines() if line.startswith('CapPrm:')).split()[1], 16)


class Sandbox:
    def __init__(self, unit, survived=(), errors=False):
        self.unit, self.survived, self.errors = unit, set(survived), errors

    def apply(self):
        """For this process and its children, for ever. The list of system calls is last: it may refuse what the others need."""
        self.drop_capabilities()
        for build in (self.families, self.memory, self.realtime, self.modes, self.namespaces, self.personality, self.groups,
                      self.architectures, self.calls):
            made = build()
            if made is not None:
                made.load()

    def drop_capabilities(self):
        value = self.unit.value('CapabilityBoundingSet')
        if value is None or os.geteuid() != 0:  # others have none
            return
        kept = [CAPABILITIES[word] for word in value.split()]
        number = 0
        while number in kept or LIBC.prctl(PR_CAPBSET_DROP, number, 0, 0, 0) == 0:
            number += 1
        # Beyond the last one, or root that is none.
        assert ctypes.get_errno() in (errno.EINVAL, errno.EPERM), os.strerror(ctypes.get_errno())
        bits = sum(1 << each for each in kept) & permitted_capabilities()
        sets = struct.pack('<6I', *(bits,) * 3, 0, 0, 0)
        head = struct.pack('<Ii', CAPABILITY_VERSION, 0)
        assert LIBC.capset(head, sets) == 0, os.strerror(ctypes.get_errno())

    def refusal(self, call, number=errno.EPERM):
        return seccomp.ERRNO(number) if self.errors or call in self.survived else seccomp.KILL_PROCESS

    @staticmethod
    def new_filter(action=seccomp.ALLOW):
        made = seccomp.SyscallFilter(action)
        made.set_attr(seccomp.Attr.ACT_BADARCH, seccomp.ALLOW)  # that is the matter of architectures() alone
        return made

    @staticmethod
    def add(made, action, call, *conditions):
        """A rule, if this machine has CALL."""
        number = seccomp.resolve_syscall(seccomp.Arch(), call)
        if number >= 0:
            made.add_rule_exactly(action, number, *conditions)

    def families(self):
        words = ' '.join(self.unit.values('RestrictAddressFamilies')).split()
        if not words:
            return None
        assert not any(word.startswith('~') for word in words), 'a list of families that are refused is not known here'
        allowed = {int(getattr(socket, word)): word for word in words}
        names = {int(family): family.name for family in socket.AddressFamily}
        made = self.new_filter()
        self.add(made, self.refusal('socket', errno.EAFNOSUPPORT), 'socket', seccomp.Arg(0, seccomp.GT, ANY_FAMILY))
        for family in range(ANY_FAMILY + 1):
            if family not in allowed:
                action = self.refusal(f'socket:{names.get(family, family)}', errno.EAFNOSUPPORT)
                self.add(made, action, 'socket', seccomp.Arg(0, seccomp.EQ, family))
        return made

    def memory(self):
        if not self.unit.is_on('MemoryDenyWriteExecute'):
            return None
        made, both = self.new_filter(), mmap.PROT_WRITE | mmap.PROT_EXEC
        for call, bits in (('mmap', both), ('mprotect', mmap.PROT_EXEC), ('pkey_mprotect', mmap.PROT_EXEC), ('shmat', SHM_EXEC)):
            self.add(made, self.refusal(call), call, seccomp.Arg(2, seccomp.MASKED_EQ, bits, bits))
        return made

    def realtime(self):
        if not self.unit.is_on('RestrictRealtime'):
            return None
        made, call = self.new_filter(), 'sched_setscheduler'
        for policy in set(range(os.SCHED_IDLE)) - {os.SCHED_OTHER, os.SCHED_BATCH}:
            self.add(made, self.refusal(call), call, seccomp.Arg(1, seccomp.EQ, policy))
        self.add(made, self.refusal(call), call, seccomp.Arg(1, seccomp.GT, os.SCHED_IDLE))
        return made

    def modes(self):
        if not self.unit.is_on('RestrictSUIDSGID'):
            return None
        made = self.new_filter()
        for bit in (stat.S_ISUID, stat.S_ISGID):
            for call, place in MODES.items():
                self.add(made, self.refusal(call), call, seccomp.Arg(place, seccomp.MASKED_EQ, bit, bit))
            for call, place in OPEN_MODES.items():
                self.add(made, self.refusal(call), call, seccomp.Arg(place, seccomp.MASKED_EQ, os.O_CREAT, os.O_CREAT),
                         seccomp.Arg(place + 1, seccomp.MASKED_EQ, bit, bit))
        # Its mode lies in memory, which a filter does not see: callers take openat.
        self.add(made, seccomp.ERRNO(errno.ENOSYS), 'openat2')
        return made

    def namespaces(self):
        if self.unit.value('RestrictNamespaces') is None:
            return None
        assert self.unit.is_on('RestrictNamespaces'), 'a list of namespaces is not known here'
        made = self.new_filter()
        for call in ('unshare', 'clone'):
            for bit in NAMESPACES:
                self.add(made, self.refusal(call), call, seccomp.Arg(0, seccomp.MASKED_EQ, bit, bit))
        self.add(made, self.refusal('setns'), 'setns')
        # As openat2: libraries take clone.
        self.add(made, seccomp.ERRNO(errno.ENOSYS), 'clone3')
        return made

    def personality(self):
        if not self.unit.is_on('LockPersonality'):
            return None
        made = self.new_filter()
        self.add(made, self.refusal('personality'), 'personality', seccomp.Arg(0, seccomp.NE, PERSONALITY))
        return made

    def groups(self):
        made = self.new_filter()
        for setting, word in GROUPS.items():
            if self.unit.is_on(setting):
                for call in calls_of(word):
                    self.add(made, self.refusal(call), call)
        for setting, calls in CALLS.items():
            if self.unit.is_on(setting):
                for call in calls:
                    self.add(made, self.refusal(call), call)
        return made

    def architectures(self):
        value = self.unit.value('SystemCallArchitectures')
        if value is None:
            return None
        assert value == 'native', value
        made = seccomp.SyscallFilter(seccomp.ALLOW)
        made.set_attr(seccomp.Attr.ACT_BADARCH, seccomp.KILL_PROCESS)
        return made

    def calls(self):
        is_allowed, calls = listed_calls(self.unit)
        if is_allowed is None:
            return None
        name = self.unit.value('SystemCallErrorNumber')
        assert name, 'a filter without an error number ends the service'
        number = getattr(errno, name)
        if not is_allowed:
            made = self.new_filter()
            for call in calls:
                self.add(made, self.refusal(call, number), call)
            return made
        made = self.new_filter(seccomp.ERRNO(number) if self.errors else seccomp.KILL_PROCESS)
        for call in calls:
            self.add(made, seccomp.ALLOW, call)
        if not self.errors:
            for call in self.survived - calls:
                self.add(made, seccomp.ERRNO(number), call.partition(':')[0])
        return made
