"""Kinds of names and expressions in one function of the kernel."""

import ast
from functools import cache


@cache
def parameters(node):
    """(name, kind) of the parameters of a function, as annotated."""
    kinds = {"float": "float", "int": "int", "bool": "bool", "'float[:]'": "array"}
    return [(argument.arg, kinds[ast.unparse(argument.annotation)]) for argument in node.args.args]


class Scope:
    """One function: the kinds of its names, and which of them follow the inputs."""

    def __init__(self, kernel, module, node):
        self.kernel, self.module, self.node = kernel, module, node
        self.kinds = dict(parameters(node))
        for statement in sorted(
            (n for n in ast.walk(node) if isinstance(n, (ast.Assign, ast.For))), key=lambda n: n.lineno
        ):
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
            return "float"
        if isinstance(node, (ast.Compare, ast.BoolOp)):
            return "bool"
        if isinstance(node, ast.UnaryOp):
            return self.kind(node.operand)
        if isinstance(node, ast.BinOp):
            floats = isinstance(node.op, ast.Div) or "float" in (self.kind(node.left), self.kind(node.right))
            return "float" if floats else "int"
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
        if name == "pi":
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


@cache
def constant_kinds(tree):
    """Kind of every constant of a module, by name."""
    return {
        node.target.id: ast.unparse(node.annotation)[len("Final[") : -1]
        for node in tree.body
        if isinstance(node, ast.AnnAssign)
    }
