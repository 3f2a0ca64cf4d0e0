"""Values and rates of expressions, as text."""

import ast
from collections import namedtuple
from functools import cache

from .rules import ACTIVE_ARRAYS, RATES
from .scope import Scope, parameters

Pair = namedtuple("Pair", "value rate")  # texts; the rate is None for what is constant
OPERATORS = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.LShift: "<<",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
}


class Expressions(Scope):
    """Writes the values and rates of one function's expressions, line by line."""

    def __init__(self, kernel, module, node):
        super().__init__(kernel, module, node)
        self.derivatives, self.lines, self.depth, self.count = set(), [], 1, 0
        self.active = {
            name for name, kind in self.kinds.items() if kind == "float" and name in dict(parameters(node))
        }
        self.names = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)} | set(self.kinds)
        assignments = [
            (part.targets[0] if isinstance(part, ast.Assign) else part.target, part.value)
            for part in ast.walk(node)
            if isinstance(part, (ast.Assign, ast.AugAssign))
        ]
        before = -1
        while len(self.active) != before:
            before = len(self.active)
            for target, value in assignments:
                self.note_active(target, value)

    def note_active(self, target, value):
        targets = target.elts if isinstance(target, ast.Tuple) else [target]
        values = value.elts if isinstance(value, ast.Tuple) else [value] * len(targets)
        for one, its in zip(targets, values):
            if isinstance(one, ast.Name) and self.kinds[one.id] == "float" and self.follows(its):
                self.active.add(one.id)

    def follows(self, node):
        """Whether an expression has a rate."""
        if isinstance(node, ast.Name):
            return node.id in self.active
        if isinstance(node, ast.Subscript):
            return node.value.id in ACTIVE_ARRAYS
        if isinstance(node, ast.Call):
            name = node.func.id
            if name in ("int", "isfinite", "held", "rate_of", "nonzero", "common_rate"):
                return False
            if name in ("moving", "seeded", "differentiated"):
                return True
            if self.kernel.home(self.module, name) is not None:
                return self.kernel.differentiated(self.module, name) is not None
            return any(self.follows(argument) for argument in node.args)
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return False
        return any(self.follows(child) for child in ast.iter_child_nodes(node))

    def write(self, line):
        self.lines.append("    " * self.depth + line)

    def fresh(self, letter):
        """A name that the function does not have."""
        self.count += 1
        name = f"{letter}{self.count}"
        return name if name not in self.names else self.fresh(letter)

    def derivative_call(self, call, derivative):
        """The text of a derivative's call."""
        self.derivatives.add(derivative)
        arguments = []
        for (name, kind), argument in zip(parameters(self.kernel.node(*derivative)), call.args):
            if kind == "array":
                arguments += [argument.id, argument.id + "_t"] if name in ACTIVE_ARRAYS else [argument.id]
            elif kind == "float":
                pair = self.pair(argument)
                arguments += [pair.value, pair.rate or "0.0"]
            else:
                arguments.append(self.value(argument))
        return f"{derivative[1]}_t({', '.join(arguments)})"

    def value(self, node, own=False):
        """Text of an expression's value; calls that change something stand before it.
        ``own``: a call that stays one."""
        if isinstance(node, ast.Call) and node.func.id in ("held", "moving", "seeded"):
            return self.value(node.args[0])
        if isinstance(node, ast.Call) and node.func.id == "rate_of":
            return self.pair(node.args[0]).rate or "0.0"
        if isinstance(node, ast.Call) and not own:
            home = self.kernel.home(self.module, node.func.id)
            if home is not None and self.kernel.writes(home, node.func.id):
                name = self.fresh("n")
                kinds = self.kernel.returns(home, node.func.id)
                derivative = self.kernel.differentiated(self.module, node.func.id)
                if derivative is None:
                    self.write(f"{name} = {self.value(node, own=True)}")
                else:
                    results = f"{name}, {name}_t" if kinds == ("float",) else name
                    self.write(f"{results} = {self.derivative_call(node, derivative)}")
                return name
        if isinstance(node, ast.BoolOp):
            before = len(self.lines)
            parts = [self.operand(part) for part in node.values]
            if len(self.lines) > before:
                raise ValueError(
                    f"{self.module}.py, line {node.lineno}: one of several conditions calls "
                    f"what changes something"
                )
            return (" and " if isinstance(node.op, ast.And) else " or ").join(parts)
        if isinstance(node, ast.Call):
            return f"{node.func.id}({', '.join(self.value(argument) for argument in node.args)})"
        if isinstance(node, ast.Compare):
            return f"{self.value(node.left)} {OPERATORS[type(node.ops[0])]} {self.value(node.comparators[0])}"
        if isinstance(node, ast.Subscript):
            return f"{node.value.id}[{self.value(node.slice)}]"
        if isinstance(node, ast.BinOp):
            return f"{self.operand(node.left)} {OPERATORS[type(node.op)]} {self.operand(node.right)}"
        if isinstance(node, ast.UnaryOp):
            sign = "not " if isinstance(node.op, ast.Not) else "-"
            return f"{sign}{self.operand(node.operand)}"
        return ast.unparse(node)

    def operand(self, node):
        """Text of a value as part of a larger expression."""
        text = self.value(node)
        return text if is_atom(text) else f"({text})"

    def atom(self, node):
        """A pair whose value is a name, a number or an array's element."""
        pair = self.pair(node)
        whole = self.kind(node) == "int"  # C multiplies vectors by floats only
        return Pair(self.named(f"float({pair.value})" if whole else pair.value), pair.rate)

    def named(self, text):
        """A name for the value ``text``, or itself if it is one already."""
        if is_atom(text):
            return text
        name = self.fresh("v")
        self.write(f"{name} = {text}")
        return name

    def pair(self, node):
        """Value and rate of an expression of floats."""
        if not self.follows(node) and not (isinstance(node, ast.Call) and node.func.id == "rate_of"):
            text = self.value(node)
            return Pair(text, None)
        if isinstance(node, ast.Name):
            return Pair(node.id, node.id + "_t")
        if isinstance(node, ast.Subscript):
            index = self.value(node.slice)
            if has_call(node.slice):
                at = self.fresh("k")
                self.write(f"{at} = {index}")
                index = at
            return Pair(f"{node.value.id}[{index}]", f"{node.value.id}_t[{index}]")
        if isinstance(node, ast.UnaryOp):
            pair = self.pair(node.operand)
            return Pair(f"-{closed(pair.value)}", f"-{closed(pair.rate)}")
        if isinstance(node, ast.BinOp):
            return self.binary(node)
        return self.call(node)

    def binary(self, node):
        """Value and rate of a sum, product or quotient."""
        if isinstance(node.op, (ast.Add, ast.Sub)):
            left, right = self.pair(node.left), self.pair(node.right)
            sign = OPERATORS[type(node.op)]
            rate = " ".join(filter(None, (left.rate, right.rate and f"{sign} {closed(right.rate)}")))
            return Pair(
                f"{closed(left.value)} {sign} {closed(right.value)}",
                rate if left.rate else rate.removeprefix("+ ").replace("- ", "-", 1),
            )
        left, right = self.atom(node.left), self.atom(node.right)
        if isinstance(node.op, ast.Mult):
            parts = [
                f"{closed(left.rate)} * {right.value}" if left.rate else "",
                f"{left.value} * {closed(right.rate)}" if right.rate else "",
            ]
            return Pair(f"{left.value} * {right.value}", " + ".join(filter(None, parts)))
        if isinstance(node.op, ast.Div):
            if not right.rate:
                return Pair(f"{left.value} / {right.value}", f"{closed(left.rate)} / {right.value}")
            quotient = self.named(f"{left.value} / {right.value}")
            rate = (
                f"{closed(left.rate)} - {quotient} * {closed(right.rate)}"
                if left.rate
                else f"-{quotient} * {closed(right.rate)}"
            )
            return Pair(quotient, f"({rate}) / {right.value}")
        raise ValueError(f"{self.module}.py, line {node.lineno}: this operation has no rate")

    def call(self, node):
        """Value and rate of a call."""
        name = node.func.id
        if name == "moving":
            other = self.pair(node.args[1])
            return Pair(self.value(node.args[0]), other.rate)
        if name == "seeded":
            return Pair(self.value(node.args[0]), self.value(node.args[1]))
        if name == "rate_of":
            return Pair(self.pair(node.args[0]).rate or "0.0", None)
        derivative = self.kernel.called(self.module, node)
        if derivative:
            result = self.fresh("v")
            call = node.args[0] if name == "differentiated" else node
            self.write(f"{result}, {result}_t = {self.derivative_call(call, derivative)}")
            return Pair(result, result + "_t")
        if name in ("min", "max"):
            return self.smaller(*node.args, "<" if name == "min" else ">")
        argument = self.atom(node.args[0])
        value = f"{name}({argument.value})"
        if "{f}" in RATES[name]:
            value = self.named(value)
        return Pair(value, RATES[name].format(v=argument.value, f=value, d=closed(argument.rate)))

    def smaller(self, first, second, sign):
        """Value and rate of the smaller or larger of two values: the first, unless the second truly is."""
        one, other, chosen = self.pair(first), self.atom(second), self.fresh("v")
        self.write(f"{chosen} = {one.value}")
        self.write(f"{chosen}_t = {one.rate or '0.0'}")
        self.write(f"if {other.value} {sign} {chosen}:")
        self.write(f"    {chosen} = {other.value}")
        self.write(f"    {chosen}_t = {other.rate or '0.0'}")
        return Pair(chosen, chosen + "_t")


def has_call(node):
    """Whether an expression calls something."""
    return any(isinstance(part, ast.Call) for part in ast.walk(node))


def is_atom(text):
    """Whether a text is a name, a number or an array's element."""
    return isinstance(expression(text), (ast.Name, ast.Constant, ast.Subscript))


def closed(text):
    """A text as part of a larger expression."""
    whole = isinstance(expression(text), (ast.Name, ast.Constant, ast.Subscript, ast.Call))
    return text if whole else f"({text})"


@cache
def expression(text):
    """The syntax tree of an expression."""
    return ast.parse(text, mode="eval").body
