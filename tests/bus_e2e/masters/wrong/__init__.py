"""Masters with one mistake each, by topic, and the rule of canopen-audit that it breaks: MASTERS."""

from . import bus, drive, nmt, pdo, sdo
from .mistake import MASTERS

__all__ = ['MASTERS', 'bus', 'drive', 'nmt', 'pdo', 'sdo']
