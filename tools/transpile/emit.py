"""The C of one function of the kernel, from its syntax tree.

The dialect has few kinds of statements and expressions, and each has one form in C with the same operations in
the same order: the names are those of the Python, comments stand where they stood.  What has no form here is
refused with its line, and so is what would be another kind of number in C: a name that changes its kind, an
``and`` of numbers, a call of anything that neither the kernel nor C has.

In the differentiated kernel a rate beside a value has the type ``directional_rate`` (native/directions.h), as many rates as there
are directions in one pass.  A statement that assigns a rate computes all of them, ``EACH_DIRECTION each(x_t) = ...``.
"""

import ast
import io
import tokenize

from differentiate.scope import parameters

from .expressions import BINARY, WHOLE, Expressions, named
from .modules import stored

TYPES = {
    "float": "double",
    "int": "int64_t",
    "bool": "bool",
    "rate": "directional_rate",
    "array": "array_double_1d",
    "rates": "array_directional_rate_1d",
}


def comments_of(text):
    """The comments in a module's text (bytes), by their lines."""
    if b"#" not in text:
        return {}
    tokens = tokenize.tokenize(io.BytesIO(text).readline)
    return {token.start[0]: token.string.lstrip("# ") for token in tokens if token.type == tokenize.COMMENT}


class Function(Expressions):
    """The C of one function: its ``head`` and its ``text``, of the function ``node`` of the module ``source``."""

    def __init__(self, kernel, source, node, comments=()):
        super().__init__(kernel, source, node)
        self.comments = {line: text for line, text in dict(comments).items() if line > node.lineno}
        self.arguments = dict(parameters(node))
        self.results = kernel.returns(source.name, node.name)
        self.taken = {one.id for one in ast.walk(node) if isinstance(one, ast.Name)} | set(self.arguments)
        self.outs = self.out_names() if len(self.results) > 1 else []
        self.lines, self.depth = [], 1
        self.block(node.body[1:] if ast.get_docstring(node) else node.body)

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
            self.put(f"{place} = along_all({self.value(value)});")
        else:
            with self.each_direction():
                text = self.value(value)
            self.put(f"EACH_DIRECTION each({place}) = {text};")

    def check(self, node, kind, value):
        """Refuse a value of another kind than its place; a number may stand for a rate."""
        found = self.kind(value)
        if found != kind and (kind, found) != ("rate", "float"):
            self.refuse(node, f"{ast.unparse(value)} is a {found}, and a {kind} is wanted")


def emitted(kernel, module):
    """The functions of a ``module`` that C does not have by itself, by name: (head, text)."""
    comments = comments_of(module.text)
    found = {}
    for name, node in module.functions.items():
        if module.marks.get(name) != "native":
            function = Function(kernel, module, node, comments)
            found[name] = function.head, function.text
    return found
