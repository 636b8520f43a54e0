"""Writing DXF tag by tag, so that a drawing can be exactly as plain or as odd as a case asks for.

A tag is a pair (group code, value). `ascii_bytes` and `binary_bytes` lay a list of tags out as a file. Nothing here
comes from ezdxf: the writer must not share a misunderstanding with the oracle that reads it back.
"""

import struct

BINARY_SENTINEL = b"AutoCAD Binary DXF\r\n\x1a\x00"


def number(value):
    """A float as the shortest decimal text that keeps 12 digits."""
    text = f"{value:.12g}"
    return text if any(c in text for c in ".en") else text + ".0"


def text_of(value):
    return number(value) if isinstance(value, float) else str(value)


def ascii_bytes(tags, eol="\r\n", encoding="utf-8"):
    """The tags as an ASCII DXF: code right-justified to three columns, as AutoCAD writes it."""
    return "".join(f"{code:>3}{eol}{text_of(value)}{eol}" for code, value in tags).encode(encoding)


def binary_kind(code):
    """How a binary DXF stores the value of a group code."""
    if 10 <= code <= 59 or 110 <= code <= 149 or 210 <= code <= 239 or 460 <= code <= 469 or 1010 <= code <= 1059:
        return "double"
    if 60 <= code <= 79 or 170 <= code <= 179 or 270 <= code <= 289 or 370 <= code <= 389 or 400 <= code <= 409:
        return "int16"
    if 90 <= code <= 99 or 420 <= code <= 429 or 440 <= code <= 459 or code == 1071:
        return "int32"
    if 160 <= code <= 169:
        return "int64"
    if 290 <= code <= 299:
        return "byte"
    if 1060 <= code <= 1070:
        return "int16"
    return "text"


def binary_bytes(tags, encoding="utf-8", short_codes=False):
    """The tags as a binary DXF. Up to R12 group codes are one byte (`short_codes`), from R13 on two."""
    out = bytearray(BINARY_SENTINEL)
    formats = {"double": "<d", "int16": "<h", "int32": "<i", "int64": "<q", "byte": "<B"}
    for code, value in tags:
        if not short_codes:
            out += struct.pack("<H", code)
        elif code < 255:
            out += struct.pack("<B", code)
        else:
            out += struct.pack("<BH", 255, code)
        kind = binary_kind(code)
        if kind == "text":
            out += str(value).encode(encoding) + b"\0"
        else:
            out += struct.pack(formats[kind], float(value) if kind == "double" else int(value))
    return bytes(out)
