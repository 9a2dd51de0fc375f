#!/usr/bin/env python3
"""Length of classical CAN frames on the wire, for comparison with hub/bit_time.

Written from the rules of ISO 11898-1 alone: a frame is a string of the characters 0 and 1. The CRC is the remainder of
a division of polynomials, and stuff bits are put in by replacing text. Prints "FRAME BITS" for each frame of a set:
chosen extremes, then random ones. A frame is written as candump writes it.
"""

import argparse
import random
import re

POLYNOMIAL = 0b1100010110011001  # x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1
CRC_BITS = 15
# CRC delimiter, ACK slot, ACK delimiter, end of frame, intermission: fixed form, no stuffing
TAIL = "1" + "0" + "1" + "1" * 7 + "1" * 3
RUN = re.compile("00000|11111")


def binary(value, width):
    return format(value, f"0{width}b")


def header(identifier, extended, remote, length):
    """Start of frame to the data length code."""
    code = binary(length, 4)
    rtr = "1" if remote else "0"
    if not extended:
        return "0" + binary(identifier, 11) + rtr + "0" + "0" + code
    whole = binary(identifier, 29)
    return "0" + whole[:11] + "1" + "1" + whole[11:] + rtr + "00" + code


def checksum(bits):
    """Remainder of bits times x^15 by the generator polynomial."""
    rest = int(bits, 2) << CRC_BITS
    while rest.bit_length() > CRC_BITS:
        rest ^= POLYNOMIAL << (rest.bit_length() - CRC_BITS - 1)
    return binary(rest, CRC_BITS)


def stuffed(bits):
    """After five equal bits comes one of the other value, which counts for the five that follow."""
    position = 0
    while run := RUN.search(bits, position):
        inverse = "1" if run.group()[0] == "0" else "0"
        bits = bits[: run.end()] + inverse + bits[run.end() :]
        position = run.end()
    return bits


def length_on_wire(identifier, extended, remote, length, data):
    bits = header(identifier, extended, remote, length)
    if not remote:
        bits += "".join(binary(byte, 8) for byte in data)
    return len(stuffed(bits + checksum(bits)) + TAIL)


def extremes():
    """No stuffing, the most stuffing, and everything short of data or of identifier."""
    fillings = [0x00, 0xFF, 0x55, 0xAA, 0x0F, 0xF0, 0x1F, 0x3C, 0x78, 0xE1, 0x07, 0xC1]
    for extended, identifiers in (
        (False, [0x000, 0x001, 0x0F0, 0x2AA, 0x3E0, 0x555, 0x555 ^ 0x7FF, 0x783, 0x7C1, 0x7FF]),
        (True, [0x0, 0x1, 0x0AAAAAAA, 0x15555555, 0x1F07C1F0, 0x1E1E1E1E, 0x1FFFFFFF, 0x10000000]),
    ):
        for identifier in identifiers:
            for length in range(9):
                yield identifier, extended, True, length, b""
                for filling in fillings[: 1 if length == 0 else None]:
                    yield identifier, extended, False, length, bytes([filling] * length)


def random_frames(count, seed):
    chance = random.Random(seed)
    for _ in range(count):
        extended = chance.random() < 0.5
        identifier = chance.getrandbits(29 if extended else 11)
        remote = chance.random() < 0.1
        length = chance.randint(0, 8)
        # runs of equal bits are rare in uniform bytes: half of the frames are made of long ones
        data = bytes(chance.choice([0x00, 0xFF, 0x0F, 0xF8, 0x83, chance.getrandbits(8)]) for _ in range(length))
        if chance.random() < 0.5:
            data = bytes(chance.getrandbits(8) for _ in range(length))
        yield identifier, extended, remote, length, b"" if remote else data


def candump(identifier, extended, remote, length, data):
    name = format(identifier, "08X" if extended else "03X")
    return f"{name}#R{length or ''}" if remote else f"{name}#{data.hex().upper()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1, help="of the random frames")
    parser.add_argument("--count", type=int, default=1000, help="of the random frames")
    arguments = parser.parse_args()
    for frame in [*extremes(), *random_frames(arguments.count, arguments.seed)]:
        print(candump(*frame), length_on_wire(*frame))


if __name__ == "__main__":
    main()
