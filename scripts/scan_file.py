"""Reads the scans this package writes: organised, binary PCD with the fields of scan_points."""
import numpy as np


class ScanFileError(Exception):
    """One line: file, cause, remedy."""


def read_scan(path):
    """The scan as a structured array of shape (rows, cells): x y z intensity sigma stage time flags."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise ScanFileError("%s: cannot be read: %s" % (path, error.strerror))
    header, offset = _read_header(path, content)
    dtype = _dtype(path, header)
    width, height = int(header["WIDTH"][0]), int(header["HEIGHT"][0])
    if len(content) - offset < width * height * dtype.itemsize:
        raise ScanFileError("%s: ends after %d of %d bytes of points, write it again" %
                            (path, len(content) - offset, width * height * dtype.itemsize))
    return np.frombuffer(content, dtype, count=width * height, offset=offset).reshape(height, width)


def _read_header(path, content):
    header = {}
    offset = 0
    while "DATA" not in header:
        end = content.find(b"\n", offset, offset + 4096)
        if end < 0:
            raise ScanFileError("%s: is no PCD file: its header has no DATA line" % path)
        words = content[offset:end].decode("ascii", "replace").split()
        offset = end + 1
        if words and not words[0].startswith("#"):
            header[words[0]] = words[1:]
    if header["DATA"] != ["binary"]:
        raise ScanFileError("%s: DATA is %s, must be binary" % (path, " ".join(header["DATA"])))
    for key in ("FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT"):
        if key not in header:
            raise ScanFileError("%s: its header has no %s line" % (path, key))
    return header, offset


def _dtype(path, header):
    kinds = {"F": "f", "U": "u", "I": "i"}
    counts = header.get("COUNT", ["1"] * len(header["FIELDS"]))
    members = []
    for place, (name, size, kind, count) in enumerate(zip(header["FIELDS"], header["SIZE"], header["TYPE"], counts)):
        if name == "_":  # padding; every member of a numpy dtype needs a name of its own
            members.append(("padding%d" % place, "V%d" % (int(size) * int(count))))
        else:
            members.append((name, "<%s%s" % (kinds[kind], size)))
    for name in ("x", "y", "z"):
        if name not in header["FIELDS"]:
            raise ScanFileError("%s: has no field %s" % (path, name))
    return np.dtype(members)
