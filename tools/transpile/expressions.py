"""The text of an expression in C, and how tightly it binds."""

import ast
from contextlib import contextmanager

from differentiate.scope import Scope, parameters

from .modules import Refused

#: Operators, and how tightly each of them binds in C: 5 a product, 4 a sum, 3 a shift, 2 a comparison.
BINARY = {
    ast.Add: ("+", 4),
    ast.Sub: ("-", 4),
    ast.Mult: ("*", 5),
    ast.Div: ("/", 5),
    ast.LShift: ("<<", 3),
}
WHOLE = {ast.FloorDiv: "floor_div", ast.Mod: "modulo"}
COMPARE = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="}
UNARY, CALL = 6, 7
#: Of math.h, which every compiler has without a library, with what they return.
MATH = {"copysign": "float", "fabs": "float", "isfinite": "bool", "sqrt": "float"}
#: Constants of the module math.
NUMBERS = {"pi": "M_PI", "inf": "INFINITY", "nan": "NAN"}
C_WORDS = set("auto char default do double float int long register short signed static switch union".split())
#: What is asked of all rates at once, and what is a rate of each direction (native/directions.h).
OF_ALL, OF_EACH = {"nonzero", "common_rate"}, {"root_rate", "size_rate"}


def named(name):
    """A name that is not one of C's words."""
    return f"{name}_" if name in C_WORDS else name


class Expressions(Scope):
    """Writes the expressions of one function of the module ``source``."""

    def __init__(self, kernel, source, node):
        super().__init__(kernel, source.name, node)
        self.source, self.in_each, self.in_test = source, False, False

    def refuse(self, node, why):
        raise Refused(f"{self.source.path.name}, line {node.lineno}: {why}")

    @contextmanager
    def each_direction(self, on=True):
        """Within it rates stand for those of one direction, or ``on`` being false for all of them."""
        before, self.in_each = self.in_each, on
        yield
        self.in_each = before

    def value(self, node):
        """The text of an expression."""
        return self.expression(node)[0]

    def test(self, node):
        """The text of a condition."""
        if self.kind(node) not in ("bool", "int"):
            self.refuse(node, f"a condition is a bool, and {ast.unparse(node)} is a {self.kind(node)}")
        return self.value(node)

    def part(self, node, least):
        """The text of an expression within one that binds as tightly as ``least``."""
        text, binds = self.expression(node)
        return text if binds >= least else f"({text})"

    def expression(self, node):
        write = getattr(self, type(node).__name__.lower(), None)
        if write is None:
            self.refuse(node, f"the dialect has no {type(node).__name__}")
        return write(node)

    def place(self, target):
        """Where a target is stored."""
        with self.each_direction(False):
            return self.value(target)

    def constant(self, node):
        if isinstance(node.value, bool):
            return str(node.value).lower(), CALL
        if isinstance(node.value, int):
            return (str(node.value) if node.value < 2**31 else f"INT64_C({node.value})"), CALL
        if isinstance(node.value, float):
            return repr(node.value), CALL
        self.refuse(node, f"the dialect has no {node.value!r}")

    def name(self, node):
        if node.id in self.kinds:
            return self.along_each(named(node.id), self.kinds[node.id]), CALL
        imports = self.source.imports
        home = next((home for home, names in imports.items() if node.id in names), None)
        if home is None and node.id not in self.source.constants:
            if node.id not in NUMBERS:
                self.refuse(node, f"{node.id} is nothing that the kernel has")
            return NUMBERS[node.id], CALL
        return f"{home or self.module}__{node.id}", CALL

    def along_each(self, text, kind):
        return f"each({text})" if self.in_each and kind == "rate" else text

    def subscript(self, node):
        if isinstance(node.value, ast.Name) and self.kinds.get(node.value.id) in ("array", "rates"):
            if self.kind(node.slice) != "int":
                self.refuse(node, f"the index {ast.unparse(node.slice)} is a {self.kind(node.slice)}")
            with self.each_direction(False):
                index = self.value(node.slice)
            rates = self.kinds[node.value.id] == "rates"
            text = f"{'RATE_AT' if rates else 'AT'}({named(node.value.id)}, {index})"
            return self.along_each(text, "rate" if rates else "float"), CALL
        if ast.unparse(node).endswith(".shape[0]"):
            return f"{named(node.value.value.id)}.shape[0]", CALL
        self.refuse(node, f"{ast.unparse(node.value)} is no array")

    def unaryop(self, node):
        if isinstance(node.op, ast.Not):
            return f"!{self.part(node.operand, CALL)}", UNARY
        if not isinstance(node.op, ast.USub) or self.kind(node.operand) == "bool":
            self.refuse(node, f"the dialect has no {ast.unparse(node)}")
        return f"-{self.part(node.operand, CALL)}", UNARY

    def binop(self, node):
        return self.binary(node)

    def binary(self, node):
        kinds = [self.kind(side) for side in (node.left, node.right)]
        if "bool" in kinds:
            self.refuse(node, f"{ast.unparse(node)} computes with a bool")
        if type(node.op) in WHOLE or isinstance(node.op, ast.LShift):
            if kinds != ["int", "int"]:
                self.refuse(node, f"{ast.unparse(node)} wants two ints")
            if type(node.op) in WHOLE:
                return f"{WHOLE[type(node.op)]}({self.value(node.left)}, {self.value(node.right)})", CALL
        if type(node.op) not in BINARY:
            self.refuse(node, f"the dialect has no {type(node.op).__name__}")
        sign, binds = BINARY[type(node.op)]
        sides = [self.part(node.left, binds), self.part(node.right, binds + 1)]
        constant = [isinstance(side, ast.Constant) for side in (node.left, node.right)]
        if isinstance(node.op, ast.Div):
            sides = [
                self.as_double(side) if kind == "int" else text
                for side, kind, text in zip((node.left, node.right), kinds, sides)
            ]
        elif kinds == ["int", "int"] and (constant[0] and isinstance(node.op, ast.LShift) or all(constant)):
            sides[0] = f"INT64_C({sides[0]})"
        return f"{sides[0]} {sign} {sides[1]}", binds

    def as_double(self, node):
        """The text of an int as a double."""
        return f"(double){self.part(node, CALL)}"

    def compare(self, node):
        sides = [node.left, *node.comparators]
        if len(sides) > 2 or type(node.ops[0]) not in COMPARE:
            self.refuse(node, f"{ast.unparse(node)}: two values are compared by < <= > >= == or !=")
        if any(self.kind(side) == "rate" for side in sides):
            self.refuse(node, "rates are not compared; the word nonzero asks them")
        return f"{self.part(node.left, 3)} {COMPARE[type(node.ops[0])]} {self.part(sides[1], 3)}", 2

    def boolop(self, node):
        for one in node.values:
            if self.kind(one) != "bool":
                self.refuse(one, f"{ast.unparse(one)} is a {self.kind(one)}, and 'and' and 'or' join bools")
        sign = "&&" if isinstance(node.op, ast.And) else "||"
        return f" {sign} ".join(self.part(one, 2) for one in node.values), 1

    def call(self, node, outs=None):
        """A call of the kernel or of C; with ``outs``, a text alone, of a function whose results go there."""
        if outs is None:
            cast = isinstance(node.func, ast.Name) and node.func.id in ("int", "float")
            return self.call(node, []), UNARY if cast else CALL
        if not isinstance(node.func, ast.Name) or node.keywords:
            self.refuse(node, f"{ast.unparse(node)}: the dialect calls functions by name, without keywords")
        name = node.func.id
        home = self.kernel.home(self.module, name)
        if home:
            given = self.given(node, parameters(self.kernel.node(home, name)), name)
            return f"{home}__{name}({', '.join([*outs, *given])})"
        if name in ("int", "float"):
            return f"({'int64_t' if name == 'int' else 'double'}){self.part(node.args[0], CALL)}"
        kinds = [self.kind(one) for one in node.args]
        given = [self.value(one) for one in node.args]
        if name in ("min", "max"):
            if set(kinds) not in ({"float"}, {"int"}):
                self.refuse(node, f"{ast.unparse(node)} compares a {' with a '.join(kinds)}")
            text = given[0]
            for other in given[1:]:
                text = f"{'double' if kinds[0] == 'float' else 'int64'}_{name}({text}, {other})"
            return text
        if name not in MATH:
            self.refuse(node, f"{name} is a function that neither the kernel nor math.h has")
        return f"{name}({', '.join(given)})"

    def given(self, node, wanted, name):
        """The arguments of a call of the kernel."""
        if len(wanted) != len(node.args):
            self.refuse(node, f"{name} has {len(wanted)} arguments, and gets {len(node.args)}")
        texts = []
        for one, (parameter, kind) in zip(node.args, wanted):
            found = self.kind(one)
            if kind == "rate" and name not in OF_EACH:
                texts.append(self.all_rates(one))
            elif kind == found or (kind, found) == ("rate", "float"):
                texts.append(self.value(one))
            elif (kind, found) == ("float", "int"):
                texts.append(self.as_double(one))
            else:
                self.refuse(
                    one, f"{name} wants a {kind} for {parameter}, and {ast.unparse(one)} is a {found}"
                )
        return texts

    def all_rates(self, node):
        """The text of a rate along all directions: a name for a sum or a product of rates."""
        with self.each_direction(False):
            if isinstance(node, (ast.Name, ast.Subscript)) and self.kind(node) == "rate":
                return self.value(node)
            if self.kind(node) != "rate":
                return f"along_all({self.value(node)})"
            if self.in_test:
                self.refuse(node, "the condition of a loop hands on a rate that has no name")
            name = self.own("rates", "rate")
            self.store(node, name, "rate", node)
        return name
