"""Numbers as print sets them."""
import math


def exponent(value):
    """⁻⁶."""
    return str(value).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def power(value):
    """2·10⁻¹⁶."""
    if value == 0:
        return "0"
    digit, _, tens = f"{value:.0e}".partition("e")
    return f"{digit}·10{exponent(int(tens))}"


def two_digits(value):
    """0.015, 1.5, 150."""
    if value == 0:
        return "0"
    before = int(f"{value:.1e}".partition("e")[2]) + 1  # rounded first: 0.996 is 1.0
    places = max(2 - before, 0)
    return f"{math.floor(value * 10 ** places + 0.5 + 1e-6) / 10 ** places:.{places}f}"


def thousands(value):
    """12,345."""
    return f"{math.floor(value + 0.5):,}"
