# Many robots import numpy, as the capstone project's first file does, and never use it. Only its use is an error.


def __getattr__(name):
    if name.startswith("__"):
        raise AttributeError(name)
    raise ImportError("no module named 'numpy' (for numpy.%s)" % name)
