"""Bits of a CAN frame on the wire, stuffing included (ISO 11898-1)."""

CRC_POLYNOMIAL, CRC_BITS = 0x4599, 15
TAIL = 1 + 1 + 1 + 7 + 3  # CRC delimiter, ACK slot and delimiter, end of frame, intermission


def bits_of(identifier, data):
    """Bits of a data frame with an identifier of 11 bits."""
    word = identifier << 7 | len(data)  # start of frame, RTR, IDE and r0 are zeros
    bits = [int(bit) for bit in f"{word:019b}"] + [int(bit) for byte in data for bit in f"{byte:08b}"]
    crc = 0
    for bit in bits:
        divide = bit ^ crc >> CRC_BITS - 1
        crc = (crc << 1 & 0x7FFF) ^ (CRC_POLYNOMIAL if divide else 0)
    count, last, equal = 0, 1, 0
    for bit in bits + [crc >> at & 1 for at in range(CRC_BITS - 1, -1, -1)]:
        equal = equal + 1 if bit == last else 1
        count, last = count + 1, bit
        if equal == 5:
            count, last, equal = count + 1, 1 - bit, 1
    return count + TAIL


def mean_bits(frames):
    """Of (identifier, data)s; 0.0 if there are none."""
    return sum(bits_of(*frame) for frame in frames) / len(frames) if frames else 0.0
