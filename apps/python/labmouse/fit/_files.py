"""Files of users, read as far as they may be long."""

import os
from typing import Union

from .. import Error


def content_of(path: "Union[str, os.PathLike[str]]", most: int) -> bytes:
    """All bytes of a file of at most so many MiB; raises Error with the file otherwise. Devices without an end are refused, too."""
    try:
        with open(path, "rb") as file:
            content = file.read((most << 20) + 1)
    except OSError as error:
        raise Error(f"{path}: error: {error.strerror}") from error
    if len(content) > most << 20:
        raise Error(f"{path}: error: has more than {most} MiB; cut it")
    return content
