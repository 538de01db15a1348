# random, throw for throw as Python's own: the Mersenne Twister of Makoto Matsumoto and Takuji Nishimura (1997), seeded and
# used as CPython does since 3.2. Only seeds that are neither numbers nor nothing give other throws.
from math import ceil, cos, exp, floor, log, pi, sin, sqrt
from _beginning import told

_WORDS = 624


def _text_number(text):
    number = 0
    for byte in text if isinstance(text, (bytes, bytearray)) else str(text).encode():
        number = (number * 257 + byte + 1) % (1 << 64)
    return number


class Random:
    def __init__(self, x=None):
        self.seed(x)

    def seed(self, a=None, version=2):
        """Without a seed, one that follows from the contest's, as the bridge of the command line has it."""
        if a is None:
            a = _source.getrandbits(64)
        if isinstance(a, float):
            a = int(a) if a == int(a) else _text_number(a)
        if not isinstance(a, int):
            a = _text_number(a)
        a, key = abs(int(a)), []
        while a or not key:
            key.append(a & 0xffffffff)
            a >>= 32
        self._begin(key)
        self._spare = None

    def _begin(self, key):
        words = [19650218]
        for at in range(1, _WORDS):
            last = words[-1]
            words.append((1812433253 * (last ^ (last >> 30)) + at) & 0xffffffff)
        at, k = 1, 0
        for _ in range(max(_WORDS, len(key))):
            last = words[at - 1]
            words[at] = ((words[at] ^ ((last ^ (last >> 30)) * 1664525)) + key[k] + k) & 0xffffffff
            at, k = at + 1, (k + 1) % len(key)
            if at == _WORDS:
                words[0], at = words[-1], 1
        for _ in range(_WORDS - 1):
            last = words[at - 1]
            words[at] = ((words[at] ^ ((last ^ (last >> 30)) * 1566083941)) - at) & 0xffffffff
            at += 1
            if at == _WORDS:
                words[0], at = words[-1], 1
        words[0] = 0x80000000
        self._words, self._at = words, _WORDS

    def _twist(self):
        words = self._words
        for at in range(_WORDS):
            y = (words[at] & 0x80000000) | (words[(at + 1) % _WORDS] & 0x7fffffff)
            words[at] = words[(at + 397) % _WORDS] ^ (y >> 1) ^ (0x9908b0df if y & 1 else 0)
        self._at = 0

    def _word(self):
        if self._at == _WORDS:
            self._twist()
        y = self._words[self._at]
        self._at += 1
        y ^= y >> 11
        y ^= (y << 7) & 0x9d2c5680
        y ^= (y << 15) & 0xefc60000
        return y ^ (y >> 18)

    def random(self):
        return ((self._word() >> 5) * 67108864 + (self._word() >> 6)) / 9007199254740992

    def getrandbits(self, k):
        bits, at = 0, 0
        while k > 0:
            bits |= (self._word() >> max(0, 32 - k)) << at
            at, k = at + 32, k - 32
        return bits

    def _below(self, n):
        k = len(bin(n)) - 2
        throw = self.getrandbits(k)
        while throw >= n:
            throw = self.getrandbits(k)
        return throw

    def randrange(self, start, stop=None, step=1):
        if stop is None:
            start, stop = 0, start
        choices = len(range(start, stop, step))
        if choices == 0:
            raise ValueError("empty range for randrange()")
        return start + step * self._below(choices)

    def randint(self, a, b):
        return self.randrange(a, b + 1)

    def choice(self, seq):
        if not len(seq):
            raise IndexError("Cannot choose from an empty sequence")
        return seq[self._below(len(seq))]

    def choices(self, population, weights=None, *, cum_weights=None, k=1):
        n = len(population)
        if cum_weights is None and weights is None:
            return [population[floor(self.random() * n)] for _ in range(k)]
        sums = list(cum_weights or [])
        for weight in weights or []:
            sums.append((sums[-1] if sums else 0) + weight)
        throws = [self.random() * sums[-1] for _ in range(k)]
        return [population[min(n - 1, sum(1 for bound in sums if bound <= throw))] for throw in throws]

    def shuffle(self, x):
        for i in reversed(range(1, len(x))):
            j = self._below(i + 1)
            x[i], x[j] = x[j], x[i]

    def sample(self, population, k):
        n = len(population)
        if not 0 <= k <= n:
            raise ValueError("Sample larger than population or is negative")
        if n <= 21 + (4 ** ceil(log(k * 3) / log(4)) if k > 5 else 0):
            pool, taken = list(population), []
            for i in range(k):
                j = self._below(n - i)
                taken.append(pool[j])
                pool[j] = pool[n - i - 1]
            return taken
        places = []
        while len(places) < k:
            j = self._below(n)
            if j not in places:
                places.append(j)
        return [population[j] for j in places]

    def uniform(self, a, b):
        return a + (b - a) * self.random()

    def triangular(self, low=0.0, high=1.0, mode=None):
        u, c = self.random(), 0.5 if mode is None else (mode - low) / (high - low)
        if u > c:
            u, c, low, high = 1.0 - u, 1.0 - c, high, low
        return low + (high - low) * sqrt(u * c)

    def expovariate(self, lambd=1.0):
        return -log(1.0 - self.random()) / lambd

    def gauss(self, mu=0.0, sigma=1.0):
        z, self._spare = self._spare, None
        if z is None:
            angle, radius = self.random() * 2 * pi, sqrt(-2.0 * log(1.0 - self.random()))
            z, self._spare = cos(angle) * radius, sin(angle) * radius
        return mu + z * sigma

    def normalvariate(self, mu=0.0, sigma=1.0):
        while True:
            u, v = self.random(), 1.0 - self.random()
            z = 4 * exp(-0.5) / sqrt(2.0) * (u - 0.5) / v
            if z * z / 4.0 <= -log(v):
                return mu + z * sigma


_source = Random(told["seed"])
_shared = Random(told["seed"])
for _name in dir(Random):
    if not _name.startswith("_"):
        globals()[_name] = getattr(_shared, _name)
