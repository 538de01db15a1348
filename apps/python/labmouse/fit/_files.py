"""Reads files of users, up to a size limit."""

import os
from typing import Union

from .. import Error


def content_of(path: "Union[str, os.PathLike[str]]", most: int) -> bytes:
    """All bytes of a file. Raises Error if it has more than `most` MiB (endless devices do) or cannot be read."""
    try:
        with open(path, "rb") as file:
            content = file.read((most << 20) + 1)
    except OSError as error:
        raise Error(f"{path}: error: {error.strerror}") from error
    if len(content) > most << 20:
        raise Error(f"{path}: error: has more than {most} MiB; cut it")
    return content
