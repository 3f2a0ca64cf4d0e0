"""Kinds of names and expressions in one function of the kernel."""

import ast
from functools import wraps
from weakref import WeakKeyDictionary

#: Kinds by annotation; a rate is what the differentiated kernel has beside a float.
KINDS = {
    "float": "float",
    "int": "int",
    "bool": "bool",
    "'float[:]'": "array",
    "'rate'": "rate",
    "'rate[:]'": "rates",
}
NUMBERS = {"pi", "inf", "nan"}  # of the module math


def kept_with_tree(function):
    """A function of a syntax tree whose answer is kept as long as the tree: one process may translate many kernels."""
    known = WeakKeyDictionary()

    @wraps(function)
    def answer(tree):
        if tree not in known:
            known[tree] = function(tree)
        return known[tree]

    return answer


@kept_with_tree
def parameters(node):
    """(name, kind) of the parameters of a function, as annotated."""
    return [(argument.arg, KINDS[ast.unparse(argument.annotation)]) for argument in node.args.args]


def assignments(node):
    """The assignments and loops inside a statement, by their lines."""
    found, waiting = [], [node]
    while waiting:  # only statements hold statements: expressions are passed over
        one = waiting.pop()
        waiting += [*getattr(one, "body", ()), *getattr(one, "orelse", ())]
        if isinstance(one, (ast.Assign, ast.For)):
            found.append(one)
    return sorted(found, key=lambda statement: statement.lineno)


class Scope:
    """One function: the kinds of its names, and which of them follow the inputs."""

    def __init__(self, kernel, module, node):
        self.kernel, self.module, self.node = kernel, module, node
        known = kernel.known_kinds.get(node)
        self.kinds = dict(known or parameters(node))
        if known is None:
            self.note_kinds()
            kernel.known_kinds[node] = dict(self.kinds)

    def note_kinds(self):
        """The kind of every name, which is that of the first value that it gets; one that ever gets a rate, or
        that is called as one, is a rate."""
        for statement in assignments(self.node):
            if isinstance(statement, ast.For):
                self.kinds.setdefault(statement.target.id, "int")
                continue
            target, value = statement.targets[0], statement.value
            if isinstance(target, ast.Name):
                self.kinds.setdefault(target.id, self.kind(value))
            elif isinstance(target, ast.Tuple):
                kinds = (
                    [self.kind(element) for element in value.elts]
                    if isinstance(value, ast.Tuple)
                    else self.call_kinds(value)
                )
                for element, kind in zip(target.elts, kinds):
                    if isinstance(element, ast.Name):
                        self.kinds.setdefault(element.id, kind)
        if {"rate", "rates"} & set(self.kinds.values()):
            self.note_rates()

    def note_rates(self):
        """The names that are rates, those included that begin with a number."""
        for name, kind in self.kinds.items():
            if name.endswith("_t") and name[:-2] in self.kinds and kind == "float":
                self.kinds[name] = "rate"
        assigned = [
            (one.targets[0].id, one.value)
            for one in assignments(self.node)
            if isinstance(one, ast.Assign) and isinstance(one.targets[0], ast.Name)
        ]
        before = -1
        while (count := list(self.kinds.values()).count("rate")) != before:
            before = count
            self.kinds |= {name: "rate" for name, value in assigned if self.kind(value) == "rate"}

    def call_kinds(self, call):
        """Kinds of what a call returns."""
        if call.func.id == "differentiated":
            call = call.args[0]
        return self.kernel.returns(self.kernel.home(self.module, call.func.id), call.func.id)

    def kind(self, node):
        """Kind of an expression."""
        if isinstance(node, ast.Constant):
            return type(node.value).__name__
        if isinstance(node, ast.Name):
            return self.kinds.get(node.id) or self.constant_kind(node.id)
        if isinstance(node, ast.Subscript):
            if isinstance(node.value, ast.Attribute):  # x.shape[0]
                return "int"
            return "rate" if self.kinds.get(node.value.id) == "rates" else "float"
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return "bool"
        if isinstance(node, ast.UnaryOp):
            return "bool" if isinstance(node.op, ast.Not) else self.kind(node.operand)
        if isinstance(node, ast.BinOp):
            kinds = self.kind(node.left), self.kind(node.right)
            if "rate" in kinds:
                return "rate"
            return "float" if isinstance(node.op, ast.Div) or "float" in kinds else "int"
        if not isinstance(node, ast.Call):
            return type(node).__name__  # nothing that the dialect has
        if node.func.id in ("int", "isfinite"):
            return "int" if node.func.id == "int" else "bool"
        if node.func.id in ("min", "max"):
            return self.kind(node.args[0])
        if (
            node.func.id in ("held", "moving", "seeded", "rate_of", "common_rate")
            or self.kernel.home(self.module, node.func.id) is None
        ):
            return "float"
        kinds = self.call_kinds(node)
        return kinds[0] if len(kinds) == 1 else "call"

    def constant_kind(self, name):
        """Kind of a module's constant."""
        if name in NUMBERS:
            return "float"
        homes = [
            self.module,
            *(home for home, names in self.kernel.modules[self.module].imports.items() if name in names),
        ]
        for home in homes:
            kinds = constant_kinds(self.kernel.modules[home].tree)
            if name in kinds:
                return kinds[name]
        raise KeyError(f"{self.module}.py: {name} has no kind")


@kept_with_tree
def constant_kinds(tree):
    """Kind of every constant of a module, by name."""
    return {
        node.target.id: ast.unparse(node.annotation)[len("Final[") : -1]
        for node in tree.body
        if isinstance(node, ast.AnnAssign)
    }
