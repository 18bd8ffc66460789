"""Sweeps of the alternating iteration for one shape of the pressure, in closed form and counted."""

import math


def limit(alpha):
    """Ratio of the stiffnesses up to which the constant alpha converges: r + 1/r < 6 - 8/alpha + 4/alpha^2."""
    sum_of_both = 6 - 8 / alpha + 4 / alpha**2
    return (sum_of_both + math.sqrt(max(sum_of_both**2 - 4, 0.0))) / 2


def limit_of_weights(assumed):
    """Factor between the ratio of the stiffnesses and that which opposite fractions assume, up to which they converge."""
    sum_of_both = 4 + assumed + 1 / assumed
    return (sum_of_both + math.sqrt(sum_of_both**2 - 4)) / 2


def best_alpha(ratio):
    """The constant with the fewest sweeps for all ratios up to this one (and its inverse); its rate is 1 - 2 alpha."""
    root = math.sqrt(ratio)
    return 2 * root / (1 + root)**2


def rate(alpha, ratio):
    """Factor by which a sweep takes the error down in the end: spectral radius, 2 x 2."""
    half_trace = (1 - alpha)**2 - alpha**2 * (ratio + 1 / ratio) / 2
    determinant = (1 - 2 * alpha)**2
    root = half_trace**2 - determinant
    return math.sqrt(determinant) if root < 0 else abs(half_trace) + math.sqrt(root)


def sweeps(alpha, ratio, tolerance=1e-10, most=20000):
    """Sweeps from zero until the change is below the tolerance, relative to the pressure, or diverges; True: converged.

    The flexibilities are 1 and ratio, the distance between the traces is -1.
    """
    first, second = 0.0, 0.0
    first_change = None
    for count in range(1, most + 1):
        mismatch = first + ratio * second - 1
        one, two = first - alpha * mismatch, second - alpha * mismatch / ratio
        step = alpha * (one - two)
        one, two = one - step, two + step
        change = max(abs(one - first), abs(two - second))
        first, second = one, two
        if change <= tolerance * abs(first + second) / 2:
            return count, True
        first_change = first_change or change
        if change > 1e6 * first_change:
            return count, False
    return most, False


def iterations_of_run(alpha, ratio):
    """schwarz_iterations of a run: two equal problems; where sweeps diverge, one of conjugate gradients in each."""
    count, converged = sweeps(alpha, ratio)
    return 2 * count if converged else count + 2
