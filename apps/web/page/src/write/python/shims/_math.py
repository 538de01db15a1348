# math, with what MicroPython lacks of it.
from math import *


def hypot(*sides):
    return sqrt(sum(side * side for side in sides))


def dist(p, q):
    return hypot(*(a - b for a, b in zip(p, q)))


def gcd(*numbers):
    divisor = 0
    for number in numbers:
        while number:
            divisor, number = number, divisor % number
    return abs(divisor)


def prod(factors, start=1):
    for factor in factors:
        start = start * factor
    return start


def isqrt(n):
    root = int(sqrt(n))
    while root * root > n:
        root -= 1
    while (root + 1) * (root + 1) <= n:
        root += 1
    return root
