# typing: names that annotations are made of; nothing reads them here.


class _Kind:
    def __getitem__(self, kinds):
        return self

    def __call__(self, *given, **named):
        return given[-1] if given else self


Any = Callable = Deque = Dict = FrozenSet = Generator = Generic = Iterable = Iterator = List = Literal = Mapping = _Kind()
NewType = Optional = Sequence = Set = Tuple = Type = TypeVar = Union = _Kind()
TYPE_CHECKING = False


def cast(kind, value):
    return value
