#!/usr/bin/env python3
"""Checks values and derivatives of random formulas against SymPy's. Skipped (exit code 77) where SymPy is missing."""

import cmath
import json
import math
import os
import subprocess
import sys

try:
    import sympy
except ImportError:
    print("SymPy was not found (Debian: python3-sympy)")
    sys.exit(77)

COUNT = 300
SYMBOLS = sympy.symbols("x y z", real=True)


def real_part(value):
    value = complex(value)
    if abs(value.imag) > 1e-9 * max(1, abs(value.real)):
        raise ValueError("of a complex number")
    return value.real


def step(name, function, slope=lambda u: sympy.Integer(0)):
    """A function of one real argument that SymPy differentiates as we mean it: flat but for jumps, or a kink's sides."""

    def evaluated(cls, u):
        return function(u) if u.is_number and u.is_real and not u.has(sympy.nan, sympy.zoo) else None

    return type(name, (sympy.Function,), {"nargs": 1, "eval": classmethod(evaluated),
                                          "fdiff": lambda self, index=1: slope(self.args[0])})


Sign = step("Sign", sympy.sign)
Floor = step("Floor", sympy.floor)
Abs = step("Absolute", sympy.Abs, lambda u: Sign(u))


def least(a, b):
    return (a + b - Abs(a - b)) / 2


LOCALS = {
    "sign": Sign, "floor": Floor, "abs": Abs, "ln": sympy.log, "atan2": sympy.atan2, "pow": sympy.Pow,
    "log10": lambda u: sympy.log(u) / sympy.log(10), "log2": lambda u: sympy.log(u) / sympy.log(2),
    "cbrt": lambda u: Sign(u) * Abs(u) ** sympy.Rational(1, 3), "hypot": lambda u, v: sympy.sqrt(u ** 2 + v ** 2),
    "ceil": lambda u: -Floor(-u), "mod": lambda u, v: u - v * Floor(u / v), "heaviside": lambda u: (1 + Sign(u)) / 2,
    "min": least, "max": lambda a, b: -least(-a, -b), **dict(zip("xyz", SYMBOLS)),
}
# As complex functions, so that what has no real value shows as a complex one and not as an exception.
FUNCTIONS = {name: getattr(cmath, name) for name in
             "sqrt exp log sin cos tan asin acos atan sinh cosh tanh asinh acosh atanh".split()}
FUNCTIONS |= {
    "Sign": lambda u: (real_part(u) > 0) - (real_part(u) < 0), "Floor": lambda u: math.floor(real_part(u)),
    "Absolute": lambda u: abs(real_part(u)), "atan2": lambda v, u: math.atan2(real_part(v), real_part(u)),
}


def real(function, at):
    """The function's value if it is a finite real number, else None."""
    try:
        v = complex(function(*at))
    except (ArithmeticError, ValueError):
        return None
    if not (math.isfinite(v.real) and math.isfinite(v.imag)) or abs(v.imag) > 1e-9 * max(1, abs(v.real)):
        return None
    return v.real


def close(a, b):
    return abs(a - b) <= 1e-7 * max(1, abs(a), abs(b))


def main():
    tool = os.path.join(os.path.dirname(os.environ["NORMALSCOPE"]), "formula_dump")
    formulas = json.loads(subprocess.run([tool, str(COUNT), "1"], check=True, capture_output=True, text=True).stdout)
    compared = failed = 0
    for formula in formulas:
        f = sympy.sympify(formula["text"].replace("^", "**"), locals=LOCALS, rational=True)
        exact = [f] + [sympy.diff(f, s) for s in SYMBOLS]
        functions = [sympy.lambdify(SYMBOLS, e, [FUNCTIONS, vars(cmath)]) for e in exact]
        for point in formula["points"]:
            at = point["at"]
            if point["f"] is None:
                # The cosine of an imaginary number is real; but then some part of the formula is not.
                parts = (sympy.lambdify(SYMBOLS, e, [FUNCTIONS, vars(cmath)]) for e in sympy.preorder_traversal(f))
                if all(real(part, at) is not None for part in parts):
                    print(f"{formula['text']} at {at}: f has a value, {real(functions[0], at)}")
                    failed += 1
                continue
            ours = [[point["f"]]] + [[point["symbolic"][i], point["reverse"][i]] for i in range(3)]
            for i in range(4):
                theirs = real(functions[i], at)
                for value in ours[i]:
                    if value is None and i > 0:
                        continue  # f may have a value where its derivative has none
                    compared += 1
                    if theirs is not None and close(value, theirs):
                        continue
                    # Double precision may have lost digits on either side: ask for 30 of them.
                    precise = complex(exact[i].evalf(30, subs=dict(zip(SYMBOLS, map(sympy.Float, at)))))
                    if not close(value, precise):
                        print(f"{formula['text']} at {at}: {'f ∂x ∂y ∂z'.split()[i]} is {value}, SymPy's {precise}")
                        failed += 1
    print(f"{compared} values of {len(formulas)} formulas compared, {failed} differ")
    return 1 if failed or compared < 5 * COUNT else 0


if __name__ == "__main__":
    sys.exit(main())
