"""The C of one function of the kernel, from its syntax tree.

The dialect has few kinds of statements and expressions, and each has one form in C with the same operations in
the same order: the names are those of the Python, comments stand where they stood.  What has no form here is
refused with its line, and so is what would be another kind of number in C: a name that changes its kind, an
``and`` of numbers, a call of anything that neither the kernel nor C has.

In the differentiated kernel a rate beside a value has the type ``lanes`` (native/lanes.h), as many rates as there
are directions in one pass.  A statement that assigns a rate computes all of them, ``EACH_LANE each(x_t) = ...``.
"""

import ast
import io
import tokenize
from contextlib import contextmanager

from differentiate.scope import Scope, parameters

from .modules import Refused, stored

TYPES = {
    "float": "double",
    "int": "int64_t",
    "bool": "bool",
    "rate": "lanes",
    "array": "array_double_1d",
    "rates": "array_lanes_1d",
}
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
#: What is asked of all rates at once, and what is a rate of each direction (native/lanes.h).
OF_ALL, OF_EACH = {"nonzero", "common_rate"}, {"root_rate", "size_rate"}


def named(name):
    """A name that is not one of C's words."""
    return f"{name}_" if name in C_WORDS else name


def comments_of(text):
    """The comments in a module's text (bytes), by their lines."""
    if b"#" not in text:
        return {}
    tokens = tokenize.tokenize(io.BytesIO(text).readline)
    return {token.start[0]: token.string.lstrip("# ") for token in tokens if token.type == tokenize.COMMENT}


class Function(Scope):
    """The C of one function: its ``head`` and its ``text``, of the function ``node`` of the module ``source``."""

    def __init__(self, kernel, source, node, comments=()):
        super().__init__(kernel, source.name, node)
        self.source = source
        self.comments = {line: text for line, text in dict(comments).items() if line > node.lineno}
        self.arguments = dict(parameters(node))
        self.results = kernel.returns(source.name, node.name)
        self.taken = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)} | set(self.arguments)
        self.outs = self.out_names() if len(self.results) > 1 else []
        self.lines, self.depth, self.lane, self.in_test = [], 1, False, False
        self.block(node.body[1:] if ast.get_docstring(node) else node.body)

    def refuse(self, node, why):
        raise Refused(f"{self.source.path.name}, line {node.lineno}: {why}")

    # --- the whole ----------------------------------------------------------------------------------------------

    @property
    def head(self):
        """The function's first line."""
        outs = [f"{TYPES[kind]}* {name}" for name, kind in zip(self.outs, self.results)]
        given = [f"{TYPES[kind]} {named(name)}" for name, kind in self.arguments.items()]
        kind = "void" if self.outs else TYPES[self.results[0]]
        return f"{kind} {self.module}__{self.node.name}({', '.join(outs + given)})"

    @property
    def text(self):
        """The function."""
        by_type = {}
        for name, kind in self.kinds.items():
            if name not in self.arguments:
                by_type.setdefault(TYPES[kind], []).append(named(name))
        own = [f"    {kind} {', '.join(names)};" for kind, names in by_type.items()]
        return "\n".join([self.head, "{", *own, *self.lines, "}"])

    def out_names(self):
        """Where the results go: behind the names that the function returns."""
        returned = next(one.value for one in ast.walk(self.node) if isinstance(one, ast.Return))
        values = returned.elts if isinstance(returned, ast.Tuple) else [None] * len(self.results)
        names = []
        for number, value in enumerate(values):
            name = f"{value.id}_out" if isinstance(value, ast.Name) else f"out_{number}"
            names.append(name if name not in {*names, *self.taken} else self.fresh(f"out_{number}"))
        return names

    def fresh(self, stem):
        """A name that the function does not have."""
        name = next(
            name
            for name in (stem, *(f"{stem}_{number}" for number in range(2, 10000)))
            if name not in self.taken and name not in self.kinds
        )
        self.taken.add(name)
        return name

    def own(self, stem, kind):
        """A name of the C alone, declared with the others."""
        name = self.fresh(stem)
        self.kinds[name] = kind
        return name

    def put(self, line):
        self.lines.append("    " * self.depth + line)

    # --- statements ---------------------------------------------------------------------------------------------

    def block(self, body):
        for node in body:
            for line in sorted(line for line in self.comments if line <= node.lineno):
                self.put(f"/* {self.comments.pop(line).replace('*/', '* /')} */")
            write = getattr(self, f"write_{type(node).__name__.lower()}", None)
            if write is None:
                self.refuse(node, f"the dialect has no {type(node).__name__}")
            write(node)

    def braced(self, body):
        self.put("{")
        self.depth += 1
        self.block(body)
        self.depth -= 1
        self.put("}")

    def write_if(self, node, word="if"):
        self.put(f"{word} ({self.test(node.test)})")
        self.braced(node.body)
        if (
            len(node.orelse) == 1
            and isinstance(node.orelse[0], ast.If)
            and not self.needs_lines(node.orelse[0])
        ):
            self.write_if(node.orelse[0], "else if")
        elif node.orelse:
            self.put("else")
            self.braced(node.orelse)

    def needs_lines(self, node):
        """Whether something stands before the C of an ``if``: a comment, or rates that its test hands on."""
        return node.lineno in self.comments or self.calls_with_rates(node.test)

    def calls_with_rates(self, node):
        """Whether an expression hands a rate to a function that wants a name for it."""
        return any(
            isinstance(part, ast.Call) and any(self.kind(one) == "rate" for one in part.args)
            for part in ast.walk(node)
        )

    def write_while(self, node):
        self.in_test = True
        self.put(f"while ({self.test(node.test)})")
        self.in_test = False
        self.braced(node.body)

    def write_for(self, node):
        """A loop over a range, whose end Python reads once."""
        given = node.iter.args
        start, stop = (given[0], given[1]) if len(given) > 1 else (ast.Constant(0), given[0])
        for one in (start, stop):
            if self.kind(one) != "int":
                self.refuse(node, f"the range wants an int, and {ast.unparse(one)} is a {self.kind(one)}")
        step = self.step(given[2]) if len(given) > 2 else 1
        name, end = node.target.id, self.value(stop)
        names = {one.id for one in ast.walk(stop) if isinstance(one, ast.Name)}
        reads = any(isinstance(one, (ast.Subscript, ast.Call)) for one in ast.walk(stop))
        if reads or names & ({name} | stored(node.body)):
            kept = self.own(f"{name}_end", "int")
            self.put(f"{kept} = {end};")
            end = kept
        name = named(name)
        sign = "<" if step > 0 else ">"
        self.put(f"for ({name} = {self.value(start)}; {name} {sign} {end}; {name} += {step})")
        self.braced(node.body)

    def step(self, node):
        """The step of a range, a whole number other than 0."""
        try:
            found = ast.literal_eval(node)
        except ValueError:
            found = 0
        if type(found) is not int or found == 0:
            self.refuse(node, f"the step of a range is a whole number, not {ast.unparse(node)}")
        return found

    def write_break(self, node):
        self.put("break;")

    def write_pass(self, node):
        pass

    def write_expr(self, node):
        if not isinstance(node.value, ast.Call):
            self.refuse(node, "an expression does nothing")
        kinds = self.call_kinds(node.value)
        unread = [self.own("unread", kind) for kind in kinds] if len(kinds) > 1 else []
        self.put(self.call(node.value, [f"&{name}" for name in unread]) + ";")

    def write_return(self, node):
        if not self.outs:
            self.check(node, self.results[0], node.value)
            self.put(f"return {self.value(node.value)};")
            return
        if isinstance(node.value, ast.Tuple):
            for name, kind, value in zip(self.outs, self.results, node.value.elts):
                self.store(node, f"*{name}", kind, value)
        else:
            self.put(self.call(node.value, self.outs) + ";")
        if node is not self.node.body[-1]:
            self.put("return;")

    def write_assign(self, node):
        if len(node.targets) > 1:
            self.refuse(node, "one target for each assignment")
        target, value = node.targets[0], node.value
        if not isinstance(target, ast.Tuple):
            self.store(node, self.place(target), self.kind(target), value)
        elif isinstance(value, ast.Tuple):
            self.store_each(node, target.elts, value.elts)
        else:
            self.store_results(node, target.elts, value)

    def write_augassign(self, node):
        load = ast.parse(ast.unparse(node.target), mode="eval").body
        value = ast.copy_location(ast.BinOp(load, node.op, node.value), node)
        kind, sign = self.kind(node.target), BINARY.get(type(node.op), ("",))[0]
        self.check(node, kind, value)
        if type(node.op) in WHOLE or kind == "rate":
            self.store(node, self.place(node.target), kind, value)
        else:
            self.binary(value)  # what is refused there is refused here
            self.put(f"{self.place(node.target)} {sign}= {self.value(node.value)};")

    def store_each(self, node, targets, values):
        """Several assignments at once: where a value reads what one before it writes, all are computed first."""
        written = {one.id if isinstance(one, ast.Name) else one.value.id for one in targets}
        read = {one.id for value in values for one in ast.walk(value) if isinstance(one, ast.Name)}
        kinds = [self.kind(target) for target in targets]
        places = [self.place(target) for target in targets]
        if not written & read:
            for place, kind, value in zip(places, kinds, values):
                self.store(node, place, kind, value)
            return
        kept = [self.own("kept", kind) for kind in kinds]
        for name, kind, value in zip(kept, kinds, values):
            self.store(node, name, kind, value)
        for place, name in zip(places, kept):
            self.put(f"{place} = {name};")

    def store_results(self, node, targets, call):
        """The results of a call; those that go into an array have a name first."""
        kinds = self.call_kinds(call)
        if len(kinds) != len(targets):
            self.refuse(node, f"{len(targets)} names for {len(kinds)} results")
        names = []
        for target, kind in zip(targets, kinds):
            if self.kind(target) != kind:
                self.refuse(node, f"{ast.unparse(target)} is a {self.kind(target)} and gets a {kind}")
            names.append(named(target.id) if isinstance(target, ast.Name) else self.own("kept", kind))
        self.put(self.call(call, [f"&{name}" for name in names]) + ";")
        for target, name in zip(targets, names):
            if not isinstance(target, ast.Name):
                self.put(f"{self.place(target)} = {name};")

    def store(self, node, place, kind, value):
        """One value to its place."""
        self.check(node, kind, value)
        if kind != "rate":
            self.put(f"{place} = {self.value(value)};")
        elif self.kind(value) != "rate":
            self.put(f"{place} = all_lanes({self.value(value)});")
        else:
            with self.each_lane():
                text = self.value(value)
            self.put(f"EACH_LANE each({place}) = {text};")

    def check(self, node, kind, value):
        """Refuse a value of another kind than its place; a number may stand for a rate."""
        found = self.kind(value)
        if found != kind and (kind, found) != ("rate", "float"):
            self.refuse(node, f"{ast.unparse(value)} is a {found}, and a {kind} is wanted")

    # --- expressions: text and how tightly it binds -------------------------------------------------------------

    @contextmanager
    def each_lane(self, on=True):
        """Within it rates stand for those of one direction, or ``on`` being false for all of them."""
        before, self.lane = self.lane, on
        yield
        self.lane = before

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
        with self.each_lane(False):
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
            return self.lanes_of(named(node.id), self.kinds[node.id]), CALL
        imports = self.source.imports
        home = next((home for home, names in imports.items() if node.id in names), None)
        if home is None and node.id not in self.source.constants:
            if node.id not in NUMBERS:
                self.refuse(node, f"{node.id} is nothing that the kernel has")
            return NUMBERS[node.id], CALL
        return f"{home or self.module}__{node.id}", CALL

    def lanes_of(self, text, kind):
        return f"each({text})" if self.lane and kind == "rate" else text

    def subscript(self, node):
        if isinstance(node.value, ast.Name) and self.kinds.get(node.value.id) in ("array", "rates"):
            if self.kind(node.slice) != "int":
                self.refuse(node, f"the index {ast.unparse(node.slice)} is a {self.kind(node.slice)}")
            with self.each_lane(False):
                index = self.value(node.slice)
            rates = self.kinds[node.value.id] == "rates"
            text = f"{'RATE_AT' if rates else 'AT'}({named(node.value.id)}, {index})"
            return self.lanes_of(text, "rate" if rates else "float"), CALL
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
        with self.each_lane(False):
            if isinstance(node, (ast.Name, ast.Subscript)) and self.kind(node) == "rate":
                return self.value(node)
            if self.kind(node) != "rate":
                return f"all_lanes({self.value(node)})"
            if self.in_test:
                self.refuse(node, "the condition of a loop hands on a rate that has no name")
            name = self.own("rates", "rate")
            self.store(node, name, "rate", node)
        return name


def emitted(kernel, module):
    """The functions of a ``module`` that C does not have by itself, by name: (head, text)."""
    comments = comments_of(module.text)
    found = {}
    for name, node in module.functions.items():
        if module.marks.get(name) != "native":
            function = Function(kernel, module, node, comments)
            found[name] = function.head, function.text
    return found
